"""A robot does what it last heard, within its own limits, and stops when it hears nothing."""

from math import hypot, pi

import numpy as np
import pytest
from factory import robot

from soccersim.control.orders import BLOCK, PERFECT, build_orders, forget, obey, post
from soccersim.kernel import kernel
from soccersim.spec.senses import Radio
from soccersim.state import new_command, new_estimate

HZ, DECIDE = 500, 20  # ticks a second, ticks from order to order
CONTROL = 5  # ticks from control step to control step
LIMITS = {"speed": 2.0, "acceleration": 2.5, "turn_rate": 4.0, "turn_acceleration": 10.0}
FREE = {"speed": 10.0, "acceleration": None, "turn_rate": 20.0, "turn_acceleration": None}
STEP = CONTROL / HZ  # s


@kernel
def step(orders, estimate, command, tick, dt):
    obey(orders, estimate, command, tick, dt)


class Team:
    """Robots that do at once just what their command says, and their radio."""

    def __init__(self, count=1, limits=LIMITS, seed=1, **radio):
        models = [robot(control={"limits": limits}) for _ in range(count)]
        spec = Radio(**{**PERFECT.model_dump(), **radio})
        self.orders = build_orders(models, spec, DECIDE, HZ, seed)
        self.estimate, self.command = new_estimate(count, 3), new_command(count, 3)
        self.tick = 0

    def order(self, vx=0.0, vy=0.0, omega=0.0, kick=0.0, dribble=0.0):
        packets = np.array([(vx, vy, omega, kick, dribble)] * len(self.command.kick))
        post(self.orders, packets, self.tick)

    def go(self, ticks):
        for _ in range(ticks):
            if self.tick % CONTROL == 0:
                step(self.orders, self.estimate, self.command, self.tick, 1 / HZ)
                self.estimate.twist[:] = self.command.twist
            self.estimate.pose[:, 2] += self.estimate.twist[:, 2] / HZ
            self.tick += 1
        return self.twist

    @property
    def twist(self):
        return self.command.twist[0]

    @property
    def field_velocity(self):
        vx, vy, _ = self.orders.velocity[0]
        return np.array([vx, vy])


def test_before_the_first_order_a_robot_stands():
    assert (Team().go(100) == 0).all()


def test_an_order_is_under_way_for_the_radio_s_delay():
    team = Team(limits=FREE, delay=0.03)
    team.order(1.0)
    team.go(15)
    assert (team.twist == 0).all()
    team.go(1)
    assert team.twist == pytest.approx([1, 0, 0])


def test_the_newest_of_several_orders_counts():
    team = Team(limits=FREE, delay=0.1)
    for speed in (0.1, 0.2, 0.3):
        team.order(speed)
        team.go(2)
    team.go(60)
    assert team.twist == pytest.approx([0.3, 0, 0])


def test_orders_under_way_do_not_push_each_other_out():
    team = Team(limits=FREE, delay=0.3)
    heard = []
    for k in range(20):
        team.order((k + 1) / 2)
        heard.append(round(2 * team.go(DECIDE)[0]))
    assert heard[:7] == [0] * 7
    assert heard[7:] == list(range(1, 14))  # each one, 7.5 orders later


def test_it_speeds_up_and_slows_down_as_its_limits_allow():
    team = Team()
    team.order(5.0)
    team.go(CONTROL)
    assert team.twist[0] == pytest.approx(2.5 * STEP)
    for _ in range(20):
        team.order(3.0, 4.0)
        team.go(50)
    assert team.twist == pytest.approx([1.2, 1.6, 0.0])  # its top speed, in the direction asked
    team.order(0.0)
    team.go(50)
    assert hypot(*team.twist[:2]) == pytest.approx(2.0 - 2.5 * 0.1)


def test_it_turns_as_its_limits_allow():
    team = Team()
    team.order(omega=-9.0)
    team.go(50)
    assert team.twist[2] == pytest.approx(-10.0 * 0.1)
    team.order(omega=-9.0)
    team.go(200)
    assert team.twist[2] == pytest.approx(-4.0)


