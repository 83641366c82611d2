"""The base station over its own line: what is told, what is obeyed, who may not come in."""

import http.client
import json
import socket
import time
from contextlib import ExitStack

import numpy as np
import pytest
from stations import Talk, cpu, station
from websockets.exceptions import InvalidStatus

from soccersim import Simulation, load_scenario
from soccersim.live.gate import Gate, is_loopback
from soccersim.live.hub import CROWD
from soccersim.live.station import bound
from soccersim.problems import InputError


@pytest.fixture(scope="module")
def running():
    with station() as (gate, session):
        yield gate, session


@pytest.fixture
def talk(running):
    with Talk(running[0]) as talk:
        talk.say(do="open", scenario="training")
        talk.say(do="speed", factor=1.0)
        yield talk


def get(gate, path="/", method="GET", **headers):
    line = http.client.HTTPConnection("127.0.0.1", gate.port, timeout=5)
    line.putrequest(method, path, skip_host=True)
    for name, value in {"Host": f"127.0.0.1:{gate.port}", **headers}.items():
        line.putheader(name, value)
    line.endheaders()
    answer = line.getresponse()
    body = answer.read().decode()
    line.close()
    return answer.status, body, answer.headers


def test_page_comes_whole_and_asks_for_nothing_from_elsewhere(running):
    status, body, headers = get(running[0])
    assert status == 200
    assert "</html>" in body
    assert "{{" not in body
    assert "http:" not in body.replace("http://www.w3.org", "")
    assert "default-src 'none'" in headers["Content-Security-Policy"]
    assert "frame-ancestors 'none'" in headers["Content-Security-Policy"]
    assert headers["Referrer-Policy"] == "no-referrer"
    assert get(running[0], "/else")[0] == 404


def test_click_moves_the_robot_within_150_ms_and_it_arrives(talk, running):
    goal = (0.5, 0.8)
    talk.say(do="speed", factor=8.0)
    while talk.pose(talk.picture())[0] < -1.03:  # on its way to its place
        pass
    time.sleep(0.1)
    talk.say(do="speed", factor=1.0)
    times = []
    for x, y in (0.3, 0.4), (0.2, 0.0), goal:  # thrice: this machine may be busy
        start, asked = talk.pose(talk.picture())[:2], time.monotonic()
        assert talk.say(do="go", robot=0, x=x, y=y, heading=0.0)["type"] == "done"
        while np.hypot(*(talk.pose(talk.picture())[:2] - start)) < 0.001:
            assert time.monotonic() < asked + 5
        times.append(time.monotonic() - asked)
        if len(times) < 3:
            talk.say(do="halt", robot=0)
            time.sleep(0.5)
            talk.frames.clear()
            while talk.picture()[0] < running[1].play.tick - 20:  # those of the pause
                pass
    assert min(times) < 0.15
    talk.say(do="speed", factor=8.0)
    while np.hypot(*(talk.pose(talk.picture())[:2] - goal)) > 0.05:
        assert time.monotonic() < asked + 15


def test_answers_do_not_wait_for_one_another(talk):
    """Unless asyncio knows the socket for TCP, every second answer takes 40 ms."""
    times = []
    for _ in range(15):
        asked = time.monotonic()
        talk.say(do="gains", robot=0, loop="heading", kp=4.0, ki=0.0, kd=0.0)
        times.append(time.monotonic() - asked)
        time.sleep(0.03)
    assert sorted(times)[7] < 0.015


def test_a_foreign_page_is_refused(running):
    gate = running[0]
    for origin in ("http://evil.example", "null", f"http://127.0.0.1:{gate.port + 1}", "http://"):
        with pytest.raises(InvalidStatus, match="403"):
            Talk(gate, origin=origin)
        assert get(gate, Origin=origin)[0] == 403


def test_a_name_that_was_made_to_lead_here_is_refused(running):
    gate = running[0]
    for host in ("evil.example", f"evil.example:{gate.port}", "127.0.0.1", "127.0.0.1:1", ""):
        assert get(gate, Host=host)[0] == 403
    for host in (f"localhost:{gate.port}", f"LOCALHOST:{gate.port}"):
        assert get(gate, Host=host)[0] == 200


def test_two_hosts_in_a_request_are_none(running):
    gate = running[0]
    with socket.create_connection(("127.0.0.1", gate.port), 5) as line:
        good = f"Host: 127.0.0.1:{gate.port}\r\n"
        line.sendall(f"GET / HTTP/1.1\r\n{good}Host: evil.example\r\n\r\n".encode())
        assert b" 400 " in line.recv(1000)


def test_other_methods_and_rubbish_end_their_line_only(running):
    gate = running[0]
    for rubbish in (b"POST / HTTP/1.1\r\n\r\n", b"\x16\x03\x01\x02", b"GET\r\n\r\n", b""):
        with socket.create_connection(("127.0.0.1", gate.port), 5) as line:
            line.sendall(rubbish)
            line.shutdown(socket.SHUT_WR)
            line.recv(1000)
    assert get(gate)[0] == 200


def test_a_token_is_needed_where_others_can_come():
    with station(host="0.0.0.0") as (gate, _):
        assert len(gate.token) > 20
        assert gate.url.endswith(f"?token={gate.token}")
        assert get(gate)[0] == 403
        assert get(gate, "/?token=" + "x" * len(gate.token))[0] == 403
        assert get(gate, "/?token=%C3%A9")[0] == 403
        assert get(gate, f"/?token={gate.token}")[0] == 200
        with pytest.raises(InvalidStatus, match="403"):
            Talk(gate)
        query = f"?token={gate.token}"
        with pytest.raises(InvalidStatus, match="403"):
            Talk(gate, query, origin="http://evil.example")
        with Talk(gate, query) as talk:
            assert talk.say(do="ping")["type"] == "pong"


