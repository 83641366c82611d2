"""Files that nobody should call a scenario: refused in one line, at once, in little memory."""

import os
import subprocess
import sys

import pytest

ROBOT = "  - {{name: r{}, model: {}, start: [0, 0, 0]}}\n"


def write_hostile(folder):
    """Files that nobody should call a scenario, by name."""
    (folder / "empty.yaml").write_bytes(b"")
    (folder / "binary.yaml").write_bytes(bytes(range(256)) * 99)
    (folder / "folder.yaml").mkdir()
    os.mkfifo(folder / "fifo.yaml")
    with open(folder / "large.yaml", "wb") as file:
        file.truncate(200_000_000)
    (folder / "brackets.yaml").write_text("[" * 50_000)
    bomb = "a: &a [x, x, x, x, x, x, x, x, x]\n"
    for old, new in zip("abcdefgh", "bcdefghi", strict=True):
        bomb += f"{new}: &{new} [{', '.join([f'*{old}'] * 9)}]\n"
    (folder / "aliases.yaml").write_text(bomb)
    merge = "a0: &a0 {x: 1}\n"
    for i in range(1, 25):
        merge += f"a{i}: &a{i}\n  <<: [*a{i - 1}, *a{i - 1}]\n"
    (folder / "merge.yaml").write_text(merge)
    entries = "".join(f"k{i}: {i}\n" for i in range(5900))
    (folder / "fat.yaml").write_text(entries)
    head = "version: 1\nname: x\nfield: msl\nrobots:\n"
    robots = "".join(ROBOT.format(i, "./fat.yaml") for i in range(22))
    (folder / "fat-robots.yaml").write_text(head + robots)
    (folder / "robots.yaml").write_text(
        head + "".join(ROBOT.format(i, "garcia") for i in range(1200))
    )


HOSTILE = {
    "empty": "empty.yaml:1:1: is empty: a YAML document is needed",
    "binary": "binary.yaml:2:118: byte 0x80 is not UTF-8: a YAML text is needed",
    "folder": "folder.yaml: is not a file: a YAML file is needed",
    "fifo": "fifo.yaml: is not a file: a YAML file is needed",
    "large": "large.yaml: is larger than 96 KiB: a file holds less",
    "brackets": "brackets.yaml:1:33: more than 32 levels: nest less deeply",
    "aliases": "aliases.yaml:1:4: anchors (&) and aliases (*) are not allowed: write the value "
    "out, or quote the text",
    "merge": "merge.yaml:1:5: anchors (&) and aliases (*) are not allowed: write the value out, "
    "or quote the text",
    "fat-robots": "fat-robots.yaml:5:23: robots.0.model: with this robot the scenario has more "
    "than 12000 keys and values: use less",
    "robots": "robots.yaml:1204:6: more than 12000 keys and values: a file holds fewer",
}


@pytest.mark.parametrize("name", HOSTILE)
def test_no_file_is_too_hostile(soccersim, tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    write_hostile(tmp_path)
    ended = soccersim("run", f"./{name}.yaml", "--out", "results")
    assert (ended.code, ended.out, ended.lines) == (2, "", [HOSTILE[name]])
    assert not (tmp_path / "results").exists()


WATCH = """
import os, resource, sys
from soccersim.cli.main import main
if os.fork() == 0:
    main()
code = os.waitstatus_to_exitcode(os.wait()[1])
print(code, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="megabytes are counted as Linux does")
@pytest.mark.parametrize("name", ["large", "brackets", "merge", "fat-robots", "robots"])
def test_the_most_hostile_files_take_no_memory_to_refuse(tmp_path, name):
    write_hostile(tmp_path)
    words = [sys.executable, "-c", WATCH, "run", f"./{name}.yaml", "--out", "results"]
    ended = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=True)
    code, megabytes = map(int, ended.stdout.split())
    assert (code, ended.stderr) == (2, HOSTILE[name] + "\n")
    assert megabytes < 200
    assert not (tmp_path / "results").exists()
