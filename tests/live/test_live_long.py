"""The base station for long, under load, and under fire."""

import gc
import json
import random
import resource
import time
import tracemalloc

import pytest
from stations import Talk, cpu, station

from soccersim import Simulation, load_scenario
from soccersim.live.catalogue import Catalogue
from soccersim.live.frame import Framer
from soccersim.live.messages import Command

WORDS = [kind.__name__.lower() for kind in Command]
KEYS = [
    *("do", "id", "robot", "x", "y", "heading", "vx", "vy", "omega", "speed", "on", "fx", "fy"),
    *("loop", "kp", "ki", "kd", "factor", "ticks", "scenario", "home", "away", "seed", "call"),
    *("side", "more", "__proto__", ""),
]
VALUES = [
    *(None, True, False, 0, 1, -1, 3, 99, 2**53, 10**40, 0.5, -7.25, 1e308, "", "home", "corner"),
    *("stop", "start", "goal", "position", "wheel", "NaN", "\ud800", "x" * 400, "../x.yaml"),
    *([], [[]], {}, {"do": "go"}, [0] * 50),
]


def nonsense(chance):
    """A message as nobody should send it, now and then by chance one that is right."""
    kind = chance.random()
    if kind < 0.1:
        return bytes(chance.randrange(256) for _ in range(chance.randrange(60)))
    if kind < 0.25:
        return "".join(chr(chance.randrange(32, 0x2FF)) for _ in range(chance.randrange(80)))
    told = {chance.choice(KEYS): chance.choice(VALUES) for _ in range(chance.randrange(8))}
    if kind < 0.95:
        told["do"] = chance.choice([word for word in WORDS if word != "open"])
    text = json.dumps(told)
    if kind < 0.5:
        at = chance.randrange(len(text))
        text = text[:at] + chance.choice(['"', "}", "[", "1e999", "\\u0000", "NaN", ""]) + text[at:]
    return text


def bombard(scenario, count, seed):
    """So many such messages; every one is answered, and the simulation goes on."""
    chance, answers = random.Random(seed), {"done": 0, "wrong": 0, "pong": 0}
    with station(scenario) as (gate, session), Talk(gate) as talk:
        session.loop.call_soon_threadsafe(lambda: None)
        for _ in range(count):
            answers[talk.raw(nonsense(chance))["type"]] += 1
        assert talk.say(do="resume")["type"] == "done"
        assert talk.say(do="open", scenario=scenario)["type"] == "done"
        first = talk.picture()[0]
        while talk.picture()[0] < first + 5:
            pass
        assert session._thread.is_alive()
        assert not session.play.over
    assert sum(answers.values()) == count
    assert answers["wrong"] > count / 2
    return answers


@pytest.mark.parametrize("scenario", ["training", "friendly-match"])
def test_nonsense_is_answered(scenario):
    bombard(scenario, 150, seed=1)


@pytest.mark.slow
@pytest.mark.parametrize("scenario", ["training", "friendly-match"])
def test_ten_thousand_pieces_of_nonsense(scenario):
    bombard(scenario, 500, seed=2)
    gc.collect()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    bombard(scenario, 10_000, seed=3)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 20_000  # KiB


@pytest.mark.slow
def test_wrong_messages_leave_the_digest_as_it_is():
    chance = random.Random(4)
    with station("training") as (gate, session), Talk(gate) as talk:
        while not session.play.digest:
            text = nonsense(chance)
            if isinstance(text, bytes) or len(text) > 10:
                talk.raw(b"\0" + text if isinstance(text, bytes) else text[:-1])
        digest = session.play.digest
    assert digest == Simulation(load_scenario("training")).run().digest


@pytest.mark.slow
@pytest.mark.parametrize("scenario", ["training", "kickabout"])
def test_an_hour_needs_no_more_memory_than_a_minute(scenario):
    play = Catalogue(scenario).first()
    framer = Framer(play)

    def minutes(count):
        for _ in range(count * 60 * 5):
            play.advance(play.hz // 5)
            framer.packed({})
            play.news.clear()

    minutes(2)
    gc.collect()
    tracemalloc.start()
    minutes(1)
    gc.collect()
    before = tracemalloc.get_traced_memory()[0]
    whole = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    minutes(60)
    gc.collect()
    grown = tracemalloc.get_traced_memory()[0] - before
    tracemalloc.stop()
    assert grown < 200_000
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - whole < 5_000


@pytest.mark.slow
def test_serving_ten_robots_at_50_hz_takes_less_than_15_percent_of_a_core():
    with station("kickabout") as (gate, session), Talk(gate) as talk:
        for _ in range(25):
            talk.picture()
        begun, at, count = cpu(session), time.monotonic(), 0
        while time.monotonic() < at + 10:
            talk.picture()
            count += 1
        served = (cpu(session) - begun) / (time.monotonic() - at)
        begun = time.thread_time()
        for _ in range(500):
            session._framer.packed({})
        packed = (time.thread_time() - begun) / 500 * 50
    print(f"{count / 10:.1f} pictures a second: {served:.2%} to serve, {packed:.2%} to pack")
    assert count > 450
    assert served + packed < 0.15
