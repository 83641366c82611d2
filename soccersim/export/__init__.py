"""Recordings for other tools: a log that Foxglove shows, and a table that anything reads."""
