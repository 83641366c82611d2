"""`soccersim run`."""

import json
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from soccersim.cli.film import PLAIN, FilmCommand, asked_film, can_show, video_option
from soccersim.cli.results import Results
from soccersim.problems import InputError, Problem, Stopped, one_line

if TYPE_CHECKING:
    from soccersim.record import Recording
    from soccersim.render.cut import Cut
    from soccersim.spec.scenario import Scenario

FILES = ("report.json", "trajectory.png", "recording.npz", PLAIN, "frames")


@click.command("run", cls=FilmCommand, short_help="Run a scenario.")
@click.argument("scenario")
@click.option("--seed", type=click.IntRange(min=0), help="Instead of the scenario's own.")
@click.option("--out", type=click.Path(path_type=Path), help="Folder for the files.")
@click.option("--set", "settings", multiple=True, metavar="KEY.PATH=VALUE", help="Change a value.")
@click.option("--frames", is_flag=True, help="Write frames/000000.png and so on, into --out.")
@video_option
@click.option("--no-plot", is_flag=True, help="Leave trajectory.png out.")
@click.option("--runs", type=click.IntRange(1, 100_000), default=1, help="Repeat over seeds.")
@click.option("--jobs", type=click.IntRange(1, 256), default=1, help="Processes for --runs.")
@click.option("--force", is_flag=True, help="Overwrite what is in --out.")
@click.option("--json", "as_json", is_flag=True, help="One JSON document on stdout.")
def command(
    scenario: str,
    seed: int | None,
    out: Path | None,
    settings: tuple[str, ...],
    frames: bool,
    video: str | None,
    no_plot: bool,
    runs: int,
    jobs: int,
    force: bool,
    as_json: bool,
    **part: Any,
) -> None:
    """Run SCENARIO, a bundled name (`soccersim list`) or a YAML file, and report on each leg.

    \b
    soccersim run defender
    soccersim run defender --out results --video
    soccersim run defender --out results --video turn.gif --from 3 --to 5 --size 640x428
    soccersim run striker --runs 200 --jobs 2
    soccersim run ./my.yaml --set robots.0.model.mass=25 --seed 3

    The table shows where each leg's target was, where the robot's odometry believed to be, where
    it truly was, and what the paper printed. Without --out nothing is written.
    """
    from soccersim.spec.load import load_scenario

    if (frames or video) and out is None:
        raise click.UsageError("--frames and --video need a folder: --out DIR")
    spec = load_scenario(scenario, seed=seed, settings=settings)
    if spec.match:
        wrong = f"is a match: `soccersim match HOME AWAY --scenario {one_line(scenario)}` plays it"
        raise InputError(Problem(wrong, one_line(scenario)))
    check_seeds(spec.seed, runs)
    cut = asked_film(video, frames, spec.duration, **part)
    names = tuple(dict.fromkeys((*FILES, video or PLAIN)))
    with Results(out, names, force) if out else nullcontext() as results:
        announce_compiling()
        recording, document = simulate(spec, runs, jobs)
        done = len(document.get("runs", [0]))
        goes_on = done == runs  # else there was a Ctrl-C: no pictures
        if results:
            shown = goes_on and (frames or video) and can_show(cut, recording)
            wanted = {
                "report.json": True,
                "recording.npz": True,
                "trajectory.png": goes_on and not no_plot,
                "frames": shown and frames,
                video or PLAIN: shown and video,
            }
            write(recording, document, results, wanted, cut)
    if as_json:
        click.echo(json.dumps(document, allow_nan=False))
    else:
        from soccersim.cli.tables import show

        show(spec, document)
    for path in results.written if results else ():
        click.echo(f"wrote {path}", err=True)
    if not goes_on:
        raise Stopped(
            f"stopped after {done} of {runs} seeds; the rest: "
            f"--seed {spec.seed + done} --runs {runs - done}"
        )


def announce_compiling() -> None:
    """Say that the first run on a machine takes longer, and why."""
    from soccersim.kernel import will_compile

    if will_compile():
        click.echo("first run here: compiling the simulator, once, about 20 s ...", err=True)


def simulate(spec: "Scenario", runs: int, jobs: int) -> tuple["Recording", dict[str, Any]]:
    """The first run's recording, and the report of all that were finished before a Ctrl-C."""
    from soccersim.cli.progress import Bar
    from soccersim.repeat import repeat, short
    from soccersim.report import bands, report
    from soccersim.simulation import Simulation

    with Bar(f"simulating {spec.name}") as bar:
        simulation = Simulation(spec)
        try:
            recording = simulation.run(bar if runs == 1 else None)
        except KeyboardInterrupt:
            at = simulation.tick * spec.dt
            raise Stopped(
                f"stopped at {at:.1f} s of {spec.duration:g} s; nothing was kept: "
                "run it again, or less of it with --set duration=SECONDS"
            ) from None
        document = report(recording)
        if runs > 1:
            each = document["runs"] = [short(recording)]
            try:
                for run in repeat(spec, range(spec.seed + 1, spec.seed + runs), jobs):
                    each.append(run)
                    bar.count(len(each), runs)
            except KeyboardInterrupt:
                pass  # the caller sees that some are missing
            document["bands"] = bands([run["robots"] for run in each])
    return recording, document


def write(
    recording: "Recording",
    document: dict[str, Any],
    results: Results,
    wanted: dict[str, Any],
    cut: "Cut",
) -> None:
    """The run's files, each whole or not at all."""
    try:
        for name in filter(wanted.get, wanted):
            with results.new(name) as path:
                write_one(name, recording, document, path, cut)
        results.done()
    except KeyboardInterrupt:
        kept = ", ".join(map(str, results.written)) or "nothing"
        raise Stopped(
            f"stopped while writing {name}; kept: {kept}; the same command with --force starts anew"
        ) from None


def write_one(
    name: str, recording: "Recording", document: dict[str, Any], path: Path, cut: "Cut"
) -> None:
    """One of the run's files."""
    from soccersim.cli.progress import Bar

    if name == "report.json":
        text = json.dumps(document, indent=2, allow_nan=False)
        path.write_text(text + "\n", encoding="utf-8")
    elif name == "recording.npz":
        recording.save(path)
    elif name == "trajectory.png":
        from soccersim.render.plots import save_trajectory

        save_trajectory(recording, path)
    elif name == "frames":
        from soccersim.render.frames import save_frames

        with Bar("drawing frames") as bar:
            save_frames(recording, path, bar.count, cut)
    else:
        from soccersim.render.cut import film_kind
        from soccersim.render.video import save_video

        with Bar("encoding video") as bar:
            save_video(recording, path, bar.count, cut, film_kind(name))


def check_seeds(first: int, runs: int) -> None:
    """Seeds are numbers of 63 bits."""
    if first + runs > 2**63:
        raise InputError(Problem(f"--runs {runs} leads from seed {first} beyond 2^63 - 1"))
