"""The pictures say what they show."""

import pytest

from soccersim.reproduce import idris, utama
from soccersim.reproduce.lab import Lab


@pytest.fixture(scope="module")
def pictures():
    with Lab(jobs=1, seeds=5) as lab:
        sections = [*idris.sections(lab), *utama.sections(lab)]
    return [section.figure() for section in sections if section.figure]


def test_there_is_a_picture_for_every_table_and_figure_of_the_two_papers(pictures):
    assert len(pictures) == 7 + 3  # Table 6 is one, Figures 6 to 8


def test_every_axis_has_a_quantity_with_its_unit(pictures):
    for figure in pictures:
        for axes in figure.axes:
            assert "(" in axes.get_ylabel() or axes.get_ylabel().startswith("row")
        assert figure.axes[-1].get_xlabel()


def test_every_picture_tells_ours_from_the_papers(pictures):
    for figure in pictures:
        legends = [*figure.legends, *(axes.get_legend() for axes in figure.axes)]
        names = {text.get_text() for legend in legends if legend for text in legend.get_texts()}
        assert len(names) >= 3
