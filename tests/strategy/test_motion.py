"""A robot gets there soon, stops there, and goes round what is in the way: in a toy world."""

from math import cos, hypot, pi, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from toy import Robot, Toy

from soccersim.strategy import Ball, Body, Opponent, Pitch, Player, View, skills
from soccersim.strategy.motion import drive_to, pace, time_to, turn_to, wrap

place = st.floats(-6, 6)
angle = st.floats(-pi, pi)


def gone(toy, seconds, x, y, heading=None, **more):
    """The toy after its first robot has been sent somewhere."""
    return toy.play(seconds, lambda v: skills.go_to(v, v.robots[0], x, y, heading, **more))


def moving(x, y, heading, vx, vy):
    """A robot that moves already."""
    robot = Robot(x, y, heading)
    robot.vx, robot.vy, robot.asked = vx, vy, [vx, vy, 0.0]
    return robot


@settings(max_examples=40, derandomize=True)
@given(place, place, angle, angle, st.floats(-1.5, 1.5), st.floats(-1.5, 1.5))
def test_a_robot_stops_where_it_is_sent_and_does_not_overshoot(x, y, start, heading, vx, vy):
    toy = Toy([moving(0.0, 0.0, start, vx, vy)])
    robot = toy.robots[0]
    needed = time_to(toy.now().robots[0], x, y)
    gone(toy, max(needed, 2.0) + 0.9, x, y, heading)
    for _ in range(25):
        assert hypot(robot.x - x, robot.y - y) < 0.06
        assert abs(wrap(robot.heading - heading)) < 0.03
        gone(toy, 0.04, x, y, heading)
    assert hypot(robot.vx, robot.vy) < 0.05


def test_a_robot_takes_hardly_longer_than_physics_asks():
    toy = Toy([Robot(0, 0)])
    toy.play(
        20, lambda v: None if toy.robots[0].x > 5.95 else skills.go_to(v, v.robots[0], 6, 0, 0)
    )
    ideal = 2 * 3.0 / 2.2 + (6 - 3.0**2 / 2.2) / 3.0  # s: accelerate, cruise, brake
    assert ideal < toy.time < ideal + 0.6


def test_a_slower_robot_is_asked_for_what_it_can():
    slow = Body(speed=1.0, acceleration=0.5, turn_rate=1.0)
    command = skills.go_to(View(robots=()), Player(1, 0, 0, body=slow), 9, 0, 3)
    assert hypot(command.vx, command.vy) == pytest.approx(1.0)
    assert abs(command.omega) <= 1.0
    command = skills.go_to(View(robots=()), Player(1, 0, 0), 9, 0, speed=0.7)
    assert hypot(command.vx, command.vy) == pytest.approx(0.7)


@settings(derandomize=True)
@given(angle)
def test_the_command_is_in_the_bodys_frame(heading):
    command = skills.go_to(View(robots=()), Player(1, 0, 0, heading), 9, 0, heading)
    c, s = cos(heading), sin(heading)
    assert c * command.vx - s * command.vy == pytest.approx(3.0)
    assert s * command.vx + c * command.vy == pytest.approx(0.0, abs=1e-9)


def test_without_a_heading_a_robot_looks_at_the_ball():
    toy = gone(Toy([Robot(0, 0, 2.0)], ball=(5, 5)), 4, 1, 1)
    assert toy.robots[0].heading == pytest.approx(pi / 4, abs=0.02)


def test_a_robot_turns_to_a_place_the_short_way():
    toy = Toy([Robot(0, 0, 3.0)]).play(2, lambda v: skills.face(v, v.robots[0], -1, -1))
    assert toy.robots[0].heading == pytest.approx(-3 * pi / 4 + 2 * pi, abs=0.02)
    assert (toy.robots[0].x, toy.robots[0].y) == (0, 0)


def test_a_robot_that_turns_fast_brakes_before_it_is_there():
    assert turn_to(Player(1, 0, 0, -0.2), 0.0) > 0
    assert turn_to(Player(1, 0, 0, -0.2, omega=4.0), 0.0) < 0


def test_a_robot_that_moves_along_with_its_place_goes_on_so():
    player = Player(1, 2, 3, vx=1.5)
    assert drive_to(player, 2, 3, 0.0, run=(1.5, 0.0)) == pytest.approx((1.5, 0, 0))
    assert drive_to(player, 2, 3, 0.0)[0] < 0


@settings(derandomize=True)
@given(st.floats(0, 20), st.floats(0.1, 5), st.floats(0.5, 10))
def test_the_pace_lets_one_stop_in_time(far, braking, gain):
    speed = pace(far, braking, gain)
    assert speed**2 / (2 * braking) <= far * (1 + 1e-9)
    assert speed <= gain * far * (1 + 1e-9)


@pytest.mark.parametrize(
    ("start", "velocity", "stop", "seconds"),
    [
        (2.0, 0.0, True, 2 * (2.0 / 2.2) ** 0.5),  # half of it faster, half of it slower
        (2.0, 0.0, False, (2 * 2.0 / 2.2) ** 0.5),
        (9.0, 0.0, True, 3 / 2.2 + 9 / 3),
        (2.0, 2.2, True, 1.374),  # it comes at 2.2 already
        (2.0, -2.2, True, 1 + 2 * ((2.0 + 1.1) / 2.2) ** 0.5),  # a second to turn round
        (0.5, 2.2, True, 1 + 2 * (0.6 / 2.2) ** 0.5),  # it runs 0.6 m past it
        (0.0, 0.0, True, 0.0),
    ],
)
def test_the_time_to_a_place_is_that_of_school_physics(start, velocity, stop, seconds):
    player = Player(1, -start, 0, vx=velocity)
    assert time_to(player, 0, 0, stop=stop) == pytest.approx(seconds, abs=0.01)


