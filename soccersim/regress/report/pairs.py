"""The table of all pairs, and the pairs that differ most with their replays."""

from collections.abc import Mapping, Sequence

from soccersim.regress.account import Account, Match
from soccersim.regress.report.markup import Html, join, row, table, tag
from soccersim.regress.report.meetings import Meeting, Played, faults, most_different
from soccersim.regress.report.words import number, signed

MOST = 6  # pairs whose replays are linked
Replays = Mapping[str, str]


def widest(account: Account, pairs: Sequence[Played], replays: Replays) -> Html:
    """The pairs that most goals lay between, with links to what was kept of them."""
    listed = most_different(pairs, MOST)
    if not listed:
        return tag("p", "None: both sides saw the same matches.", class_="faint")
    items = []
    for pair in listed:
        goals = signed(2.0 * pair.sample.difference, _places(account))
        watch = join(*(_watched(match, replays) for match in pair.legs))
        title = tag("p", tag("strong", f"{goals} goals"), f", seed {pair.seed}, {_when(pair)}")
        items.append(tag("div", title, watch))
    kept = any(match.row.recording in replays for pair in listed for match in pair.legs)
    note = "" if kept else tag("p", UNSEEN, class_="faint")
    return join(tag("div", *items, class_="widest"), note)


UNSEEN = join(
    "No recordings of these were kept: ",
    tag("code", "--keep lost"),
    " or ",
    tag("code", "--keep all"),
    " keeps them.",
)


def _watched(match: Match, replays: Replays) -> Html:
    """A match with its score, a link where there is a replay."""
    home, away = match.row.score
    said = f"{match.home} {home} : {away} {match.away}"
    page = replays.get(match.row.recording)
    return tag("div", tag("a", said, href=page) if page else said)


def pairs_table(account: Account, pairs: Sequence[Played], replays: Replays) -> Html:
    """A row for each pair, or where there are opponents for each pair and opponent."""
    mine, its = account.candidate, account.base
    teams: tuple[str, ...] = (f"{mine} : {its}", f"{its} : {mine}")
    opponent: tuple[str | Html, ...] = ()
    note = "Scores are home : away. The difference is the candidate's goals less the base's"
    if account.against:
        teams = (f"{mine} home", f"{mine} away", f"{its} home", f"{its} away")
        opponent = (tag("th", "opponent", class_="left"),)
        note += ", both matches together, on average over the opponents."
    else:
        note += ", both matches together."
    legs = (tag("th", name, class_="team") for name in teams)
    head = row("pair", "seed", *opponent, *legs, *LAST, cell="th")
    rows = join(*(each for pair in pairs for each in _rows(account, pair, replays)))
    scrolling = tag("div", table(head, rows), class_="tall", tabindex=0)
    return join(tag("p", note, class_="faint"), scrolling)


LAST = ("difference, goals", "matches parted", tag("th", "faults", class_="left"))


def _rows(account: Account, pair: Played, replays: Replays) -> list[Html]:
    sample, count = pair.sample, len(pair.meetings)
    if sample.void:
        seed = "" if pair.seed is None else pair.seed
        wide = len(LAST) + (5 if account.against else 2)  # all the columns after these two
        why = tag("td", f"void: {pair.void}", class_="left", colspan=wide)
        return [row(sample.number, seed, why, class_="void")]
    span = count if count > 1 else None
    goals = 2.0 * sample.difference
    class_ = "plus" if goals > 0 else "minus" if goals < 0 else "even"
    first = (tag("td", sample.number, rowspan=span), tag("td", pair.seed, rowspan=span))
    last = (
        tag("td", signed(goals, _places(account)), class_=class_, rowspan=span),
        tag("td", _parted(pair), rowspan=span),
        tag("td", _faults(pair), class_="left", rowspan=span),
    )
    rows = []
    for k, meeting in enumerate(pair.meetings):
        begins, ends = (first, last) if k == 0 else ((), ())
        opponent = (tag("td", meeting.opponent, class_="left"),) if account.against else ()
        cells = [_score(leg, replays) for leg in _legs(account, meeting)]
        rows.append(row(*begins, *opponent, *cells, *ends))
    return rows


def _legs(account: Account, meeting: Meeting) -> tuple[Match | None, ...]:
    return (*meeting.candidate, *meeting.base) if account.against else meeting.candidate


def _score(match: Match | None, replays: Replays) -> Html:
    """Home : away, a link to the replay where there is one."""
    if match is None:
        return tag("td", "")
    home, away = match.row.score
    page = replays.get(match.row.recording)
    said = f"{home} : {away}"
    return tag("td", tag("a", said, href=page) if page else said)


def _parted(pair: Played) -> str:
    """Whether the digests parted, and when if that is known."""
    if not pair.sample.diverged:
        return "no"
    return "yes" if pair.sample.parted is None else f"tick {number(pair.sample.parted)}"


def _when(pair: Played) -> str:
    return (
        "parted" if pair.sample.parted is None else f"parted at tick {number(pair.sample.parted)}"
    )


def _faults(pair: Played) -> str:
    """Who did what wrong."""
    each = [f"{f.team} ({f.side}): {f.kind} at tick {number(f.tick)}" for f in faults(pair.legs)]
    return "; ".join(dict.fromkeys(each))


def _places(account: Account) -> int:
    """Of a difference: whole goals, unless it is a mean over opponents."""
    return 2 if account.against else 0
