"""The one model of a base on omni or mecanum wheels: any number, anywhere, any way round.

Body frame: x forward, y left, counter-clockwise positive. Wheel i touches the floor at
p = l (cos a, sin a) and turns towards the angle b; its rollers let it push along
f = (cos(b + gamma), sin(b + gamma)) alone. For the base's twist (vx, vy, omega), with J = rot90,

    f . (v + omega J p + betadot J (p - lambda)) = r cos(gamma) Omega

where the betadot term exists for a leg that is steered about its pivot lambda.
Source: Lynch & Park, Modern Robotics, section 13.2.1; the betadot term is Garcia-Sillas et al.
(2015), eq. (5), with eq. (4) corrected to omega_c = omega_i - betadot_i.
"""

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

RANK_TOLERANCE = 1e-6  # least over greatest singular value; nearer to 0 a layout is an accident
ROLLER_TOLERANCE = 1e-6  # cos(gamma) of a wheel whose rollers turn along with it: no drive


@dataclass(frozen=True, eq=False)
class OmniBase:
    """Where the wheels of a base stand and which way they push; made by `tangential` or `general`.

    SI and radians, body frame, one row per wheel; every array is read-only. A steered base is
    shown at one instant: angles and contacts are those of the legs as they stand.

    Raises:
        ValueError: fewer than three wheels, a size that is not positive or not a number, or
            wheels that leave some motion free (the matrix has rank < 3).
    """

    azimuth: Array  # (n,) rad, direction of the contact point from the centre
    distance: Array  # (n,) m, from the centre to the contact point
    direction: Array  # (n,) rad, where a wheel with positive speed rolls to
    wheel_radius: Array  # (n,) m
    roller_angle: Array  # (n,) rad, gamma: 0 omni, +-pi/4 mecanum
    roller_radius: Array | None = None  # (n,) m, wanted by roller_speeds alone
    pivot: Array | None = None  # (n, 2) m, body frame; wanted with steering rates alone

    @classmethod
    def tangential(
        cls,
        azimuths_deg: ArrayLike = (30, 150, 270),
        distance: ArrayLike = 0.19,
        wheel_radius: ArrayLike = 0.05,
    ) -> Self:
        """Plain omni wheels that all turn the base to the left: b = a + 90 deg, gamma = 0.

        `distance` and `wheel_radius` are one number or one per wheel.
        """
        return cls.general(azimuths_deg, distance, wheel_radius)

    @classmethod
    def general(
        cls,
        azimuths_deg: ArrayLike,
        distance: ArrayLike,
        wheel_radius: ArrayLike,
        directions_deg: ArrayLike | None = None,
        roller_angles_deg: ArrayLike = 0.0,
        roller_radius: ArrayLike | None = None,
        pivots: ArrayLike | None = None,
    ) -> Self:
        """Any layout: each argument is one number or one per wheel, pivots one (x, y) per wheel.

        Without `directions_deg` the wheels are tangential, b = a + 90 deg.
        """
        azimuth = np.radians(np.atleast_1d(np.asarray(azimuths_deg, dtype=np.float64)))
        n = azimuth.size
        if directions_deg is None:
            direction = azimuth + np.pi / 2
        else:
            direction = np.radians(per_wheel("directions_deg", directions_deg, n))
        return cls(
            azimuth,
            per_wheel("distance", distance, n),
            direction,
            per_wheel("wheel_radius", wheel_radius, n),
            np.radians(per_wheel("roller_angles_deg", roller_angles_deg, n)),
            None if roller_radius is None else per_wheel("roller_radius", roller_radius, n),
            None if pivots is None else np.asarray(pivots, dtype=np.float64),
        )

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if value is not None:
                object.__setattr__(self, field.name, read_only(np.array(value, dtype=np.float64)))
        check_wheels(self)
        pseudo_inverse(self.jacobian, self.reach)

    @property
    def wheels(self) -> int:
        """How many wheels, n."""
        return self.azimuth.size

    @property
    def reach(self) -> float:
        """Distance of the farthest wheel, which makes turning and moving comparable; never 0."""
        return float(self.distance.max()) or 1.0

    @cached_property
    def rolling_radius(self) -> Array:
        """(n,) m, r cos(gamma): how far along its push a wheel rolls per radian."""
        return read_only(self.wheel_radius * np.cos(self.roller_angle))

    @cached_property
    def contact(self) -> Array:
        """(n, 2) m, the contact points p in the body frame."""
        return read_only(self.distance[:, None] * unit(self.azimuth))

    @cached_property
    def jacobian(self) -> Array:
        """(n, 3) G: rows (fx, fy, px fy - py fx), body twist to speed along each wheel's push."""
        return read_only(rows(unit(self.direction + self.roller_angle), self.contact))

    @cached_property
    def transverse(self) -> Array:
        """(n, 3) H: rows like G's with rot90(f), body twist to speed across each wheel's push."""
        return read_only(rows(rot90(self.jacobian[:, :2]), self.contact))

    @cached_property
    def inverse_jacobian(self) -> Array:
        """(3, n) G+: speeds along the pushes to the body twist, by least squares."""
        return read_only(pseudo_inverse(self.jacobian, self.reach))

    def wheel_speeds(self, twist: ArrayLike, steering_rates: ArrayLike | None = None) -> Array:
        """Inverse kinematics: the (n,) rad/s with which the wheels roll without slip.

        `twist` is (vx, vy, omega) in m/s and rad/s, body frame. `steering_rates` are the legs'
        turning rates relative to the base, rad/s; they need `pivots`.
        """
        rolling = self.jacobian @ vector("twist", twist, 3)
        return (rolling + self._steering(self.jacobian, steering_rates)) / self.rolling_radius

    def twist(
        self,
        wheel_speeds: ArrayLike,
        weights: ArrayLike | None = None,
        steering_rates: ArrayLike | None = None,
    ) -> Array:
        """Forward kinematics: (vx, vy, omega) in the body frame that fits the wheels best.

        `weights` are how much each wheel's speed in m/s is trusted, 1/variance; 0 leaves it out.
        """
        rolling = self._rolling(wheel_speeds, steering_rates)
        if weights is None:
            return self.inverse_jacobian @ rolling
        trust = vector("weights", weights, self.wheels)
        if not (np.isfinite(trust) & (trust >= 0)).all() or not trust.any():
            raise ValueError(f"weights must be finite, >= 0 and not all 0: got {trust.tolist()}")
        return pseudo_inverse(self.jacobian, self.reach, trust) @ rolling

    def slip_residual(
        self,
        wheel_speeds: ArrayLike,
        gyro: float | None = None,
        steering_rates: ArrayLike | None = None,
    ) -> Array:
        """What the wheels say less what their best twist says, (n,) m/s: e = (I - G G+) u.

        Zero when the wheels agree: n - 3 degrees of freedom, blind to wheels that slip alike.
        With the `gyro`'s yaw rate, the row (0, 0, 1), an (n+1)th entry follows: the wheels'
        omega less the gyro's, rad/s, which tells of slip even when n = 3.
        """
        rolling = self._rolling(wheel_speeds, steering_rates)
        fit = self.inverse_jacobian @ rolling
        residual = rolling - self.jacobian @ fit
        return residual if gyro is None else np.append(residual, fit[2] - gyro)

    def roller_speeds(self, twist: ArrayLike, steering_rates: ArrayLike | None = None) -> Array:
        """(n,) rad/s of the rollers on the floor, positive when they roll to rot90(b).

        Source: Garcia-Sillas et al. (2015), eqs. (20) to (22), for any layout.
        """
        if self.roller_radius is None:
            raise ValueError("no roller_radius is known: give roller_radius= to OmniBase.general")
        across = rows(rot90(unit(self.direction)), self.contact)
        speed = across @ vector("twist", twist, 3) + self._steering(across, steering_rates)
        return speed / (self.roller_radius * np.cos(self.roller_angle))

    def _rolling(self, wheel_speeds: ArrayLike, steering_rates: ArrayLike | None) -> Array:
        """(n,) m/s along the pushes that the base's own motion must account for."""
        speeds = vector("wheel_speeds", wheel_speeds, self.wheels)
        return self.rolling_radius * speeds - self._steering(self.jacobian, steering_rates)

    def _steering(self, along: Array, rates: ArrayLike | None) -> Array:
        """(n,) m/s that the legs' turning about their pivots adds along (n, 3) rows."""
        if rates is None:
            return np.zeros(self.wheels)
        if self.pivot is None:
            raise ValueError("steering_rates need pivots: give pivots= to OmniBase.general")
        lever = rows(along[:, :2], self.contact - self.pivot)[:, 2]
        return lever * vector("steering_rates", rates, self.wheels)


