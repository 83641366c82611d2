"""What `soccersim tournament` shows: the table, and who took what from whom."""

from typing import Any

from rich.markup import escape
from rich.table import Table as Shown

from soccersim.cli.tables import Screen, new_table
from soccersim.cli.verdict_tables import faults_table
from soccersim.regress.table import Table


def show(table: Table, document: dict[str, Any]) -> None:
    """Print it on standard output. document: of --json."""
    console = Screen(highlight=False)
    pairs, scenario = document["pairs"], escape(document["scenario"])
    console.print(f"[bold]{len(table.rows)} teams, {pairs} pairs of {scenario}[/]")
    console.print(league(table))
    console.print("won-drawn-lost, row against column")
    console.print(cross(table))
    if document["void"]:
        console.print(f"[yellow]{document['void']} matches could not be played: void[/]")
    if document["faults"]:
        console.print(faults_table(document["faults"]))
    matches = document["matches"]
    console.print(
        f"[dim]{matches['played']} matches played, {matches['found']} were there already, in "
        f"{escape(document['results'])}. Elo about the mean of the field, 95 % interval.[/]"
    )


def league(table: Table) -> Shown:
    """A row a team."""
    shown = new_table("", "", "team")
    names = ("played", "won", "drawn", "lost", "goals", "points", "Elo", "+-", "faults")
    for name in names:
        shown.add_column(name, justify="right", no_wrap=True)
    for place, row in enumerate(table.rows, 1):
        record = (str(number) for number in (row.played, row.won, row.drawn, row.lost))
        rating = f"{row.elo:+.0f}", f"{row.error:.0f}"
        goals, faults = f"{row.goals}:{row.against}", str(row.faults or "")
        shown.add_row(
            str(place), escape(row.team), *record, goals, str(row.points), *rating, faults
        )
    return shown


def cross(table: Table) -> Shown:
    """Won, drawn and lost by each row's team against each column's."""
    shown = new_table("", "", "team")
    for place in range(1, len(table.rows) + 1):
        shown.add_column(str(place), justify="right", no_wrap=True)
    for k, row in enumerate(table.rows):
        cells = [
            "" if k == j else "-".join(str(number) for number in table.cross[k, j])
            for j in range(len(table.rows))
        ]
        shown.add_row(str(k + 1), escape(row.team), *cells)
    return shown
