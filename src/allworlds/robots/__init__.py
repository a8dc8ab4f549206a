"""Several robots in worlds that change: every schedule, and every choice of the adversary.

``model`` is the base of every model, ``models`` has those that are built in, ``schedulers`` says
which robots are activated, ``minds`` which action a program does next, ``configurations`` searches
one world, ``graph`` holds the transitions, ``cycles`` finds runs that never end, ``events`` lists
the events of a run, and ``single_search`` searches one world in this process.
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
    from allworlds.robots.single_search import SearchOutcome as SearchOutcome, search as search
else:
    open_door(__name__)
