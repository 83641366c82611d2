"""`soccersim plot`."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from soccersim.cli.results import Results

if TYPE_CHECKING:
    from soccersim.record import Recording


@click.command("plot", short_help="Plot recordings over time.")
@click.argument("recordings", nargs=-1, required=True, metavar="RECORDING...", type=click.Path())
@click.option("--out", required=True, type=click.Path(path_type=Path), help=".png, .svg or .pdf.")
@click.option("--robot", "robots", multiple=True, metavar="NAME", help="Only this one; repeatable.")
@click.option("--force", is_flag=True, help="Overwrite what is there.")
def command(recordings: tuple[str, ...], out: Path, robots: tuple[str, ...], force: bool) -> None:
    """Draw position, heading, errors, wheel speeds, slip and PWM of RECORDINGs over time.

    \b
    soccersim plot results/recording.npz --out run.png
    soccersim plot a/recording.npz b/recording.npz --out both.svg
    soccersim plot match-1.npz --robot home-2 --out two.pdf

    Of one recording all robots are drawn, of several the first of each over one another, unless
    --robot names others. Wheels are drawn for up to three robots, and where the recording holds
    them: `record` of a scenario says so. Poses are in the scenario's frame; errors are the belief
    less the truth.
    """
    from soccersim.record import Recording
    from soccersim.render.curve_plots import MOST_WHEELED, plot_kind, save_curves
    from soccersim.render.curves import curves

    kind = plot_kind(out)
    loaded = [(name, Recording.load(name)) for name in recordings]
    drawn, told = curves(loaded, robots)
    if len(drawn) > MOST_WHEELED and any(curve.wheels for curve in drawn):
        told.append(f"wheels are drawn for up to {MOST_WHEELED} robots: --robot NAME chooses")
    with Results(out.parent, (out.name,), force) as results, results.new(out.name) as part:
        save_curves(drawn, _title(loaded), part, kind)
    for line in told:
        click.echo(line, err=True)
    click.echo(f"wrote {out}", err=True)


def _title(loaded: list[tuple[str, "Recording"]]) -> str:
    """The scenarios' names, with the seed of a single run."""
    from soccersim.render.tracks import shortened

    names = dict.fromkeys(recording.scenario.name for _, recording in loaded)
    title = shortened(", ".join(names), 60)
    if len(loaded) == 1:
        title += f", seed {loaded[0][1].meta['seed']}"
    return title
