"""A lab of few seeds, in this process."""

import pytest

from soccersim.reproduce.lab import Lab


@pytest.fixture(scope="module")
def lab():
    with Lab(jobs=1, seeds=20) as lab:
        yield lab
