"""A planar arm of revolute joints: forward, every inverse solution, Jacobian and workspace.

Frame of the arm: the first joint at the origin; q1 turns from the x axis, every other joint from
the link before it, counter-clockwise positive. Radians; lengths in any one unit, which is then
that of x and y. A pose is (x, y, phi) of the tip, phi the direction of the last link.
Source: Dasmahapatra, eq. (2.1) to (2.10a); the arc cosines that follow there lose solutions and
stand in papers.py.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan2, ceil, cos, degrees, floor, hypot, inf, isfinite, pi, remainder, sin, sqrt

import numpy as np

from soccersim.kinematics.omni import Array

Angles = tuple[float, float, float]
Pose = tuple[float, float, float]

REACH_TOLERANCE = 1e-12  # of the arm's length; so near the edge of reach only rounding sees it
LIMIT_TOLERANCE = 1e-9  # rad; a joint that misses its limit by rounding is put on it
SINGULAR = 1e-6  # least over greatest singular value, lengths in lengths of the arm


@dataclass(frozen=True)
class PlanarArm:
    """The lengths of the links, from the base to the tip, and where the joints may stand.

    Any number of links; `inverse` and what tells of it are for three: two carry the wrist, and
    the third points along phi.

    Raises:
        ValueError: a length is not positive, or the limits are not one (lower, upper) per joint.
    """

    lengths: tuple[float, ...]
    limits: tuple[tuple[float, float], ...] | None = None  # rad, (lower, upper) per joint

    def __post_init__(self) -> None:
        object.__setattr__(self, "lengths", tuple(map(float, self.lengths)))
        if not self.lengths or not all(0 < length < inf for length in self.lengths):
            raise ValueError(f"an arm has one or more links of positive length: got {self.lengths}")
        if self.limits is None:
            return
        object.__setattr__(self, "limits", tuple((float(a), float(b)) for a, b in self.limits))
        ordered = all(a <= b and a < inf and b > -inf for a, b in self.limits)
        if len(self.limits) != self.links or not ordered:
            raise ValueError(f"limits are one (lower, upper) for each joint: got {self.limits}")

    @property
    def links(self) -> int:
        """How many links, n."""
        return len(self.lengths)

    def forward(self, q: Sequence[float]) -> Pose:
        """The tip's (x, y, phi), phi the plain sum of the angles. Source: eq. (2.6), (2.1)."""
        x = y = phi = 0.0
        for length, angle in zip(self.lengths, numbers("q", q, self.links), strict=True):
            phi += angle
            x += length * cos(phi)
            y += length * sin(phi)
        return x, y, phi

    def joints(self, q: Sequence[float]) -> Array:
        """(n + 1, 2) points: the base, every further joint and the tip."""
        phi = np.cumsum(numbers("q", q, self.links))
        links = np.array(self.lengths)[:, None] * np.column_stack((np.cos(phi), np.sin(phi)))
        return np.vstack((np.zeros(2), np.cumsum(links, axis=0)))

    def inverse(self, pose: Sequence[float]) -> list[Angles]:
        """Every (q1, q2, q3) that brings the tip to (x, y, phi); [] when out of reach.

        Two, that with q2 > 0 first; one where they meet, the elbow straight or folded. Angles are
        in (-pi, pi], or, where the limits leave only that, whole turns away. With the wrist on
        the base joint (`wrist_on_base`) q1 is free: the list then has one solution that stands
        for infinitely many, with q1 = 0 if the limits allow. `reach_problem` tells why there is
        none.

        Raises:
            ValueError: the arm has not three links, or the pose is not three finite numbers.
        """
        kept = [q for branch in self._branches(pose) if (q := self._within_limits(branch))]
        return kept[:1] if self.wrist_on_base(pose) else kept

    def reach_problem(self, pose: Sequence[float]) -> str | None:
        """Why `inverse` finds nothing for this pose, and by how much; None where it does."""
        if self.inverse(pose):
            return None
        branches = self._branches(pose)
        if branches and self.wrist_on_base(pose):
            return "joint limits: the wrist is on the base joint, but no angle of joint 1 helps"
        if branches:
            return "joint limits: " + ", or ".join(map(self._limit_problem, branches))
        distance = hypot(*self._wrist(pose))
        least, most = self._wrist_reach()
        if distance > most:
            return f"too far by {distance - most:.6g}: the wrist reaches {most:.6g} from the base"
        return f"too near by {least - distance:.6g}: the wrist keeps {least:.6g} from the base"

    def wrist_on_base(self, pose: Sequence[float]) -> bool:
        """Whether the wrist stands on the base joint (links 1 and 2 are equal, q2 = pi)."""
        least, _ = self._wrist_reach()
        tolerance = REACH_TOLERANCE * sum(self.lengths)
        return least <= tolerance and hypot(*self._wrist(pose)) <= tolerance

    def jacobian(self, q: Sequence[float]) -> Array:
        """(3, n): joint speeds, rad/s, to the speeds of the tip's x, y and phi."""
        points = self.joints(q)
        lever = points[-1] - points[:-1]
        return np.vstack((-lever[:, 1], lever[:, 0], np.ones(self.links)))

    def manipulability(self, q: Sequence[float]) -> float:
        """How freely the tip moves, sqrt(det(J J^T)): for three links l1 l2 |sin q2|.

        0 where a motion is lost, as always with fewer than three. Source: Yoshikawa (1985).
        """
        if self.links < 3:
            return 0.0
        return float(np.prod(np.linalg.svd(self.jacobian(q), compute_uv=False)))

    def singular(self, q: Sequence[float]) -> bool:
        """Whether the tip has lost a motion: for three links, the elbow straight or folded."""
        if self.links < 3:
            return True
        length = sum(self.lengths)
        values = np.linalg.svd(self.jacobian(q) / [[length], [length], [1]], compute_uv=False)
        return bool(values[-1] <= SINGULAR * values[0])

    def workspace(self) -> tuple[float, float]:
        """Least and greatest distance of the tip from the base, whatever phi, without limits."""
        length = sum(self.lengths)
        return max(0.0, 2 * max(self.lengths) - length), length

    def inside(self, x: float, y: float) -> bool:
        """Whether the tip can be brought to (x, y) with some phi, without limits."""
        least, most = self.workspace()
        tolerance = REACH_TOLERANCE * most
        return least - tolerance <= hypot(x, y) <= most + tolerance

    def _wrist(self, pose: Sequence[float]) -> tuple[float, float]:
        """Where the third joint stands, (m, n) of eq. (2.7)."""
        if self.links != 3:
            raise ValueError(f"the inverse is of three links: this arm has {self.links}")
        x, y, phi = numbers("pose", pose, 3)
        return x - self.lengths[2] * cos(phi), y - self.lengths[2] * sin(phi)

    def _wrist_reach(self) -> tuple[float, float]:
        """Least and greatest distance of the third joint from the base."""
        return abs(self.lengths[0] - self.lengths[1]), self.lengths[0] + self.lengths[1]

    def _branches(self, pose: Sequence[float]) -> list[Angles]:
        """The solutions as if without limits; some of the infinitely many where q1 is free."""
        m, n = self._wrist(pose)
        first, second = self.lengths[:2]
        if self.wrist_on_base(pose):
            return [wrapped(q1, pi, pose[2] - q1 - pi) for q1 in self._free_angles(pose[2])]
        found = []
        for q2 in self._elbow_angles(hypot(m, n)):
            q1 = atan2(n, m) - atan2(second * sin(q2), first + second * cos(q2))
            found.append(wrapped(q1, q2, pose[2] - q1 - q2))
        return found

    def _elbow_angles(self, distance: float) -> tuple[float, ...]:
        """The q2, none to two, that put the wrist at a distance > 0: eq. (2.10a), by atan2."""
        least, most = self._wrist_reach()
        tolerance = REACH_TOLERANCE * sum(self.lengths)
        if not least - tolerance <= distance <= most + tolerance:
            return ()
        if distance >= most - tolerance:
            return (0.0,)
        if distance <= least + tolerance:
            return (pi,)
        # 2 l1 l2 times sine and cosine: factors, as 1 - cos^2 has lost the digits near 0 and pi
        sine = sqrt((most - distance) * (most + distance) * (distance - least) * (distance + least))
        cosine = distance * distance - self.lengths[0] ** 2 - self.lengths[1] ** 2
        angle = atan2(sine, cosine)
        return angle, -angle

    def _free_angles(self, phi: float) -> list[float]:
        """The q1 to try where any would do: 0, then where joint 1 or 3 is on a limit.

        What the limits allow is made of intervals of q1, and these end where a joint is on one.
        """
        ends = [0.0]
        if self.limits:
            ends += [*self.limits[0], *(phi - pi - limit for limit in self.limits[2])]
        return [end for end in ends if isfinite(end)]

    def _within_limits(self, q: Angles) -> Angles | None:
        """The same directions within the limits; None where a joint cannot stand so."""
        if self.limits is None:
            return q
        q1, q2, q3 = (within(angle, *limit) for angle, limit in zip(q, self.limits, strict=True))
        return None if q1 is None or q2 is None or q3 is None else (q1, q2, q3)

    def _limit_problem(self, q: Angles) -> str:
        """Which joints cannot stand so."""
        return " and ".join(
            f"joint {joint} at {degrees(angle):.1f} deg, "
            f"which has {degrees(limit[0]):.1f} to {degrees(limit[1]):.1f}"
            for joint, (angle, limit) in enumerate(zip(q, self.limits or (), strict=True), 1)
            if within(angle, *limit) is None
        )


