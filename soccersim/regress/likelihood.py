"""How much likelier the results are under one hypothesis than another: log-likelihood ratios.

Two hypotheses say how strong the candidate is. Under each, of all distributions of pair scores
that fit it, the one is taken that makes the counts most likely (a generalised likelihood ratio);
the logarithm of the quotient, LLR, is what a sequential test watches. Above 0 it speaks for the
second.

Every function is finite for every vector of counts. Arrays as in `statistics`: five counts on the
last axis, any axes before it.
"""

import numpy as np
from numpy.typing import ArrayLike

from soccersim.regress.statistics import (
    SCORES,
    Array,
    effect_of_elo,
    expected_score,
    moments,
    regularized,
)

WIDEST = 200.0  # nElo; beyond 245 no five-valued pair from the uniform start has so large an effect
ROUNDS = 10  # of the fixed point; 3 or 4 do for hypotheses as close as 50 nElo
STEPS = 200  # of the root finder; 8 are usual, halving alone needs some 60
SETTLED = 1e-9  # largest change of a probability in the last round
NEAR = 1e-12  # a root stays when its next step is so small a part of its way to the poles
FINEST = 4e-16  # or when its bracket is as narrow as numbers of this size can tell


def logistic_llr(counts: ArrayLike, elo: tuple[float, float]) -> Array:
    """LLR of the second against the first logistic Elo: the mean score is expected_score(elo)."""
    filled = regularized(counts)
    shares = filled / filled.sum(axis=-1, keepdims=True)
    under = [tilted(shares, SCORES - expected_score(hypothesis)) for hypothesis in elo]
    return np.asarray((filled * np.log(under[1] / under[0])).sum(axis=-1))


def normalized_llr(counts: ArrayLike, nelo: tuple[float, float]) -> Array:
    """LLR of the second against the first normalized Elo, (mean - 1/2) / sd = effect_of_elo."""
    _within_reach(nelo)
    filled = regularized(counts)
    shares = filled / filled.sum(axis=-1, keepdims=True)
    under = [_likeliest(shares, float(effect_of_elo(hypothesis))) for hypothesis in nelo]
    return np.asarray((filled * np.log(under[1] / under[0])).sum(axis=-1))


def closed_llr(counts: ArrayLike, nelo: tuple[float, float]) -> Array:
    """The normalized LLR by formula: N ln[(1 + (nt - nt0)^2) / (1 + (nt - nt1)^2)], nt = nElo / C.

    N pairs are 2 N games. Near the hypotheses it agrees with `normalized_llr`; for large effects it
    falls again, because the spread it divides by vanishes.
    """
    pairs, mean, variance = moments(counts)
    effect = (mean - 0.5) / np.sqrt(2.0 * variance)
    return _quadratic(2.0 * pairs, effect, *(effect_of_elo(nelo) / np.sqrt(2.0)))


def outcome_llr(
    pairs: ArrayLike, total: ArrayLike, squares: ArrayLike, nelo: tuple[float, float]
) -> Array:
    """LLR from any outcome x of a pair, such as its goal difference; arrays of one shape (...).

    pairs: how many, N; total: sum of x; squares: sum of x^2. t = mean / sqrt(mean of x^2), LLR =
    (N / 2) ln[(1 + (t - t0)^2) / (1 + (t - t1)^2)]. The spread is taken about zero: with the
    ordinary one the LLR falls again for a team that wins every pair by the same score. Where all x
    are 0 the LLR is 0.
    """
    _within_reach(nelo)
    size = np.asarray(pairs, dtype=np.float64)
    ratio = _quadratic(size, effect(pairs, total, squares), *effect_of_elo(nelo))
    return np.where(np.asarray(squares, dtype=np.float64) > 0.0, ratio, 0.0)


def effect(pairs: ArrayLike, total: ArrayLike, squares: ArrayLike) -> Array:
    """t = mean / sqrt(mean of x^2) from sums as above: -1 to 1, and 0 where all x are 0."""
    sized = np.sqrt(np.asarray(pairs, dtype=np.float64) * np.asarray(squares, dtype=np.float64))
    some = sized > 0.0
    return np.where(some, np.asarray(total, dtype=np.float64) / np.where(some, sized, 1.0), 0.0)


def tilted(shares: Array, phi: Array) -> Array:
    """The likeliest distribution q with sum q phi = 0, seen the shares p: q = p / (1 + theta phi).

    theta solves sum p phi / (1 + theta phi) = 0, which falls from +inf to -inf between the poles
    -1 / max phi and -1 / min phi: Newton's steps inside that bracket, halving where they fail.
    Arrays (..., 5). Where phi has one sign only there is no such q: p is returned.
    """
    phi = np.broadcast_to(phi, shares.shape)
    solvable = (phi.max(axis=-1) > 0.0) & (phi.min(axis=-1) < 0.0)
    phi = np.where(solvable[..., None], phi, np.array([-1.0, -1.0, 0.0, 1.0, 1.0]))
    poles = -1.0 / phi.max(axis=-1), -1.0 / phi.min(axis=-1)
    low, high = poles
    theta, before = np.zeros(low.shape), np.full(low.shape, np.inf)
    for _ in range(STEPS):
        ratio = phi / (1.0 + theta[..., None] * phi)
        value = (shares * ratio).sum(axis=-1)
        low, high = np.where(value > 0.0, theta, low), np.where(value > 0.0, high, theta)
        newton = theta + value / (shares * ratio * ratio).sum(axis=-1)
        good = (newton > low) & (newton < high) & (np.abs(value) < 0.5 * before)
        room = np.minimum(theta - poles[0], poles[1] - theta)
        done = np.abs(newton - theta) <= NEAR * room
        done |= high - low <= FINEST * np.abs(theta)
        if done.all():
            break
        theta = np.where(done, theta, np.where(good, newton, 0.5 * (low + high)))
        before = np.abs(value)
    q = shares / (1.0 + theta[..., None] * phi)
    return np.where(solvable[..., None], q, shares)


def _likeliest(shares: Array, t: float) -> Array:
    """The likeliest distribution with (mean - 1/2) / sd = t, by fixed point from the uniform one.

    The condition is made linear about the last guess: with its mean mu and spread sigma,
    phi = a - 1/2 - t sigma (1 + ((mu - a) / sigma)^2) / 2 has the mean 0.
    """
    q = np.full(shares.shape, 0.2)
    for _ in range(ROUNDS):
        mean = (q @ SCORES)[..., None]
        spread = np.sqrt((q * (SCORES - mean) ** 2).sum(axis=-1, keepdims=True))
        phi = SCORES - 0.5 - t * spread * (1.0 + ((mean - SCORES) / spread) ** 2) / 2.0
        last, q = q, tilted(shares, phi)
        if np.abs(q - last).max(initial=0.0) < SETTLED:
            break
    return q


def _quadratic(size: Array, t: Array, t0: float, t1: float) -> Array:
    """(size / 2) ln[(1 + (t - t0)^2) / (1 + (t - t1)^2)]."""
    return np.asarray(size / 2.0 * (np.log1p((t - t0) ** 2) - np.log1p((t - t1) ** 2)))


def _within_reach(nelo: tuple[float, float]) -> None:
    if not max(abs(nelo[0]), abs(nelo[1])) <= WIDEST:
        raise ValueError(f"normalized Elo from {-WIDEST:g} to {WIDEST:g}, not {nelo[0]}, {nelo[1]}")
