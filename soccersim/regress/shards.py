"""A run in parts that know nothing of each other: what each keeps, and how they are put together.

A shard is a store with some of a plan's pair numbers. Put together they are the store that one run
would have left, and the verdict comes of the rows alone.
"""

import json
import os
import shutil
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import Any

from soccersim.problems import InputError, MachineError, Problem, one_line
from soccersim.regress.engine import environment
from soccersim.regress.plan import Plan, plan_of
from soccersim.regress.recordings import Recordings
from soccersim.regress.row import Row
from soccersim.regress.store import Store

AT_ONCE = 500  # rows in a transaction
PLAN, COMMAND, ENVIRONMENT = "plan", "command", "environment"  # notes in a store
DIFFERENCES = {  # keys of a plan's document: what a user calls them
    "scenario": "the scenario, --set or --duration",
    "base": "the base's code or options",
    "candidate": "the candidate's code or options",
    "against": "the opponents",
    "rule": "--pairs",
    "seed": "--seed",
    "engine": "soccersim's version or the platform",
}


def keep_plan(store: Store, plan: Plan, command: str) -> None:
    """Note in the store what is played into it, and by whose code."""
    store.keep_bundles(team.bundle for team in plan.teams)
    store.note(PLAN, json.dumps(plan.document()))
    store.note(COMMAND, command)
    store.note(ENVIRONMENT, json.dumps(environment()))


def plan_in(paths: Sequence[Path]) -> Plan:
    """The plan that these shards are of.

    InputError where a file is no shard, or of another plan than the first.
    """
    plan: Plan | None = None
    for path in paths:
        with opened(path) as shard:
            document = noted(shard)
            if plan is None:
                plan = plan_of(document, shard.bundles())
            elif parts := different(plan.document(), document):
                wrong = f"differs from {paths[0]} in {' and '.join(parts)}"
                raise InputError(Problem(wrong, str(path)))
    if plan is None:
        raise InputError(Problem("no shards are named"))
    return plan


def merge(plan: Plan, paths: Sequence[Path], target: Store) -> None:
    """Put the shards of a plan into a store."""
    for path in paths:
        with opened(path) as shard:
            target.keep_bundles(shard.bundles().values())
            for note in (PLAN, ENVIRONMENT):
                target.note(note, shard.noted(note))
            take(plan, shard, target)


def opened(path: Path) -> Store:
    """A shard's store; InputError where there is none."""
    if not path.is_file():
        raise InputError(Problem("there is no such file", one_line(str(path), 200)))
    return Store(path)


def noted(shard: Store) -> dict[str, Any]:
    """The document of the plan whose pairs a shard holds."""
    document = json.loads(shard.noted(PLAN) or "{}")
    if "pairs" not in document.get("rule", {}):
        wrong = "is no shard: `soccersim worker` writes those"
        raise InputError(Problem(wrong, one_line(str(shard.path), 200)))
    return dict(document)


def different(one: Mapping[str, Any], other: Mapping[str, Any]) -> list[str]:
    """What differs between the documents of two plans; the names of the same code may."""
    bare, others = unnamed(one), unnamed(other)
    return [DIFFERENCES[key] for key in DIFFERENCES if bare[key] != others[key]]


def unnamed(document: Mapping[str, Any]) -> dict[str, Any]:
    """A plan's document without the names of teams, nor what it says twice."""

    def team(told: Mapping[str, Any]) -> dict[str, Any]:
        return {**told, "name": ""}

    match = {**document["scenario"]["match"], "home": None, "away": None}
    return {
        **document,
        "scenario": {**document["scenario"], "match": match, "seed": None},
        "base": team(document["base"]),
        "candidate": team(document["candidate"]),
        "against": [team(told) for told in document["against"]],
    }


def take(plan: Plan, shard: Store, target: Store) -> None:
    """Copy a shard's rows of this plan, what contradicts them, and their recordings."""
    recordings = Recordings(shard.path), Recordings(target.path)
    rows = iter(planned(plan, shard))
    while some := list(islice(rows, AT_ONCE)):
        target.add(*(brought(row, *recordings) for row in some))
    target.keep_contradictions(shard.contradictions())


def planned(plan: Plan, shard: Store) -> Iterator[Row]:
    """The rows that are the plan's: a store may hold others."""
    number, keys = -1, set[str]()
    for row in shard.rows():
        if row.pair != number:
            number, keys = row.pair, {leg.key for leg in plan.legs_of(row.pair)}
        if row.key in keys and row.pair < plan.most:
            yield row


def brought(row: Row, source: Recordings, target: Recordings) -> Row:
    """The row with its recording in the target's folder; without, where that is not there."""
    if not row.recording:
        return row
    path, new = source.folder / row.recording, target.folder / row.recording
    if not path.is_file():
        return replace(row, recording="")
    try:
        target.folder.mkdir(exist_ok=True)
        if not new.exists():
            with suppress(OSError):
                os.link(path, new)
        if not new.exists():  # another disk, say
            part = new.with_name(new.name + ".part")
            shutil.copyfile(path, part)
            part.replace(new)
    except OSError as error:
        raise MachineError(f"{new}: {error.strerror or error}") from error
    return row


def missing(plan: Plan, store: Store) -> list[int]:
    """The pair numbers of which a leg is not there."""
    return [
        number
        for number in range(plan.most)
        if any(store.row(leg.key) is None for leg in plan.legs_of(number))
    ]
