"""Finding a robot's gains by experiment.

rig.py      one control loop of a robot: open, for a relay, and closed, with any gains
session.py  the experiments on a loop, the rules' gains compared, and which to take
findings.py what it came to: a document, the YAML to paste, pictures
"""

from soccersim.tune.findings import document
from soccersim.tune.session import Tuned, Tuning, tune

__all__ = ["Tuned", "Tuning", "document", "tune"]
