"""The presets of senses, and senses that make no sense."""

import pytest

from soccersim import bundled
from soccersim.problems import InputError
from soccersim.spec.senses import Senses, lowest
from soccersim.spec.validate import validate
from soccersim.spec.yaml12 import parse, read


def preset(name):
    return validate(Senses, read(bundled.find("senses", name)))


def numbers(tree, at=()):
    """All numbers of a tree with their paths."""
    if isinstance(tree, dict):
        for key, value in tree.items():
            yield from numbers(value, (*at, key))
    elif isinstance(tree, list | tuple):
        for i, value in enumerate(tree):
            yield from numbers(value, (*at, i))
    elif not isinstance(tree, str):
        yield at, tree


def test_three_presets_come_with_the_program_and_say_where_their_figures_come_from():
    assert bundled.names("senses") == ["friendly", "ideal", "realistic"]
    for name in ("friendly", "realistic"):
        about = " ".join(preset(name).about.split())
        assert "ER-Force" in about
        assert "estimate" in about
    assert "CAMBADA" in preset("realistic").about
    assert "Falcons" in preset("realistic").about


def test_realistic_is_what_one_gets_without_a_word():
    assert preset("realistic").model_dump(exclude={"about"}) == Senses().model_dump(
        exclude={"about"}
    )


def test_ideal_has_no_error_no_delay_and_no_loss():
    ideal = preset("ideal")
    faults = [
        value
        for at, value in numbers(ideal.model_dump(exclude={"about", "localisation"}))
        if at[-1] not in ("rate_hz", "range", "silence")
    ]
    assert faults == [0.0] * len(faults)
    assert len(faults) == 23


def test_friendly_is_milder_than_realistic_in_everything():
    mild, hard = (preset(name) for name in ("friendly", "realistic"))
    for kind in ("ball", "opponents"):
        a, b = getattr(mild.camera, kind), getattr(hard.camera, kind)
        assert a.range > b.range
        assert a.dropout <= b.dropout
        for d in (0.3, 1.0, 3.0, 7.0):
            for name in ("radial", "tangential"):
                x, y = (sum(c * d**k for k, c in enumerate(getattr(s, name))) for s in (a, b))
                assert x < y
    assert mild.camera.delay < hard.camera.delay
    assert mild.camera.lines.distance_sd < hard.camera.lines.distance_sd
    assert mild.radio.delay < hard.radio.delay
    assert mild.radio.report_loss < hard.radio.report_loss


def test_least_spread_within_the_range():
    assert lowest((0.039, -0.01, 0.01), 8.0) == pytest.approx(0.0365)  # at 0.5 m
    assert lowest((0.039, -0.01, 0.01), 0.2) == pytest.approx(0.0374)
    assert lowest((1.0, -0.1, 0.0), 20.0) == pytest.approx(-1.0)


def test_a_spread_that_turns_negative_is_refused_where_it_stands():
    tree = parse("camera: {ball: {radial: [0.01, -0.1, 0.01]}}", "senses.yaml")
    with pytest.raises(InputError) as refused:
        validate(Senses, tree)
    (problem,) = refused.value.problems
    assert problem.path == "camera.ball.radial"
    assert "negative" in problem.message
