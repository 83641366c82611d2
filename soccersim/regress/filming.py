"""Recordings of the matches that a report shows, after the verdict: they are played once more.

Which pairs differ most is known at the end alone, and to keep every recording until then takes
half a megabyte for each minute of play. The same match again is the same match, which is looked at
on the occasion.
"""

from concurrent.futures import Future, as_completed
from dataclasses import replace

from soccersim.regress.campaign import Campaign, PoolOf
from soccersim.regress.job import Lost, Played
from soccersim.regress.leg import Leg
from soccersim.regress.report.meetings import most_different, played

MOST = 6  # pairs, as in report/pairs.py


def unfilmed(campaign: Campaign, most: int = MOST) -> list[Leg]:
    """The legs of the pairs that differ most, as far as they have no recording."""
    pairs = most_different(played(campaign.account("", 1, 1.0)), most)
    rows = [match.row for pair in pairs for match in pair.legs]
    keys = {row.key for row in rows if not row.recording and not row.void}
    numbers = sorted(pair.sample.number for pair in pairs)
    legs = {leg.key: leg for number in numbers for leg in campaign.plan.legs_of(number)}
    return [replace(leg, keep="all") for key, leg in legs.items() if key in keys]


def film(campaign: Campaign, legs: list[Leg], pool: PoolOf) -> None:
    """Play these legs again, and keep their recordings; what the machine fails to do is left out.

    One that comes out differently makes the campaign INVALID.
    """
    with pool() as place:
        asked: dict[Future[Played], Leg] = {place.submit(leg, False): leg for leg in legs}
        for future in as_completed(asked):
            try:
                found = future.result()
            except Lost:
                continue
            if found.row and not found.doubt:
                keep(campaign, asked[future], found)
    campaign.see_again({leg.pair for leg in legs})


def keep(campaign: Campaign, leg: Leg, found: Played) -> None:
    """The recording of a leg, if it is the match that was played before."""
    there = campaign.store.row(leg.key)
    if there and found.row and there.digest == found.row.digest and found.recording:
        name = campaign.recordings.keep(leg, found.recording)
        campaign.store.record(leg.key, name)
    elif found.row:
        campaign.store.add(found.row)
