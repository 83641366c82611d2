"""How much memory a process may take besides what it has: where the system can hold it to that."""

from contextlib import suppress
from pathlib import Path

MEBIBYTE = 2**20
TEAM = 512 * MEBIBYTE  # of a team, besides what its process starts with
ADDRESSES = 2048 * MEBIBYTE  # more than that: threads and libraries reserve what they never use
STATM = Path("/proc/self/statm")  # pages: of addresses, ..., sixth: of data

_before: list[tuple[int, tuple[int, int]]] = []  # limits as they were


def limit_memory(more: int) -> None:
    """From now on this process gets so many bytes more of data; then Python raises MemoryError."""
    if not STATM.exists():  # not Linux: no such limits, or none that hold
        return
    import resource

    pages = [int(number) for number in STATM.read_text().split()]
    for what, have, room in (
        (resource.RLIMIT_DATA, pages[5], more),
        (resource.RLIMIT_AS, pages[0], more + ADDRESSES),
    ):
        soft, hard = resource.getrlimit(what)
        wanted = have * resource.getpagesize() + room
        if hard != resource.RLIM_INFINITY:
            wanted = min(wanted, hard)
        with suppress(OSError, ValueError):
            resource.setrlimit(what, (wanted, hard))
            _before.append((what, (soft, hard)))


def lift_limit() -> None:
    """The memory was full: room to say so. Needs next to none itself."""
    if _before:
        import resource

        for what, limits in _before:
            resource.setrlimit(what, limits)
