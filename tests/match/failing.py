"""A match's process that fails without any team's doing: how stands in the environment."""

import os
import time
from pathlib import Path

from soccersim.match.child import serve
from soccersim.problems import MachineError


def main(folder):
    serve(Path(folder), work)


def work(request, turn, folder):
    turn.tick = 40
    how = os.environ["HOW"]
    if how == "dies":
        os._exit(7)
    elif how == "stalls":
        time.sleep(99)
    elif how == "disk":
        raise MachineError("/x: No space left on device")
    raise ZeroDivisionError("our own mistake")
