"""A planar arm of three links on motorised joints: on a fixed base, or carried by a robot."""

from collections.abc import Iterator
from math import radians
from typing import TYPE_CHECKING, Annotated, Literal

from pydantic import Field as Key
from pydantic import model_validator

from soccersim.kinematics import PlanarArm
from soccersim.spec.base import Name, NonNegative, Number, Pose, Positive, Share, Spec
from soccersim.spec.frame import Coordinates
from soccersim.spec.validate import Fault

if TYPE_CHECKING:
    from soccersim.spec.scenario import Scenario

Length = Annotated[float, Key(ge=0.01, le=10)]
Three = Annotated[tuple[Length, Length, Length], Key(strict=False)]
Angles = Annotated[tuple[Number, Number, Number], Key(strict=False)]


class Joint(Spec):
    """The drive of each joint: a limited torque, commanded by a PID on the joint's angle.

    The gains are per unit of the inertia that the joints turn at that moment, so that they suit
    short arms and long ones: kp = w2 and kd = 2 w give a bandwidth of w rad/s.
    """

    kp: NonNegative = 900.0
    """1/s2."""
    ki: NonNegative = 3000.0
    """1/s3."""
    kd: NonNegative = 60.0
    """1/s, on the measured rate."""
    torque: Positive = 20.0
    """The most a joint can give, N m (estimate)."""
    friction: NonNegative = 0.5
    """1/s: viscous friction, per unit of the inertia turned with the arm stretched (estimate)."""
    speed: Positive = 2.0
    """rad/s of the joint that turns farthest."""
    acceleration: Positive = 8.0
    """rad/s2 of the same."""


class Reach(Spec):
    """A pose of the tip to go to and hold."""

    to: Pose
    """x, y of the tip and direction of the last link, counter-clockwise, seen from the arm's base;
    in the scenario's units."""
    elbow: Literal["near", "up", "down"] = "near"
    """Which of the two solutions: the nearer one, or the elbow's angle positive or negative."""
    hold: NonNegative = 1.0
    """Seconds."""


class Guard(Spec):
    """A keeper's arm: it waits folded, and stretches to the side where a shot will pass.

    The league lets a keeper be 0.6 m wide for at most 1 s, and then rest 4 s (rulebook 2016).
    """

    folded: Angles = (150.0, -150.0, 150.0)
    """Joint angles at rest, degrees; for a stretch to the other side all signs change."""
    stretched: Angles = (85.0, -10.0, -15.0)
    """Joint angles to block on the left, degrees."""
    covers: Positive = 0.35
    """How far to the side the stretched arm reaches, m from the robot's centre."""
    body: Positive = 0.25
    """What the robot covers by itself, m to each side."""
    sees: Positive = 0.6
    """Seconds before the ball is there at which the keeper acts (estimate)."""
    longest: Positive = 1.0
    """Seconds stretched at most."""
    rest: NonNegative = 4.0
    """Seconds folded after that."""


class Arm(Spec):
    """Three links in a plane parallel to the floor, so that no weight pulls at the joints."""

    name: Name
    lengths: Three
    """m, from the base to the tip."""
    on: Name | None = None
    """The robot that carries it; null: it stands on the floor."""
    base: Pose = (0.0, 0.0, 0.0)
    """x, y and direction of the first joint's zero: m and degrees in the robot's body frame, or,
    on the floor, in the scenario's units and frame."""
    start_deg: Angles = (0.0, 0.0, 0.0)
    """Joint angles at the start."""
    mass_per_length: Annotated[float, Key(ge=0.001, le=1000)] = 1.0
    """kg/m of each link (estimate)."""
    thickness: Annotated[float, Key(ge=0.001, le=1)] = 0.03
    """m."""
    elasticity: Share = 0.2
    """Of the ball's bounce off a link (estimate)."""
    joint: Joint = Joint()
    reaches: Annotated[tuple[Reach, ...], Key(strict=False, max_length=1000)] = ()
    """Where the tip shall go, one pose after the other."""
    guard: Guard | None = None
    """Instead of reaches: block shots. Needs a robot that carries the arm, and a ball."""

    @property
    def kinematics(self) -> PlanarArm:
        """The arm in metres and radians."""
        return PlanarArm(self.lengths)

    def base_pose(self, at: Coordinates) -> tuple[float, float, float]:
        """The first joint, SI: in the carrier's body frame, or on the field."""
        if self.on:
            return self.base[0], self.base[1], radians(self.base[2])
        return at.field_pose(self.base)

    @model_validator(mode="after")
    def _one_task(self) -> "Arm":
        if self.guard and self.reaches:
            raise Fault("has `reaches` too: keep one of them", at=("guard",))
        if self.guard and self.on is None:
            raise Fault("needs a robot that carries the arm: set `on`", at=("guard",))
        return self


def unreachable(scenario: "Scenario") -> Iterator[Fault]:
    """What arms cannot do: stand on nobody, reach too far, guard against nothing."""
    names = [player.name for player in scenario.robots]
    for i, arm in enumerate(scenario.arms):
        if arm.on is not None and arm.on not in names:
            yield Fault(f"there is no robot `{arm.on}`", at=("arms", i, "on"))
        if arm.guard and scenario.ball is None:
            yield Fault("needs a `ball`", at=("arms", i, "guard"))
        for k, reach in enumerate(arm.reaches):
            problem = arm.kinematics.reach_problem(scenario.coordinates.local(reach.to))
            if problem:
                yield Fault(f"{problem} (m)", at=("arms", i, "reaches", k, "to"))
    taken = [arm.name for arm in scenario.arms]
    for i, name in enumerate(taken):
        if taken.index(name) < i:
            at = ("arms", i, "name")
            yield Fault(f"`{name}` is taken by arms.{taken.index(name)}", at=at)
