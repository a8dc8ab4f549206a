"""Counts of maps, each made twice: ``counter``."""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.count.counter import Census as Census, count as count
else:
    open_door(__name__)
