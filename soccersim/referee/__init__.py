"""The referee: what is seen every tick, and what is ruled at every decision."""
