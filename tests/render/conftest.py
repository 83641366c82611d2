"""A browser, and replay pages opened in it."""

import pytest
from browser import Browser
from on_page import ATTACK, circling

from soccersim.render.page import page


@pytest.fixture(scope="module")
def recording():
    return circling()


@pytest.fixture(scope="module")
def browser():
    with Browser() as started:
        yield started


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """Writes pages; gives their addresses."""
    folder = tmp_path_factory.mktemp("pages")

    def write(recording, name="page"):
        path = folder / f"{name}.html"
        path.write_text(page(recording, title=f"a title {ATTACK}"), encoding="utf-8")
        return path.as_uri()

    return write


@pytest.fixture(scope="module")
def address(pages, recording):
    return pages(recording)


@pytest.fixture
def opened(browser, address):
    """Opens a page; nothing may have been complained of when the test ends."""
    tabs = []

    def tab(url=address, **more):
        new = browser.open(url, **more)
        new.run("soccersim.ready")
        tabs.append(new)
        return new

    yield tab
    for each in tabs:
        assert each.complaints() == []
        assert each.requests() == [each.run("location.href.split('#')[0]")]
        each.close()
