"""A match: two teams, a referee, and the loop that brings them together."""
