"""`soccersim plot`."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from soccersim.cli.results import Results

if TYPE_CHECKING:
    from matplotlib.figure import Figure

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
    less the truth. Of arms without robots the ways of their tips and their joints are drawn.
    """
    from soccersim.record import Recording
    from soccersim.render.curve_plots import plot_kind, save_plot

    kind = plot_kind(out)
    figure, told = _figure([(name, Recording.load(name)) for name in recordings], robots)
    with Results(out.parent, (out.name,), force) as results, results.new(out.name) as part:
        save_plot(figure, part, kind)
    for line in told:
        click.echo(line, err=True)
    click.echo(f"wrote {out}", err=True)


def _figure(
    loaded: list[tuple[str, "Recording"]], robots: tuple[str, ...]
) -> tuple[Callable[[], "Figure"], list[str]]:
    """What makes the figure, and what is left out of it, a line each."""
    from soccersim.render.arm_plots import arm_figure
    from soccersim.render.curve_plots import MOST_WHEELED, curve_figure
    from soccersim.render.curves import curves, labels

    title = _title(loaded)
    if not robots and not any(recording.scenario.robots for _, recording in loaded):
        arms = list(zip(labels(loaded), (recording for _, recording in loaded), strict=True))
        return partial(arm_figure, arms, title), []
    drawn, told = curves(loaded, robots)
    if len(drawn) > MOST_WHEELED and any(curve.wheels for curve in drawn):
        told.append(f"wheels are drawn for up to {MOST_WHEELED} robots: --robot NAME chooses")
    return partial(curve_figure, drawn, title), told


def _title(loaded: list[tuple[str, "Recording"]]) -> str:
    """The scenarios' names, with the seed of a single run."""
    from soccersim.render.tracks import shortened

    names = dict.fromkeys(recording.scenario.name for _, recording in loaded)
    title = shortened(", ".join(names), 60)
    if len(loaded) == 1:
        title += f", seed {loaded[0][1].meta['seed']}"
    return title
