"""`soccersim replay`."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from soccersim.cli.results import Results

if TYPE_CHECKING:
    from soccersim.record import Recording


@click.command("replay", short_help="Look at a recording again, or check it.")
@click.argument("recording", type=click.Path(path_type=Path))
@click.option("--verify", is_flag=True, help="Simulate it again and compare, record by record.")
@click.option("--html", type=click.Path(path_type=Path), help="Write a page that plays it.")
@click.option("--video", type=click.Path(path_type=Path), help="Write a film, an .mp4.")
@click.option("--frames", type=click.Path(path_type=Path), help="Write PNG frames into a folder.")
@click.option("--force", is_flag=True, help="Overwrite what is there.")
def command(
    recording: Path,
    verify: bool,
    html: Path | None,
    video: Path | None,
    frames: Path | None,
    force: bool,
) -> None:
    """Say what RECORDING holds; draw it, or check that it can be played again bit by bit.

    \b
    soccersim replay match-1.npz
    soccersim replay match-1.npz --html match.html
    soccersim replay match-1.npz --video match.mp4
    soccersim replay match-1.npz --verify

    --html writes one file that opens in a browser, without any network: docs/replay.md.
    --verify simulates the run anew: a path from its scenario, a match from the orders that the
    teams sent. It names the first record that differs, and exits with 1 then.
    """
    from soccersim.record import Recording

    loaded = Recording.load(recording)
    loaded.scenario  # noqa: B018  said at once where it cannot be read
    if not (verify or html or video or frames):
        click.echo(described(loaded))
    for path, write in ((html, "html"), (video, "video"), (frames, "frames")):
        if path:
            folder = Results(path.parent, (path.name,), force)
            with folder as results, results.new(path.name) as part:
                _draw(loaded, part, write)
            click.echo(f"wrote {path}", err=True)
    if verify:
        _verify(loaded)


def described(recording: "Recording") -> str:
    """In a few lines what a recording holds."""
    scenario = recording.scenario
    lines = [
        f"{scenario.name} seed {recording.meta['seed']}: {recording.duration:g} s, "
        f"{len(scenario.robots)} robots, digest {recording.digest[:16]}",
        f"recorded by soccersim {recording.meta['soccersim']}",
    ]
    if match := recording.match:
        home, away = match["score"]
        lines.insert(1, f"{match['home']} {home} : {away} {match['away']}")
        lines += [f"forfeit of {f['side']}: {f['kind']}" for f in match["faults"]]
    return "\n".join(lines)


def _draw(recording: "Recording", path: Path, kind: str) -> None:
    from soccersim.cli.progress import Bar

    if kind == "html":
        from soccersim.render.page import page

        path.write_text(page(recording), encoding="utf-8")
    elif kind == "video":
        from soccersim.render.video import save_video

        with Bar("encoding video") as bar:
            save_video(recording, path, bar.count)
    else:
        from soccersim.render.frames import save_frames

        with Bar("drawing frames") as bar:
            save_frames(recording, path, bar.count)


def _verify(recording: "Recording") -> None:
    from soccersim.cli.progress import Bar
    from soccersim.cli.run import announce_compiling
    from soccersim.verify import verify

    announce_compiling()
    with Bar("simulating again") as bar:
        verdict = verify(recording, bar)
    if verdict.elsewhere:
        other = ", ".join(verdict.elsewhere)
        click.echo(f"recorded on another platform ({other}): bits may differ there", err=True)
    if verdict.tick is None:
        click.echo(f"verified: {len(recording.tick)} records come out the same, bit by bit")
        return
    seconds = verdict.tick / float(recording.meta["physics_hz"])
    click.echo(f"differs from tick {verdict.tick} ({seconds:.3f} s) on")
    click.get_current_context().exit(1)