def unit(angle: Array) -> Array:
    """(n, 2) unit vectors at (n,) angles."""
    return np.column_stack((np.cos(angle), np.sin(angle)))


def rot90(vectors: Array) -> Array:
    """(n, 2) vectors turned a quarter to the left."""
    return np.column_stack((-vectors[:, 1], vectors[:, 0]))


def rows(along: Array, arm: Array) -> Array:
    """(n, 3) rows that give a twist's speed at the (n, 2) points `arm` along (n, 2) vectors."""
    moment = arm[:, 0] * along[:, 1] - arm[:, 1] * along[:, 0]
    return np.column_stack((along, moment))


def pseudo_inverse(jacobian: Array, reach: float, weights: Array | None = None) -> Array:
    """(3, n) least-squares inverse (G' W G)^-1 G' W; ValueError when some motion is left free.

    The third column is measured in units of `reach`, so that the test of the rank means the same
    for a toy and for a lorry.
    """
    scale = np.array((1.0, 1.0, reach))
    root = np.ones(len(jacobian)) if weights is None else np.sqrt(weights)
    left, size, right = np.linalg.svd(root[:, None] * jacobian / scale, full_matrices=False)
    if size[2] <= RANK_TOLERANCE * size[0]:
        raise ValueError(free_motion(jacobian[root > 0], right[2] / scale))
    inverse: Array = (right.T / size) @ left.T * root / scale[:, None]
    # One step of Newton's: of 20,000 random layouts 7 missed 1e-12 without it, none with it.
    return inverse + (np.eye(3) - inverse @ jacobian) @ inverse


