"""A match that must be alone has its machine to itself, and does not wait for ever."""

import os
import threading
import time

import pytest

from soccersim.regress.room import room

pytestmark = pytest.mark.skipif(os.name != "posix", reason="locks")


@pytest.fixture
def play(tmp_path, monkeypatch):
    """Plays a match in a thread; what happens is in play.told."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))

    def begin(name, alone=False, wanted=lambda: True):
        over = threading.Event()

        def match():
            with room(alone, wanted) as here:
                begin.told.append(f"{name} begins" if here else f"{name} unwanted")
                over.wait(10)
            begin.told.append(f"{name} ends")

        thread = threading.Thread(target=match)
        thread.start()
        time.sleep(0.15)

        def end():
            over.set()
            thread.join()
            time.sleep(0.15)

        return end

    begin.told = []
    return begin


def test_who_is_to_be_alone_waits_for_the_others_and_the_next_wait_for_him(play):
    one, two = play("one"), play("two")
    alone = play("alone", alone=True)
    three = play("three")
    assert play.told == ["one begins", "two begins"]
    one()
    assert play.told[2:] == ["one ends"]
    two()
    assert play.told[3:] == ["two ends", "alone begins"]
    alone()
    assert play.told[5:] == ["alone ends", "three begins"]
    three()


def test_who_is_not_wanted_any_more_waits_no_longer(play):
    one, asked = play("one"), [True]
    alone = play("alone", alone=True, wanted=lambda: asked[0])
    asked[0] = False
    alone()
    assert play.told == ["one begins", "alone unwanted", "alone ends"]
    two = play("two")
    assert play.told[3:] == ["two begins"]
    one()
    two()
