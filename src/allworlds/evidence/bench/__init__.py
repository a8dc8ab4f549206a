"""Measurements side by side: ``rounds`` measures, ``bench_telling`` tells."""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.evidence.bench.rounds import bench as bench
else:
    open_door(__name__)
