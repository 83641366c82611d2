"""`soccersim replay`."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from soccersim.cli.film import check_film, film_cut, film_options
from soccersim.cli.results import Results
from soccersim.problems import InputError, Problem

if TYPE_CHECKING:
    from soccersim.record import Recording
    from soccersim.render.cut import Cut


FILE = click.Path(path_type=Path)
BAR = {  # what is written, and what the bar says meanwhile
    "html": "writing the page",
    "video": "encoding video",
    "frames": "drawing frames",
    "mcap": "writing the log",
    "csv": "writing the table",
}


@click.command("replay", short_help="Look at a recording again, check it, or hand it on.")
@click.argument("recording", type=FILE)
@click.option("--verify", is_flag=True, help="Simulate it again and compare, record by record.")
@click.option("--html", type=FILE, help="Write a page that plays it.")
@click.option("--video", type=FILE, help="Write a film: .mp4, .gif or .webp.")
@click.option("--frames", type=FILE, help="Write PNG frames into a folder.")
@click.option("--mcap", type=FILE, help="Write a log for Foxglove and other tools of robotics.")
@click.option("--csv", type=FILE, help="Write a table with a row for each recorded tick.")
@film_options
@click.option("--force", is_flag=True, help="Overwrite what is there.")
def command(
    recording: Path,
    verify: bool,
    start: float | None,
    end: float | None,
    speed: float | None,
    size: str | None,
    force: bool,
    **files: Path | None,
) -> None:
    """Say what RECORDING holds; draw it, hand it to other tools, or play it again bit by bit.

    \b
    soccersim replay match-1.npz
    soccersim replay match-1.npz --html match.html
    soccersim replay match-1.npz --video goal.gif --from 50 --to 55 --size 640x428
    soccersim replay match-1.npz --mcap match.mcap --csv match.csv
    soccersim replay match-1.npz --verify

    --html writes one file that opens in a browser, without any network: docs/replay.md.
    --video, --mcap and --csv are told in docs/export.md. A recording holds records at the
    scenario's record_hz, 50 a second unless it says otherwise; films, logs and tables show them.
    --verify simulates the run anew: a path from its scenario, a match from the orders that the
    teams sent. It names the first record that differs, and exits with 1 then.
    """
    from soccersim.record import Recording

    wanted = {kind: path for kind, path in files.items() if path}
    film_wanted = bool({"video", "frames"} & set(wanted))
    if (speed is not None or size is not None) and not film_wanted:
        raise click.UsageError("--speed and --size are of --video and --frames")
    if (start is not None or end is not None) and not set(wanted) - {"html"}:
        raise click.UsageError("--from and --to are of --video, --frames, --mcap and --csv")
    loaded = Recording.load(recording)
    loaded.scenario  # noqa: B018  said at once where it cannot be read
    if not (verify or wanted):
        click.echo(described(loaded))
    if wanted:
        check_paths(recording, wanted)
        _write_all(loaded, wanted, film_cut(start, end, speed, size), force)
    if verify:
        _verify(loaded)


def check_paths(recording: Path, wanted: dict[str, Path]) -> None:
    """InputError where one file would take the place of another, or of the recording."""
    taken = {recording.resolve(): "the recording"}
    for kind, path in wanted.items():
        other = taken.setdefault(path.resolve(), f"--{kind}")
        if other != f"--{kind}":
            raise InputError(Problem(f"--{kind} would take the place of {other}", str(path)))


def _write_all(recording: "Recording", wanted: dict[str, Path], cut: "Cut", force: bool) -> None:
    """Each file whole or not at all; nothing is begun before all that was asked for is possible."""
    from soccersim.render.cut import shown

    cut.check(recording.duration)
    if {"mcap", "csv"} & set(wanted):
        shown(recording, cut.start, cut.end)
    if "video" in wanted:
        check_film(wanted["video"])
    if "mcap" in wanted:
        from soccersim.export.mcap import mcap_writer

        mcap_writer()
    each = [
        (kind, path, Results(path.parent, (path.name,), force)) for kind, path in wanted.items()
    ]
    for kind, path, folder in each:
        with folder as results, results.new(path.name) as part:
            _write(recording, kind, path, part, cut)
        click.echo(f"wrote {path}", err=True)


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


def _write(recording: "Recording", kind: str, path: Path, part: Path, cut: "Cut") -> None:
    """One file: part is where it is written, path what it will be called."""
    from soccersim.cli.progress import Bar

    if kind == "html":
        from soccersim.render.page import page

        part.write_text(page(recording), encoding="utf-8")
        return
    with Bar(BAR[kind]) as bar:
        if kind == "video":
            from soccersim.render.cut import film_kind
            from soccersim.render.video import save_video

            save_video(recording, part, bar.count, cut, film_kind(path))
        elif kind == "frames":
            from soccersim.render.frames import save_frames

            save_frames(recording, part, bar.count, cut)
        elif kind == "mcap":
            from soccersim.export.mcap import save_mcap

            save_mcap(recording, part, bar.count, cut.start, cut.end)
        else:
            from soccersim.export.table import save_csv

            save_csv(recording, part, bar.count, cut.start, cut.end)


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
