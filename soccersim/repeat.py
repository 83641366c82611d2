"""The same scenario over many seeds, in one process or several: the same results either way."""

import multiprocessing
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from typing import Any

from soccersim.spec.scenario import Scenario


def repeat(
    scenario: Scenario, runs: int, jobs: int, progress: Callable[[float], None]
) -> list[dict[str, Any]]:
    """Reports of seeds S+1 .. S+runs-1, in order; S itself has been run already."""
    seeds = range(scenario.seed + 1, scenario.seed + runs)
    reports = []
    for report in _reports(scenario, seeds, min(jobs, len(seeds))):
        reports.append(report)
        progress(len(reports) / len(seeds))
    return reports


def _reports(scenario: Scenario, seeds: range, jobs: int) -> Iterator[dict[str, Any]]:
    text = scenario.model_dump_json()
    if jobs == 1:
        for seed in seeds:
            yield run_seed(text, seed)
        return
    # spawn: the same on every system, and no threads or locks are inherited half-way
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(jobs, mp_context=context) as pool:
        yield from pool.map(run_seed, [text] * len(seeds), seeds, chunksize=4)


def run_seed(text: str, seed: int) -> dict[str, Any]:
    """The short report of one seed; text is the scenario as JSON."""
    from soccersim.report import robots
    from soccersim.simulation import Simulation

    scenario = Scenario.model_validate_json(text).model_copy(update={"seed": seed})
    recording = Simulation(scenario).run()
    return {
        "seed": seed,
        "digest": recording.digest,
        "duration": recording.duration,
        "robots": robots(recording),
    }
