"""What a user writes: scenarios, fields, robots, sensors; frozen and validated."""
