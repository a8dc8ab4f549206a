"""Request of ``worst``: an explorer, the worlds and the reading of line 4."""

from __future__ import annotations

from typing import Annotated, cast, get_args

from allworlds.document import Positive, about
from allworlds.engines import (
    AskedCluster,
    AskedDirectory,
    AskedListener,
    AskedShard,
    Limits,
)
from allworlds.explorers import AskedExplorer
from allworlds.inputs import RULES, SCOPE, InputError, Option, Taken, integer_of, show
from allworlds.judging import AskedTask
from allworlds.maps import AskedClass
from allworlds.studies.worst.every_schedule import Transit
from allworlds.world import AskedLighthouse, AskedWhere

DEFAULT_EDGES, OTHERS_EDGES = 5, 3


def _transit(given: object) -> Transit | None:
    if given not in (None, *get_args(Transit)):
        raise InputError(f"transit {show(given)} is not one of {', '.join(get_args(Transit))}")
    return cast("Transit | None", given)


class WorstRequest(
    AskedListener,
    AskedCluster,
    AskedDirectory,
    Limits,
    AskedShard,
    AskedTask,
    AskedWhere,
    AskedLighthouse,
    AskedClass,
    AskedExplorer,
):
    """Request of ``worst``: an explorer, the worlds and the effort."""

    edges: Annotated[
        int | None,
        Option(
            SCOPE,
            "M",
            f"At most M edges [default: {DEFAULT_EDGES} of algorithm1, {OTHERS_EDGES} of others].",
            parse=integer_of,
            told=Annotated[Positive, about("at most so many")],
        ),
    ] = None
    transit: Annotated[
        Taken[str | None, Transit | None],
        Option(
            RULES,
            "|".join(get_args(Transit)),
            "How Algorithm 1 goes to the next edge: on a shortest or on any simple path "
            "[default: simple].",
            told=Annotated[
                Transit | None,
                about(
                    "the paths by which Algorithm 1 goes to the next edge; null: another explorer"
                ),
            ],
        ),
    ] = Taken(_transit, None)
