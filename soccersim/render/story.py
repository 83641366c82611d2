"""What a match's recording tells at each of its records, in words and numbers to be shown."""

from bisect import bisect_right
from typing import Any, NamedTuple

import numpy as np

from soccersim.match_report import SIDES, team_names
from soccersim.record.recording import Recording
from soccersim.sheet import PHASES
from soccersim.shots import passes, shots
from soccersim.touches import BallPlay

HOLDS, FADES = 5.0, 1.5  # s that a decision is shown, and that it takes to go
LEVELS = 6  # steps in which it goes
CHEERS = 3.0  # s that the score is in the colour of who has just scored
QUIET = {*PHASES, "start", "in_play"}  # events that the phase tells already
WORDS = {  # phases that are not called by their names
    "stop": "STOP",
    "kick_off": "kick-off",
    "throw_in": "throw-in",
    "play": "in play",
    "over": "full time",
}


class Said(NamedTuple):
    """A decision of the referee, or the end of a team."""

    text: str
    side: int | None  # the slot whose goal it is; others are nobody's
    level: int  # LEVELS: fresh; 0: gone


class Counts(NamedTuple):
    """How often something happened up to a record, by slot."""

    records: tuple[list[int], list[int]]  # at which, in order

    def until(self, slot: int, record: int) -> int:
        """How often up to and with this record."""
        return bisect_right(self.records[slot], record)


class Story:
    """One match of T records, read once."""

    def __init__(self, recording: Recording) -> None:
        match, arrays = recording.match or {}, recording.arrays
        play = BallPlay(recording)
        self.names = team_names(recording)
        self.players = recording.scenario.robots
        self.sides = play.sides
        self.hz = float(recording.meta["physics_hz"])
        self.ticks: list[int] = recording.tick.tolist()
        self.duration, self.length = recording.scenario.duration, recording.duration
        self.decision: list[int] = play.decision.tolist()
        self.phase: list[int] = arrays["phase"].tolist()
        self.whose: list[int] = arrays["whose"].tolist()
        self.started: list[int] = arrays["started"].tolist()
        self.scores: list[list[int]] = arrays["score"].tolist()
        self.direction: list[int] = arrays["direction"].tolist()
        self.in_play: list[list[int]] = arrays["in_play"].tolist()
        self.holder: list[int] = play.holder.tolist()
        self.events: list[dict[str, Any]] = match["events"]
        self.goals = [e for e in self.events if e["kind"] == "goal"]
        self.goal_ticks = [event["tick"] for event in self.goals]
        self.kicks = play.kicks
        self._read_counts(play)
        self._read_decisions(match)

    def _read_counts(self, play: BallPlay) -> None:
        sides = np.array([*self.sides, -1])[play.holder]
        self.had = [np.cumsum(sides == slot).tolist() for slot in (0, 1)]
        tried = [(kick.record, self.sides[kick.robot], on_goal) for kick, on_goal in shots(play)]
        passed = [(touch.record, self.sides[touch.robot]) for touch in passes(play)]
        self.shots = _counts([(record, slot) for record, slot, _ in tried])
        self.on_goal = _counts([(record, slot) for record, slot, on_goal in tried if on_goal])
        self.passes = _counts(passed)

    def _read_decisions(self, match: dict[str, Any]) -> None:
        """What is decided after the last record stands in its picture."""
        last = self.ticks[-1] if self.ticks else 0
        self.decided = [
            (
                min(e["tick"], last),
                e["text"],
                SIDES.index(e["side"]) if e["kind"] == "goal" else None,
            )
            for e in self.events
            if e["kind"] not in QUIET
        ]
        for fault in match["faults"]:
            text = f"{fault['side']} forfeits the match: {fault['kind'].replace('_', ' ')}"
            self.decided.append((last, text, None))
        self.decided_ticks = [tick for tick, _, _ in self.decided]
        self.final: list[int] = match["score"]
        over = any(event["kind"] == "end" for event in self.events)
        self.outcome = "forfeit" if match["faults"] else WORDS["over"] if over else ""

    def is_last(self, record: int) -> bool:
        """Whether it is the last record, whose picture tells how the match ended."""
        return record == len(self.ticks) - 1

    def seconds(self, record: int) -> float:
        """Since the match began; of the last record, how long it took."""
        return self.length if self.is_last(record) else self.ticks[record] / self.hz

    def half(self, record: int) -> int:
        """1 or 2."""
        return 1 if 2 * self.seconds(record) < self.duration else 2

    def score(self, record: int) -> list[int]:
        """As it stands."""
        return self.final if self.is_last(record) else self.scores[self.decision[record]]

    def cheering(self, record: int) -> int | None:
        """The slot that has just scored."""
        at = bisect_right(self.goal_ticks, self.ticks[record]) - 1
        if at < 0 or self.ticks[record] - self.goal_ticks[at] > CHEERS * self.hz:
            return None
        return SIDES.index(self.goals[at]["side"])

    def state(self, record: int) -> tuple[str, int | None, str]:
        """The phase, the slot whose restart it is, and what that means just now."""
        decision = self.decision[record]
        phase, whose = PHASES[self.phase[decision]], self.whose[decision]
        if self.outcome and self.is_last(record):
            return self.outcome, None, ""
        word = WORDS.get(phase) or phase.replace("_", " ")
        holder = self.holder[record]
        if phase == "stop":
            return word, None, "all robots halt"
        if phase == "play":
            slot = self.sides[holder] if holder >= 0 else None
            number = self.players[holder].number
            return (
                word,
                slot,
                f"last touched by {number}" if holder >= 0 else "nobody's ball",
            )
        ready = "START given" if self.started[decision] else "getting ready"
        return word, None if whose < 0 else whose, ready

    def said(self, record: int) -> Said | None:
        """The referee's last decision, until it has faded."""
        tick = self.ticks[record]
        at = bisect_right(self.decided_ticks, tick) - 1
        if at < 0:
            return None
        since, text, side = self.decided[at]
        late = (tick - since) / self.hz - HOLDS
        level = LEVELS if late < 0 else int(LEVELS * (1 - late / FADES))
        return Said(text, side, level) if level > 0 else None

    def possession(self, record: int) -> int | None:
        """Home's share of it so far, in per cent; see match_report."""
        home, away = self.had[0][record], self.had[1][record]
        return round(100 * home / (home + away)) if home + away else None


def _counts(happened: list[tuple[int, int]]) -> Counts:
    home, away = (sorted(record for record, own in happened if own == slot) for slot in (0, 1))
    return Counts((home, away))
