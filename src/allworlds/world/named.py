"""The world of a text: inline JSON, a file, a name, or a family of maps."""

from __future__ import annotations

import re
from difflib import get_close_matches
from pathlib import Path
from typing import Annotated

from allworlds.inputs import (
    SCOPE,
    InputError,
    Option,
    Request,
    integer_of,
    parse_json,
    read_text,
    show,
)
from allworlds.maps import FORMS, CombinatorialMap, NoSuchMap, family, named_map, named_maps
from allworlds.world.corpus import own_corpus
from allworlds.world.lighthouses.directional import Directional
from allworlds.world.lighthouses.kinds import lighthouse_from_json, lighthouse_named
from allworlds.world.world import World

HOLES = Option(SCOPE, "P%", "Share of a family's edges to remove [default: none].")
"""An option of every verb that takes a family."""


def world_named(text: str, kind: str = Directional.kind) -> World:
    """The world of inline JSON, of ``@file``, of the corpus, or of a named map.

    Where no lighthouse is named it is of that kind, at its default place: at dart 0 of a
    named map.
    """
    lighthouse_named(kind)
    if text.startswith("@"):
        return _world_of_json(read_text(text[1:]), kind)
    if _is_json(text):
        return _world_of_json(text, kind)
    try:
        map_ = named_map(text)
    except NoSuchMap as error:
        return _world_of_corpus(text, kind, error)
    return World.from_json(map_.to_json(), missing=kind)


def _world_of_corpus(name: str, kind: str, no_map: NoSuchMap) -> World:
    corpus = own_corpus()
    for entry in corpus.of_kind("world"):
        if entry.name == name:
            return World.from_json(corpus.document(entry), missing=kind)
    if f"{name.rpartition('-')[0]}-N" in named_maps():
        raise no_map
    raise InputError(
        f"world {show(name)} is neither JSON, nor @file, nor one of {', '.join(named_maps())}, "
        f"nor a world of the corpus{_hint(name)}"
    )


def _is_json(text: str) -> bool:
    if text.lstrip().startswith(("{", "[")):
        return True
    try:
        parse_json(text)
    except InputError:
        return False
    return True


def _world_of_json(text: str, kind: str) -> World:
    document = parse_json(text)
    keys = document.keys() if isinstance(document, dict) else set()
    if keys & {"findings", "finding", "law"} and not keys & {"sigma", "alpha"}:
        raise InputError("this is a report or a finding, not a world; see replay and explain")
    return World.from_json(document, missing=kind)


def _hint(name: str) -> str:
    """What may have been meant by a name that is none."""
    if Path(name).suffix == ".json":
        return f"; to read a file write {show('@' + name)}"
    if ":" in name:
        return f"; a family is given by --family {name}"
    known = [*named_maps(), *(entry.name for entry in own_corpus().of_kind("world"))]
    meant = get_close_matches(name.lower(), known, 1)
    return f"; did you mean {meant[0]!r}?" if meant else ""


class FamilyWords(Request):
    """One world of a family, in place of another, as the command line names it."""

    family: Annotated[str | None, Option(SCOPE, "F", f"One world of a family: {FORMS}.")] = None
    holes: Annotated[str | None, HOLES] = None
    seed: Annotated[
        int, Option(SCOPE, "S", "For whatever is drawn of a family.", parse=integer_of)
    ] = 0

    def world(self, kind: str) -> World:
        """That world, started at dart 0, with a lighthouse at its default place."""
        assert self.family is not None
        map_ = map_of_family(self.family, self.holes, self.seed)
        return World(map_, lighthouse_from_json(None, map_, 0, kind))


def map_of_family(text: str, holes: str | None, seed: int) -> CombinatorialMap:
    """The map of a family; ``holes`` is ``10%`` or ``0.1``."""
    return family(text, holes=0.0 if holes is None else _fraction(holes), seed=seed)


def _fraction(text: str) -> float:
    """``10%`` or ``0.1``."""
    match = re.fullmatch(r"([0-9]+(?:\.[0-9]+)?)(%?)", text)
    value = float(match[1]) / (100 if match[2] else 1) if match else -1.0
    if not 0 <= value < 1:
        raise InputError(f"holes {show(text)} is no share of the edges; 0% up to 99% are legal")
    return value
