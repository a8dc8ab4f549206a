"""Wrong learners: explorers with position only that make false statements about ambiguity."""

from __future__ import annotations

from collections.abc import Callable, Generator
from typing import Any

from msgspec import Struct

from allworlds.document import replace
from allworlds.explorers import BUILT_IN
from allworlds.maps import cycles
from allworlds.protocol import Ambiguous, Answer, Percept


def doubtful_for_no_reason(right: Answer) -> Answer:
    """Doubts where only one world looks so: in place of a map it answers with a quotient."""
    if isinstance(right, Ambiguous):
        return right
    map_ = right.map
    degree = [map_.degree_at[dart] for dart in map_.darts]
    return Ambiguous(map_.sigma, map_.alpha, degree, [0] * len(degree), right.here)


def degrees_of_the_quotient(right: Answer) -> Answer:
    """Counts the darts round a vertex of the quotient, and not those that are sensed there."""
    if not isinstance(right, Ambiguous):
        return right
    round_it = {dart: len(cycle) for cycle in cycles(right.sigma) for dart in cycle}
    return replace(right, degree=[round_it[dart] for dart in range(len(right.sigma))])


class WrongLearner(Struct, frozen=True):
    """A mutant of the explorer ``quotient``.

    Attributes:
        slip: what becomes of the right answer.
        equivalent: why it is right all the same; empty for one that must be killed.
    """

    slip: Callable[[Answer], Answer]
    equivalent: str = ""

    lighthouse = BUILT_IN["quotient"].lighthouse
    task = "map"

    @property
    def name(self) -> str:
        """The name of the slip, with hyphens."""
        return self.slip.__name__.replace("_", "-")

    @property
    def breaks(self) -> str:
        """The learner's mistake, in words."""
        return (self.slip.__doc__ or "").strip()

    def explorer(self) -> Callable[..., Generator[Any, Any, Answer]]:
        """The generator function, which runs in this process."""
        slip = self.slip

        def explore(first: Percept) -> Generator[Any, Any, Answer]:
            return slip((yield from BUILT_IN["quotient"].explore(first)))

        explore.__module__, explore.__qualname__ = "mutants", self.name
        return explore


WRONG_LEARNERS = (WrongLearner(doubtful_for_no_reason), WrongLearner(degrees_of_the_quotient))
"""The learners that must be refuted."""
