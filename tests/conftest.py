"""Makes tests/factory.py importable from every test, and says how many processes run them."""

import os
import signal
import sys

import pytest
from hypothesis import settings

settings.register_profile("patient", deadline=None)  # gives hypothesis time to compile
settings.load_profile("patient")


def pytest_xdist_auto_num_workers(config):
    """A process a core for the whole suite; none for tests that were chosen, or that measure."""
    whole = config.args == config.getini("testpaths") and not config.option.keyword
    quick = config.option.markexpr == "not slow and not benchmark"
    return os.cpu_count() if whole and quick else 0


@pytest.fixture
def soccersim(monkeypatch, capsys):
    """Run a command line in this process, through the real entry."""

    from ended import Ended

    from soccersim.cli.main import main

    def run(*words):
        monkeypatch.setattr(sys, "argv", ["soccersim", *map(str, words)])
        monkeypatch.setattr(sys, "unraisablehook", sys.unraisablehook)  # main puts its own
        capsys.readouterr()
        code, before = 0, signal.getsignal(signal.SIGINT)
        try:
            main()
        except SystemExit as stop:
            code = stop.code or 0
        finally:
            signal.signal(signal.SIGINT, before)
        return Ended(code, *capsys.readouterr())

    return run
