"""soccersim: a 2D robot-soccer simulator that tells the truth about wheels and odometry.

>>> from soccersim import Simulation, load_scenario
>>> recording = Simulation(load_scenario("defender", seed=3)).run()
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from soccersim.match.play import play_match
    from soccersim.record import Recording
    from soccersim.simulation import Simulation
    from soccersim.spec.load import load_scenario

__version__ = "0.1.0"
__all__ = ["Recording", "Simulation", "__version__", "load_scenario", "play_match"]

_PLACES = {
    "Recording": "soccersim.record",
    "Simulation": "soccersim.simulation",
    "load_scenario": "soccersim.spec.load",
    "play_match": "soccersim.match.play",
}


def __getattr__(name: str) -> Any:
    # imported when first used: `soccersim --help` must not wait for numba
    if name in _PLACES:
        from importlib import import_module

        return getattr(import_module(_PLACES[name]), name)
    raise AttributeError(f"module 'soccersim' has no attribute {name!r}")
