"""Several robots in worlds that change: every schedule, and every choice of the adversary.

``model`` the base of every model, ``models`` those that are built in, ``schedulers`` who is
activated, ``minds`` what a program does next, ``configurations`` the search of one world,
``graph`` its steps, ``cycles`` the runs that never end, ``events`` what happened, ``one_world``
the same in this process.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.robots.model import (
        QUIET as QUIET,
        Assumption as Assumption,
        Liveness as Liveness,
        Model as Model,
        Places as Places,
        every_start as every_start,
    )
    from allworlds.robots.models.shared_whiteboard import SharedWhiteboard as SharedWhiteboard
    from allworlds.robots.models.table import named_model as named_model
    from allworlds.robots.one_world import SearchOutcome as SearchOutcome, search as search
else:
    open_door(__name__)
