"""What ``count`` is asked for, as a value."""

from __future__ import annotations

from allworlds.engines import AskedListener
from allworlds.maps import AskedExtent


class CountRequest(AskedListener, AskedExtent):
    """What ``count`` is asked for."""
