"""Progress of a run directory: ``run_status``, also while it grows."""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.status.run_status import Standing as Standing, status as status
else:
    open_door(__name__)
