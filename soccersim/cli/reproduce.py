"""`soccersim reproduce`."""

import json
from collections.abc import Callable
from contextlib import nullcontext
from functools import partial
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from soccersim.cli.results import Results

if TYPE_CHECKING:
    from soccersim.reproduce.section import Section, Summary

FILES = ("reproduce.json", "reproduce.html")
WIDEST = 1000  # characters of a table's line; a terminal that is narrower wraps it


@click.command("reproduce", short_help="Every table of the papers beside ours.")
@click.argument("papers", nargs=-1)
@click.option("--out", type=click.Path(path_type=Path), help="Folder for JSON, pictures and page.")
@click.option("--seeds", type=click.IntRange(2, 100_000), default=200, help="Runs behind a band.")
@click.option("--jobs", type=click.IntRange(1, 256), help="Processes; default: all cores.")
@click.option("--force", is_flag=True, help="Overwrite what is in --out.")
@click.option("--json", "as_json", is_flag=True, help="One JSON document on stdout.")
def command(
    papers: tuple[str, ...],
    out: Path | None,
    seeds: int,
    jobs: int | None,
    force: bool,
    as_json: bool,
) -> None:
    """Reproduce PAPERS (idris, utama, dasmahapatra, four-wheel, garcia), all by default.

    \b
    soccersim reproduce idris
    soccersim reproduce --out results      reproduce.html, reproduce.json, a picture a table

    Each table shows the paper's value as printed, ours as simulated and the difference, and marks
    where the paper itself is wrong, with the reason. Physics and what was fitted to a table stand
    in columns of their own.
    """
    from soccersim.cli.progress import Bar
    from soccersim.cli.run import announce_compiling
    from soccersim.reproduce.lab import Lab
    from soccersim.reproduce.papers import PAPERS, sections

    wanted = list(dict.fromkeys(papers)) or list(PAPERS)
    _check(wanted)
    found: dict[str, list[Section]] = {}
    with Results(out, FILES, force) if out else nullcontext() as results:
        announce_compiling()
        with Bar("reproducing") as bar, Lab(jobs, seeds) as lab:
            for i, name in enumerate(wanted):
                lab.progress = partial(_share, bar, i, len(wanted))
                found[name] = list(sections(name, lab))
        document = {"papers": {name: [s.document() for s in found[name]] for name in wanted}}
        if results:
            for file, data in drawn(found, document).items():
                with results.new(file) as path:
                    path.write_bytes(data)
    if as_json:
        click.echo(json.dumps(document))
    else:
        from soccersim.cli.tables import Screen

        for name in wanted:
            Screen().rule(f"[bold]{PAPERS[name]}")
            for section in found[name]:
                show(section)
    if out:
        click.echo(f"wrote {out / 'reproduce.html'}, reproduce.json and pictures", err=True)


def _share(bar: Callable[[float], None], paper: int, papers: int, share: float) -> None:
    """Tell the bar how much of all papers is done."""
    bar((paper + share) / papers)


def _check(papers: list[str]) -> None:
    """InputError where a paper is not known."""
    from difflib import get_close_matches

    from soccersim.problems import InputError, Problem
    from soccersim.reproduce.papers import PAPERS

    for name in papers:
        if name not in PAPERS:
            near = get_close_matches(name, PAPERS, n=1)
            hint = f"did you mean `{near[0]}`?" if near else f"there are {', '.join(PAPERS)}"
            raise InputError(Problem(f"no paper `{name[:60]}`: {hint}"))


def drawn(found: "dict[str, list[Section]]", document: dict[str, Any]) -> dict[str, bytes]:
    """All files by their names: pictures, of which it tells the document, reproduce.json, .html."""
    from soccersim.reproduce.page import page

    files = {}
    for name, sections in found.items():
        for section, entry in zip(sections, document["papers"][name], strict=True):
            if section.figure:
                entry["figure"] = f"{name}-{section.key}.png"
                picture = BytesIO()
                section.figure().savefig(picture, metadata={"Software": None})
                files[entry["figure"]] = picture.getvalue()
    text = json.dumps(document, indent=1, ensure_ascii=False) + "\n"
    return {**files, FILES[0]: text.encode(), FILES[1]: page(document, files).encode()}


def show(section: "Section") -> None:
    """A section on the console; no number is cut, however narrow the console is."""
    from soccersim.cli.tables import Screen, new_table
    from soccersim.reproduce.section import text

    table = new_table(f"[bold]{section.title}[/]")
    for column in section.columns:
        table.add_column(column.replace(" ", "\n"), justify="right", no_wrap=True)
    for i, row in enumerate(section.rows):
        first, *rest = map(text, row)
        wrong = i in section.marks
        table.add_row(f"{first} *" if wrong else first, *rest, style="red" if wrong else None)
    console = Screen()
    if section.rows:
        console.width = max(console.width, Screen(width=WIDEST).measure(table).maximum)
        console.print(table)
    else:
        console.print(f"[bold]{section.title}[/]")
    for line in (*wrongs(section), *map(told, section.summary), *section.notes):
        console.print(f"  {line}", highlight=False, markup=False)
    console.print()


def wrongs(section: "Section") -> list[str]:
    """The reasons why rows are marked, each once, with the rows it is about."""
    from soccersim.reproduce.section import text

    rows: dict[str, list[str]] = {}
    for i, why in section.marks.items():
        rows.setdefault(why, []).append(" ".join(map(text, section.rows[i][:2])))
    return [f"* {', '.join(which)}: {why}" for why, which in rows.items()]


def told(summary: "Summary") -> str:
    """A summary in one line."""
    from soccersim.reproduce.section import text

    parts = [f"paper {text(summary.printed)}"]
    if summary.recomputed is not None:
        parts.append(f"recomputed {text(summary.recomputed)}")
    if summary.ours is not None:
        parts.append(f"ours {text(summary.ours)}{' (fitted)' if summary.fitted else ''}")
    if summary.band:
        low, high = summary.band
        where = "inside" if summary.inside else "outside"
        parts.append(f"5-95 % {text(low)} .. {text(high)}, the paper lies {where}")
    note = f" - {summary.note}" if summary.note else ""
    return f"{summary.what}: {', '.join(parts)}{note}"
