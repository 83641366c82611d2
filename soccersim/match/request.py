"""What is asked for when a match is: who plays, in which scenario, with what changed."""

import json
from collections.abc import Iterable
from pathlib import Path

from soccersim.match.seating import Isolate
from soccersim.match.supervise import Request
from soccersim.problems import InputError, Problem, one_line
from soccersim.spec.load import load_scenario
from soccersim.spec.scenario import Scenario
from soccersim.strategy.load import locate


def match_request(
    home: str,
    away: str,
    scenario: str,
    *,
    seed: int | None = None,
    duration: float | None = None,
    settings: Iterable[str] = (),
    isolate: Isolate = "match",
    recording: Path | None = None,
) -> Request:
    """The request for a match; InputError with what is wrong with it. Runs no strategy's code."""
    origins = locate(home), locate(away)
    length = [] if duration is None else [f"duration={duration!r}"]
    own = match_of(load_scenario(scenario), scenario).match
    teams = []
    for side, name, team in (
        ("home", home, own and own.home),
        ("away", away, own and own.away),
    ):
        if team and team.strategy != name:  # the scenario's options are for another strategy
            teams += [f"match.{side}.strategy={json.dumps(name)}", f"match.{side}.options={{}}"]
    spec = load_scenario(scenario, seed=seed, settings=[*teams, *length, *settings])
    return Request(match_of(spec, scenario), origins, isolate, recording)


def match_of(spec: Scenario, source: str) -> Scenario:
    """The scenario, if it is a match."""
    if spec.match is None:
        name = one_line(source)
        raise InputError(Problem(f"is no match: `soccersim run {name}` runs it", name))
    return spec
