"""The same scenario over many seeds, in one process or several: the same results either way."""

from collections.abc import Iterator
from functools import lru_cache
from typing import Any

from soccersim.record import Recording
from soccersim.report import robots
from soccersim.spec.scenario import Scenario
from soccersim.workers import Workers


def repeat(scenario: Scenario, seeds: range, jobs: int) -> Iterator[dict[str, Any]]:
    """The short reports of these seeds, in their order, each as soon as it is there."""
    text = scenario.model_dump_json()
    jobs = min(jobs, len(seeds))
    if jobs <= 1:
        yield from (run_seed(text, seed) for seed in seeds)
        return
    with Workers(jobs) as workers:
        yield from workers.map(run_seed, [text] * len(seeds), seeds)


def run_seed(text: str, seed: int) -> dict[str, Any]:
    """The short report of one seed; text is the scenario as JSON."""
    return short(recorded(text, seed))


def recorded(text: str, seed: int) -> Recording:
    """The run of one seed; text is the scenario as JSON."""
    from soccersim.simulation import Simulation

    return Simulation(_told(text).model_copy(update={"seed": seed})).run()


@lru_cache(1)
def _told(text: str) -> Scenario:
    """The scenario; checked once for all of its seeds."""
    return Scenario.model_validate_json(text)


def short(recording: Recording) -> dict[str, Any]:
    """What `report.json` keeps of each of several runs."""
    return {
        "seed": recording.meta["seed"],
        "digest": recording.digest,
        "duration": recording.duration,
        "robots": robots(recording),
    }
