"""Request of ``optimum``: the number of edges or of loops, and the effort."""

from __future__ import annotations

from typing import Annotated

from allworlds.document import Positive, Text, about
from allworlds.engines import AskedDirectory, AskedListener, AskedTime
from allworlds.inputs import SCOPE, InputError, Option, a_text, an_integer, integer_of, show
from allworlds.studies.optimum.bouquets import MOST_LOOPS

DEFAULT_EDGES, MOST_EDGES = 3, 6
DEFAULT_LOOPS = 4
BOUQUET = "bouquet"


class OptimumRequest(AskedListener, AskedDirectory, AskedTime):
    """Request of ``optimum``: the number of edges or of loops, and the effort."""

    edges: Annotated[
        int | None,
        Option(
            SCOPE,
            "M",
            f"Worlds with 1, 2, ... up to M edges (at most {MOST_EDGES}) [default: "
            f"{DEFAULT_EDGES}].",
            parse=integer_of,
            told=Annotated[Positive | None, about("the most edges; null: a family")],
        ),
    ] = None
    family: Annotated[
        str | None,
        Option(
            SCOPE,
            "F",
            f"'{BOUQUET}': v0 of degree 1 joined to a vertex with loops, matched in every way; the "
            "explorer knows that, and the number of loops.",
            told=Annotated[Text | None, about(f"`{BOUQUET}`; null: all worlds")],
        ),
    ] = None
    to: Annotated[
        int | None,
        Option(
            SCOPE,
            "C",
            f"With --family: 1, 2, ... up to C loops (at most {MOST_LOOPS}) [default: "
            f"{DEFAULT_LOOPS}].",
            parse=integer_of,
            told=Annotated[Positive | None, about("the most loops; null: no family")],
        ),
    ] = None

    @property
    def largest(self) -> int:
        """The number of edges of the last row, or of loops.

        Raises:
            InputError: for a number that is not legal, or options that exclude each other.
        """
        if self.family is None:
            if self.to is not None:
                raise InputError(f"to = {show(self.to)} has no effect without family = '{BOUQUET}'")
            return _legal("edges", self.edges, DEFAULT_EDGES, MOST_EDGES)
        if a_text("family", self.family) != BOUQUET:
            raise InputError(f"family {show(self.family)}: the optimum is searched for '{BOUQUET}'")
        if self.edges is not None:
            raise InputError(f"edges = {show(self.edges)} has no effect with a family; 'to' has")
        return _legal("to", self.to, DEFAULT_LOOPS, MOST_LOOPS)


def _legal(name: str, given: int | None, default: int, most: int) -> int:
    number = default if given is None else an_integer(name, given)
    if not 1 <= number <= most:
        raise InputError(f"{name} = {show(number)}; the optimum is searched for 1..{most}")
    return number
