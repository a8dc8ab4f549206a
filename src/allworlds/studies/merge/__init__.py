"""One report of all shards of a job: ``merging``."""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.merge.merging import merge as merge
else:
    open_door(__name__)
