"""The tables that `soccersim run` shows."""

from math import degrees
from typing import TYPE_CHECKING, Any

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.markup import escape
from rich.table import Table

if TYPE_CHECKING:
    from soccersim.spec.scenario import Scenario

ROWS = {  # what `--runs` shows of each leg: title, and the unit it is shown in
    "odometry_error": ("odometry from target", "m"),
    "truth_error": ("truth from target", "m"),
    "drift": ("truth from odometry", "m"),
    "odometry_heading_error": ("heading, odometry", "deg"),
    "truth_heading_error": ("heading, truth", "deg"),
    "heading_drift": ("heading, drift", "deg"),
    "time": ("time", "s"),
}


class Screen(Console):
    """Standard output; a reader who leaves early, as `head` does, is told to main."""

    def on_broken_pipe(self) -> None:
        """Without this, rich ends the program with exit code 1."""
        raise BrokenPipeError


def show(spec: "Scenario", document: dict[str, Any]) -> None:
    """Print what was run, a table of its legs, and over several seeds a table of bands."""
    console = Screen()
    name, seed = escape(document["scenario"]), document["seed"]
    console.print(
        f"[bold]{name}[/] seed {seed}: {document['duration']:.2f} s simulated, "
        f"digest {document['digest'][:16]}"
    )
    if any(arm["goals"] for arm in document["arms"]):
        console.print(arms_table(document))
    if document["shots"]:
        goals = sum(shot["goal"] is not None for shot in document["shots"])
        console.print(f"{len(document['shots'])} shots, {goals} goals")
    if any(robot["legs"] for robot in document["robots"]):
        console.print(legs_table(document))
        console.print(
            "[dim]In the scenario's frame, headings counter-clockwise. Error: distance from the "
            "target; drift: from odometry to truth.[/]"
        )
    elif spec.robots:
        console.print(f"{len(spec.robots)} robots, no leg has ended")
    if "bands" in document:
        console.print(bands_table(document))


def arms_table(document: dict[str, Any]) -> Table:
    """A row a goal of each arm: where the tip should be and where it was held."""
    table = new_table("where each arm held its tip, from its base", "arm")
    for name in ("target\nx m", "\ny m", "\ndeg", "tip\nx m", "\ny m", "\ndeg"):
        table.add_column(name, justify="right", no_wrap=True)
    for name in ("off by\nmm", "\ndeg"):
        table.add_column(name, justify="right", no_wrap=True)
    for arm in document["arms"]:
        for k, goal in enumerate(arm["goals"], 1):
            poses = [
                text
                for pose in (goal["target"], goal["tip"])
                for text in (number(pose[0], "m"), number(pose[1], "m"), number(pose[2], "deg"))
            ]
            off = f"{1000 * goal['position_error']:.3f}", number(goal["angle_error"], "deg")
            table.add_row(escape(f"{arm['name']} {k}"), *poses, *off)
    return table


def legs_table(document: dict[str, Any]) -> Table:
    """A block a leg: target, odometry, truth, drift and time, ours and the paper's."""
    legs = [
        (robot["name"], k, leg)
        for robot in document["robots"]
        for k, leg in enumerate(robot["legs"], 1)
    ]
    papers = any(leg["paper"] for _, _, leg in legs)
    table = new_table("where each leg ended", "")
    for name in ("x m", "y m", "heading\ndeg", "error\nm"):
        table.add_column(name, justify="right", no_wrap=True)
    if papers:
        for name in ("paper\nx m", "\ny m", "heading\ndeg", "error\nm"):
            table.add_column(name, justify="right", no_wrap=True, style="magenta")
    for name, k, leg in legs:
        table.add_row(escape(f"{name} {k}"), style="bold")
        for row, pose, error in BLOCK:
            cells = [*_cells(leg, pose, error), *_cells(leg["paper"] or {}, pose, error, row)]
            table.add_row(f"  {row}", *cells[: 8 if papers else 4])
        if not leg["reached"]:
            table.add_row("  out of time", style="red")
    return table


def new_table(title: str, *columns: str) -> Table:
    """A plain table with left columns."""
    table = Table(title=title, title_justify="left", box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
    for column in columns:
        table.add_column(column, no_wrap=True)
    return table


BLOCK = (  # rows of a leg's block: title, its pose, its error
    ("target", "target", ""),
    ("odometry", "odometry", "odometry_error"),
    ("truth", "truth", "truth_error"),
    ("drift", "", "drift"),
    ("time s", "", "time"),
)


def _cells(leg: dict[str, Any], pose: str, error: str, row: str = "") -> list[str]:
    """x, y, heading and error as text; a paper's target is not told twice."""
    x, y, heading = (row != "target" and leg.get(pose)) or (None, None, None)
    return [
        number(x, "m"),
        number(y, "m"),
        number(heading, "deg"),
        number(leg.get(error), "s" if error == "time" else "m"),
    ]


def number(value: float | None, unit: str) -> str:
    """A number for people, in its unit."""
    if value is None:
        return ""
    if unit == "deg":
        return f"{round(degrees(value), 2) + 0.0:.2f}"
    places = 2 if unit == "s" else 3
    return f"{round(value, places) + 0.0:.{places}f}"  # no -0.000


def bands_table(document: dict[str, Any]) -> Table:
    """Per leg and error: the paper's value, our median and 5-95 % band, where the paper lies."""
    table = new_table(f"over {len(document['runs'])} seeds", "")
    for name in ("paper", "median", "5 %", "95 %", "paper's\npercentile"):
        table.add_column(name, justify="right")
    for i, robot in enumerate(document["bands"]):
        for k, leg in enumerate(robot["legs"]):
            table.add_row(escape(f"{robot['name']} {k + 1}"), style="bold")
            for key, (title, unit) in ROWS.items():
                if key in leg:
                    paper = _paper_value(document, i, k, key)
                    low, middle, high = (number(value, unit) for value in leg[key])
                    place = percentile(document, i, k, key, paper)
                    row = f"  {title}, {unit}"
                    table.add_row(row, number(paper, unit), middle, low, high, place)
    return table


def _paper_value(document: dict[str, Any], robot: int, leg: int, key: str) -> float | None:
    paper = document["robots"][robot]["legs"][leg]["paper"]
    return paper[key] if paper else None


def percentile(
    document: dict[str, Any], robot: int, leg: int, key: str, paper: float | None
) -> str:
    """The share of our runs that lie below the paper's value."""
    if paper is None:
        return ""
    ours = [run["robots"][robot]["legs"] for run in document["runs"]]
    values = [legs[leg][key] for legs in ours if leg < len(legs)]
    return f"{100 * sum(value < paper for value in values) / len(values):.0f}"
