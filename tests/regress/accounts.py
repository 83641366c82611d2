"""Accounts of runs that were never played: matches as drawn, verdicts by the real rule."""

import random
from pathlib import Path

from soccersim.regress.account import Account, Match
from soccersim.regress.row import Row
from soccersim.regress.rules import Fixed, Sprt
from soccersim.regress.samples import Leg, Pair, between, compared, void
from soccersim.regress.standing import Statistic
from soccersim.regress.verdict import decide

BASE, CANDIDATE = "b" * 64, "c" * 64
TRACEBACK = (
    "Traceback (most recent call last):\n"
    '  File "my_roles.py", line 12, in decide\n'
    '    raise ValueError("enough <b>")\n'
    "ValueError: enough <b>"
)
FAULT = {"side": "home", "kind": "exception", "tick": 260, "detail": TRACEBACK}


class Season:
    """Draws matches between named teams, and makes an account of them."""

    def __init__(self, base="roles", candidate="./my_roles.py", against=(), seed=1):
        self.base, self.candidate, self.against = base, candidate, tuple(against)
        self.base_sha, self.candidate_sha = BASE, CANDIDATE
        self.rng = random.Random(seed)
        self.samples, self.matches = {}, []
        self.keep = "pair-{pair:06d}-leg-{leg}-{key}.npz"

    def sha(self, team):
        """Of a team's code: opponents have their own."""
        known = {self.base: self.base_sha, self.candidate: self.candidate_sha}
        return known.get(team, f"{team.encode(errors='surrogatepass').hex():f<64}"[:64])

    def match(self, pair, leg, home, away, score, digest="", faults=(), **more):
        """One leg that was played."""
        key = f"{len(self.matches):012x}"
        row = Row(
            key=key,
            pair=pair,
            leg=leg,
            seed=pair + 1,
            home=self.sha(home),
            away=self.sha(away),
            score=score,
            digest=digest or f"{self.rng.getrandbits(256):064x}",
            duration=60.0,
            faults=tuple(faults),
            events=(),
            seconds=0.61,
            overhead=0.21,
            recording=more.pop("recording", self.keep.format(pair=pair, leg=leg, key=key)),
            **more,
        )
        teams = home, away
        candidate, base = (
            teams.index(team) if team in teams else None for team in (self.candidate, self.base)
        )
        if self.candidate == self.base:
            candidate, base = leg, 1 - leg
        self.matches.append(Match(row, home, away, candidate, base))
        return row

    def goals(self, strength):
        """Of one match: for, against."""
        odds = (4.0, 4.0, 2.0, 1.0, 0.4)
        tilted = [weight * strength**goals for goals, weight in enumerate(odds)]
        return self.rng.choices(range(5), tilted)[0], self.rng.choices(range(5), odds)[0]

    def two(self, pair, team, other, strength, same=False, faults=()):
        """Both legs of a team against another, as the statistics see them."""
        (ours, theirs), (again, back) = self.goals(strength), self.goals(strength)
        if same:
            again, back = theirs, ours
        digests = ("d" * 64,) * 2 if same else ("", "")
        home = self.match(pair, 0, team, other, (ours, theirs), digests[0], faults)
        away = self.match(pair, 1, other, team, (back, again), digests[1])
        return Pair(Leg(ours, theirs, home.digest, len(faults)), Leg(again, back, away.digest))

    def play(self, pairs, strength=1.0, same=0.0, faults=None):
        """Pairs of the candidate against the base, or of both against the opponents."""
        for number in range(len(self.samples), len(self.samples) + pairs):
            wrong = (faults or {}).get(number, ())
            if self.against:
                mine = [
                    self.two(number, self.candidate, a, strength, faults=wrong)
                    for a in self.against
                ]
                its = [self.two(number, self.base, a, 1.0) for a in self.against]
                self.samples[number] = compared(number, mine, its, 30 + number)
            else:
                alike = self.rng.random() < same
                pair = self.two(number, self.candidate, self.base, strength, alike, wrong)
                parted = None if alike else 40 + self.rng.randrange(3000)
                self.samples[number] = between(number, pair, parted)
        return self

    def lose_machine(self):
        """A pair that could not be played."""
        number = len(self.samples)
        teams = self.candidate, self.base
        for leg, (home, away) in enumerate((teams, teams[::-1])):
            why = "a worker was lost five times"
            self.match(number, leg, home, away, (0, 0), void=why, recording="")
        self.samples[number] = void(number)
        return self

    def account(self, rule=None, statistic=Statistic.GOALS, folder=Path("run"), **more):
        """The account of what has been played, up to where the rule ends it."""
        rule = rule or Sprt()
        alike = self.base_sha == self.candidate_sha
        decided = {name: more.pop(name) for name in ("contradictions",) if name in more}
        standing = decide(self.samples, rule, statistic=statistic, same_code=alike, **decided)
        known = {
            "command": "soccersim regress roles ./my_roles.py --scenario friendly-match",
            "scenario": "friendly-match",
            "base": self.base,
            "candidate": self.candidate,
            "against": self.against,
            "base_sha": self.base_sha,
            "candidate_sha": self.candidate_sha,
            "rule": rule,
            "standing": standing,
            "samples": tuple(self.samples[n] for n in range(standing.numbers)),
            "matches": tuple(m for m in self.matches if m.row.pair < standing.numbers),
            "jobs": 2,
            "seconds": 71.5,
            "played": len(self.matches),
            "found": 16,
            "environment": {"soccersim": "0.1.0", "python": "3.11.2", "os": "Linux", "cpu": "0a1b"},
            "store": folder / "roles.sqlite",
            "recordings": folder / "roles.sqlite.recordings",
        }
        return Account(**{**known, **more})


def passing():
    """A better candidate; a few pairs are the same match on both sides."""
    return Season().play(400, 1.25, same=0.1).account()


def failing():
    """A worse one."""
    return Season(seed=2).play(400, 0.6).account()


def inconclusive():
    """One as good, over a fixed number of pairs; the machine failed once."""
    season = Season(seed=5).play(25)
    season.lose_machine()
    return season.play(34).account(Fixed(60), Statistic.RESULTS)


def identical():
    """The same code under the same name."""
    season = Season("roles", "roles")
    season.base_sha = season.candidate_sha
    return season.play(8, same=1.1).account()


def invalid():
    """A candidate that raises now and then."""
    faults = dict.fromkeys((3, 4, 9), (FAULT,))
    return Season(seed=3).play(400, 1.3, faults=faults).account()


def comparison():
    """Both against the same two opponents."""
    return Season(against=("chaser", "positioning"), seed=4).play(400, 1.2).account()


def stopped():
    """Ctrl-C before the first pair."""
    return Season().account()


ACCOUNTS = {
    "PASS": passing,
    "FAIL": failing,
    "INCONCLUSIVE": inconclusive,
    "IDENTICAL": identical,
    "INVALID": invalid,
    "comparison": comparison,
    "STOPPED": stopped,
}
