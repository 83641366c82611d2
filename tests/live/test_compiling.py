"""The first start on a machine: the physics is compiled for half a minute, and all are told so."""

import threading
import time

import browser
import pytest
from stations import Talk, station

from soccersim.live import session as sessions
from soccersim.live.catalogue import Catalogue
from soccersim.live.free import FreePlay


@pytest.fixture
def compiled(monkeypatch):
    """Until this is set the first step is not ready, as if it were being compiled."""
    Catalogue("training").first().advance(1)  # so that nothing is compiled in truth
    ready, step = threading.Event(), FreePlay.advance
    ready.asked = threading.Event()

    def advance(play, ticks):
        if ticks:
            ready.asked.set()
            ready.wait(30)
        step(play, ticks)

    monkeypatch.setattr(sessions, "will_compile", lambda: not ready.is_set())
    monkeypatch.setattr(FreePlay, "advance", advance)
    yield ready
    ready.set()


def test_who_speaks_while_it_compiles_is_answered_and_sees_the_field(compiled):
    with station(moves=False) as (gate, _):
        with Talk(gate) as talk:
            why, seconds = talk.hello["waits"]
            assert why.startswith("compiling the physics, once")
            assert 0 <= seconds < 30
            assert talk.pose(talk.picture()).tolist() == [-2, 0, 0]
            told = talk.say(do="halt", robot=0)
            assert told["type"] == "wrong"
            assert "not yet: compiling the physics" in told["what"]
            assert talk.say(do="ping")["type"] == "pong"
            compiled.set()
            while talk.picture()[talk.head["tick"]] == 0:
                pass
            assert talk.say(do="halt", robot=0)["type"] == "done"
        with Talk(gate) as talk:
            assert talk.hello["waits"] is None


def test_who_ends_it_while_it_compiles_does_not_wait(compiled):
    with station(moves=False) as (_, session):
        assert compiled.asked.wait(20)
        begun = time.monotonic()
        session.end()
        assert time.monotonic() < begun + 5
        assert session._thread.is_alive()
        compiled.set()


@pytest.mark.skipif(not browser.installed(), reason="no chromium on this machine")
def test_the_page_is_there_at_once_and_becomes_live_by_itself(compiled):
    with station(moves=False) as (gate, _), browser.Browser() as chromium:
        tab = chromium.open(gate.url)
        veil = "document.getElementById('veil')"
        tab.wait(f"{veil}.textContent.startsWith('compiling the physics, once')")
        tab.wait(f"/ [1-9][0-9]* s$/.test({veil}.textContent)")
        tab.press("h", "KeyH")
        tab.wait("document.getElementById('toast').textContent.includes('not yet')")
        assert not tab.run(f"{veil}.hidden")
        compiled.set()
        tab.wait(f"{veil}.hidden && soccersim.moment.time > 0.1")
        assert tab.complaints() == []
