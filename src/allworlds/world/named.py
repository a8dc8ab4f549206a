"""The world of a text: inline JSON, a file, a name, or a family of maps."""

from __future__ import annotations

import re
from difflib import get_close_matches
from pathlib import Path
from typing import Annotated

from allworlds.document import Text, about
from allworlds.inputs import (
    SCOPE,
    Argument,
    InputError,
    Option,
    Request,
    integer_of,
    one_of,
    parse_json,
    read_text,
    show,
)
from allworlds.maps import (
    FORMS,
    CombinatorialMap,
    Dart,
    NoSuchMap,
    family,
    named_map,
    named_maps,
    rooted_code,
)
from allworlds.world.adversary import FORM, PREFIX
from allworlds.world.corpus import own_corpus
from allworlds.world.lighthouses.directional import Directional
from allworlds.world.lighthouses.kinds import (
    LIGHTHOUSES,
    GivenLighthouse,
    LighthouseKind,
    lighthouse_from_json,
    lighthouse_kind,
)
from allworlds.world.world import World

WORLD = Argument("", "WORLD", "Inline JSON, @file, or a name such as k4, wheel:4, cycle:5.")
"""An argument of every verb that takes a world."""

LIGHTHOUSE = Option(
    SCOPE, "KIND", f"The lighthouse for a WORLD that names none: {one_of(LIGHTHOUSES)}."
)
"""An option of most of them."""

HOLES = Option(
    SCOPE,
    "P%",
    "Share of a family's edges to remove [default: none].",
    told=Annotated[Text | None, about("the share of a family's edges that was removed")],
)
"""An option of every verb that takes a family."""


def a_world(given: object, kind: GivenLighthouse, seed: int | None = None) -> World:
    """The world of a text, as :func:`world_named` has it, or a world that is given as it is.

    Raises:
        InputError: if it is neither, or a seed is given beside a world.
    """
    if isinstance(given, str):
        return world_named(given, kind, seed)
    if not isinstance(given, World):
        raise InputError(f"world = {show(given)} is no World; World.from_json makes one")
    if seed is not None:
        raise InputError(f"seed = {show(seed)} has no effect on a world that is given")
    return given


def world_named(
    text: str, kind: GivenLighthouse = Directional.kind, seed: int | None = None
) -> World:
    """The world of inline JSON, of ``@file``, of the corpus, of a named map, or of a code.

    If no lighthouse is named, it is of that kind, at its default place: at dart 0 of a
    named map.  The seed is that of a family, by default 0.

    Raises:
        InputError: naming a text that is none of these, or a seed that has no effect.
    """
    kind = lighthouse_kind(kind)
    if seed is not None and (_is_json(text) or text.partition(":")[0] not in _families()):
        raise InputError(f"seed {seed} has no effect on world {show(text)}, which is no family")
    if text.startswith("@"):
        return _world_of_json(read_text(text[1:]), kind)
    if _is_json(text):
        return _world_of_json(text, kind)
    if _CODE.fullmatch(text):
        return World.from_json(map_of_code(text).to_json(), missing=kind)
    if ":" in text:
        return World.from_json(map_of_family(text, None, seed or 0).to_json(), missing=kind)
    try:
        map_ = named_map(text)
    except NoSuchMap as error:
        return _world_of_corpus(text, kind, error)
    return World.from_json(map_.to_json(), missing=kind)


_CODE = re.compile(r"[0-9.]+/[0-9.]+", re.ASCII)


def code_of(map_: CombinatorialMap, root: Dart = 0) -> str:
    """The canonical code of a map rooted at a dart, as a WORLD: ``SIGMA/ALPHA``.

    Each is written as its images, with dots between; two worlds have one code exactly if they
    are isomorphic as rooted maps.
    """
    return "/".join(".".join(map(str, each)) for each in rooted_code(map_.sigma, map_.alpha, root))


def map_of_code(text: str) -> CombinatorialMap:
    """The map of :func:`code_of`, or of another numbering in the same form.

    Raises:
        InvalidMap: naming what is no map.
    """
    sigma, _, alpha = text.partition("/")
    return CombinatorialMap(*([int(f"0{image}") for image in t.split(".")] for t in (sigma, alpha)))


