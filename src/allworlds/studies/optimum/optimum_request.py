"""What ``optimum`` is asked for, as a value."""

from __future__ import annotations

from typing import Annotated

from allworlds.engines import AskedListener
from allworlds.inputs import EFFORT, SCOPE, Option, integer_of, seconds_of

DEFAULT_EDGES, MOST_EDGES = 3, 6


class OptimumRequest(AskedListener):
    """What ``optimum`` is asked for."""

    edges: Annotated[
        int,
        Option(
            SCOPE,
            "M",
            f"Worlds with 1, 2, ... up to M edges (at most {MOST_EDGES}).",
            parse=integer_of,
        ),
    ] = DEFAULT_EDGES
    time_limit: Annotated[
        float | None,
        Option(EFFORT, "S", "Seconds for the search of each row.", parse=seconds_of, apart=True),
    ] = None
