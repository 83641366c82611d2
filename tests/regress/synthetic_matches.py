"""A synthetic engine: pairs of matches with known odds, and the order in which workers end them.

A match is a goal difference. In a world, two equal teams on a neutral field end a match d goals
apart with chances proportional to weights[|d|]. Strength and sides tilt that: the candidate's
difference has chances proportional to weights[|d|] exp((strength +- side) d), + where it plays
HOME. In a share of the pairs, `copies`, both teams do the same all match long: the second leg is
the first with the names exchanged, and the pair is exactly 0. The strength is set so that the
effect of the pair, by goals or by results, is exactly the one asked for.

Matches take 1 unit of time when the candidate wins, 2 when drawn and 3 when it loses, give or take
a tenth: forfeits and quick wins come in first. Workers take the legs in the order of their
numbers.
"""

from dataclasses import dataclass
from math import sqrt
from typing import NamedTuple

import numpy as np

from soccersim.regress.rules import Sprt, Tally, first_decided, llr_of, tally
from soccersim.regress.samples import CLIP, Leg, Pair, between
from soccersim.regress.statistics import effect_of_elo

DURATION = {1: 1.0, 0: 2.0, -1: 3.0}  # by the candidate's result


@dataclass(frozen=True)
class World:
    """Odds of matches. weights: of a match that ends 0, 1, 2, ... goals apart."""

    weights: tuple[float, ...]
    side: float = 0.0  # how much playing HOME tilts a goal
    copies: float = 0.0  # share of pairs whose legs are the same match

    @property
    def differences(self):
        """(D,) the goal differences of a match."""
        most = len(self.weights) - 1
        return np.arange(-most, most + 1)

    def odds(self, strength):
        """(D, D) chances of the candidate's differences at home and away."""
        d = self.differences
        weights = np.array(self.weights)[abs(d)]
        home, away = (weights * np.exp((strength + s) * d) for s in (self.side, -self.side))
        copied = np.diag(weights * np.exp(self.side * d))[:, ::-1]  # away as at home, turned round
        apart = np.outer(home / home.sum(), away / away.sum())
        return (1 - self.copies) * apart + self.copies * copied / copied.sum()

    def effect(self, strength, by):
        """The effect of a pair: by goals about zero, by results about the mean."""
        d, odds = self.differences, self.odds(strength)
        x = outcome(d[:, None], d[None, :], by)
        mean, square = (odds * x).sum(), (odds * x * x).sum()
        return mean / sqrt(square - (mean * mean if by == "results" else 0.0))

    def strength(self, nelo, by):
        """The strength that gives this normalized Elo."""
        low, high, wanted = -3.0, 3.0, float(effect_of_elo(nelo))
        for _ in range(80):
            middle = 0.5 * (low + high)
            below = self.effect(middle, by) < wanted
            low, high = (middle, high) if below else (low, middle)
        return middle


WORLDS = {
    "lively": World((1.0, 0.85, 0.5, 0.25, 0.1, 0.04)),
    "few goals": World((1.0, 0.2, 0.02)),
    "many goals": World((1.0, 0.95, 0.9, 0.8, 0.7, 0.6, 0.4, 0.3, 0.2)),
    "a strong side": World((1.0, 0.85, 0.5, 0.25, 0.1), side=0.5),
    "no draws": World((0.0, 1.0, 0.5, 0.2)),
    "near copies": World((1.0, 0.85, 0.5, 0.25, 0.1, 0.04), copies=0.8),
    "very near copies": World((1.0, 0.85, 0.5, 0.25, 0.1, 0.04), side=0.3, copies=0.95),
}


class Played(NamedTuple):
    """Runs of pairs: the candidate's goal difference in each leg, and how long the leg takes."""

    legs: np.ndarray  # (runs, pairs, 2) at home, away
    time: np.ndarray  # (runs, pairs, 2)


def play(world, nelo, by, runs, pairs, seed):
    """Pairs of a candidate that is truly nelo better by goals or by results."""
    rng = np.random.default_rng(seed)
    odds = world.odds(world.strength(nelo, by))
    drawn = rng.choice(odds.size, size=(runs, pairs), p=odds.ravel())
    legs = world.differences[np.stack(np.divmod(drawn, len(odds)), axis=-1)]
    time = np.vectorize(DURATION.get)(np.sign(legs)) * rng.uniform(0.9, 1.1, legs.shape)
    return Played(legs, time)


def outcome(home, away, by):
    """What of a pair is judged: goal difference, clipped, or score less 1/2."""
    if by == "results":
        return (np.sign(home) + np.sign(away)) / 4
    return np.clip(home + away, -CLIP, CLIP).astype(float)


def outcomes(legs, by):
    """(runs, pairs) of legs (runs, pairs, 2)."""
    return outcome(legs[..., 0], legs[..., 1], by)


def sums(x, marks, by) -> Tally:
    """Tallies of outcomes (runs, pairs), none void."""
    return tally(x, np.ones(x.shape, dtype=bool), marks, by == "results")


def llr(tallied, nelo):
    """The ratios of a Tally; counts that came several times are worked out once."""
    if tallied.counts is None:
        return llr_of(tallied, nelo)
    counts, which = np.unique(tallied.counts.reshape(-1, 5), axis=0, return_inverse=True)
    unequal = counts.sum(axis=1) - counts[:, 2]
    several = llr_of(tallied._replace(counts=counts, unequal=unequal), nelo)
    return several[which].reshape(tallied.pairs.shape)


def ends(x, by, rule=None):
    """(runs,) each: how many pairs runs of outcomes (runs, pairs) took, and 1, -1 or 0."""
    rule = rule or Sprt()
    marks = rule.marks(x.shape[1])
    tallied = sums(x, marks, by)
    if isinstance(rule, Sprt):
        at, clear = first_decided(rule.judge_llr(llr(tallied, rule.nelo), tallied))
    else:
        at, clear = first_decided(rule.judge(tallied))
    return np.append(marks, x.shape[1])[at], clear


def ended(played, workers):
    """(runs, pairs) when both legs of each pair have ended, on so many workers."""
    runs, pairs, _ = played.time.shape
    free, each = np.zeros((runs, workers)), np.arange(runs)
    done = np.empty((runs, 2 * pairs))
    for leg, time in enumerate(np.moveaxis(played.time.reshape(runs, -1), 1, 0)):
        worker = free.argmin(axis=1)
        free[each, worker] += time
        done[:, leg] = free[each, worker]
    return done.reshape(runs, pairs, 2).max(axis=-1)


def as_samples(legs):
    """The samples of one run's legs (pairs, 2), as the store would hand them out."""
    return [
        between(number, Pair(leg(home, f"{number} {home}"), leg(away, f"{number} {-away}")))
        for number, (home, away) in enumerate(legs.tolist())
    ]


def leg(difference, digest="", **faults):
    """A match that ended so many goals apart."""
    return Leg(max(difference, 0), max(-difference, 0), digest, **faults)
