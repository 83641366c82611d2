"""A run as a program of its own: `campaign.py STORE FOLDER PAIRS CHILD`; teams are FOLDER's files.

Prints a line for each row. GROWTH, in the environment, is how many bytes the store may grow.
"""

import os
import sys
from pathlib import Path

from soccersim import load_scenario
from soccersim.match.supervise import CHILD
from soccersim.problems import InputError, MachineError
from soccersim.regress.bundle import bundle
from soccersim.regress.ground import Ground
from soccersim.regress.leg import pair_of
from soccersim.regress.pool import LocalPool
from soccersim.regress.runner import run
from soccersim.regress.store import Store

SECONDS = {"quick": 0.5, "real": 2.0}
STRANGE = 9  # what ends otherwise than it should


def legs(folder, pairs, child):
    """The same ones every time."""
    spec = load_scenario("friendly-match", settings=[f"duration={SECONDS[child]}"])
    teams = bundle(str(folder / "one.py")), bundle(str(folder / "two.py"))
    for number in range(pairs):
        yield from pair_of(spec, teams, number, number + 1, keep="lost", watched=0)


def main(path, folder, pairs, child):
    asked = list(legs(Path(folder), int(pairs), child))
    real = child == "real"
    ground = Ground(asked[0].scenario if real else "", CHILD if real else child)
    with Store(Path(path)) as store, LocalPool(2, ground) as pool:
        if limit := os.environ.get("GROWTH"):
            import resource

            most = Path(path).stat().st_size + int(limit)
            resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
        for leg, row in run(asked, store, pool):
            print(leg.pair, leg.leg, row.score, row.again, row.void, flush=True)


if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parent))
    try:
        main(*sys.argv[1:])
    except (InputError, MachineError) as error:
        print(error, file=sys.stderr)
        sys.exit(2 if isinstance(error, InputError) else 3)
