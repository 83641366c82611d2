"""A process that does what it is told, in Python."""

import ctypes  # noqa: F401
import os
import random  # noqa: F401
import signal  # noqa: F401
import subprocess  # noqa: F401
import sys  # noqa: F401
import threading  # noqa: F401
import time  # noqa: F401

import numpy  # noqa: F401


def main(code):
    exec(code, globals())


def play(request, turn, folder):
    """What a process that is reused does: it sleeps, and so does a child of it."""
    (folder / f"begun{os.getpid()}").touch()
    os.system("sleep 99")
