"""What the end of a process says."""

import signal

from soccersim.match.faults import CRASH, EXIT, MEMORY

FULL = 77  # exit code of a team's process whose memory is full


def how_ended(code: int) -> tuple[str, str]:
    """The kind of fault that an end with this exit code is, and its words."""
    if code == FULL:
        return MEMORY, "its memory is full"
    if code >= 0:
        return EXIT, f"its process ended with exit code {code}"
    try:
        name = signal.Signals(-code).name
    except ValueError:
        name = f"signal {-code}"
    full = ", as a system does whose memory is full" if name == "SIGKILL" else ""
    return CRASH, f"its process was killed by {name}{full}"
