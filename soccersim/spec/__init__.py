"""What a user writes: scenarios, fields, robots, sensors; frozen and validated."""

MAX_ROBOTS = 22  # on one field
