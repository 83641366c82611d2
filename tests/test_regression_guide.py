"""docs/regression.md and its workflow for GitHub: what they say is so, and what they run runs."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import click
import pytest
import yaml
from pages import ROOT, rows

from soccersim.cli.main import soccersim
from soccersim.regress.standing import EXIT, Verdict

GUIDE = ROOT / "docs" / "regression.md"
WORKFLOW = ROOT / "docs" / "github-actions-regression.yml"
BASH = ("bash", "--noprofile", "--norc", "-eo", "pipefail")  # as GitHub runs `shell: bash`
CURRENT = {  # major versions when this was written
    "actions/checkout": "v7",
    "actions/setup-python": "v7",
    "actions/cache/restore": "v6",
    "actions/cache/save": "v6",
    "actions/upload-artifact": "v7",
}
needs_bash = pytest.mark.skipif(not shutil.which("bash"), reason="needs bash")


@pytest.fixture(scope="module")
def workflow():
    return yaml.safe_load(WORKFLOW.read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def steps(workflow):
    return workflow["jobs"]["regression"]["steps"]


@pytest.fixture(scope="module")
def scripts(steps):
    return {step["name"]: step["run"] for step in steps if "run" in step}


def commands(script):
    """The soccersim commands of a script, as words; variables stay as they are written."""
    for line in script.replace("\\\n", " ").splitlines():
        for part in re.split(r"\||&&|;", line):
            words = shlex.split(part, comments=True)
            if words[:1] == ["soccersim"]:
                yield words[1:]


def test_workflow_runs_on_pull_requests_and_may_only_read(workflow):
    assert set(workflow) == {True, "name", "permissions", "concurrency", "env", "defaults", "jobs"}
    assert workflow[True] == {"pull_request": None}  # YAML 1.1 reads `on` as true
    assert workflow["permissions"] == {"contents": "read"}
    assert workflow["defaults"]["run"]["shell"] == "bash"


def test_workflow_uses_actions_of_their_current_versions(steps):
    used = [step["uses"].split("@") for step in steps if "uses" in step]
    assert dict(used) == CURRENT
    checkout = next(step for step in steps if step.get("uses", "").startswith("actions/checkout"))
    assert checkout["with"] == {"fetch-depth": 2, "persist-credentials": False}


def test_every_soccersim_command_of_the_workflow_exists_with_its_options(workflow, scripts):
    found = [words for script in scripts.values() for words in commands(script)]
    assert [words[0] for words in found] == ["--version", "regress"]
    for words in found[1:]:
        words = [workflow["env"].get(word.removeprefix("$"), word) for word in words]
        verb = soccersim.get_command(click.Context(soccersim), words[0])
        context = verb.make_context(words[0], words[1:])
        from soccersim.cli.regress import rule_of

        given = context.params
        assert rule_of(None, given["sprt"], None, None, given["max_pairs"]).nelo == (-50.0, 0.0)
        assert given["report"].parent == given["junit"].parent == Path("report")


@needs_bash
def test_every_script_of_the_workflow_is_bash(scripts):
    assert len(scripts) == 4
    for name, script in scripts.items():
        assert "${{" not in script, name  # a title of a pull request could be a command
        done = subprocess.run([*BASH, "-n"], input=script, text=True, capture_output=True)
        assert (done.returncode, done.stderr) == (0, ""), name


def test_steps_that_must_come_after_a_failure_do(steps):
    names = [step.get("name", "") for step in steps]
    after = steps[names.index("Regression") + 1 :]
    assert [step["if"] for step in after] == ["always()"] * 3
    saved = after[-1]["with"]
    restored = next(step["with"] for step in steps if step.get("id") == "cache")
    assert saved["path"] == restored["path"] == "cache"


def test_guide_tells_every_verdict_with_its_exit_code():
    told = rows(GUIDE, "Did the change make the team better?")
    assert list(told) == [verdict.value for verdict in Verdict]
    for verdict, (_, code) in told.items():
        assert int(code.split(";")[0]) == EXIT[Verdict(verdict)]


def test_guide_tells_every_key_of_the_json_document():
    sys.path.insert(0, str(ROOT / "tests" / "regress"))
    from accounts import comparison

    from soccersim.cli.verdicts import document_of

    cells = rows(GUIDE, "What comes of it")
    told = [key.strip("` ") for cell in cells for key in cell.split(",")]
    assert sorted(told) == sorted(document_of(comparison()))


@pytest.mark.slow
def test_guide_tells_how_many_pairs_it_takes():
    sys.path.insert(0, str(ROOT / "tests" / "regress"))
    import numpy as np
    from synthetic_matches import WORLDS, ends, outcomes, play

    text = GUIDE.read_text(encoding="utf-8")
    told = re.findall(r"\| (\d+) nElo \| \+?([\d.]+) \| (\d+) % \| (\d+) \| (\d+) \|", text)
    assert len(told) == 5
    for row in told:
        nelo, goals, share, mean, most = map(float, row)
        played = play(WORLDS["lively"], nelo, "goals", 600, 400, seed=int(nelo) + 1)
        pairs, _ = ends(outcomes(played.legs, "goals"), "goals")
        assert pairs.mean() == pytest.approx(mean, rel=0.08)
        assert np.quantile(pairs, 0.9) == pytest.approx(most, rel=0.15)
        assert played.legs.mean() == pytest.approx(goals, abs=0.02)
        assert 50 * (np.sign(played.legs) + 1).mean() == pytest.approx(share, abs=1)


TEAM = """\
from soccersim.strategy import Command, Strategy


