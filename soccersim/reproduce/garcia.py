"""Garcia-Sillas et al. again: equations (4) to (30), and the two motions of Figures 6 and 7."""

from collections.abc import Iterator

from soccersim.reproduce import garcia_body, garcia_motion, garcia_wheels
from soccersim.reproduce.lab import Lab
from soccersim.reproduce.section import Section


def sections(lab: Lab) -> Iterator[Section]:
    """Table 1 and the equations, then the motions, in the paper's order."""
    yield garcia_wheels.leg()
    yield garcia_wheels.table_1()
    yield garcia_wheels.omni_wheel()
    yield garcia_wheels.three_wheels()
    yield garcia_body.composite()
    yield garcia_body.slip()
    yield garcia_body.free_speeds()
    yield garcia_body.motion()
    yield garcia_body.final()
    lab.told(0.2)
    yield from garcia_motion.sections(lab)
