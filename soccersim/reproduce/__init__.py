"""Reproduction: every table of the papers beside ours, and where a paper itself is wrong."""
