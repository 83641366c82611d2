"""`soccersim run`."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from soccersim.record import Recording
    from soccersim.spec.scenario import Scenario

FILES = ("report.json", "trajectory.png", "recording.npz", "video.mp4", "frames")


@click.command("run", short_help="Run a scenario.")
@click.argument("scenario")
@click.option("--seed", type=click.IntRange(min=0), help="Instead of the scenario's own.")
@click.option("--out", type=click.Path(path_type=Path), help="Folder for the files.")
@click.option("--set", "settings", multiple=True, metavar="KEY.PATH=VALUE", help="Change a value.")
@click.option("--frames", is_flag=True, help="Write frames/000000.png and so on, into --out.")
@click.option("--video", is_flag=True, help="Write video.mp4 into --out.")
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
    video: bool,
    no_plot: bool,
    runs: int,
    jobs: int,
    force: bool,
    as_json: bool,
) -> None:
    """Run SCENARIO, a bundled name (`soccersim list`) or a YAML file, and report on each leg.

    \b
    soccersim run defender
    soccersim run defender --out results --video
    soccersim run striker --runs 200 --jobs 2
    soccersim run ./my.yaml --set robots.0.model.mass=25 --seed 3

    The table shows where each leg's target was, where the robot's odometry believed to be, where
    it truly was, and what the paper printed. Without --out nothing is written.
    """
    from soccersim.spec.load import load_scenario

    if (frames or video) and out is None:
        raise click.UsageError("--frames and --video need a folder: --out DIR")
    spec = load_scenario(scenario, seed=seed, settings=settings)
    if out:
        prepare(out, force)
    announce_compiling()
    recording, document = simulate(spec, runs, jobs)
    written = write(recording, document, out, frames, video, not no_plot) if out else []
    if as_json:
        click.echo(json.dumps(document))
    else:
        from soccersim.cli.tables import show

        show(spec, document)
    for path in written:
        click.echo(f"wrote {path}", err=True)


def announce_compiling() -> None:
    """Say that the first run on a machine takes longer, and why."""
    from soccersim.kernel import will_compile

    if will_compile():
        click.echo("first run here: compiling the simulator, once, about 20 s ...", err=True)


def simulate(spec: "Scenario", runs: int, jobs: int) -> tuple["Recording", dict[str, Any]]:
    """The first run's recording, and the report of all."""
    from soccersim.cli.progress import Bar
    from soccersim.repeat import repeat
    from soccersim.report import bands, report
    from soccersim.simulation import Simulation

    with Bar(f"simulating {spec.name}") as bar:
        recording = Simulation(spec).run(bar if runs == 1 else None)
        document = report(recording)
        if runs > 1:
            document["runs"] = [_short(document), *repeat(spec, runs, jobs, bar)]
            document["bands"] = bands([run["robots"] for run in document["runs"]])
    return recording, document


def _short(document: dict[str, Any]) -> dict[str, Any]:
    return {key: document[key] for key in ("seed", "digest", "duration", "robots")}


def prepare(out: Path, force: bool, names: tuple[str, ...] = FILES) -> None:
    """Make the folder; refuse to overwrite an earlier run's files unless told to."""
    from soccersim.problems import InputError, MachineError, Problem

    there = [name for name in names if (out / name).exists()]
    if there and not force:
        wrong = f"holds {', '.join(there)} already: choose another folder, or add --force"
        raise InputError(Problem(wrong, file=str(out)))
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise MachineError(f"{out}: {error.strerror or error}") from error


def write(
    recording: "Recording",
    document: dict[str, Any],
    out: Path,
    frames: bool,
    video: bool,
    plot: bool,
) -> list[Path]:
    """The run's files; returns their paths."""
    from soccersim.cli.progress import Bar
    from soccersim.problems import MachineError

    paths = [out / "report.json", out / "recording.npz"]
    try:
        paths[0].write_text(json.dumps(document, indent=2) + "\n", encoding="utf-8")
    except OSError as error:
        raise MachineError(f"{paths[0]}: {error.strerror or error}") from error
    recording.save(paths[1])
    if plot:
        from soccersim.render.plots import save_trajectory

        paths.append(out / "trajectory.png")
        save_trajectory(recording, paths[-1])
    if frames:
        from soccersim.render.frames import save_frames

        paths.append(out / "frames")
        with Bar("drawing frames") as bar:
            save_frames(recording, paths[-1], bar.count)
    if video:
        from soccersim.render.video import save_video

        paths.append(out / "video.mp4")
        with Bar("encoding video") as bar:
            save_video(recording, paths[-1], bar.count)
    return paths
