"""The strict YAML reader: what it reads, where things stand, what it refuses, and never a crash."""

import json
import os
import re
import socket
import subprocess
import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from soccersim.problems import InputError
from soccersim.spec.core_schema import MAX_INTEGER
from soccersim.spec.yaml12 import MAX_BYTES, MAX_DEPTH, Mark, parse, read


def value_of(text):
    return parse(text, "f.yaml").value


def refusal(call, *arguments):
    """The one line that a user reads."""
    with pytest.raises(InputError) as caught:
        call(*arguments)
    assert len(caught.value.problems) == 1
    line = str(caught.value)
    assert line.isprintable()
    return line


def refusal_or_none(call, *arguments):
    try:
        call(*arguments)
    except InputError:
        return refusal(call, *arguments)


def refused(text):
    return refusal(parse, text, "f.yaml")


@pytest.mark.parametrize(
    ("word", "value"),
    [
        *[(word, None) for word in ("null", "Null", "NULL", "~", "")],
        *[(word, True) for word in ("true", "True", "TRUE")],
        *[(word, False) for word in ("false", "False", "FALSE")],
        *[(word, word) for word in ("no", "on", "yes", "off", "y", "nULL", "tRUE")],
        *[(word, word) for word in ("1_000", "1:30", "2001-01-01", "0b1", "0x", "0o9", "1e", ".")],
        *[("0", 0), ("-0", 0), ("+5", 5), ("010", 10), ("0o17", 15), ("0xfF", 255)],
        *[("1e-3", 0.001), (".5", 0.5), ("1.", 1.0), ("-.5e+3", -500.0), ("1E2", 100.0)],
        *[('"1"', "1"), ("'true'", "true"), ('""', ""), ("'~'", "~"), ('"\\u00e9"', "é")],
        *[("|\n  a\n  b\n", "a\nb\n"), (">-\n  a\n  b\n", "a b"), ("[1, [a, ]]", [1, ["a"]])],
        *[("{x: 1, 'y': 2}", {"x": 1, "y": 2}), ("a b#c # d", "a b#c"), ('"\\/"', "/")],
    ],
)
def test_words_mean_what_the_core_schema_of_yaml_1_2_says(word, value):
    read = value_of(f"key: {word}")["key"]
    assert read == value
    assert type(read) is type(value)


def test_windows_line_ends_a_byte_order_mark_and_a_version_change_nothing():
    expected = {"a": [1, 2], "b": "x"}
    assert value_of("\ufeffa:\r\n- 1\r\n- 2\r\nb: x\r\n") == expected
    assert value_of("%YAML 1.2\n---\na: [1, 2]\nb: x\n...\n") == expected


