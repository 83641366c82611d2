"""Pictures of a run: film frames, video and plots, made from a Recording alone."""

import os

# pygame greets whoever imports it, on the stdout that belongs to --json
os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
