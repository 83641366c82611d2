"""Did the change make the team better? Verdicts from pairs of matches, ratings from tournaments."""
