"""What a page tells besides numbers: field, look, robots, events, and what was said, as JSON."""

from math import pi
from typing import Any

from soccersim.record.recording import Recording
from soccersim.render import arms, likeness, look, markings, moments, pitch, sprites
from soccersim.render.cells import MINUS, leg_number, leg_text
from soccersim.render.page.notes import kinds, noted
from soccersim.render.page.telling import match_events, run_events
from soccersim.render.story import Story
from soccersim.spec.field import Field

Document = dict[str, Any]


def document(recording: Recording, story: Story | None, title: str, shown: list[int]) -> Document:
    """Everything of one recording; places in the field frame, SI."""
    scenario, meta = recording.scenario, recording.meta
    models = [player.model for player in scenario.robots]
    kinds = [model for i, model in enumerate(models) if models.index(model) == i]
    return {
        "title": title,
        "scenario": scenario.name,
        "seed": meta["seed"],
        "digest": recording.digest,
        "soccersim": meta["soccersim"],
        "hz": float(meta["physics_hz"]),
        "duration": recording.duration,
        "field": field(scenario.field),
        "look": palette(),
        "models": [_model(kind) for kind in kinds],
        "robots": [
            {
                "name": player.name,
                "number": player.number,
                "team": int(player.team == "away"),
                "model": kinds.index(player.model),
                "targets": [scenario.coordinates.field_pose(leg.to) for leg in player.path or ()],
                "start": scenario.coordinates.field_pose(player.start),
                "repeat": player.repeat,
            }
            for player in scenario.robots
        ],
        "ball": scenario.ball.radius if scenario.ball else None,
        "arms": [{"lengths": arm.lengths, "thickness": arm.thickness} for arm in scenario.arms],
        "match": _match(recording, story, shown) if story else None,
        "states": _changes([_run_state(recording, i) for i in shown]) if not story else [],
        "events": match_events(recording, story) if story else run_events(recording),
    }


def field(spec: Field) -> Document:
    """The field as polylines and measures, m."""
    return {
        "floor": pitch.floor(spec),
        "length": spec.length,
        "width": spec.width,
        "lines": [_rounded(line) for line in markings.lines(spec)],
        "goals": [_rounded(goal) for goal in markings.goals(spec)],
        "spots": _rounded(markings.spots(spec)),
        "line_width": spec.line_width,
        "post_radius": spec.goal.post_radius,
        "board": pitch.BOARD,
        "stripes": pitch.STRIPES,
        "mesh": pitch.MESH,
    }


def palette() -> Document:
    """The colours of the frames, for CSS, and the shapes of what moves."""
    return {
        "page": css(look.PAGE),
        "card": css(look.CARD),
        "ink": css(look.INK),
        "faint": css(look.FAINT),
        "grass": [css(colour) for colour in look.GRASS],
        "verge": css(look.VERGE),
        "line": css(look.LINE),
        "board": css(look.BOARD),
        "board_edge": css(look.BOARD_EDGE),
        "post": css(look.POST),
        "teams": [css(colour) for colour in look.TEAMS.values()],
        "tints": [css(look.tint(team)) for team in look.TEAMS],
        "rims": [css(look.mix(colour, look.OUTLINE, 0.22)) for colour in look.TEAMS.values()],
        "nets": [
            [css(look.mix(look.VERGE, colour, share)) for share in (0.35, 0.75)]
            for colour in look.TEAMS.values()
        ],
        "outline": css(look.OUTLINE),
        "hub": css(look.HUB),
        "nose": css(look.NOSE),
        "tyre": css(look.TYRE),
        "roller": css(look.ROLLER),
        "dead_tyre": css(look.DEAD_TYRE),
        "dead_roller": css(look.DEAD_ROLLER),
        "shadow": css(look.SHADOW),
        "ball": css(look.BALL),
        "ball_rim": css(look.BALL_RIM),
        "ball_patch": css(look.BALL_PATCH),
        "ball_trail": css(look.BALL_TRAIL),
        "glow": css(look.GLOW),
        "believed": css(look.BELIEVED),
        "target": css(look.TARGET),
        "link": css(arms.LINK),
        "link_edge": css(arms.EDGE),
        "joint": css(arms.JOINT),
        "nose_angle": likeness.NOSE,
        "hub_share": likeness.HUB,
        "ghost_nose": sprites.GHOST_NOSE,
        "target_radius": sprites.TARGET_RADIUS,
        "dim": sprites.DIM / 255,
        "flash": moments.FLASH,
        "old": moments.OLD,
    }


def css(colour: tuple[int, ...]) -> str:
    """A colour as CSS writes it, with its alpha if it has one."""
    return "#" + "".join(f"{part:02x}" for part in colour)


def _model(model: Any) -> Document:
    """A kind of robot: its shell, its wheels as drawn, and whether driven and dead ones count."""
    wheels = [[round(float(number), 4) for number in mark] for mark in likeness.wheel_marks(model)]
    counted = [bool(kind and kind.encoder) for kind in (model.drive, model.dead)]
    return {"radius": model.radius, "wheels": wheels, "counted": counted}


def _match(recording: Recording, story: Story, shown: list[int]) -> Document:
    """What teams and referee said, by time or by row."""
    match = recording.match or {}
    decisions = [story.decision[record] for record in shown]
    ticks, hz = recording.arrays["decision_tick"].tolist(), story.hz
    return {
        "names": story.names,
        "length": story.duration,
        "states": _changes([story.state(record) for record in shown]),
        "scores": _changes([story.score(record) for record in shown]),
        "halves": _changes([story.half(record) for record in shown]),
        "said": [[tick / hz, text, slot] for tick, text, slot in story.decided],
        "kicks": [
            [round(n, 3) for n in (k.tick / hz, k.robot, k.x, k.y, k.vx, k.vy)] for k in story.kicks
        ],
        "shots": _times(recording, story.shots.records),
        "on_goal": _times(recording, story.on_goal.records),
        "passes": _times(recording, story.passes.records),
        "labels": [[ticks[at] / hz, row, text] for at, row, text in match["labels"]],
        "notes": [
            _changes([kinds(notes) for notes in noted(recording, slot, decisions)])
            for slot in (0, 1)
        ],
    }


def _times(recording: Recording, records: tuple[list[int], list[int]]) -> list[list[float]]:
    """Seconds of records, by slot."""
    return [[round(float(recording.time[record]), 3) for record in own] for own in records]


def _run_state(recording: Recording, record: int) -> tuple[str, int | None, str]:
    """Of a lone robot the leg it is on."""
    players = recording.scenario.robots
    if len(players) != 1:
        return "", None, ""
    leg = int(recording.leg[record, 0])
    text = leg_text(players[0], leg)
    if not text:
        return "", None, ""
    word = f"{'phase' if players[0].open_loop else 'leg'} {text}"
    targets = players[0].path
    if not targets:
        return word, None, "driven without a plan"
    target = targets[leg_number(players[0], leg)]
    x, y, heading = recording.scenario.coordinates.field_pose(target.to)
    x, y, degrees = round(x, 2) + 0.0, round(y, 2) + 0.0, round(heading * 180 / pi) + 0.0
    return word, None, f"to ({x:.2f}, {y:.2f}) m, {degrees:.0f}°".replace("-", MINUS)


def _changes(values: list[Any]) -> list[list[Any]]:
    """The row from which on it is so, and what."""
    return [
        [row, value] for row, value in enumerate(values) if row == 0 or value != values[row - 1]
    ]


def _rounded(points: Any) -> list[list[float]]:
    return [[round(float(x), 4), round(float(y), 4)] for x, y in points]
