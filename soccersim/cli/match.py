"""`soccersim match`."""

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from soccersim.cli.film import PLAIN, FilmCommand, asked_film, can_show, video_option
from soccersim.cli.main import INVALID
from soccersim.cli.results import Results
from soccersim.cli.run import announce_compiling, write
from soccersim.problems import InputError, Problem, Stopped

if TYPE_CHECKING:
    from soccersim.match.supervise import Outcome, Request
    from soccersim.match.turn import State

FILES = ("report.json", "recording.npz", PLAIN, "frames")
PATIENCE = 2.0  # s before the bar appears


@click.command("match", cls=FilmCommand, short_help="Play a match.")
@click.argument("home")
@click.argument("away")
@click.option("--scenario", default="msl-match", show_default=True, help="Bundled name or file.")
@click.option("--seed", type=click.IntRange(min=0), help="Instead of the scenario's own.")
@click.option("--duration", type=float, metavar="S", help="Seconds of the whole match.")
@click.option("--set", "settings", multiple=True, metavar="KEY.PATH=VALUE", help="Change a value.")
@click.option("--out", type=click.Path(path_type=Path), help="Folder for the files.")
@click.option("--frames", is_flag=True, help="Write frames/000000.png and so on, into --out.")
@video_option
@click.option(
    "--isolate",
    type=click.Choice(["match", "team"]),
    default="match",
    show_default=True,
    help="What has a process of its own.",
)
@click.option("--force", is_flag=True, help="Overwrite what is there.")
@click.option("--json", "as_json", is_flag=True, help="One JSON document on stdout.")
def command(
    home: str,
    away: str,
    scenario: str,
    seed: int | None,
    duration: float | None,
    settings: tuple[str, ...],
    out: Path | None,
    frames: bool,
    video: str | None,
    isolate: Any,
    force: bool,
    as_json: bool,
    **part: Any,
) -> None:
    """Play a match of two strategies, HOME against AWAY, and tell how it came out.

    \b
    soccersim match roles chaser
    soccersim match ./my_team.py roles --scenario friendly-match --seed 3
    soccersim match ./teams.py:Mine package.module:Other --out results --video

    HOME and AWAY are bundled strategies (`soccersim list`), files, modules, or entry points of
    installed packages; their options come from the scenario, or from
    --set match.home.options.NAME=VALUE. Without --out the recording is match-SEED.npz.

    A team whose code fails forfeits: the match ends 0:3, or as it stands where that is worse for
    it, and the exit code is 4. docs/faults.md tells what --isolate promises.
    """
    from soccersim.cli.match_tables import show
    from soccersim.match.request import match_request
    from soccersim.match_report import match_report
    from soccersim.record import Recording

    if (frames or video) and out is None:
        raise click.UsageError("--frames and --video need a folder: --out DIR")
    asked = match_request(
        home,
        away,
        scenario,
        seed=seed,
        duration=duration,
        settings=settings,
        isolate=isolate,
    )
    cut = asked_film(video, frames, asked.scenario.duration, **part)
    name = "recording.npz" if out else f"match-{asked.scenario.seed}.npz"
    if not out and not force and Path(name).exists():
        wrong = "is there already: add --force, or name a folder with --out"
        raise InputError(Problem(wrong, name))
    names = tuple(dict.fromkeys((*FILES, video or PLAIN))) if out else (name,)
    with Results(out or Path(), names, force) as results:
        announce_compiling()
        outcome = recorded(asked, results, name)
        document = told(home, away, asked, outcome, str(results.folder / name))
        if out or not as_json:
            recording = Recording.load(document["recording"])
            report = {**document, "report": match_report(recording)}
        if out:
            shown = (frames or video) and can_show(cut, recording)
            film = {"frames": shown and frames, video or PLAIN: shown and video}
            write(recording, report, results, {"report.json": True, **film}, cut)
        if as_json:
            click.echo(json.dumps(document, allow_nan=False))
        else:
            show(report)
        for path in results.written:
            click.echo(f"wrote {path}", err=True)
    tell_faults(document, outcome)
    if outcome.faults:
        click.get_current_context().exit(INVALID)


def recorded(asked: "Request", results: Results, name: str) -> "Outcome":
    """Play, and keep the recording under this name."""
    from dataclasses import replace

    from soccersim.cli.progress import Bar
    from soccersim.match.supervise import play
    from soccersim.match.turn import Turn, read_turn

    spec = asked.scenario
    match = spec.match
    teams = (match.home.strategy, match.away.strategy) if match else ("", "")
    last = read_turn(Turn().buffer)
    with Bar(f"{teams[0]} - {teams[1]}", PATIENCE) as bar, results.new(name) as path:

        def progress(state: "State") -> None:
            nonlocal last
            last = state
            bar(state.share, f"{teams[0]} {state.score[0]} : {state.score[1]} {teams[1]}")

        try:
            return play(replace(asked, recording=path), progress, printed)
        except KeyboardInterrupt:
            at, score = last.share * spec.duration, f"{last.score[0]}:{last.score[1]}"
            raise Stopped(
                f"stopped at {at:.1f} s of {spec.duration:g} s, at {score}; nothing was kept: "
                "run it again, or less of it with --duration SECONDS"
            ) from None


def printed(text: str) -> None:
    """What strategies print: never on standard output, which is ours."""
    sys.stderr.write(text)
    sys.stderr.flush()


def told(
    home: str, away: str, asked: "Request", outcome: "Outcome", recording: str
) -> dict[str, Any]:
    """The document of --json."""
    return {
        "home": home,
        "away": away,
        "seed": asked.scenario.seed,
        "score": list(outcome.score),
        "digest": outcome.digest,
        "duration": outcome.duration,
        "events": outcome.events,
        "faults": outcome.faults,
        "realtime_factor": outcome.realtime_factor,
        "recording": recording,
    }


def tell_faults(document: dict[str, Any], outcome: "Outcome") -> None:
    """On standard error: who forfeits and why, with the last lines of its traceback."""
    if outcome.again:
        click.echo(f"played again, each team by itself, to be certain: {outcome.again}", err=True)
    for fault in document["faults"]:
        team, side, kind = document[fault["side"]], fault["side"], fault["kind"]
        click.echo(f"{team} ({side}) forfeits at tick {fault['tick']}: {kind}", err=True)
        for line in fault["detail"].splitlines():
            click.echo(f"  {line}", err=True)
