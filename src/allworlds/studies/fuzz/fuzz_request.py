"""Request of ``fuzz``: an explorer, the sample, rules and effort."""

from __future__ import annotations

from typing import Annotated

from allworlds.engines import AskedCluster, AskedDirectory, AskedShard
from allworlds.inputs import SCOPE, Option, Request, integer_of
from allworlds.studies.check import ManyRuns
from allworlds.world import AskedWhere


class AskedSample(Request):
    """Options for drawing worlds: their sizes and their number."""

    edges: Annotated[int, Option(SCOPE, "M", "At most M edges.", parse=integer_of)]
    min_edges: Annotated[
        int,
        Option(
            SCOPE,
            "L",
            "At least L edges; choose more than an exhaustive check has tried.",
            parse=integer_of,
        ),
    ] = 1
    runs: Annotated[int, Option(SCOPE, "R", "The number of worlds.", parse=integer_of)]
    seed: Annotated[int, Option(SCOPE, "S", "Which sample.", parse=integer_of)] = 0


class MapsRequest(ManyRuns, AskedWhere):
    """Request for runs in given maps: an explorer, the class and a condition, rules and effort."""


class FuzzRequest(AskedDirectory, AskedCluster, AskedShard, MapsRequest, AskedSample):
    """Request of ``fuzz``: an explorer, the sample, rules and effort."""
