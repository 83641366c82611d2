"""What `soccersim match` shows."""

from collections import Counter
from typing import Any

from rich.markup import escape
from rich.table import Table

from soccersim.cli.tables import Screen, new_table

SIDES = ("home", "away")
PLAIN = ("start", "in_play")  # kinds that every restart brings
DONE = ("shots", "on_goal", "passes", "kicks")  # of each side, in match_report
LAST = 8  # events that are shown whole


def show(document: dict[str, Any]) -> None:
    """The score, the goals, what each side did and was given, and how the match ended.

    document: of --json, with match_report's as its `report`.
    """
    console = Screen()
    report, score = document["report"], document["score"]
    home, away = (escape(document[side]) for side in SIDES)
    console.print(f"[bold]{home} {score[0]} : {score[1]} {away}[/]")
    console.print(
        f"{escape(report['scenario'])} seed {document['seed']}: {document['duration']:.2f} s "
        f"played, {document['realtime_factor']:.3g} x real time, digest {document['digest'][:16]}"
    )
    events = [event for event in document["events"] if event["kind"] not in PLAIN]
    goals = [event for event in events if event["kind"] == "goal"]
    if goals:
        console.print(events_table("goals", goals))
    if document["duration"]:
        console.print(teams_table(report, events))
    if events:
        console.print(events_table("how it ended", events[-LAST:]))
    for fault in document["faults"]:
        console.print(f"[red]forfeit of {fault['side']}: {fault['kind']}[/]")


def teams_table(report: dict[str, Any], events: list[dict[str, Any]]) -> Table:
    """What each side did, then how often it was given what."""
    table = new_table("the teams", "")
    for name in (*SIDES, "nobody"):
        table.add_column(name, justify="right", no_wrap=True)
    shares = [report[side]["possession"] for side in SIDES]
    cells = ["" if share is None else f"{100 * share:.0f} %" for share in shares]
    table.add_row("possession", *cells)
    for key in DONE:
        table.add_row(key.replace("_", " "), *(str(report[side][key]) for side in SIDES))
    driven = [sum(report[side]["distance"].values()) for side in SIDES]
    table.add_row("driven, all robots", *(f"{metres:.0f} m" for metres in driven))
    table.add_row("ball in play", "", "", f"{100 * report['in_play']:.0f} %", end_section=True)
    counts = Counter((event["kind"], event["side"]) for event in events)
    for kind in sorted({event["kind"] for event in events}):
        told = [str(counts[kind, side] or "") for side in (*SIDES, None)]
        table.add_row(escape(kind.replace("_", " ")), *told)
    return table


def events_table(title: str, events: list[dict[str, Any]]) -> Table:
    """A row an event."""
    table = new_table(title)
    table.add_column("time", justify="right", no_wrap=True)
    for name in ("side", "robots", "what"):
        table.add_column(name, no_wrap=name == "side")
    for event in events:
        robots = escape(", ".join(event["robots"]))
        table.add_row(clock(event["time"]), event["side"] or "", robots, escape(event["text"]))
    return table


def clock(seconds: float) -> str:
    """Minutes and seconds."""
    minutes, rest = divmod(seconds, 60)
    return f"{minutes:.0f}:{rest:04.1f}"
