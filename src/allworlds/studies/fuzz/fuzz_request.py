"""What ``fuzz`` is asked for, as a value."""

from __future__ import annotations

from typing import Annotated

from allworlds.inputs import SCOPE, Option, Request, integer_of
from allworlds.studies.check import ManyRuns


class AskedSample(Request):
    """Which worlds are drawn."""

    edges: Annotated[int, Option(SCOPE, "M", "At most M edges.", parse=integer_of)]
    min_edges: Annotated[
        int,
        Option(
            SCOPE,
            "L",
            "At least L edges: more than were tried exhaustively.",
            parse=integer_of,
        ),
    ] = 1
    runs: Annotated[int, Option(SCOPE, "R", "How many worlds.", parse=integer_of)]
    seed: Annotated[int, Option(SCOPE, "S", "Which sample.", parse=integer_of)] = 0


class FuzzRequest(ManyRuns, AskedSample):
    """What ``fuzz`` is asked for."""
