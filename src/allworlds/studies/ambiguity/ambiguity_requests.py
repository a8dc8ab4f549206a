"""Requests of ``ambiguity twins``, ``class``, ``census`` and ``search``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import KW_ONLY
from pathlib import Path
from typing import Annotated

from allworlds.document.struct import Text, about
from allworlds.engines.effort import AskedCluster, AskedDirectory, AskedListener, AskedTime
from allworlds.engines.units import AskedShard
from allworlds.inputs.checks import InputError, integer_of, one_of, seconds_of, show
from allworlds.inputs.requests import EFFORT, OUTPUT, SCOPE, Argument, Option, Request, Taken
from allworlds.maps.classes import ClassOptions, ExtentOptions
from allworlds.world.lighthouses.kinds import LIGHTHOUSES, OWN, GivenLighthouse, LighthouseKind
from allworlds.world.lighthouses.marked import Position
from allworlds.world.named import LIGHTHOUSE, WORLD
from allworlds.world.selection import WhereOptions, tried_kind
from allworlds.world.world import World

DEFAULT_LIMIT = 1000
"""The largest class whose members are all made, unless another limit is named."""


class CensusRequest(
    AskedListener, AskedCluster, AskedDirectory, AskedTime, AskedShard, WhereOptions, ExtentOptions
):
    """Request of ``ambiguity census``: a class, its bounds and the effort."""

    lighthouse: Annotated[
        Taken[GivenLighthouse, LighthouseKind],
        Option(
            SCOPE,
            "KIND",
            f"KIND[:key=value,...]: {one_of(LIGHTHOUSES)}, or {OWN}.",
            told=Annotated[Text, about("`KIND[:key=value,...]`")],
        ),
    ] = Taken(tried_kind, Position.kind)


class AskedMembers(ClassOptions):
    """Options that select members of an ambiguity class."""

    limit: Annotated[
        int,
        Option(
            EFFORT,
            "L",
            "List at most L worlds; size and poses are exact all the same.",
            parse=integer_of,
        ),
    ] = DEFAULT_LIMIT


class ClassRequest(AskedListener, AskedMembers, kw_only=False):
    """Request of ``ambiguity class``: a world, and how many members are listed."""

    world: Annotated[World | str, WORLD]
    _: KW_ONLY
    lighthouse: Annotated[GivenLighthouse, LIGHTHOUSE] = Position.kind


class TwinsRequest(Request, kw_only=False):
    """Request of ``ambiguity twins``: the two worlds."""

    a: Annotated[World | str, Argument("", "A", WORLD.help)]
    b: Annotated[World | str, Argument("", "B", "Another one.")]
    _: KW_ONLY
    lighthouse: Annotated[GivenLighthouse, LIGHTHOUSE] = Position.kind


def motion_list(text: str) -> tuple[int, ...]:
    """The motions of a text, integers with commas between; negative ones too."""
    if not re.fullmatch(r"-?[0-9]{1,3}(,-?[0-9]{1,3})*", text):
        raise InputError(f"motions {show(text)} are not integers of up to 3 digits with commas")
    return tuple(int(part) for part in text.split(","))


class SearchRequest(AskedListener, ClassOptions):
    """Request of ``ambiguity search``: the properties of the twins, and the solver."""

    lighthouse: Annotated[
        str,
        Option(
            SCOPE,
            "KIND",
            "The lighthouse, sensed besides degrees: none, position, compass or directional.",
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
            "Percepts after each motion: 3A (degree 3, marker absent) or 4P (present).",
            parse=lambda text: tuple(text.split(",")),
        ),
    ] = ()
    solver: Annotated[
        str | None,
        Option(
            EFFORT,
            "PATH",
            "The program CaDiCaL, version 2 or later, in place of z3; it also writes the proofs.",
            apart=True,
        ),
    ] = None
    time_limit: Annotated[
        float | None,
        Option(
            EFFORT,
            "S",
            "The time limit in seconds for the whole search.",
            parse=seconds_of,
            apart=True,
        ),
    ] = None
    out: Annotated[
        str | Path | None,
        Option(
            OUTPUT,
            "DIR",
            "The directory for formulas and proofs (default: a new temporary directory).",
            apart=True,
        ),
    ] = None
