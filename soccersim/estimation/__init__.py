"""What a robot believes, from its readings alone."""
