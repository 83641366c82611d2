"""What `run`, `match` and `replay` share of films: a name after --video, and which part of it."""

from collections.abc import Callable, Iterable, Iterator
from os import PathLike
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from soccersim.record import Recording
    from soccersim.render.cut import Cut

PLAIN = "video.mp4"  # what --video alone writes
ENDINGS = {  # of films; of these we write the first three, and say so of the others
    *(".mp4", ".gif", ".webp"),
    *(".avi", ".mkv", ".mov", ".webm", ".m4v", ".mpg", ".mpeg", ".wmv", ".flv", ".apng", ".png"),
}
OPTIONS = (
    click.option(
        "--from", "start", type=float, metavar="S", help="Show from there on, in seconds."
    ),
    click.option("--to", "end", type=float, metavar="S", help="Show up to there, in seconds."),
    click.option(
        "--speed", type=float, metavar="X", help="Of film and frames: 0.25 is slow motion."
    ),
    click.option("--size", metavar="WxH", help="Of film and frames, in pixels."),
)


class FilmCommand(click.Command):
    """A verb whose `--video` stands alone, or before the name of a film.

    Click would give it any word that follows, also SCENARIO or HOME. Those do not end as films do.
    """

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """As click does, with a name for each `--video` that has none."""
        return super().parse_args(ctx, list(named(args)))


def named(words: Iterable[str]) -> Iterator[str]:
    """The words of a command line, with the plain name after each `--video` without one."""
    bare = False
    for word in words:
        if bare and PurePath(word).suffix.lower() not in ENDINGS:
            yield PLAIN
        yield word
        bare = word == "--video"
    if bare:
        yield PLAIN


def video_option(command: Callable[..., Any]) -> Callable[..., Any]:
    """Adds a --video whose film lies in --out, and what part of it is told with."""
    told = "Write video.mp4 into --out, or a film of that name: .mp4, .gif or .webp."
    add = click.option("--video", metavar="[FILE]", help=told)
    return add(film_options(command))


def film_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Adds --from, --to, --speed and --size."""
    for add in reversed(OPTIONS):
        command = add(command)
    return command


def film_cut(
    start: float | None, end: float | None, speed: float | None, size: str | None
) -> "Cut":
    """The part that is asked for; InputError for a size that no film can have."""
    from soccersim.render.cut import Cut, film_size
    from soccersim.render.look import SIZE

    return Cut(
        start, end, 1.0 if speed is None else speed, SIZE if size is None else film_size(size)
    )


def check_film(name: str | PathLike[str]) -> None:
    """InputError where a film of this name cannot be written: before the work that leads to it."""
    from soccersim.render.cut import film_kind
    from soccersim.render.video import pyav

    film_kind(name)
    pyav()


def asked_film(video: str | None, frames: bool, duration: float, **part: Any) -> "Cut":
    """The part of a run or match to come that is filmed, checked before it begins.

    duration: seconds that it may take. part: as of film_cut.
    """
    if any(value is not None for value in part.values()) and video is None and not frames:
        raise click.UsageError("--from, --to, --speed and --size are of --video and --frames")
    if video is not None:
        check_film(video)
        if PurePath(video).name != video:
            raise click.UsageError("--video takes a name without a folder: it lies in --out")
    cut = film_cut(**part)
    cut.check(duration)
    return cut


def can_show(cut: "Cut", recording: "Recording") -> bool:
    """Whether a run or match came as far as its film shall begin; says so where it did not."""
    if not len(recording.tick):  # a team forfeited at once
        return False
    if (cut.start or 0.0) <= recording.duration:
        return True
    end, begin = f"{recording.duration:g} s", f"--from {cut.start:g}"
    click.echo(f"nothing to show: it was over at {end}, before {begin}", err=True)
    return False
