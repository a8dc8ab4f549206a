"""Fixtures of the quick tests of the page of a robot."""

from reports.play.conftest import ask

__all__ = ["ask"]
