"""The fuzzer: worlds far beyond the exhaustive bound, and the way back to small ones."""

from allworlds.fuzzer.drive import fuzz

__all__ = ["fuzz"]
