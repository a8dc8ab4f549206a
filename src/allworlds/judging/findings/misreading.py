"""The convention that an explorer has wrong, seen by playing it behind a translator."""

from __future__ import annotations

from msgspec import Struct


class Misreading(Struct, frozen=True):
    """The result of playing the explorer of a finding behind a translator: no law was broken.

    Attributes:
        convention: the name in :data:`allworlds.explorers.CONVENTIONS`.
        runs: the number of runs besides that of the finding, in all worlds of a size.
        edges: the largest number of edges of their worlds.
        among: the class of these worlds, and the condition on them.
    """

    convention: str
    runs: int
    edges: int
    among: str
