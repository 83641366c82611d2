"""`soccersim tune`."""

import json
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from soccersim.cli.results import Results

if TYPE_CHECKING:
    from rich.table import Table

    from soccersim.spec.player import Player
    from soccersim.spec.scenario import Scenario
    from soccersim.tune import Tuning

FILES = ("tune.json", "tune.png")


@click.command("tune", short_help="Ziegler-Nichols gains from a simulated experiment.")
@click.argument("scenario")
@click.option("--robot", "name", help="Which one; default: the scenario's first.")
@click.option("--seed", type=click.IntRange(min=0), help="Instead of the scenario's own.")
@click.option("--set", "settings", multiple=True, metavar="KEY.PATH=VALUE", help="Change a value.")
@click.option("--out", type=click.Path(path_type=Path), help="Folder for tune.json and tune.png.")
@click.option("--force", is_flag=True, help="Overwrite what is in --out.")
@click.option("--json", "as_json", is_flag=True, help="One JSON document on stdout.")
def command(
    scenario: str,
    name: str | None,
    seed: int | None,
    settings: tuple[str, ...],
    out: Path | None,
    force: bool,
    as_json: bool,
) -> None:
    """Find gains for a robot of SCENARIO, a bundled name or a YAML file.

    \b
    soccersim tune defender
    soccersim tune idris-table7 --out results
    soccersim tune ./my.yaml --robot keeper --set robots.0.model.mass=25

    Each loop (x, y, heading, and the wheels' where they have encoders) is brought to oscillate by
    a relay and by rising gain. The ultimate gain and period go into the rules of Ziegler and
    Nichols and gentler ones; every rule's step response is simulated beside the present gains'.
    """
    from soccersim.cli.progress import Bar
    from soccersim.cli.run import announce_compiling
    from soccersim.spec.load import load_scenario

    spec = load_scenario(scenario, seed=seed, settings=settings)
    player = choose(spec, name)
    with Results(out, FILES, force) if out else nullcontext() as results:
        announce_compiling()
        from soccersim.tune import document, tune

        with Bar(f"tuning {player.name}") as bar:
            tuning = tune(spec, player, bar)
        found = document(tuning)
        if results:
            write(found, tuning, results)
    if as_json:
        click.echo(json.dumps(found, allow_nan=False))
    else:
        show(found)
    for path in results.written if results else ():
        click.echo(f"wrote {path}", err=True)


def choose(spec: "Scenario", name: str | None) -> "Player":
    """The robot of this name, or the first; InputError with the nearest name."""
    from difflib import get_close_matches

    from soccersim.problems import InputError, Problem

    if not spec.robots:
        raise InputError(Problem(f"{spec.name} has no robot to tune"))
    names = [player.name for player in spec.robots]
    if name is None:
        return spec.robots[0]
    if name in names:
        return spec.robots[names.index(name)]
    near = get_close_matches(name, names, n=1)
    hint = f"did you mean `{near[0]}`?" if near else f"there are {', '.join(names)}"
    raise InputError(Problem(f"no robot `{name[:60]}` in {spec.name}: {hint}", file="--robot"))


def write(found: dict[str, Any], tuning: "Tuning", results: Results) -> None:
    """tune.json and tune.png."""
    from soccersim.render.tune_plots import save_tune
    from soccersim.tune.findings import pictures

    with results.new("tune.json") as path:
        text = json.dumps(found, indent=2, allow_nan=False)
        path.write_text(text + "\n", encoding="utf-8")
    with results.new("tune.png") as path:
        title = f"{found['scenario']}: {found['robot']}, seed {found['seed']}"
        save_tune(title, pictures(tuning), path)


def show(found: dict[str, Any]) -> None:
    """Tables of the ultimate points and of each loop's answers, then the YAML and why."""
    from rich.console import Console
    from rich.padding import Padding
    from rich.text import Text

    console = Console(highlight=False)
    console.print(
        f"{found['scenario']}: robot {found['robot']}, seed {found['seed']}", style="bold"
    )
    console.print(ultimate_table(found["loops"]))
    for loop in found["loops"]:
        console.print(answers_table(loop))
    console.print("[dim]grey: scaled from the rule's PID like Ziegler and Nichols' own[/]")
    console.print("\nFor the robot's file:\n")
    console.print(found["yaml"], markup=False, soft_wrap=True)
    said = [f"{loop['loop']}: {loop['why']}" for loop in found["loops"]]
    for text, style in [*((s, "") for s in said), *((note, "dim") for note in found["notes"])]:
        console.print(Padding(Text(text, style), (0, 0, 0, 2)))


def ultimate_table(loops: list[dict[str, Any]]) -> "Table":
    """Ultimate gain and period of every loop, by both experiments."""
    from soccersim.cli.tables import new_table

    table = new_table("where each loop just oscillates", "", "gain in")
    for column in ("relay\nKu", "\nTu s", "sweep\nKu", "\nTu s", "push", "of grip"):
        table.add_column(column, justify="right", no_wrap=True)
    for loop in loops:
        relay, sweep = loop["relay"], loop["sweep"]
        table.add_row(
            loop["loop"],
            f"{loop['push_unit']} per {loop['unit']}",
            *(number(p[key]) for p in (relay, sweep) for key in ("gain", "period")),
            f"{relay['push']:.2g} {loop['push_unit']}",
            f"{relay['grip']:.0%}",
        )
    return table


def answers_table(loop: dict[str, Any]) -> "Table":
    """The present gains and every rule's, and what the loop's step looks like with them."""
    from math import degrees

    from soccersim.cli.tables import new_table

    turn = loop["unit"] == "rad"
    step = f"{degrees(loop['step']):.3g} deg" if turn else f"{loop['step']:.3g} {loop['unit']}"
    table = new_table(f"{loop['loop']}: a step of {step}", "", "")
    heads = ("kp", "ki", "kd", "rise\ns", "over\n%", "settled\ns", f"IAE\n{loop['unit']} s")
    for column in heads:
        table.add_column(column, justify="right", no_wrap=True)
    chosen = (loop["recommended"]["rule"], loop["recommended"]["controller"])
    for row in (loop["present"], *loop["rules"]):
        bold = (row["rule"], row["controller"]) == chosen
        table.add_row(
            row["rule"],
            row["controller"],
            *(number(row[key] or None) for key in ("kp", "ki", "kd")),
            number(row["rise_time"]),
            f"{100 * row['overshoot']:.1f}",
            number(row["settling_time"]),
            number(row["iae"]),
            style="bold green" if bold else "" if row["printed"] else "dim",
        )
    return table


def number(value: float | None) -> str:
    """Three digits, or a dash for what there is not."""
    return "-" if value is None else f"{value:.3g}" if abs(value) < 1000 else f"{value:.0f}"