def numbers(name: str, values: Sequence[float], size: int) -> list[float]:
    """The values as floats; ValueError when they are not so many, or not finite."""
    found = [float(value) for value in values]
    if len(found) != size or not all(map(isfinite, found)):
        raise ValueError(f"{name} must be {size} finite numbers: got {found}")
    return found


def wrapped(q1: float, q2: float, q3: float) -> Angles:
    """The same directions in (-pi, pi]."""
    a, b, c = (remainder(angle, 2 * pi) for angle in (q1, q2, q3))
    return (a if a > -pi else pi), (b if b > -pi else pi), (c if c > -pi else pi)


def within(angle: float, lower: float, upper: float) -> float | None:
    """The angle, or the same direction nearest to it, in [lower, upper]; None where there is none.

    Rounding may take it LIMIT_TOLERANCE beyond: it is then put on the limit.
    """
    turns = 0
    if angle < lower - LIMIT_TOLERANCE:
        turns = ceil((lower - LIMIT_TOLERANCE - angle) / (2 * pi))
    elif angle > upper + LIMIT_TOLERANCE:
        turns = floor((upper + LIMIT_TOLERANCE - angle) / (2 * pi))
    turned = angle + 2 * pi * turns
    if not lower - LIMIT_TOLERANCE <= turned <= upper + LIMIT_TOLERANCE:
        return None
    return min(max(turned, lower), upper)