def test_every_value_and_every_key_has_its_place():
    tree = parse("a: 1\nb:\n  - x: [2, 3]\n  - y\n", "f.yaml")
    assert tree.marks == {
        (): Mark("f.yaml", 1, 1),
        ("a",): Mark("f.yaml", 1, 4),
        ("b",): Mark("f.yaml", 3, 3),
        ("b", 0): Mark("f.yaml", 3, 5),
        ("b", 0, "x"): Mark("f.yaml", 3, 8),
        ("b", 0, "x", 0): Mark("f.yaml", 3, 9),
        ("b", 0, "x", 1): Mark("f.yaml", 3, 12),
        ("b", 1): Mark("f.yaml", 4, 5),
    }
    assert tree.keys == {
        ("a",): Mark("f.yaml", 1, 1),
        ("b",): Mark("f.yaml", 2, 1),
        ("b", 0, "x"): Mark("f.yaml", 3, 5),
    }
    assert tree.place(("b", 0, "z", 7)) == Mark("f.yaml", 3, 5)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("", "1:1: is empty"),
        ("# only a comment\n", "1:1: is empty"),
        ("---\n", "1:1: is empty"),
        ("a: 1\nb: 2\na: 3\n", "3:1: the key `a` stands on line 1 already"),
        ("{a: 1, a: 2}", "1:8: the key `a` stands on line 1 already"),
        ("a:\n\tb: 1", "2:1: a tab stands here: use spaces"),
        ("a: &x 1", "1:4: anchors (&) and aliases (*) are not allowed"),
        ("a: *x", "1:4: anchors (&) and aliases (*) are not allowed"),
        ("a: *.csv", "1:5: anchors (&) and aliases (*) are not allowed"),
        ("<<: {a: 1}", "1:1: merge keys (<<) are not allowed"),
        ("a: !!python/object/apply:os.system [x]", "1:4: tags (!) are not allowed"),
        ("a: !foo x", "1:4: tags (!) are not allowed"),
        ("!", "1:1: tags (!) are not allowed"),
        ("%YAML 1.1\n---\na: 1", "1:1: this is read as YAML 1.2"),
        ("%TAG !e! x:\n---\na: 1", "1:1: this is read as YAML 1.2"),
        ("%YAML 1.2\n", "2:1: --- is missing"),
        ("a: 1\n---\nb: 1", "2:1: a second document starts here"),
        ("1: a", "1:1: a key must be a text, not 1: put it in quotes"),
        ("null: a", "1:1: a key must be a text, not nothing (null)"),
        ("? [a]\n: 1", "1:3: a key must be a text, not a list or a mapping"),
        ("a: {x:1}", "1:5: `x:1` is one word: put a space after the colon"),
        ("a: 1\nb", "2:1: a colon and a space are needed"),
        ("a: b: c", "1:5: `: ` may not stand here"),
        ("a: [1, 2", "1:4: this bracket is never closed: `]` is missing"),
        ("a: [1, 2}", "1:9: a comma or `]` is missing before this"),
        ("[1,, 2]", "1:4: a value is missing before `,`"),
        ("a:\n  b: 1\n c: 2", "3:2: this does not line up with what stands above"),
        ("a: 'it's'", "1:8: the value ends before this: put the whole text in quotes"),
        ('a: "x', "1:4: this quote is never closed"),
        ('a: "C:\\dir"', "1:8: unknown escape: write \\\\ for a backslash"),
        ('a: "\\u12"', "1:7: this escape needs 4 hexadecimal digits"),
        ('a: "\\UFFFFFFFF"', "1:7: this number is too large"),
        ('a: "\\ud800"', "1:4: half of a surrogate pair"),
        ('a: "\\0"', "1:4: a text may not hold the character NUL"),
        ("a: @b", "1:4: a text starts with `@`: put it in quotes"),
        ("a: |x", "1:5: after | or > only"),
        ("a: .inf", "1:4: a finite number is needed, not .inf"),
        ("a: -.INF", "1:4: a finite number is needed, not -.INF"),
        ("a: .nan", "1:4: a finite number is needed, not .nan"),
        ("a: 1e999", "1:4: 1e999 is too large for a number"),
        (f"a: {MAX_INTEGER + 1}", f"1:4: {MAX_INTEGER + 1} is too large for an integer"),
        ("a: " + "9" * 5000, "1:4: 9999"),
        ("%YAML 1." + "9" * 5000, "1:9: this number is too large"),
        ("a: b\nc: \x00", "2:4: a YAML text may not hold the character U+0000"),
        ("a: \u2028b", "1:4: a YAML text may not hold the character U+2028"),
        ("a: \udc80", "1:4: a YAML text may not hold the character U+DC80"),
        ("x" * (MAX_BYTES + 1), " is larger than 96 KiB"),
    ],
)
def test_what_is_refused_is_told_in_one_line_with_its_place(text, line):
    assert refused(text).startswith(f"f.yaml:{line}")


BOMB = "a: &a [x, x]\n" + "".join(f"{b}: &{b} [*{a}, *{a}]\n" for a, b in zip("abc", "bcd"))  # noqa: B905
MERGES = "a: {x: 1}\n" + "b: {<<: [" + "{x: 1}, " * 500 + "]}\n"


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("[" * 50_000, "1:33: more than 32 levels"),
        ("{" * 50_000, "1:2: a key must be a text"),
        ("{a: " * 20_000, "1:129: more than 32 levels"),
        ("- " * 40_000, "1:65: more than 32 levels"),
        ("[\n" * 40_000, "33:1: more than 32 levels"),
        ("? " * 40_000, "1:3: a key must be a text"),
        ("]" * 50_000, "1:1: a value is missing before `]`"),
        ("[" + "a," * 40_000, "1:24000: more than 12000 keys and values"),
        ("- \n" * 30_000, "12000:2: more than 12000 keys and values"),
        ("---\n" * 20_000, "1:1: is empty"),
        ('"' + "a\n" * 40_000, "1:1: this quote is never closed"),
        (BOMB, "1:4: anchors (&) and aliases (*) are not allowed"),
        (MERGES, "2:5: merge keys (<<) are not allowed"),
    ],
)
def test_texts_made_to_hurt_are_refused(text, line):
    assert refused(text).startswith(f"f.yaml:{line}")


def test_the_deepest_nesting_that_is_allowed_is_read():
    assert value_of("[" * MAX_DEPTH + "]" * MAX_DEPTH)
    assert "levels" in refused("[" * (MAX_DEPTH + 1) + "]" * (MAX_DEPTH + 1))


def test_a_large_scenario_with_22_robots_written_out_is_read():
    robot = "  - name: r\n    start: [1.5, -0.25, 90]\n    wheels:\n" + "".join(
        f"      coefficient_{n}: {{value: {n}.25e-3, table: [{n}, 200]}}\n" for n in range(55)
    )
    text = "robots:\n" + robot * 22
    assert 60_000 < len(text) < MAX_BYTES
    assert len(value_of(text)["robots"]) == 22


