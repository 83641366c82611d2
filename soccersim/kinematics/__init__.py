"""Kinematics: knowledge that the simulator and a robot's own code share."""

from soccersim.kinematics.arm import PlanarArm
from soccersim.kinematics.omni import OmniBase

__all__ = ["OmniBase", "PlanarArm"]
