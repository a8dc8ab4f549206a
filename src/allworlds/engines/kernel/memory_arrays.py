"""The shared memory of stretches as arrays with rows, for compiled code."""

from __future__ import annotations

from typing import Any, Literal

from numpy import asarray
from typing_extensions import override

from allworlds.engines.kernel.stretch import Stretch


class StretchArrays(Stretch):
    """The memory of a stretch, whose parts are arrays."""

    @override
    def part(self, kind: Literal["i", "B"], *shape: int) -> Any:
        return asarray(super().part(kind, *shape)).reshape(shape)
