"""What is kept of one match."""

from dataclasses import dataclass
from typing import Any, Literal

from soccersim.match.supervise import DOUBTFUL

Document = dict[str, Any]


@dataclass(frozen=True)
class Row:
    """One leg, played; or void, where the machine failed to play it."""

    key: str  # of its Leg
    pair: int
    leg: Literal[0, 1]
    seed: int
    home: str  # SHA-256 of the bundle that played HOME
    away: str
    score: tuple[int, int]  # home, away
    digest: str  # "" where the process of the match died, or it is void
    duration: float  # s played
    faults: tuple[Document, ...]  # side, kind, tick, detail
    events: tuple[Document, ...]
    seconds: float = 0.0  # that playing took
    overhead: float = 0.0  # s besides: process, loading, recording, store
    again: str = ""  # why it was played twice; "": it was not
    void: str = ""  # why it could not be played; "": it was
    recording: str = ""  # its file in the folder beside the store; "": not kept

    @property
    def is_doubtful(self) -> bool:
        """Whether it ended as a busy machine may end it, at another moment each time."""
        return any(fault["kind"] in DOUBTFUL for fault in self.faults)

    @property
    def result(self) -> tuple[Any, ...]:
        """All that comes out the same whenever, wherever and beside what it is played.

        Of faults not their words, which may tell times and addresses.
        """
        who = (self.key, self.seed, self.leg, self.home, self.away)
        faults = tuple((fault["side"], fault["kind"], fault["tick"]) for fault in self.faults)
        return (*who, self.score, self.digest, self.duration, faults, self.events, bool(self.void))
