"""The papers' own formulae, as LaTeX in their texts, turned into numbers."""

import math
import re

import numpy as np

FUNCTIONS = {"sin": math.sin, "cos": math.cos, "__builtins__": {}}


def numbered(text, number):
    """The formula that ends in this number."""
    (found,) = [
        block
        for block in re.findall(r"\$\$(.*?)\$\$", text, re.S)
        if f"({number})" in block.rsplit("quad", 1)[-1]
    ]
    return found.rsplit("\\quad", 1)[0]


def matrices(latex):
    """The matrices in it, each a list of rows of cells."""
    found = re.findall(r"\\begin\{[pb]matrix\}(.*?)\\end\{[pb]matrix\}", latex, re.S)
    return [
        [row.split("&") for row in re.sub(r"\[0\.3em\]", "", block).split("\\\\") if row.strip()]
        for block in found
    ]


def values(matrix, names):
    """The matrix as numbers."""
    return np.array([[value(cell, names) for cell in row] for row in matrix])


def value(latex, names):
    """A cell or a right side as a number; names are LaTeX, such as `\\omega_{1x}`."""
    text = re.sub(r"\\cdot|\\left|\\right|\\[,;]|\s", "", latex)
    text = text.replace("\\sqrt{3}", "(3**0.5)").replace("\\degree", "(0.017453292519943295)")
    while "\\frac" in text:
        text = re.sub(
            r"\\frac\{([^{}]*|(?:[^{}]*\{[^{}]*\})*[^{}]*)\}\{([^{}]*)\}", r"((\1)/(\2))", text
        )
    for name in sorted(names, key=len, reverse=True):
        if name.startswith("\\") or "_" in name:
            text = text.replace(name, f"({float(names[name])!r})")
    letters = "".join(name for name in names if len(name) == 1)
    if letters:
        text = re.sub(
            rf"(?<![a-z])[{letters}](?![a-z])", lambda m: f"({float(names[m[0]])!r})", text
        )
    text = text.replace("\\", "")
    text = re.sub(r"(?<=[0-9)])(?=\(|sin|cos)", "*", text)
    return float(eval(text, FUNCTIONS))
