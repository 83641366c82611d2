"""The base station: a simulation that people watch and steer from their browsers."""