def test_what_it_can_change_in_a_step_is_a_matter_of_the_field_not_of_its_front():
    """One that turns while it drives straight on needs no force, however fast its front turns."""
    team = Team(limits={**FREE, "acceleration": 2.5})
    team.order(1.0)
    team.go(300)
    team.order(-1.0, omega=pi)
    before = team.field_velocity
    for _ in range(20):
        team.go(CONTROL)
        change = hypot(*(team.field_velocity - before))
        before = team.field_velocity
        assert change <= 2.5 * STEP * (1 + 1e-9)


def test_a_twist_is_held_in_the_body_frame_so_a_turning_robot_drives_an_arc():
    team = Team(limits=FREE)
    team.order(1.0, 0.5, 2.0)
    for _ in range(40):
        team.go(CONTROL)
        assert team.twist == pytest.approx([1.0, 0.5, 2.0])


def test_lost_packets_leave_the_old_order_and_half_a_second_of_silence_stops_the_robot():
    team = Team(limits=FREE)
    team.order(1.0, kick=5.0, dribble=1.0)
    team.go(DECIDE)
    team.orders = team.orders._replace(loss=1.0)
    for _ in range(11):  # 0.48 s
        team.order(-1.0)
        team.go(DECIDE)
        assert team.twist[0] == pytest.approx(1.0)
        assert team.command.dribble[0] == 1
    team.order(-1.0)
    team.go(DECIDE + CONTROL)
    assert (team.twist == 0).all()
    assert (team.command.kick[0], team.command.dribble[0]) == (0, 0)


@pytest.mark.parametrize("loss", [0.03, 0.3])
def test_as_many_packets_are_lost_as_asked(loss):
    team = Team(limits=FREE, order_loss=loss)
    total = 3000
    arrived = 0
    for k in range(total):
        team.orders.heard[:] = -1
        team.order(1.0)
        team.go(DECIDE if k % 2 else CONTROL)
        arrived += team.orders.heard[0] >= 0
    sd = (loss * (1 - loss) / total) ** 0.5
    assert 1 - arrived / total == pytest.approx(loss, abs=4 * sd)


def test_each_robot_loses_packets_of_its_own():
    def lost(count):
        team = Team(count, order_loss=0.2)
        for _ in range(BLOCK + 50):
            team.order(1.0)
        return team.orders.chance.copy()

    alone, together = lost(1), lost(3)
    assert (alone[0] == together[0]).all()
    assert len(np.unique(together)) == 3 * BLOCK
    assert lost(2)[0, 0] != Team(1, seed=2, order_loss=0.2).orders.chance[0, 0]


def test_a_kick_is_passed_on_once_an_order():
    team = Team()
    team.order(kick=8.0)
    team.go(CONTROL)
    assert team.command.kick[0] == 8.0
    team.command.kick[0] = 0.0  # it has been made
    team.go(DECIDE - CONTROL)
    assert team.command.kick[0] == 0.0
    team.order(kick=6.0)
    team.go(CONTROL)
    assert team.command.kick[0] == 6.0


def test_a_halted_robot_brakes_and_waits_for_a_new_order():
    team = Team()
    team.order(2.0, dribble=1.0, kick=3.0)
    team.go(200)
    assert team.twist[0] == pytest.approx(1.0)
    team.orders.halted[0] = 1
    team.order(2.0, dribble=1.0, kick=3.0)
    team.go(50)
    assert team.twist[0] == pytest.approx(0.75)
    assert (team.command.kick[0], team.command.dribble[0]) == (0, 0)
    team.go(450)
    assert (team.twist == 0).all()
    team.orders.halted[0] = 0
    team.go(50)
    assert (team.twist == 0).all()
    team.order(2.0)
    team.go(50)
    assert team.twist[0] == pytest.approx(0.25)


def test_a_robot_carried_elsewhere_stands_there():
    team = Team(2, delay=0.05)
    team.order(2.0)
    team.go(300)
    team.order(2.0)
    forget(team.orders, 0)
    team.go(100)
    assert (team.command.twist[0] == 0).all()
    assert team.command.twist[1, 0] > 1.0
