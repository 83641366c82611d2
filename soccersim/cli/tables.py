"""The tables that `soccersim run` shows."""

from math import degrees
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table

if TYPE_CHECKING:
    from soccersim.spec.scenario import Scenario

ROWS = {  # what `--runs` shows of each leg: title, and the unit it is shown in
    "odometry_error": ("odometry - target", "m"),
    "truth_error": ("truth - target", "m"),
    "drift": ("truth - odometry", "m"),
    "odometry_heading_error": ("heading, odometry - target", "deg"),
    "truth_heading_error": ("heading, truth - target", "deg"),
    "heading_drift": ("heading, truth - odometry", "deg"),
    "time": ("time", "s"),
}


def show(spec: "Scenario", document: dict[str, Any]) -> None:
    """Print what was run, a table of its legs, and over several seeds a table of bands."""
    console = Console()
    console.print(
        f"[bold]{document['scenario']}[/] seed {document['seed']}: {document['duration']:.2f} s "
        f"simulated, digest {document['digest'][:16]}"
    )
    if not any(robot["legs"] for robot in document["robots"]):
        console.print(f"{len(spec.robots)} robots, no leg has ended")
        return
    console.print(legs_table(document))
    console.print(
        "[dim]poses: x, y in m and heading in deg, counter-clockwise, in the scenario's "
        "frame; * the leg ran out of time[/]"
    )
    if "bands" in document:
        console.print(bands_table(document))


def legs_table(document: dict[str, Any]) -> Table:
    """A row a leg, under it the paper's row where there is one."""
    table = Table(title="where each leg ended", title_justify="left", header_style="bold")
    table.add_column("robot", no_wrap=True)
    table.add_column("leg", justify="right")
    for name in ("target", "odometry", "truth"):
        table.add_column(name, justify="right", no_wrap=True)
    for name in ("odometry\nerror", "true\nerror", "drift"):
        table.add_column(f"{name} m", justify="right")
    table.add_column("time s", justify="right")
    for robot in document["robots"]:
        for k, leg in enumerate(robot["legs"], 1):
            late = "" if leg["reached"] else "*"
            table.add_row(robot["name"] if k == 1 else "", f"{k}{late}", *_cells(leg))
            if leg["paper"]:
                cells = _cells({**leg["paper"], "target": None})
                table.add_row("", "paper", *cells, style="magenta")
        table.add_section()
    return table


def _cells(leg: dict[str, Any]) -> list[str]:
    """Poses, errors and time as text."""
    poses = [pose_text(leg[key]) for key in ("target", "odometry", "truth")]
    errors = [number(leg[key], "m") for key in ("odometry_error", "truth_error", "drift")]
    return [*poses, *errors, number(leg["time"], "s")]


def pose_text(pose: list[float | None] | None) -> str:
    """`x y heading` in m and deg."""
    if pose is None:
        return ""
    x, y, heading = pose
    turn = "    -" if heading is None else f"{degrees(heading) + 0.0:5.1f}"
    return f"{x:6.3f} {y:6.3f} {turn}"


def number(value: float | None, unit: str) -> str:
    """A number for people, in its unit."""
    if value is None:
        return ""
    if unit == "deg":
        return f"{degrees(value):.2f}"
    return f"{value:.2f}" if unit == "s" else f"{value:.3f}"


def bands_table(document: dict[str, Any]) -> Table:
    """Per leg and error: the paper's value, our median and 5-95 % band, where the paper lies."""
    runs = len(document["runs"])
    table = Table(title=f"over {runs} seeds", title_justify="left", header_style="bold")
    for name in ("robot", "leg", "what"):
        table.add_column(name)
    for name in ("paper", "median", "5-95 %", "paper's\npercentile"):
        table.add_column(name, justify="right")
    for i, robot in enumerate(document["bands"]):
        for k, leg in enumerate(robot["legs"]):
            for key, (title, unit) in ROWS.items():
                if key in leg:
                    paper = _paper_value(document, i, k, key)
                    low, middle, high = (number(value, unit) for value in leg[key])
                    place = percentile(document, i, k, key, paper)
                    row = (f"{title}, {unit}", number(paper, unit), middle, f"{low} .. {high}")
                    table.add_row(robot["name"], str(k + 1), *row, place)
            table.add_section()
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
