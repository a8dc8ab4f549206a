"""Several robots in worlds that change: every schedule, and every choice of the adversary.

A *model* says how a world changes.  An *activation* of a robot is Look (it gets a percept), Compute
(its program chooses an action) and Move (the action is done).  The *adversary* makes all choices
that the model and the scheduler leave open.  The modules:

``model``, ``models``, ``model_checks``
    the base of every model; the built-in models; checks that a model gives the same answers twice;
``schedulers``
    which robots are activated at once;
``minds``
    the action that a program does next;
``configurations``, ``graph``
    the search of one world; the transitions of the search;
``cycles``, ``events``
    runs that never end; the events of a run;
``team``, ``team_finding``
    the programs of a team, the scope and the counts of its searches; the finding of a search;
``search_lane``, ``program_player``
    the searches of a unit; programs that other processes play, and their second play;
``single_search``
    the search of one world in this process.
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