texts = st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0"), max_size=20)
plain_values = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-MAX_INTEGER, MAX_INTEGER)
    | st.floats(allow_nan=False, allow_infinity=False)
    | texts,
    lambda inner: st.lists(inner, max_size=5) | st.dictionaries(texts, inner, max_size=5),
    max_leaves=30,
)


def block(value, indent=""):
    """YAML in block style, as people write it; texts are in single quotes."""
    if isinstance(value, dict) and value:
        return "".join(
            f"\n{indent}{json.dumps(k)}:{block(v, indent + ' ')}" for k, v in value.items()
        )
    if isinstance(value, list) and value:
        return "".join(f"\n{indent}-{block(entry, indent + '  ')}" for entry in value)
    return " " + json.dumps(value).replace("\x7f", "\\x7f")


@settings(deadline=None)
@given(value=plain_values)
def test_json_is_yaml_and_comes_back_equal(value):
    text = json.dumps(value).replace("\x7f", "\\x7f")  # a control character, for YAML
    assert value_of(text) == value
    assert repr(value_of(json.dumps(value, indent=1).replace("\x7f", "\\x7f"))) == repr(value)


@settings(deadline=None)
@given(value=plain_values)
def test_block_style_comes_back_equal_and_every_value_has_a_place(value):
    tree = parse(block(value), "f.yaml")
    assert repr(tree.value) == repr(value)
    paths = set(paths_of(value))
    assert set(tree.marks) == paths
    assert set(tree.keys) == {path for path in paths if path and isinstance(path[-1], str)}


def paths_of(value, path=()):
    yield path
    listed = dict(enumerate(value)) if isinstance(value, list) else value
    for step, entry in listed.items() if isinstance(listed, dict) else ():
        yield from paths_of(entry, (*path, step))


pieces = st.sampled_from([*"[]{},:-?#&*!|>'\"%@`\\ \t\n\r~<=.01aé\0", "\n  ", ": ", "- ", "a: "])


@settings(deadline=None)
@given(text=st.text() | st.lists(pieces, max_size=60).map("".join))
def test_no_text_does_worse_than_a_refusal(text):
    line = refusal_or_none(parse, text, "f.yaml")
    assert line is None or re.match(r"f\.yaml:[1-9][0-9]*:[1-9]", line)
    if line is None:
        json.dumps(value_of(text), allow_nan=False, ensure_ascii=False).encode()


@settings(deadline=None)
@given(data=st.binary(max_size=200))
def test_no_file_does_worse_than_a_refusal(data, tmp_path_factory):
    path = tmp_path_factory.getbasetemp() / "fuzz.yaml"
    path.write_bytes(data)
    line = refusal_or_none(read, path)
    assert line is None or line.startswith(f"{path}:")


def test_a_file_is_read_with_its_own_name_in_every_place(tmp_path):
    path = tmp_path / "s.yaml"
    path.write_bytes("\ufeffname: é\r\n".encode())
    tree = read(path)
    assert tree.value == {"name": "é"}
    assert tree.marks["name",] == Mark(str(path), 1, 7)


def test_what_is_not_a_readable_text_file_is_refused_at_once(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    os.mkfifo("pipe")
    os.symlink("loop", "loop")
    (tmp_path / "latin").write_bytes("a: 1\nb: é".encode("latin-1"))
    (tmp_path / "utf16").write_bytes("a: 1".encode("utf-16"))
    (tmp_path / "program").write_bytes(b"\x7fELF\x02\x01\x01\x00")
    with open("sparse", "wb") as file:
        file.truncate(200_000_000)
    with socket.socket(socket.AF_UNIX) as server:
        server.bind("socket")
        for name in (".", "pipe", "socket", "/dev/zero"):
            assert refusal(read, name) == f"{name}: is not a file: a YAML file is needed"
    assert refusal(read, "none") == "none: cannot be read: No such file or directory"
    assert refusal(read, "loop").startswith("loop: cannot be read: ")
    assert refusal(read, "x" * 5000).startswith("xxx")
    assert refusal(read, "a\0b") == "a\\x00b: cannot be read: embedded null byte"
    assert refusal(read, "latin").startswith("latin:2:4: byte 0xe9 is not UTF-8")
    assert refusal(read, "utf16").startswith("utf16:1:1: byte 0xff is not UTF-8")
    assert refusal(read, "program").startswith("program:1:1: a YAML text may not hold")
    assert refusal(read, "sparse") == "sparse: is larger than 96 KiB: a file holds less"


@pytest.mark.skipif(os.name == "posix" and os.geteuid() == 0, reason="root may read everything")
def test_a_file_without_permission_is_refused(tmp_path):
    (tmp_path / "secret").touch(mode=0)
    assert "cannot be read: Permission denied" in refusal(read, tmp_path / "secret")


def test_the_reader_does_not_import_pydantic():
    code = "import sys, soccersim.spec.yaml12; sys.exit('pydantic' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
