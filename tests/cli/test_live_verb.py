"""`soccersim live` as a user meets it."""

import os
import re
import signal
import socket
import subprocess
import sys
import urllib.request

import pytest


@pytest.fixture
def started(compiled):
    """A base station in a process of its own, once it has said where it is."""
    processes = []

    def start(*words):
        process = subprocess.Popen(
            [sys.executable, "-m", "soccersim", "live", *words],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONUNBUFFERED": "1"},
        )
        processes.append(process)
        return process, process.stdout.readline()

    yield start
    for process in processes:
        process.kill()
        process.communicate()


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT for one process")
def test_it_tells_its_address_serves_and_ends_with_ctrl_c(started):
    process, line = started("friendly-match", "--port", "0")
    url = re.search(r"http://127\.0\.0\.1:\d+/", line)[0]
    with urllib.request.urlopen(url, timeout=5) as answer:
        assert b"soccersim live" in answer.read()
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=15)
    assert (process.returncode, out, err) == (0, "", "ended\n")


def test_a_port_in_use_is_told_in_one_line(soccersim):
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        ended = soccersim("live", "--port", other.getsockname()[1])
    assert ended.code == 2
    assert len(ended.lines) == 1
    assert "in use" in ended.err


def test_what_cannot_be_is_told_in_one_line(soccersim):
    for words, why in (
        (("nowhere",), "no scenario `nowhere` is bundled"),
        (("--host", "203.0.113.7"), "no address of this computer"),
        (("--home", "roles"), "match"),
        (("friendly-match", "--home", "nobody"), "no strategy `nobody` is bundled"),
        (("--set", "robots.0.model.mass=-1"), "mass"),
        (("--port", "70000"), "70000"),
    ):
        ended = soccersim("live", "--port", "0", *words)
        assert ended.code == 2, words
        assert len(ended.lines) == 1, ended.err
        assert why in ended.err


def test_without_its_library_it_says_what_to_install(soccersim, monkeypatch):
    for name in [name for name in sys.modules if name.startswith("soccersim.live")]:
        monkeypatch.delitem(sys.modules, name)
    for name in [name for name in sys.modules if name.split(".")[0] == "websockets"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "websockets.asyncio.server", None)
    monkeypatch.setitem(sys.modules, "websockets", None)
    ended = soccersim("live", "--port", "0")
    assert ended.code == 2
    assert "soccersim[live]" in ended.err


def test_a_window_without_a_display_is_told_in_one_line(soccersim, monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr("sys.platform", "linux")
    ended = soccersim("live", "--window")
    assert ended.code == 3
    assert len(ended.lines) == 1
    assert "no display" in ended.err
