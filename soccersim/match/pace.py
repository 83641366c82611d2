"""How fast a match is played."""

from time import perf_counter


class Pace:
    """Times real time, from the second decision on.

    What comes before loads kernels, and whatever strategies import when they are first asked.
    """

    def __init__(self, duration: float) -> None:
        self._duration = duration  # s, of the whole match
        self._decisions = 0

    def __call__(self, share: float) -> None:
        """To be told at each decision: the share of the match that is over."""
        self._decisions += 1
        if self._decisions == 2:
            self._from, self._start = share * self._duration, perf_counter()

    def factor(self, played: float) -> float:
        """After so many seconds of the match; 0 where it has not come that far."""
        if self._decisions < 2:
            return 0.0
        return (played - self._from) / (perf_counter() - self._start)
