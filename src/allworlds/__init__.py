"""Exhaustive testing of exploration algorithms on embedded graphs.

Explorers use these names::

    from allworlds import CombinatorialMap, Percept, Move, Drop, Pick, Write
    from allworlds import Estimate, Ambiguous, Choices, Checkpoint

Programs for several robots also use ``Wait``, ``Watch``, ``Do``, ``End`` and ``Automaton``.
``Lighthouse`` is the base class of your own lighthouses.  ``Model`` is the base class of your own
models, which are worlds that change.

Each verb of the command line is a function of the same name, for example
``allworlds.check(explore, edges=4)``.  The functions are loaded when they are first used, so
importing the package is fast.
"""

from typing import TYPE_CHECKING

from allworlds.documents import shown as _shown
from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds import (
        claims as claims,
        maps as maps,
        robots as robots,
        strategies as strategies,
        testing as testing,
        world as world,
    )
    from allworlds.explorers.loading import shield as shield
    from allworlds.judging.findings.finding import Finding as Finding
    from allworlds.maps.combinatorial import (
        CombinatorialMap as CombinatorialMap,
        InvalidMap as InvalidMap,
    )
    from allworlds.protocol.actions import (
        Ambiguous as Ambiguous,
        Checkpoint as Checkpoint,
        Do as Do,
        Drop as Drop,
        End as End,
        Estimate as Estimate,
        IllegalAction as IllegalAction,
        Move as Move,
        Percept as Percept,
        Pick as Pick,
        Wait as Wait,
        Watch as Watch,
        Write as Write,
    )
    from allworlds.protocol.choices import Choices as Choices
    from allworlds.protocol.turns import Automaton as Automaton
    from allworlds.reports.drawing.svg import Drawing as Drawing, draw as draw
    from allworlds.robots.model import Model as Model
    from allworlds.studies import ambiguity as ambiguity
    from allworlds.studies.ambiguity.members import twins as twins
    from allworlds.studies.ambiguity.twin_search import search as search
    from allworlds.studies.check.exhaustive import check as check
    from allworlds.studies.compare.comparison import compare as compare
    from allworlds.studies.convert import convert as convert
    from allworlds.studies.count import count as count
    from allworlds.studies.explain import explain as explain
    from allworlds.studies.fuzz.sample_sweep import fuzz as fuzz
    from allworlds.studies.init import init as init
    from allworlds.studies.ledger import ledger as ledger
    from allworlds.studies.merge import merge as merge, status as status
    from allworlds.studies.run import play as play, replay as replay, run as run
    from allworlds.studies.team.search_sweep import team as team
    from allworlds.studies.worst.all_worlds import worst as worst
    from allworlds.version import __version__ as __version__
    from allworlds.world.lighthouses.base import Lighthouse as Lighthouse
    from allworlds.world.selection import worlds as worlds
    from allworlds.world.world import World as World
else:
    open_door(__name__)


@_shown.register
def _writers() -> _shown.Writers:
    """Load and return the functions that write reports and pictures.

    This function is called only when the first report or picture is shown.
    """
    from allworlds.reports.notebook import WRITERS

    return WRITERS