class Team(Strategy):
    def decide(self, view):
        return [Command() for _ in view.robots]
"""


class Runner:
    """A machine that does what GitHub's does, as far as that goes without GitHub."""

    def __init__(self, folder, workflow):
        self.folder, self.origin = folder / "workspace", folder / "origin"
        self.env = {**os.environ, **workflow["env"], "DURATION": "0.5", "MAX_PAIRS": "2"}
        self.env["GITHUB_STEP_SUMMARY"] = str(folder / "summary.md")
        # kernels from where the tests have them: to compile takes half a minute
        del self.env["SOCCERSIM_CACHE"]
        if "SOCCERSIM_CACHE" in os.environ:
            self.env["SOCCERSIM_CACHE"] = os.environ["SOCCERSIM_CACHE"]
        self.env["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
        self.git("init", "--quiet", "--initial-branch=main", str(self.origin), at=folder)

    def git(self, *words, at=None):
        who = ("-c", "user.name=a", "-c", "user.email=a@b")
        return subprocess.run(["git", *who, *words], cwd=at or self.origin, check=True)

    def commit(self, **files):
        for name, text in files.items():
            (self.origin / f"{name}.py").write_text(text, encoding="utf-8")
        self.git("add", ".")
        self.git("commit", "--quiet", "--message=x")

    def pull_request(self, **files):
        """A branch, and the merge that GitHub tests; checked out two commits deep."""
        self.git("checkout", "--quiet", "-b", "change")
        self.commit(**files)
        self.git("checkout", "--quiet", "main")
        self.git("merge", "--quiet", "--no-ff", "--message=merge", "change")
        url = self.origin.as_uri()
        words = ("clone", "--quiet", "--depth=2", url, str(self.folder))
        self.git(*words, at=self.origin.parent)

    def run(self, script):
        return subprocess.run(
            [*BASH, "-c", script], cwd=self.folder, env=self.env, capture_output=True, text=True
        )


@pytest.fixture
def runner(tmp_path, workflow):
    return Runner(tmp_path, workflow)


def play(runner, scripts):
    """The steps that need no GitHub: worktree, regression, summary."""
    assert runner.run(scripts["The code as it is now"]).returncode == 0
    done = runner.run(scripts["Regression"])
    assert runner.run(scripts["The verdict on the page of this run"]).returncode == 0
    return done


@needs_bash
@pytest.mark.slow
def test_a_pull_request_that_changes_a_comment_is_identical(runner, scripts):
    runner.commit(my_team=TEAM)
    runner.pull_request(my_team=TEAM + "# a comment\n")
    done = play(runner, scripts)
    assert done.returncode == 0, done.stderr
    assert "IDENTICAL" in (runner.folder.parent / "summary.md").read_text()
    report = runner.folder / "report"
    assert {"report.html", "junit.xml", "verdict.txt"} <= {path.name for path in report.iterdir()}
    assert ElementTree.parse(report / "junit.xml").getroot()[0].get("failures") == "0"
    again = runner.run(scripts["Regression"])  # from the cache: it plays nothing
    assert again.returncode == 0
    assert "IDENTICAL" in again.stdout


@needs_bash
@pytest.mark.slow
def test_a_pull_request_that_breaks_the_team_is_stopped(runner, scripts):
    runner.commit(my_team=TEAM)
    runner.pull_request(my_team=TEAM.replace("[Command() for", "[nonsense for"))
    done = play(runner, scripts)
    assert done.returncode == 4, done.stderr
    assert "INVALID" in (runner.folder.parent / "summary.md").read_text()
    page = (runner.folder / "report" / "report.html").read_text()
    assert "NameError" in page
    suite = ElementTree.parse(runner.folder / "report" / "junit.xml").getroot()[0]
    assert int(suite.get("errors")) > 0


@needs_bash
@pytest.mark.slow
def test_a_pull_request_that_brings_a_team_plays_the_bundled_one(runner, scripts):
    runner.commit(other="")
    runner.pull_request(my_team=TEAM)
    done = play(runner, scripts)
    assert done.returncode in (0, 1), done.stderr
    assert "roles" in (runner.folder / "report" / "verdict.txt").read_text()