def test_gate_knows_this_computer():
    assert all(map(is_loopback, ("127.0.0.1", "127.9.9.9", "::1", "localhost")))
    assert not any(map(is_loopback, ("0.0.0.0", "::", "192.168.1.2", "example.org", "")))
    assert Gate("::1", 5).url == "http://[::1]:5/"
    assert "0.0.0.0" not in Gate("0.0.0.0", 5, "x").url
    assert Gate("::1", 5).refusal("/", {"Host": "[::1]:5"}, None) == ""


def test_port_in_use_is_one_line(running):
    with pytest.raises(InputError, match=r"in use.*--port 0"):
        bound("127.0.0.1", running[0].port)
    with pytest.raises(InputError, match="no address of this computer"):
        bound("203.0.113.7", 0)


def test_every_bad_message_is_answered(talk):
    for bad, why in (
        ("", "JSON"),
        ("[]", "object"),
        ("{}", "discriminator"),
        ('{"do":"fly"}', "tags"),
        ('{"do":"go","robot":0}', "x"),
        ('{"do":"go","robot":"0","x":1,"y":1}', "robot"),
        ('{"do":"go","robot":true,"x":1,"y":1}', "robot"),
        ('{"do":"go","robot":0,"x":NaN,"y":1}', "x"),
        ('{"do":"go","robot":0,"x":1e400,"y":1}', "x"),
        ('{"do":"go","robot":0,"x":50,"y":1}', "floor ends"),
        ('{"do":"go","robot":7,"x":1,"y":1}', "there are 4"),
        ('{"do":"pause","more":1}', "more"),
        ('{"do":"speed","factor":1000}', "16"),
        ('{"do":"open","scenario":"../../etc/passwd"}', "not one of those"),
        ('{"do":"open","scenario":"./x.yaml"}', "not one of those"),
        ('{"do":"referee","call":"stop"}', "none without a match"),
        ('{"do":"kick","robot":3,"speed":3}', "no kicker"),
        ('{"do":"release","robot":0}', "without a match"),
        ('{"do":"gains","robot":3,"loop":"wheel","kp":1,"ki":1}', "no loop"),
        ("[" * 1900, "JSON"),
        ('{"do":"\\ud800"}', ""),
        ('{"a' + "b" * 1500 + '":1}', ""),
        ("x" * 3000, "at most 2000"),
        (b"\x00\xff", "messages are text"),
    ):
        told = talk.raw(bad)
        assert told["type"] == "wrong", bad
        assert why in told["what"], (bad[:60], told)
        assert len(told["what"]) < 400
        assert "\n" not in told["what"]
    assert talk.raw('{"do":"fly","id":17}')["id"] == 17


def test_what_is_much_too_long_ends_its_line_only(running, talk):
    with Talk(running[0]) as other, pytest.raises(Exception, match="1009"):
        other.raw("x" * 100_000)
    assert talk.say(do="ping")["type"] == "pong"


def test_two_browsers_see_the_same_and_both_may_steer(running, talk):
    with Talk(running[0]) as other:
        talk.say(do="pause")
        tick = other.say(do="step", ticks=7)["tick"]
        wanted = talk.say(do="step", ticks=3)["tick"]
        assert wanted == tick + 3
        for each in (talk, other):
            while (frame := each.picture())[each.head["tick"]] != wanted:
                assert frame[each.head["tick"]] < wanted
            assert frame[each.head["viewers"]] == 2
            assert frame[each.head["paused"]] == 1
        other.say(do="gains", robot=0, loop="heading", kp=2.5, ki=0.0, kd=0.0)
        assert talk.until("gains")["gains"][0]["heading"] == [2.5, 0, 0]
        other.say(do="resume")


def test_a_crowd_is_let_in_up_to_a_point(running):
    with ExitStack() as crowd:
        for _ in range(CROWD):
            crowd.enter_context(Talk(running[0]))
        with pytest.raises(InvalidStatus, match="503"):
            Talk(running[0])
    with Talk(running[0]) as talk:
        assert talk.say(do="ping")["type"] == "pong"


def test_pace_is_the_clocks_times_the_speed(talk):
    talk.say(do="speed", factor=4.0)
    time.sleep(0.1)
    frames = [talk.picture() for _ in range(30)]
    ticks = frames[-1][talk.head["tick"]] - frames[0][talk.head["tick"]]
    assert 0.6 < ticks / 500 / (29 / 50) / 4 < 1.5
    talk.say(do="speed", factor=1.0)


def test_watching_and_bad_messages_leave_the_run_as_it_is(talk, running):
    """The digest of the run that the page shows is that of the same run without any page."""
    session = running[1]
    talk.say(do="speed", factor=4.0)
    for i in range(100):
        talk.raw(json.dumps({"do": "go", "robot": 0, "x": "far", "id": i}))
    deadline = time.monotonic() + 20
    while not session.play.digest:
        talk.hear()
        assert time.monotonic() < deadline
    assert session.play.digest == Simulation(load_scenario("training")).run().digest


def test_a_browser_that_does_not_read_holds_up_nobody(running, talk):
    with Talk(running[0]) as lazy:
        for _ in range(300):
            lazy.line.send('{"do":"ping"}')
        begun = cpu(running[1])
        frames = [talk.picture() for _ in range(25)]
        assert frames[-1][talk.head["factor"]] > 0.5
        assert cpu(running[1]) - begun < 0.5
