"""Processes that play match after match, for systems that cannot fork."""

from typing import Any

from soccersim.match.processes import Process, start


class Reused:
    """to come"""

    def start(self) -> None:
        """x"""

    def begin(self, module: str, arguments: list[str], **pipes: Any) -> Process:
        """x"""
        return start(module, arguments, **pipes)

    def close(self) -> None:
        """x"""