def nearest_pass(toy, seconds, x, y, discs=(), **more):
    """How near the robot came to the centres of the opponents, or of the discs."""
    least, robot = 9.0, toy.robots[0]
    end = toy.time + seconds
    while toy.time < end and hypot(robot.x - x, robot.y - y) > 0.1:
        gone(toy, 0.04, x, y, **more)
        for ox, oy in [*((o.x, o.y) for o in toy.opponents), *discs]:
            least = min(least, hypot(ox - robot.x, oy - robot.y))
    assert hypot(robot.x - x, robot.y - y) <= 0.1
    return least


@settings(max_examples=25, derandomize=True)
@given(st.floats(-0.6, 0.6), st.floats(-3, 3), st.floats(-0.6, 0.6))
def test_a_robot_goes_round_another(y, x, target):
    toy = Toy([Robot(-5, 0)], opponents=[Opponent(x, y)])
    assert nearest_pass(toy, 6, 5, target) > 0.48


def test_two_in_a_row_and_a_wall_of_three_are_passed():
    row = [Opponent(-1, 0.1), Opponent(0.5, -0.1)]
    assert nearest_pass(Toy([Robot(-4, 0)], opponents=row), 7, 4, 0) > 0.48
    wall = [Opponent(0, y) for y in (-0.9, 0, 0.8)]
    assert nearest_pass(Toy([Robot(-4, 0)], opponents=wall), 8, 4, 0) > 0.48


def test_a_robot_goes_round_its_mates_too_and_straight_when_it_is_told_to():
    toy = Toy([Robot(-3, 0), Robot(0, 0.05)])
    mate = [(0, 0.05)]
    least = 9.0
    for _ in range(100):
        view = toy.now()
        toy.step(
            [skills.go_to(view, view.robots[0], 3, 0), skills.go_to(view, view.robots[1], 0, 0.05)]
        )
        least = min(least, hypot(toy.robots[0].x, toy.robots[0].y - 0.05))
    assert least > 0.48
    assert nearest_pass(Toy([Robot(-3, 0)]), 6, 3, 0, mate, avoid=False) < 0.07


def test_robots_that_are_off_the_field_are_no_obstacles():
    me, off = Player(1, -3, 0), Player(2, 0, 0, in_play=False)
    view = View(robots=(me, off))
    assert skills.go_to(view, me, 3, 0).vy == pytest.approx(0, abs=1e-9)


def test_a_robot_that_stands_against_another_gets_away_and_to_a_place_beside_one():
    toy = Toy([Robot(-0.49, 0)], opponents=[Opponent(0, 0)])
    assert nearest_pass(toy, 5, 3, 0) > 0.45
    toy = Toy([Robot(-3, 0)], opponents=[Opponent(0, 0)])
    gone(toy, 4, -0.5, 0)
    assert hypot(toy.robots[0].x + 0.5, toy.robots[0].y) < 0.05


def test_a_disc_is_kept_out_of_even_where_no_robot_stands():
    toy = Toy([Robot(-5, 0.2)])
    assert nearest_pass(toy, 9, 5, 0, [(0, 0)], keep_off=[(0, 0, 2)]) > 1.95


AREA = Pitch().penalty_area
FRONT, SIDE = AREA.depth - Pitch().length / 2, AREA.width / 2


@pytest.mark.parametrize(
    ("start", "target"),
    [((-9, 5), (-9, -5)), ((-5, 0), (-10, -5)), ((-5, 4), (-10, -5)), ((-10.5, -4), (-8, 3))],
)
def test_a_field_player_goes_round_its_own_penalty_area(start, target):
    toy = Toy([Robot(*start)])
    robot = toy.robots[0]
    for _ in range(200):
        gone(toy, 0.04, *target, area=False)
        assert not (robot.x < FRONT and abs(robot.y) < SIDE)
    assert hypot(robot.x - target[0], robot.y - target[1]) < 0.2


def test_a_place_in_the_area_is_moved_to_its_edge_and_a_robot_in_it_leaves():
    toy = gone(Toy([Robot(-5, 0)]), 4, -10, 1, area=False)
    assert toy.robots[0].x == pytest.approx(FRONT + 0.36, abs=0.03)
    toy = gone(Toy([Robot(-10, 0)]), 4, -5, 0, area=False)
    assert toy.robots[0].x == pytest.approx(-5, abs=0.03)


def test_a_robot_on_the_edge_of_the_board_goes_round_inside():
    toy = Toy([Robot(-3, 7.5)], opponents=[Opponent(0, 7.4)])
    highest = 0.0
    for _ in range(120):
        gone(toy, 0.04, 3, 7.5)
        highest = max(highest, toy.robots[0].y)
    assert highest < 7.0 + 1.0 - 0.24
    assert toy.robots[0].x == pytest.approx(3, abs=0.05)


def test_a_ball_that_is_not_seen_is_nobodys_concern():
    view = View(robots=(Player(1, 0, 0),), ball=None)
    player = view.robots[0]
    still = skills.intercept(view, player), skills.shoot(view, player)
    assert all((c.vx, c.vy, c.omega, c.kick) == (0, 0, 0, 0) for c in still)
    assert skills.quickest(view, view.robots) is None
    assert skills.quickest(View(robots=(), ball=Ball(0, 0)), ()) is None
