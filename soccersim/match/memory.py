"""How much memory a process may take besides what it has: where the system can hold it to that."""

from contextlib import suppress
from pathlib import Path

MEBIBYTE = 2**20
TEAM = 512 * MEBIBYTE  # of a team, besides what its process starts with
ADDRESSES = 2048 * MEBIBYTE  # more than that: threads and libraries reserve what they never use
RESERVE = 64 * MEBIBYTE  # given back when the memory is full, so that this can be told
STATM = Path("/proc/self/statm")  # pages: of addresses, ..., sixth: of data


def limit_memory(more: int) -> None:
    """From now on this process gets so many bytes more of data; then Python raises MemoryError."""
    _set(more)


def lift_limit() -> None:
    """Some more room: what is left to do is to say that the memory was full."""
    _set(RESERVE)


def _set(more: int) -> None:
    if not STATM.exists():  # not Linux: no such limits, or none that hold
        return
    import resource

    pages = [int(number) for number in STATM.read_text().split()]
    size = resource.getpagesize()
    for what, have, room in (
        (resource.RLIMIT_DATA, pages[5], more),
        (resource.RLIMIT_AS, pages[0], more + ADDRESSES),
    ):
        _, most = resource.getrlimit(what)
        wanted = have * size + room
        if most != resource.RLIM_INFINITY:
            wanted = min(wanted, most)
        with suppress(OSError, ValueError):
            resource.setrlimit(what, (wanted, most))
