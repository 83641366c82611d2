"""The replay page: one HTML file that holds a recording and plays it, without any network."""

from soccersim.render.page.fill import page

__all__ = ["page"]
