"""The tables as they stand in the papers' own text: every figure as a string of its digits."""

import re
from pathlib import Path

FOLDER = Path(__file__).parents[2].parent / "shared" / "papers"

IDRIS = "idris-forward-inverse-kinematic.txt"
UTAMA = "utama-positioning-and-maneuver.txt"
ARM = "dasmahapatra-3r-planar-arm.txt"
GARCIA = "garcia-sillas-jacobian-model.txt"

IDRIS_HEADS = ("Gyro", "PWM", "PWM", "PWM", "Mileage", "Measured Distance", "Start")
POINT = r"\((-?[\d.]+), (-?[\d.]+)\)"


def text(file):
    return (FOLDER / file).read_text(encoding="utf-8")


def idris_blocks():
    """The seven tables, each a list of rows, each a list of words; cells without words left out."""
    blocks = re.findall(r"(?:^\|.*\n)+", text(IDRIS), flags=re.MULTILINE)
    assert len(blocks) == len(IDRIS_HEADS)
    assert all(head in block for head, block in zip(IDRIS_HEADS, blocks, strict=True))
    return [[re.findall(r"[^|\s]+", line) for line in block.splitlines()] for block in blocks]


def idris_table(number):
    """The rows that begin with their number."""
    rows = [row for row in idris_blocks()[number - 1] if row[0].isdigit() and len(row) > 1]
    assert [row[0] for row in rows] == [str(n + 1) for n in range(len(rows))]
    return rows


def idris_last_row(number):
    """The figures of the row that sums a table up."""
    return [word for word in idris_blocks()[number - 1][-1] if re.fullmatch(r"[\d.]+", word)]


def idris_text(pattern):
    """The figures of a sentence; the pattern is a regular expression with a group for each."""
    (found,) = re.findall(pattern, text(IDRIS))
    return [found] if isinstance(found, str) else list(found)


def arm_table(number):
    """The rows of numbers between `Table:1`, `Table:2` and the end."""
    part = text(ARM).split("Table:")[number]
    rows = [line.split("\t") for line in part.splitlines() if re.match(r"\d+\t", line)]
    assert [row[0] for row in rows] == [str(n + 1) for n in range(len(rows))]
    return rows


def utama_run(task):
    """A run's points A, B and perhaps C as commanded, by the sensor and measured; its headings."""
    (paragraph,) = re.findall(f"^.*simulate .*{task}.*$", text(UTAMA), re.M)
    parts = re.split(r"sensors?\b|measurement", paragraph)
    assert len(parts) == 3
    commanded, sensor, measured = (
        [list(point) for point in re.findall(POINT, part)] for part in parts
    )
    return commanded, sensor, measured, re.findall(r"-?\d+\.\d+", parts[2].rsplit(")", 1)[1])


def utama_square():
    """The four average errors, in %."""
    (paragraph,) = re.findall("^The result from this experiment.*$", text(UTAMA), re.M)
    return [figure.replace(",", ".") for figure in re.findall(r"(\d+[.,]\d+)%", paragraph)]


def garcia_table():
    """{parameter: [wheel 1, 2, 3]} with LaTeX turned into plain text."""
    rows = [
        line.split("\t") for line in text(GARCIA).splitlines() if re.match(r"\$\\\w+_i\$\t", line)
    ]
    return {
        row[0].strip("$\\").removesuffix("_i"): [plain(word) for word in row[1:]] for row in rows
    }


def plain(latex):
    """`$(\\frac{L}{2}, ...)$` as `(L/2, ...)`, without degrees."""
    latex = latex.strip("$°").replace("L\\sqrt{3}", "L sqrt(3)").replace(", ", ",")
    return re.sub(r"\\frac\{(.+?)\}\{(.+?)\}", r"\1/\2", latex)
