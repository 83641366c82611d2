"""How fast this machine runs the simulator, beside bare pymunk doing the same steps."""

import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from soccersim.plant.bare import BareWorld
from soccersim.record import Recording
from soccersim.render.frames import FrameRenderer
from soccersim.simulation import Simulation
from soccersim.spec.load import load_scenario
from soccersim.spec.scenario import Scenario

PIECE = 250  # ticks of each in turn
FILM = 10  # s of play that is drawn
SPREAD = 1.0  # m between robots of the crowd of 22: about as dense as kickabout


def measure(seconds: float, progress: Callable[[float], None]) -> dict[str, Any]:
    """Medians over pieces of `kickabout`; times are of this process's CPU, in microseconds."""
    scenario = load_scenario("kickabout", settings=[f"duration={seconds}"])
    # first, as long as nothing else is held: a picture takes much memory until it is painted
    frames_per_second = _frames(load_scenario("kickabout", settings=[f"duration={FILM}"]))
    progress(0.2)
    ticks = _race(scenario, lambda share: progress(0.2 + 0.6 * share))
    recording = ticks.pop("recording")
    crowds = {n: _alone(_crowd(scenario, n)) for n in (10, 22)}
    tick_us, floor_us = float(np.median(ticks["ours"])), float(np.median(ticks["floor"]))
    result = {
        "robots": len(scenario.robots),
        "contacts": _contacts(scenario, recording),
        "tick_us": tick_us,
        "floor_us": floor_us,
        "tick_over_floor": float(np.median(np.array(ticks["ours"]) / np.array(ticks["floor"]))),
        "realtime_factor": 1e6 * scenario.dt / tick_us,
        "tick_us_22": crowds[22],
        "growth_10_to_22": crowds[22] / crowds[10],
        "frames_per_second": frames_per_second,
        "memory_mb": resident_mb(),
    }
    progress(1.0)
    return result


def _race(scenario: Scenario, progress: Callable[[float], None]) -> dict[str, Any]:
    """Pieces of the simulation, each followed by bare pymunk from the states just recorded."""
    simulation, bare = Simulation(scenario), BareWorld(scenario)
    simulation.advance(PIECE)  # loads the kernels
    every = simulation.machine.log.every
    ours, floor = [], []
    while not simulation.done:
        start = time.process_time()
        simulation.advance(PIECE)
        ours.append((time.process_time() - start) / PIECE * 1e6)
        spent = 0.0
        states = simulation.machine.log.body[: PIECE // every].copy()
        for state in states:
            bare.set_states(state)
            start = time.process_time()
            for _ in range(every):
                bare.tick(scenario.dt)
            spent += time.process_time() - start
        floor.append(spent / (len(states) * every) * 1e6)
        progress(simulation.tick / simulation.end)
    return {"ours": ours, "floor": floor, "recording": simulation.recording()}


def _crowd(scenario: Scenario, count: int) -> Scenario:
    """So many robots on a grid, each driving to and fro within its own square metre."""
    data = scenario.model_dump(mode="json")
    model, side = data["robots"][0], int(np.ceil(np.sqrt(count)))
    data["robots"] = []
    for i in range(count):
        x, y = (i % side - side / 2) * SPREAD, (i // side - side / 2) * SPREAD
        path = [{"to": [x + dx, y + dy, 0.0]} for dx, dy in ((0.2, 0.2), (-0.2, 0.1), (0, -0.2))]
        robot = {"name": f"robot-{i}", "start": [x, y, 0.0], "path": path}
        data["robots"].append({**model, **robot})
    data["ball"]["at"] = [0.0, side * SPREAD]
    data["duration"] = 10.0
    return Scenario.model_validate(data)


def _alone(scenario: Scenario) -> float:
    """Median microseconds a tick."""
    simulation = Simulation(scenario)
    simulation.advance(PIECE)
    pieces = []
    while not simulation.done:
        start = time.process_time()
        simulation.advance(PIECE)
        pieces.append((time.process_time() - start) / PIECE * 1e6)
    return float(np.median(pieces))


def _contacts(scenario: Scenario, recording: Recording) -> float:
    """Mean number of pairs of bodies that touch."""
    radii = [player.model.radius for player in scenario.robots]
    radii += [scenario.ball.radius] if scenario.ball else []
    place = recording.body[:, :, 0] + 1j * recording.body[:, :, 1]
    apart = np.abs(place[:, :, None] - place[:, None, :])
    touching = apart < np.add.outer(radii, radii) + 0.001
    return float((touching.sum(axis=(1, 2)) - len(radii)).mean() / 2)


def _frames(scenario: Scenario) -> float:
    """Frames drawn to a surface a second, none encoded."""
    renderer = FrameRenderer(Simulation(scenario).run())
    renderer.draw(0)
    start = time.process_time()
    for index in renderer.records:
        renderer.draw(index)
    return len(renderer.records) / (time.process_time() - start)


def resident_mb() -> float:
    """The most memory this process has held, MB; nan where the system does not say."""
    status = Path("/proc/self/status")
    if status.exists():  # getrusage would start from what the parent process held
        fields = dict(line.split(":", 1) for line in status.read_text().splitlines())
        return int(fields["VmHWM"].split()[0]) / 1e3
    try:
        import resource
    except ImportError:  # Windows
        return float("nan")
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (1e6 if sys.platform == "darwin" else 1e3)
