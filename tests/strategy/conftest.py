"""Files of teams, as tests of loading need them."""

import pytest


@pytest.fixture
def file(tmp_path):
    """Writes one file."""

    def write(text, name="team.py"):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    return write
