"""What ``ambiguity census``, ``class`` and ``search`` are asked for, as values."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

from allworlds.engines import AskedCluster, AskedDirectory, AskedListener, AskedShard
from allworlds.inputs import EFFORT, OUTPUT, SCOPE, InputError, Option, integer_of, seconds_of, show
from allworlds.maps import AskedClass, AskedExtent
from allworlds.world import World

DEFAULT_LIMIT = 1000
"""The largest class whose members are all made, unless another limit is named."""


class CensusRequest(AskedListener, AskedCluster, AskedDirectory, AskedShard, AskedExtent):
    """What ``ambiguity census`` is asked for."""


class AskedMembers(AskedClass):
    """Which members of an ambiguity class are meant."""

    limit: Annotated[
        int,
        Option(
            EFFORT,
            "L",
            "List at most L worlds; size and poses are exact all the same.",
            parse=integer_of,
        ),
    ] = DEFAULT_LIMIT


class ClassRequest(AskedMembers, kw_only=False):
    """What ``ambiguity class`` is asked for."""

    world: Annotated[World, "with a position lighthouse, or a directional one (then it is alone)"]


def motion_list(text: str) -> tuple[int, ...]:
    """Motions with commas, negative ones too."""
    if not re.fullmatch(r"-?[0-9]{1,3}(,-?[0-9]{1,3})*", text):
        raise InputError(f"motions {show(text)} are not integers of up to 3 digits with commas")
    return tuple(int(part) for part in text.split(","))


class SearchRequest(AskedListener, AskedClass):
    """What ``ambiguity search`` is asked for."""

    lighthouse: Annotated[
        str,
        Option(
            SCOPE, "KIND", "What is sensed besides degrees: none, position, compass or directional."
        ),
    ]
    vertices: Annotated[int, Option(SCOPE, "N", "At most N vertices.", parse=integer_of)]
    edges: Annotated[int, Option(SCOPE, "M", "At most M edges.", parse=integer_of)]
    degree_marked: Annotated[
        int | None, Option(SCOPE, "D", "Degree of the start's vertex.", parse=integer_of)
    ] = None
    degree_others: Annotated[
        int | None, Option(SCOPE, "D", "Degree of every other vertex.", parse=integer_of)
    ] = None
    motions: Annotated[
        Sequence[int], Option(SCOPE, "K,K,...", "A walk from the start.", parse=motion_list)
    ] = ()
    percepts: Annotated[
        Sequence[str],
        Option(
            SCOPE,
            "P,P,...",
            "What it senses after each motion: 3A (degree 3, marker absent) or 4P (present).",
            parse=lambda text: tuple(text.split(",")),
        ),
    ] = ()
    solver: Annotated[
        str | None,
        Option(
            EFFORT,
            "PATH",
            "A CaDiCaL 2 or later, in place of z3; it writes the proofs too.",
            apart=True,
        ),
    ] = None
    time_limit: Annotated[
        float | None,
        Option(EFFORT, "S", "Seconds for everything.", parse=seconds_of, apart=True),
    ] = None
    out: Annotated[
        str | Path | None,
        Option(
            OUTPUT,
            "DIR",
            "For formulas and proofs (default: a new temporary directory).",
            apart=True,
        ),
    ] = None
