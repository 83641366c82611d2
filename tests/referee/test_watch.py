"""What is seen every tick: touches in order, who had the ball before, contacts of opponents."""

import pytest
from whistle import Rig

from soccersim.referee.phases import Phase
from soccersim.referee.touches import Touches
from soccersim.referee.watch import GOAL, GOAL_LINE, LOG, TOUCH_LINE


def seen(rig):
    """All touches so far."""
    history = Touches(rig.referee.scene)
    return history.read(rig.watch)


def fresh(x=0.0, y=0.0):
    rig = Rig(stuck_time=300.0).away().run(0.01)
    rig.put("ball", x, y)
    return rig


def test_a_touch_is_noted_once_with_its_place():
    rig = fresh(1.0, 2.0)
    rig.beside("home-4")
    rig.run(0.5)
    (touch,) = seen(rig)
    assert touch.robot == rig.row("home-4")
    assert (touch.x, touch.y) == (1.0, 2.0)
    assert touch.before == -1


@pytest.mark.parametrize(("gap", "touches"), [(0.0049, 1), (0.0051, 0)])
def test_five_millimetres_are_a_touch(gap, touches):
    rig = fresh()
    rig.beside("home-4", gap=gap)
    rig.run(0.1)
    assert len(seen(rig)) == touches


def test_who_has_the_ball_keeps_it_while_he_touches_it():
    rig = fresh()
    rig.beside("home-4", -1, 0)
    rig.run(0.1)
    rig.beside("away-3", 1, 0)
    rig.run(0.1)
    assert [touch.robot for touch in seen(rig)] == [rig.row("home-4")]
    rig.put("home-4", -6, 0)
    rig.run(0.1)
    first, then = seen(rig)
    assert then.robot == rig.row("away-3")
    assert then.before == first.robot


def test_the_way_a_ball_rolled_free_counts_from_the_last_touch():
    rig = fresh()
    rig.beside("home-4")
    rig.run(0.1)
    rig.put("home-4", -6, 0)
    rig.roll(2.0, 0.0)
    rig.beside("home-5", 1, 0)
    rig.run(0.1)
    assert seen(rig)[-1].free == pytest.approx(2.0)


def test_who_catches_the_ball_anew_is_noted_again():
    rig = fresh()
    for seconds, touches in ((0.1, 1), (0.3, 2)):
        rig.beside("home-4")
        rig.run(0.05)
        rig.put("home-4", -6, 0)
        rig.run(seconds)
        rig.beside("home-4")
        rig.run(0.05)
        assert len(seen(rig)) == touches


def test_of_two_that_come_at_once_the_nearer_one_has_it():
    for near, far in (("home-4", "away-3"), ("away-3", "home-4")):
        rig = fresh()
        rig.beside(near, -1, 0, gap=0.001)
        rig.beside(far, 1, 0, gap=0.002)
        rig.run(0.05)
        assert [touch.robot for touch in seen(rig)] == [rig.row(near)]


def test_more_touches_than_the_log_holds_lose_the_oldest_only():
    rig = fresh()
    for k in range(LOG + 10):
        rig.put("home-4", -6, 0)
        rig.put("away-3", 6, 0)
        rig.beside(("home-4", "away-3")[k % 2])
        rig.step()
    touches = seen(rig)
    assert len(touches) == LOG
    assert touches[-1].robot == rig.row("away-3")


@pytest.mark.parametrize("end", [-1, 1])
@pytest.mark.parametrize(
    ("x", "y", "where"), [(11.2, 0.5, GOAL), (11.2, 2.0, GOAL_LINE), (3.0, 7.2, TOUCH_LINE)]
)
def test_where_the_ball_went_out_is_noted_until_the_referee_has_ruled(end, x, y, where):
    rig = fresh()
    rig.to_start()
    rig.put("ball", end * x, end * y)
    rig.step()
    assert list(rig.watch.out[1:4]) == [where, end * x, end * y]
    rig.put("ball", 0, 0)
    rig.run(0.02)
    assert rig.watch.out[1] == where
    rig.until(lambda: rig.phase is Phase.STOP).to_start()
    assert rig.watch.out[0] == -1


def test_shoving_counts_only_within_one_contact():
    rig = fresh(0.0, -6.0)
    for _ in range(4):
        rig.put("home-4", 0.0, 3.0, 0, 0.5)
        rig.put("away-3", 0.48, 3.0, 0, 0.5)
        rig.run(0.4)
        rig.put("home-4", -2.0, 3.0)
        rig.run(0.3)
    assert rig.watch.pushed[0] == -1
    assert max(abs(rig.watch.shove)) == pytest.approx(0.2)


def test_every_contact_begins_anew_at_start():
    rig = Rig().away().run(9.0)
    rig.beside("home-4", -1, 0)
    rig.run(0.1)
    rig.beside("home-4", -1, 1)
    rig.to_start().run(0.1)
    assert tuple(rig.watch.caught[rig.row("home-4")]) == rig.place("home-4")
    assert len(seen(rig)) == 2
