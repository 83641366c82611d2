"""Recordings: all that rendering, reports and verification ever read."""

from soccersim.record.recording import Recording

__all__ = ["Recording"]
