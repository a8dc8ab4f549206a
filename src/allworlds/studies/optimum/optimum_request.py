"""Request of ``optimum``: the number of edges and the effort."""

from __future__ import annotations

from typing import Annotated

from allworlds.engines import AskedDirectory, AskedListener, AskedTime
from allworlds.inputs import SCOPE, Option, integer_of

DEFAULT_EDGES, MOST_EDGES = 3, 6


class OptimumRequest(AskedListener, AskedDirectory, AskedTime):
    """Request of ``optimum``: the number of edges and the effort."""

    edges: Annotated[
        int,
        Option(
            SCOPE,
            "M",
            f"Worlds with 1, 2, ... up to M edges (at most {MOST_EDGES}).",
            parse=integer_of,
        ),
    ] = DEFAULT_EDGES
