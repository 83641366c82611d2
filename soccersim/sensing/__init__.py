"""What sensors make of the truth: pulses, and a rate that drifts."""
