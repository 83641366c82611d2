"""What stands in a replay page, read as its own script reads it."""

import json
import re
import zlib

import numpy as np


def told(text):
    """The document and the channels of a page."""
    return read(unspelt(re.search(r'id="data">([^<]*)</script>', text)[1]))


def unspelt(letters):
    """The bytes that are spelt so."""
    kinds = [chr(code) for code in range(ord("#"), ord("~") + 1) if chr(code) != "<"]
    value = {letter: number for number, letter in enumerate(kinds)}
    pairs = zip(letters[::2], letters[1::2], strict=True)
    bits = "".join(f"{91 * value[a] + value[b]:013b}" for a, b in pairs)
    data = bytes(int(bits[at : at + 8], 2) for at in range(0, len(bits) - 7, 8))
    return data[4 : 4 + int.from_bytes(data[:4], "little")]


def read(data):
    data = zlib.decompress(data)
    size = int.from_bytes(data[:4], "little")
    document = json.loads(data[4 : 4 + size])
    found, at, rows = {}, 4 + size, document["rows"]
    for channel in document["channels"]:
        table = np.zeros((rows, channel["columns"]))
        for column in range(channel["columns"]):
            for row in range(rows):
                number, at = data[at], at + 1
                if number == 255:
                    number, at = int.from_bytes(data[at : at + 4], "little"), at + 4
                table[row, column] = -(number + 1) // 2 if number % 2 else number // 2
        for _ in range(channel["order"]):
            table = table.cumsum(axis=0)
        below = found[channel["on"]] if channel["on"] else 0.0
        found[channel["key"]] = table * channel["step"] + below
    assert at == len(data)
    for key in list(found):
        if key + "?" in found:
            found[key][found[key + "?"] == 0] = np.nan
    return document, found
