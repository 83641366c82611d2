"""soccersim: a 2D robot-soccer simulator that tells the truth about wheels and odometry."""

__version__ = "0.1.0"
