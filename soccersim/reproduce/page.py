"""One HTML file with all that was reproduced: tables, marks, pictures; opens from disk."""

from base64 import b64encode
from collections.abc import Mapping
from html import escape
from typing import Any

from soccersim.reproduce.papers import PAPERS
from soccersim.reproduce.section import text

STYLE = """
:root { color-scheme: light dark; --line: #8886; --soft: #8882; --wrong: #c62828; --ours: #1565c0 }
@media (prefers-color-scheme: dark) { :root { --wrong: #ff8a80; --ours: #90caf9 } }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem }
.wide { overflow-x: auto } table { border-collapse: collapse; margin: .7rem 0; font-size: 13.5px }
th, td { padding: .15rem .6rem; border-bottom: 1px solid var(--line); text-align: right }
th { background: var(--soft); text-align: right; vertical-align: bottom }
td:first-child, th:first-child, td.why { text-align: left }
tr.wrong td { color: var(--wrong) } td.why { font-size: 12.5px; max-width: 26rem }
.fitted { font-style: italic } img { max-width: 100%; background: white; border-radius: 6px }
nav a { margin-right: 1rem } h2 { margin-top: 3rem } .note { opacity: .8; max-width: 50rem }
"""


def page(document: dict[str, Any], pictures: Mapping[str, bytes]) -> str:
    """The page of a reproduce.json document, whose pictures are PNG files by their names."""
    papers = document["papers"]
    links = "".join(f'<a href="#{name}">{name}</a>' for name in papers)
    body = "".join(_paper(name, sections, pictures) for name, sections in papers.items())
    intro = (
        "The papers' values as printed, ours as simulated, and the difference. A row in red is "
        "wrong in the paper, with the reason. <i>Fitted</i> numbers come from an error model "
        "fitted to that very table; <b>physics</b> is motors, slipping wheels and sensors."
    )
    return (
        '<!doctype html><html lang="en"><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width"><title>soccersim reproduce</title>'
        f"<style>{STYLE}</style><h1>The papers, again</h1><p>{intro}</p><nav>{links}</nav>"
        f"{body}</html>\n"
    )


def _paper(name: str, sections: list[dict[str, Any]], pictures: Mapping[str, bytes]) -> str:
    inner = "".join(_section(section, pictures) for section in sections)
    return f'<h2 id="{escape(name)}">{escape(PAPERS[name])}</h2>{inner}'


def _section(section: dict[str, Any], pictures: Mapping[str, bytes]) -> str:
    parts = [f"<h3>{escape(section['title'])}</h3>"]
    if section["rows"]:
        parts.append(_table(section))
    if section["summary"]:
        parts.append(_summary(section["summary"]))
    parts += [f'<p class="note">{escape(note)}</p>' for note in section["notes"]]
    if section.get("figure"):
        data = b64encode(pictures[section["figure"]]).decode()
        title = escape(section["title"])
        parts.append(f'<img alt="{title}" src="data:image/png;base64,{data}">')
    return "".join(parts)


def _table(section: dict[str, Any]) -> str:
    marks = section["marks"]
    head = "".join(f"<th>{escape(column)}</th>" for column in section["columns"])
    rows = []
    for i, row in enumerate(section["rows"]):
        why = marks.get(str(i), "")
        cells = "".join(f"<td>{escape(text(cell))}</td>" for cell in row)
        last = f'<td class="why">{escape(why)}</td>' if marks else ""
        rows.append(f"<tr{' class=wrong' if why else ''}>{cells}{last}</tr>")
    head += "<th></th>" if marks else ""
    return f'<div class="wide"><table><tr>{head}</tr>{"".join(rows)}</table></div>'


def _summary(summary: list[dict[str, Any]]) -> str:
    head = ("", "paper prints", "recomputed", "ours", "5-95 %", "paper inside", "")
    rows = []
    for s in summary:
        band = " .. ".join(text(value) for value in s["band"]) if s["band"] else ""
        ours = text(s["ours"]) + (" (fitted)" if s["fitted"] else "")
        cells = (s["what"], text(s["printed"]), text(s["recomputed"]), ours, band)
        inside = text(s["inside"])
        tail = f'<td>{inside}</td><td class="why">{escape(s["note"])}</td>'
        rows.append("<tr>" + "".join(f"<td>{escape(c)}</td>" for c in cells) + tail + "</tr>")
    titles = "".join(f"<th>{title}</th>" for title in head)
    return f'<div class="wide"><table><tr>{titles}</tr>{"".join(rows)}</table></div>'
