"""The shared memories of stretches and trees as arrays with rows, for compiled code."""

from __future__ import annotations

from typing import Any, Literal

from numpy import asarray
from typing_extensions import override

from allworlds.engines.kernel.stretch import Parts, Stretch
from allworlds.engines.kernel.tree_memory import TreeMemory


class _Arrays(Parts):
    """Parts that are arrays."""

    @override
    def part(self, kind: Literal["i", "B"], *shape: int) -> Any:
        return asarray(super().part(kind, *shape)).reshape(shape)


class StretchArrays(_Arrays, Stretch):
    """The memory of a stretch."""


class TreeArrays(_Arrays, TreeMemory):
    """The memory of a tree."""
