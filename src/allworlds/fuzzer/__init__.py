"""The fuzzer: worlds far beyond the exhaustive bound, and the way back to small ones."""

from allworlds.fuzzer.drive import fuzz
from allworlds.fuzzer.given import refuted_in

__all__ = ["fuzz", "refuted_in"]
