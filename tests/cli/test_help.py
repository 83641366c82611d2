"""Help, verbs and usage: quick to answer, with an example each, one line when misused."""

import subprocess
import sys
from importlib import import_module

import click
import pytest

from soccersim import __version__
from soccersim.cli.main import VERBS

HEAVY = ("numpy", "pydantic", "numba", "rich", "matplotlib", "pygame", "av", "pymunk", "yaml")
LOADED = f"""
import sys
from soccersim.cli.main import VERBS, soccersim
for words in (["--help"], ["--version"], *([verb, "--help"] for verb in VERBS)):
    soccersim.main(words, "soccersim", standalone_mode=False)
    loaded = [name for name in {HEAVY!r} if name in sys.modules]
    print("loaded by", words, loaded) if loaded else None
"""


def test_help_waits_for_nothing_heavy():
    words = [sys.executable, "-c", LOADED]
    ended = subprocess.run(words, capture_output=True, text=True, check=True)
    assert "Usage: soccersim run" in ended.stdout
    assert "loaded by" not in ended.stdout


def test_a_newcomer_who_types_the_name_alone_reads_what_there_is(soccersim):
    alone = soccersim()
    assert (alone.code, alone.err) == (0, "")
    assert "soccersim run defender" in alone.out
    assert all(f"\n  {verb} " in alone.out for verb in VERBS)
    assert soccersim("--help").out == soccersim("-h").out == alone.out
    assert soccersim("--version").out == f"soccersim, version {__version__}\n"


@pytest.mark.parametrize("verb", VERBS)
def test_the_help_of_every_verb_shows_an_example(soccersim, verb):
    told = soccersim(verb, "--help")
    assert told.code == 0
    assert f"\n  soccersim {verb}" in told.out
    command = import_module(f"soccersim.cli.{verb}").command
    assert all(option.help for option in command.params if isinstance(option, click.Option))


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["rnu"], "soccersim: no command `rnu`: did you mean `run`?; see soccersim --help"),
        (["run"], "soccersim run: Missing argument 'SCENARIO'; see soccersim run --help"),
        (
            ["run", "defender", "--frames"],
            "soccersim run: --frames and --video need a folder: --out DIR; see soccersim run "
            "--help",
        ),
        (
            ["run", "defender", "--runs", "0"],
            "soccersim run: Invalid value for '--runs': 0 is not in the range 1<=x<=100000; "
            "see soccersim run --help",
        ),
    ],
)
def test_misuse_is_told_in_one_line(soccersim, words, line):
    ended = soccersim(*words)
    assert (ended.code, ended.out, ended.lines) == (2, "", [line])


def test_a_misspelt_option_is_refused_with_the_nearest(soccersim):
    ended = soccersim("run", "defender", "--sed", 3)
    assert (ended.code, ended.out, len(ended.lines)) == (2, "", 1)
    assert "--sed" in ended.err
    assert "--seed" in ended.err


def test_only_debug_shows_a_traceback(soccersim):
    with pytest.raises(Exception, match="no scenario `nobody`"):
        soccersim("run", "nobody", "--debug")
    ended = soccersim("run", "nobody")
    assert (ended.code, len(ended.lines)) == (2, 1)


def test_a_fault_of_ours_is_one_line_too_and_says_how_to_see_more(soccersim, monkeypatch):
    def fail(*_, **__):
        raise ZeroDivisionError("float division by zero")

    monkeypatch.setattr("soccersim.spec.load.load_scenario", fail)
    ended = soccersim("run", "defender")
    assert ended.code == 4
    assert ended.lines == [
        "float division by zero",
        "ZeroDivisionError: a fault of soccersim itself; --debug shows where",
    ]


def test_list_names_all_that_is_bundled_and_its_json_is_one_document(soccersim):
    from json import loads

    from soccersim.bundled import PLACES, names

    told, shown = loads(soccersim("list", "--json").out), soccersim("list").out
    assert {kind: list(entries) for kind, entries in told.items()} == {k: names(k) for k in PLACES}
    titles = [
        line.strip()
        for line in shown.splitlines()
        if line[:1].isalpha() and " " not in line.strip()
    ]
    assert titles == ["scenarios", "robots", "fields", "rules", "senses", "strategies"]
    for entries in told.values():
        for name, about in entries.items():
            assert name in shown
            assert about, name
            assert not about.endswith(".")


def test_letters_that_an_output_lacks_are_written_otherwise(process, scenario):
    scenario(("- name: one", '- name: "é→😀"'))
    told = process("run", "./two.yaml", env={"PYTHONIOENCODING": "ascii"})
    assert told.code == 0
    assert r"\xe9\u2192\U0001f600 1" in told.out
