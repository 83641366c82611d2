"""From a set-point to PWM: plan, profile, position PID, wheel loop."""
