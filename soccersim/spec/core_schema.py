"""The core schema of YAML 1.2: which value a word without quotes is. Source: yaml.org/spec/1.2.2.

Stricter in what cannot be used here: infinite numbers, integers beyond 64 bits, odd characters.
"""

import re
from math import isinf

from soccersim.problems import one_line

MAX_INTEGER = 2**63 - 1  # what an array of integers can hold
MAX_DIGITS = 66  # more than enough for it in any base

CONSTANTS: dict[str, bool | None] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL")),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
}
INTEGER = re.compile(r"[-+]?[0-9]+|0o[0-7]+|0x[0-9a-fA-F]+")
FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
NOT_FINITE = re.compile(r"[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)")


def plain(word: str) -> bool | int | float | str | None:
    """The value of a word without quotes; ValueError says why there is none."""
    if word in CONSTANTS:
        return CONSTANTS[word]
    if INTEGER.fullmatch(word):
        return integer(word)
    if FLOAT.fullmatch(word):
        number = float(word)
        if isinf(number):
            raise ValueError(f"{one_line(word)} is too large for a number")
        return number
    if NOT_FINITE.fullmatch(word):
        raise ValueError(f"a finite number is needed, not {word}")
    return text(word)


def integer(word: str) -> int:
    """The whole number of a word: decimal (010 is ten), 0o octal or 0x hexadecimal."""
    base = {"0o": 8, "0x": 16}.get(word[:2], 10)
    number = int(word, base) if len(word) <= MAX_DIGITS else MAX_INTEGER + 1
    if abs(number) > MAX_INTEGER:
        raise ValueError(f"{one_line(word)} is too large for an integer (at most {MAX_INTEGER})")
    return number


def text(word: str) -> str:
    """A text as it is, if its characters can be written out again."""
    if "\0" in word:
        raise ValueError("a text may not hold the character NUL")
    try:  # JSON spells a character beyond U+FFFF as two halves
        return word.encode("utf-16", "surrogatepass").decode("utf-16")
    except UnicodeDecodeError:
        raise ValueError("half of a surrogate pair (U+D800 to U+DFFF) is no character") from None
