"""The fuzzer: worlds far beyond the exhaustive bound, and the way back to small ones."""

from allworlds.fuzzer.drive import fuzz
from allworlds.fuzzer.sample import Sample

__all__ = ["Sample", "fuzz"]
