"""The bytes of a log that compiled code knows; :mod:`allworlds.protocol.log` has all of them."""

from __future__ import annotations

from allworlds.protocol.log import (
    ANSWERED as ANSWERED,
    BEYOND as STRANGE,
    CHOICE as CHOICE,
    FAULT as ILLEGAL,
    LARGEST_MOTION as LARGEST_MOTION,
    MOST_DARTS as MOST_PUBLISHED,
    OVER_BUDGET as OVER_BUDGET,
    SHOWN as SHOWN,
    SHOWN_TOO_OFTEN as SHOWN_TOO_OFTEN,
    span as span,
)

__all__ = ["ILLEGAL", "MOST_PUBLISHED", "STRANGE"]
