"""Weakened judges: the laws with one of them softened or left out."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from msgspec import Struct

from allworlds.judging.laws.bounds import paper_bound
from allworlds.judging.laws.law_table import (
    Case,
    Check,
    Violation,
    ambiguity_law,
    bound_law,
    map_law,
)
from allworlds.maps import CombinatorialMap, isomorphism, to_networkx
from allworlds.protocol.actions import Estimate, Move


def mirror_accepted(case: Case) -> Violation | None:
    """The mirror image of the world is taken for the world."""
    violation = map_law(case)
    return violation if not isomorphism(_map(case).mirrored(), case.map) else None


def graph_only(case: Case) -> Violation | None:
    """Only the graphs are compared, and not the cyclic orders round the vertices."""
    from networkx import is_isomorphic

    violation = map_law(case)
    same_graph = violation and is_isomorphic(to_networkx(_map(case)), to_networkx(case.map))
    return None if same_graph else violation


def bound_with_5mn(case: Case) -> Violation | None:
    """The bound is counted with the term +5mn twice."""
    n, m = case.map.vertex_count, case.map.edge_count
    softer = paper_bound(n, m) + 5 * m * n
    return bound_law(case) if case.walk.cost > softer else None


def retracing_not_counted(case: Case) -> Violation | None:
    """Steps back through the edge one came by cost nothing."""
    steps = case.walk.actions
    forward = sum(type(action) is Move and action.k != 0 for action in steps)
    violation = bound_law(case)
    return violation if case.bound is not None and forward > case.bound else None


def _map(case: Case) -> CombinatorialMap:
    assert isinstance(case.estimate, Estimate)
    return case.estimate.map


class WeakJudge(Struct, frozen=True):
    """A judge one of whose laws is softened, or left out.

    Attributes:
        name: for the kill matrix.
        breaks: what it lets through.
        law: the law concerned.
        softer: what stands in its place; None where nothing does.
    """

    name: str
    breaks: str
    law: str
    softer: Check | None = None

    def accepts(self, case: Case, laws: Mapping[str, Check]) -> bool:
        """Whether the weakened judge accepts an answer, where these laws apply."""
        checks = {"ambiguity": ambiguity_law, **laws}
        checks.pop(self.law, None)
        if self.softer is not None and self.law in laws:
            checks[self.law] = self.softer
        return not any(check(case) for check in checks.values())


def _softened(law: str, softer: Callable[[Case], Violation | None]) -> WeakJudge:
    name = softer.__name__.replace("_", "-")
    return WeakJudge(name, (softer.__doc__ or "").strip(), law, softer)


WEAK_JUDGES = (
    _softened("map", mirror_accepted),
    _softened("map", graph_only),
    _softened("bound", bound_with_5mn),
    _softened("bound", retracing_not_counted),
    WeakJudge("map-not-compared", "Any map is accepted.", "map"),
    WeakJudge("pose-not-compared", "The robot's place is not compared.", "pose"),
    WeakJudge(
        "quotient-not-compared", "An answer that names no map is always accepted.", "ambiguity"
    ),
    WeakJudge("I-1-not-checked", "S need not be a part of the world.", "invariant-1"),
    WeakJudge("I-2-not-checked", "U may hold explored darts.", "invariant-2"),
    WeakJudge("t-not-checked", "A pass need not explore anything.", "variant"),
    WeakJudge("folding-never-complains", "A guess that is right is accepted.", "folding"),
    WeakJudge("bound-not-checked", "The walk may be as long as it likes.", "bound"),
)
"""The judges each of which must accept something that the sound one refuses."""
