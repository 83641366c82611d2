"""A scenario without a match: robots follow their plans until somebody sends them elsewhere."""

from soccersim.control.plan import TARGET, TWIST
from soccersim.geometry import rotate
from soccersim.live import messages as say
from soccersim.live.play import FOREVER, Play
from soccersim.simulation import Simulation
from soccersim.spec.scenario import Scenario


class FreePlay(Play):
    """Robots and perhaps a ball. When the run is over, it goes on: the robots hold their places."""

    def __init__(self, scenario: Scenario) -> None:
        super().__init__(scenario, Simulation(scenario))
        m = self.simulation.machine
        self.digest = ""  # of the run as the scenario has it, once that is over
        self._legs = m.progress.leg.copy()
        self._sent: dict[int, float] = {}  # robots on their way to a place, and since when
        self._planned = not m.endless
        for robot, player in enumerate(scenario.robots):
            if player.path:
                self.targets[robot] = scenario.coordinates.field_pose(player.path[0].to)

    def _run(self, ticks: int) -> None:
        simulation = self.simulation
        simulation.hurry(ticks)
        self._look()
        if simulation.done:
            simulation.collect()
            self.digest = simulation._digest.hex
            if self._planned:
                self.tell("the run is over; the robots hold their places", "end")
            simulation.done, simulation.end = False, FOREVER
            simulation.machine = simulation.machine._replace(endless=True)

    def go(self, message: say.Go) -> None:
        """One leg takes the place of the robot's plan."""
        m, robot = self.simulation.machine, message.robot
        kept = float(m.estimate.pose[robot, 2]) if message.heading is None else message.heading
        self._plan(robot, TARGET, (message.x, message.y, kept))
        loop, pose = m.position, m.estimate.pose[robot]
        loop.sums[robot], loop.last[robot] = 0.0, pose
        vx, vy, omega = m.command.twist[robot].tolist()
        loop.velocity[robot] = *rotate(vx, vy, float(pose[2])), omega  # body to field
        self.targets[robot] = message.x, message.y, kept
        self._sent[robot] = self.seconds

    def drive(self, message: say.Drive) -> None:
        """The twist, within the robot's limits."""
        limits = self.scenario.robots[message.robot].model.control.limits
        vx, vy = message.vx, message.vy
        share = max(1.0, (vx * vx + vy * vy) ** 0.5 / limits.speed)
        turn = min(max(message.omega, -limits.turn_rate), limits.turn_rate)
        self._plan(message.robot, TWIST, (vx / share, vy / share, turn))

    def halt(self, robot: int) -> None:
        """No twist."""
        self._plan(robot, TWIST, (0.0, 0.0, 0.0))

    def kick(self, message: say.Kick) -> None:
        """The plant takes a kick out of the command once it is made."""
        super().kick(message)
        self.simulation.machine.command.kick[message.robot] = message.speed

    def disarm(self, robot: int) -> None:
        """No kick any more."""
        self.simulation.machine.command.kick[robot] = 0.0

    def dribble(self, message: say.Dribble) -> None:
        """Until it is said otherwise."""
        super().dribble(message)
        self.simulation.machine.command.dribble[message.robot] = int(message.on)

    def _plan(self, robot: int, kind: int, value: tuple[float, float, float]) -> None:
        """A single leg for the robot, from the next step of control on."""
        m = self.simulation.machine
        control = self.scenario.robots[robot].model.control
        limits = control.limits
        if m.plan.pushed[robot]:  # the scenario's hand lets go, the motors take over
            m.plan.pushed[robot] = 0
            m.truth.push[robot] = 0.0
        m.plan.profiled[robot] = control.profile == "trapezoid"
        m.plan.limits[robot] = (
            *(limits.speed, limits.acceleration or 1.0),
            *(limits.turn_rate, limits.turn_acceleration or 1.0),
        )
        m.plan.dwell[robot] = round(control.arrival.dwell * self.hz)
        m.plan.kind[robot, 0], m.plan.as_written[robot, 0] = kind, 0
        m.plan.value[robot] = 0.0
        m.plan.value[robot, 0, :3] = value
        m.plan.ticks[robot, 0], m.plan.repeat[robot], m.plan.legs[robot] = FOREVER, 0, 1
        m.progress.leg[robot] = 0
        m.progress.since[robot] = m.progress.within[robot] = -1
        m.progress.motion[robot] = 0.0
        self._legs[robot] = 0
        self._sent.pop(robot, None)
        self.targets.pop(robot, None)
        self._cancel("drive", robot)

    def _look(self) -> None:
        """Tell of legs that have ended."""
        progress, plan = self.simulation.machine.progress, self.simulation.machine.plan
        for robot in (progress.leg != self._legs).nonzero()[0].tolist():
            before, self._legs[robot] = int(self._legs[robot]), progress.leg[robot]
            player = self.scenario.robots[robot]
            if robot in self._sent:
                spent = self.seconds - self._sent.pop(robot)
                off, believed = self.off_target(robot)
                text = f"there after {spent:.1f} s: {100 * off:.1f} cm off, "
                text += f"believes {100 * believed:.1f} cm"
                self.tell(f"{player.name} {text}", "reached", int(player.team == "away"))
            elif player.path:
                reached = bool(progress.ended_reached[robot])
                off, believed = self.off_target(robot) if robot in self.targets else (0.0, 0.0)
                text = f"leg {before + 1} of {len(player.path)}"
                text += f": {100 * off:.1f} cm off" if reached else " given up"
                self.tell(f"{player.name}, {text}", "reached", int(player.team == "away"))
                leg = int(progress.leg[robot])
                if leg < plan.legs[robot]:
                    pose = self.scenario.coordinates.field_pose(player.path[leg].to)
                    self.targets[robot] = pose
