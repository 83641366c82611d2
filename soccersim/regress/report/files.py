"""The report's files: each whole or not at all."""

import re
from contextlib import suppress
from os import PathLike
from pathlib import Path
from urllib.parse import quote

from soccersim.problems import InputError, MachineError, one_line
from soccersim.regress.account import Account, Match
from soccersim.regress.report.meetings import most_different, played
from soccersim.regress.report.page import html
from soccersim.regress.report.pairs import MOST

PART = ".part"  # ends the name of a file that is not whole yet
REPLAY = re.compile(r"pair-\d+-leg-\d-[0-9a-f]+\.html")  # after recordings.Recordings


def write_report(account: Account, path: str | PathLike[str], replays: int = MOST) -> list[Path]:
    """Write the page, and beside it the replays of the pairs that differ most.

    replays: of how many pairs. Those need recordings; one that cannot be read has no replay. The
    page comes last, so that its links lead somewhere. Returns what was written, page first;
    MachineError where that fails.
    """
    page = Path(path)
    folder = page.with_name(f"{page.stem}-replays")
    wanted = [leg for pair in most_different(played(account), replays) for leg in pair.legs]
    links, written = {}, []
    for match in wanted:
        name = match.row.recording
        if name and name not in links and (text := replay(account, match)):
            target = folder / f"{Path(name).stem}.html"
            write_whole(target, text)
            written.append(target)
            links[name] = quote(f"{folder.name}/{target.name}")
    write_whole(page, html(account, links))
    tidy(folder, written)
    return [page, *written]


def replay(account: Account, match: Match) -> str:
    """The page of a recording; "" where that is gone or damaged."""
    from soccersim.record import Recording
    from soccersim.render.page import page

    row = match.row
    title = f"{match.home} {row.score[0]} : {row.score[1]} {match.away}, seed {row.seed}"
    try:
        recording = Recording.load(account.recordings / row.recording)
    except InputError:
        return ""
    return page(recording, one_line(title, 200)) if len(recording.tick) else ""


def write_whole(path: Path, text: str) -> None:
    """Write a file in place of an older one, or leave that as it is."""
    part = path.with_name(path.name + PART)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            part.write_text(text, encoding="utf-8", newline="\n")
            part.replace(path)
        finally:
            with suppress(OSError):
                part.unlink()
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        raise MachineError(f"{path}: {getattr(error, 'strerror', None) or error}") from error


def tidy(folder: Path, written: list[Path]) -> None:
    """Take away replays that an earlier report left: nothing links to them any more."""
    with suppress(OSError):
        for path in folder.iterdir():
            if REPLAY.fullmatch(path.name) and path not in written:
                path.unlink()
        folder.rmdir()  # if nothing is in it
