"""Makes tests/factory.py importable from every test, and gives hypothesis time to compile."""

from hypothesis import settings

settings.register_profile("patient", deadline=None)
settings.load_profile("patient")
