"""How a command line ended, for the tests of verbs."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Ended:
    """How a command ended."""

    code: int
    out: str
    err: str

    @property
    def lines(self):
        """What stands on standard error."""
        return self.err.splitlines()
