"""Exhaustive testing of exploration algorithms on embedded graphs.

Explorers are written against these names::

    from allworlds import CombinatorialMap, Percept, Move, Drop, Pick
    from allworlds import Estimate, Ambiguous, Choices, Checkpoint

and everything that the command line does is a function of the same name, for example
``allworlds.check(explore, edges=4)``.  The functions are loaded when they are first used, so
importing the package is fast.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.protocol import (
    Ambiguous,
    Checkpoint,
    Choices,
    Drop,
    Estimate,
    Move,
    Percept,
    Pick,
)
from allworlds.verbs import GROUPS, VERBS
from allworlds.version import __version__

if TYPE_CHECKING:
    from allworlds import ambiguity
    from allworlds.ambiguity import twins
    from allworlds.benching import bench
    from allworlds.checker import check, replay, run, worlds
    from allworlds.comparing import compare
    from allworlds.counter import count
    from allworlds.explaining import explain
    from allworlds.figures import figure
    from allworlds.fuzzer import fuzz
    from allworlds.growing import grow
    from allworlds.joining import merge, status
    from allworlds.ledger import claims
    from allworlds.libraries import native
    from allworlds.minimax import optimum
    from allworlds.mutation import mutants
    from allworlds.playing import play
    from allworlds.skeletons import init
    from allworlds.smt import search
    from allworlds.worst_case import worst

_PACKAGES = set(GROUPS)
_HOMES = {"worlds": "checker"} | {
    verb.name: verb.function.partition(":")[0] for verb in VERBS if not verb.group
}

__all__ = [
    "Ambiguous",
    "Checkpoint",
    "Choices",
    "CombinatorialMap",
    "Drop",
    "Estimate",
    "InvalidMap",
    "Move",
    "Percept",
    "Pick",
    "__version__",
    "ambiguity",
    "bench",
    "check",
    "claims",
    "compare",
    "count",
    "explain",
    "figure",
    "fuzz",
    "grow",
    "init",
    "merge",
    "mutants",
    "native",
    "optimum",
    "play",
    "replay",
    "run",
    "search",
    "status",
    "twins",
    "worlds",
    "worst",
]


def __getattr__(name: str) -> Any:
    if name in _PACKAGES:
        return import_module(f"allworlds.{name}")
    if name not in _HOMES:
        raise AttributeError(f"module 'allworlds' has no attribute {name!r}")
    return getattr(import_module(f"allworlds.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return sorted(__all__)
