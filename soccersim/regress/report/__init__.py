"""What a regression leaves behind: a page for people, a file for CI, replays beside them."""

from soccersim.regress.report.files import write_report
from soccersim.regress.report.junit import junit
from soccersim.regress.report.page import html

__all__ = ["html", "junit", "write_report"]