def names_of_worlds() -> dict[str, tuple[str, ...]]:
    """The names of a WORLD: maps, families (a capital letter is a number), the corpus."""
    entries = tuple(entry.name for entry in own_corpus().of_kind("world"))
    return {
        "maps": tuple(
            name.replace("-N", ":N")
            for name in named_maps()
            if name.removesuffix("-N") not in _families()
        ),
        "families": tuple(FORMS.split(", ")),
        "corpus": tuple(name for name in entries if name not in named_maps()),
    }


def _world_of_corpus(name: str, kind: LighthouseKind, no_map: NoSuchMap) -> World:
    corpus = own_corpus()
    for entry in corpus.of_kind("world"):
        if entry.name == name:
            return World.from_json(corpus.document(entry), missing=kind)
    if f"{name.rpartition('-')[0]}-N" in named_maps():
        raise no_map
    raise InputError(
        f"world {show(name)} is neither JSON, nor @file, nor a name that 'allworlds run --list' "
        f"tells{_hint(name)}"
    )


def _is_json(text: str) -> bool:
    if text.lstrip().startswith(("{", "[")):
        return True
    try:
        parse_json(text)
    except InputError:
        return False
    return True


def _world_of_json(text: str, kind: LighthouseKind) -> World:
    document = parse_json(text)
    keys = document.keys() if isinstance(document, dict) else set()
    if keys & {"findings", "finding", "law"} and not keys & {"sigma", "alpha"}:
        raise InputError("this is a report or a finding, not a world; see replay and explain")
    return World.from_json(document, missing=kind)


def _hint(name: str) -> str:
    """A hint for an unknown name: the nearest known one; empty if there is none near."""
    if Path(name).suffix == ".json":
        return f"; to read a file write {show('@' + name)}"
    known = [*named_maps(), *(entry.name for entry in own_corpus().of_kind("world"))]
    meant = get_close_matches(name.lower(), known, 1)
    return f"; did you mean {meant[0]!r}?" if meant else ""


class FamilyWords(Request):
    """The options of the command line that name one world of a family."""

    family: Annotated[str | None, Option(SCOPE, "F", f"One world of a family: {FORMS}.")] = None
    holes: Annotated[str | None, HOLES] = None
    seed: Annotated[
        int, Option(SCOPE, "S", "For whatever is drawn of a family.", parse=integer_of)
    ] = 0

    def world(self, kind: GivenLighthouse) -> World:
        """Return that world, started at dart 0, with a lighthouse at its default place."""
        assert self.family is not None
        map_ = map_of_family(self.family, self.holes, self.seed)
        return World(map_, lighthouse_from_json(None, map_, 0, kind))


def map_of_family(text: str, holes: str | None, seed: int) -> CombinatorialMap:
    """The map of a family, or a named one with its number; ``holes`` is ``10%`` or ``0.1``."""
    if text.startswith(PREFIX):
        raise InputError(
            f"{show(text)} is no world before an explorer has walked in it: it is for 'allworlds "
            f"run EXPLORER {FORM}'; {FORM.removeprefix(PREFIX)} has a world for each seed"
        )
    kind, _, number = text.partition(":")
    names = {name.removesuffix("-N") for name in named_maps() if name.endswith("-N")}
    if holes is None and kind in names - _families():
        return named_map(f"{kind}-{number}")
    return family(text, holes=0.0 if holes is None else _fraction(holes), seed=seed)


def _families() -> set[str]:
    """The names of the families."""
    return {form.partition(":")[0] for form in FORMS.split(", ")}


def _fraction(text: str) -> float:
    """The fraction of ``10%`` or ``0.1``; raise InputError outside 0..1."""
    match = re.fullmatch(r"([0-9]+(?:\.[0-9]+)?)(%?)", text)
    value = float(match[1]) / (100 if match[2] else 1) if match else -1.0
    if not 0 <= value < 1:
        raise InputError(f"holes {show(text)} is no share of the edges; 0% up to 99% are legal")
    return value
