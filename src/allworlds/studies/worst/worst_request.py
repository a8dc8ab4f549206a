"""Request of ``worst``: the worlds and the reading of line 4."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, cast, get_args

from allworlds.document import Positive, about
from allworlds.engines import (
    AskedCluster,
    AskedDirectory,
    AskedListener,
    AskedShard,
    AskedTime,
    AskedWorkers,
)
from allworlds.explorers import DEFAULT_EXPLORER, algorithm1
from allworlds.inputs import (
    RULES,
    SCOPE,
    Argument,
    InputError,
    Option,
    Request,
    Taken,
    an_integer,
    integer_of,
    show,
)
from allworlds.maps import AskedClass
from allworlds.studies.worst.every_schedule import Transit

DEFAULT_EDGES, MOST_EDGES = 5, 12


def _algorithm1(given: object) -> str:
    if given not in (DEFAULT_EXPLORER, algorithm1):
        raise InputError(
            f"worst is of {DEFAULT_EXPLORER}, not of {show(given)}; 'allworlds check EXPLORER "
            "--schedules all' has the best and the largest cost of any other"
        )
    return DEFAULT_EXPLORER


def _edges(given: object) -> int:
    number = an_integer("edges", given)
    if number > MOST_EDGES:
        raise InputError(f"edges = {show(number)}, but there is room for {MOST_EDGES} at most")
    return number


def _transit(given: object) -> Transit:
    if given not in get_args(Transit):
        raise InputError(f"transit {show(given)} is not one of {', '.join(get_args(Transit))}")
    return cast("Transit", given)


class AskedAlgorithm1(Request, kw_only=False):
    """The part of a request of ``worst`` that may be given by its place."""

    explore: Annotated[
        Taken[str | Callable[..., Any], str],
        Argument(
            "",
            "[EXPLORER]",
            "algorithm1; the costs of any other explorer are in the rows of check EXPLORER "
            "--schedules all.",
        ),
    ] = Taken(_algorithm1, DEFAULT_EXPLORER)


class WorstRequest(
    AskedListener,
    AskedCluster,
    AskedDirectory,
    AskedTime,
    AskedWorkers,
    AskedShard,
    AskedClass,
    AskedAlgorithm1,
):
    """Request of ``worst``: the worlds and the effort."""

    edges: Annotated[
        Taken[int, int],
        Option(
            SCOPE,
            "M",
            "At most M edges.",
            parse=integer_of,
            told=Annotated[Positive, about("at most so many")],
        ),
    ] = Taken(_edges, DEFAULT_EDGES)
    transit: Annotated[
        Taken[str, Transit],
        Option(
            RULES,
            "|".join(get_args(Transit)),
            "How Algorithm 1 goes to the next edge: on a shortest or on any simple path.",
            told=Annotated[Transit, about("the paths by which Algorithm 1 goes to the next edge")],
        ),
    ] = Taken(_transit, "simple")
