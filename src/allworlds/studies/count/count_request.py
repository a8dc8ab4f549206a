"""Request of ``count``: a class, its bounds and the effort."""

from __future__ import annotations

from allworlds.engines import AskedCluster, AskedDirectory, AskedListener, AskedShard, AskedTime
from allworlds.maps import AskedExtent
from allworlds.world import AskedWhere


class CountRequest(
    AskedListener, AskedCluster, AskedDirectory, AskedTime, AskedShard, AskedWhere, AskedExtent
):
    """Request of ``count``: a class, its bounds and the effort."""