def free_motion(jacobian: Array, twist: Array) -> str:
    """Why no wheel drives this (3,) body twist, and what to do about it."""
    fx, fy = jacobian[:, 0], jacobian[:, 1]
    if (np.abs(fx[:1] * fy - fy[:1] * fx) <= RANK_TOLERANCE).all():
        return "all wheels push along parallel lines (rank < 3): turn the direction of one of them"
    x, y = np.round((-twist[1] / twist[2], twist[0] / twist[2]), 3) + 0.0  # + 0.0: no -0
    return (
        f"the wheels push along lines that all meet at ({x:g}, {y:g}) m, so none turns the base "
        "about it (rank < 3): turn one wheel's direction (tangential: azimuth + 90 deg)"
    )


def per_wheel(name: str, values: ArrayLike, wheels: int) -> Array:
    """(n,) numbers from one for all wheels or one for each."""
    return vector(name, np.full(wheels, values) if np.ndim(values) == 0 else values, wheels)


def vector(name: str, values: ArrayLike, size: int) -> Array:
    """(size,) float64 of these values; ValueError when they are not as many."""
    array = np.asarray(values, dtype=np.float64)
    if array.shape != (size,):
        raise ValueError(f"{name} must be {size} numbers: got shape {array.shape}")
    return array


def read_only(array: Array) -> Array:
    """The same array, from now on closed to writing."""
    array.flags.writeable = False
    return array


def check_wheels(base: OmniBase) -> None:
    """Raise ValueError for the first thing that no wheel can have."""
    n = base.wheels
    if n < 3:
        raise ValueError(f"{n} wheels cannot drive vx, vy and omega: give 3 or more azimuths")
    for field in fields(base):
        values = getattr(base, field.name)
        if values is None:
            continue
        shape = (n, 2) if field.name == "pivot" else (n,)
        if values.shape != shape:
            raise ValueError(f"{field.name} must have shape {shape}: got {values.shape}")
        if not np.isfinite(values).all():
            raise ValueError(f"{field.name} must be finite: got {values.tolist()}")
    for name in ("wheel_radius", "roller_radius"):
        radius = getattr(base, name)
        if radius is not None and not (radius > 0).all():
            raise ValueError(f"{name} must be positive, in metres: got {radius.tolist()}")
    if (base.distance < 0).any():
        raise ValueError(f"distance must not be negative: got {base.distance.tolist()}")
    if (np.cos(base.roller_angle) < ROLLER_TOLERANCE).any():
        raise ValueError(
            "roller angles must lie within +-90 deg (omni 0, mecanum +-45): "
            f"got {np.degrees(base.roller_angle).tolist()}"
        )
