"""Which matches are worth a recording: told once they are over."""

from collections.abc import Sequence
from typing import Literal

from soccersim.match.faults import TeamFault

Keep = Literal["all", "faults", "lost", "none"]


def is_kept(
    keep: Keep, watched: int | None, score: Sequence[int], faults: Sequence[TeamFault]
) -> bool:
    """Whether the recording of a match that came out so is wanted.

    watched: the slot whose losses count for `lost`; None: whoever loses.
    """
    if keep == "faults":
        return bool(faults)
    if keep == "lost":
        return score[0] != score[1] if watched is None else score[watched] < score[1 - watched]
    return keep == "all"
