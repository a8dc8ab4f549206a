"""The world that a text means: inline JSON, a file, a named map, a family, or a corpus entry.

The corpus comes with the package.  A manifest lists its entries, with their provenance and their
expected results; each entry has a file.  The entries are named worlds, findings, pairs of
indistinguishable worlds, counts, and checks.  On the command line a text that means a world is
called WORLD.
"""

import re
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias

from msgspec import Meta, Struct

from allworlds.documents.document import Document, Text, about
from allworlds.documents.reading import parse
from allworlds.inputs.checks import (
    InputError,
    did_you_mean,
    in_file,
    integer_of,
    not_one_of,
    one_of,
    parse_json,
    show,
)
from allworlds.inputs.requests import RARE_SCOPE, SCOPE, Argument, Converted, Option, Request
from allworlds.maps.build import NoSuchMap, named_map, named_maps
from allworlds.maps.combinatorial import CombinatorialMap, Dart, rooted_code
from allworlds.maps.families import FORMS, OTHER_WORDS, family
from allworlds.notations.objects import entry_of
from allworlds.notations.table import entry_named
from allworlds.world.lighthouses.kinds import (
    LIGHTHOUSES,
    OWN,
    GivenLighthouse,
    LighthouseKind,
    kind_of,
)
from allworlds.world.lighthouses.marked import Directional
from allworlds.world.selection import kind_if_any, tried_kind
from allworlds.world.world import World, at_place

EntryKind: TypeAlias = Literal["world", "finding", "pair", "counts", "check"]

MANIFEST = "manifest.json"


class CorpusEntry(Document):
    """An entry of a corpus.

    The file of the entry is a JSON document: a world, a finding, a pair of worlds, counts, or the
    options of a check.
    """

    name: Annotated[Text, about("unique in the corpus")]
    kind: Annotated[EntryKind, about("what the file holds")]
    file: Annotated[Text, about("where it stands, below the corpus")]
    sha256: Annotated[str, Meta(pattern="^[0-9a-f]{64}$"), about("of the file")]
    provenance: Annotated[Text, about("where it comes from")]
    expected: Annotated[dict[str, Any], about("what must come out when it is tried")]


class Manifest(Document):
    """Manifest of a corpus."""

    schema: Annotated[Literal[1], about("the version of the document")]
    entries: Annotated[
        tuple[CorpusEntry, ...], about("what is kept, in the order in which it is told")
    ]


class Corpus(Struct, frozen=True):
    """A corpus: a directory, with the entries of its manifest."""

    directory: Path
    entries: tuple[CorpusEntry, ...]

    def of_kind(self, kind: EntryKind) -> list[CorpusEntry]:
        """The entries of the kind ``kind``, in the order of the manifest."""
        return [entry for entry in self.entries if entry.kind == kind]

    def document(self, entry: CorpusEntry) -> Any:
        """The JSON document of an entry."""
        return parse_json((self.directory / entry.file).read_text(encoding="utf-8"))


@cache
def own_corpus() -> Corpus:
    """The corpus that comes with the package."""
    package = Path(__file__).parents[1]
    installed = package / "corpus"
    directory = installed if installed.is_dir() else package.parents[1] / "corpus"
    document = parse_json((directory / MANIFEST).read_text(encoding="utf-8"))
    return Corpus(directory, parse(document, Manifest, MANIFEST).entries)


WORLD = Argument(
    "", "WORLD", "Inline JSON, @file or @file:name, or a name such as k4, wheel:4, cycle:5."
)
"""The argument of all verbs that take a world."""

LIGHTHOUSE = Option(
    SCOPE,
    "KIND",
    f"The lighthouse for a WORLD that names none: {one_of(LIGHTHOUSES)}, {OWN}, or several with + "
    "between them.",
)
"""The option of most verbs that take a world: the lighthouse, if the WORLD names none."""

HOLES = Option(
    RARE_SCOPE,
    "P%",
    "Share of a family's edges to remove [default: none].",
    document_type=Annotated[Text | None, about("the share of a family's edges that was removed")],
)
"""The option of all verbs that take a family: the share of its edges to remove."""


def world_named(
    given: str | World,
    kind: GivenLighthouse = Directional.kind,
    seed: int | None = None,
    holes: str | None = None,
) -> World:
    """The world that a text means.

    The text is inline JSON, ``@file``, a canonical code of a map (see :func:`code_of`), or the name
    of a family's member, of a map, or of a world in the corpus.

    Args:
        given: the text; or a world, which is returned unchanged.
        kind: the kind of lighthouse if the text names none; the lighthouse stands at its default
            place.
        seed: the seed of a family, by default 0.
        holes: the share of a family's edges to remove.

    Raises:
        InputError: naming a text that means no world, or a seed or holes without effect.
    """
    if not isinstance(given, str | World):
        raise InputError(f"world = {show(given)} is no World; World(map) makes one of a map")
    for name, beside in (("seed", seed), ("holes", holes)):
        if beside is not None and not _names_family(given):
            whose = f"world {show(given)}, which is no family"
            what = whose if isinstance(given, str) else "a world that is given"
            raise InputError(f"{name} {beside} has no effect on {what}")
    if isinstance(given, World):
        return given
    world = _world_of_text(given, tried_kind(kind), seed, holes)
    tried_kind(kind_of(world.lighthouse))  # the text may name another one
    return world


def _world_of_text(text: str, kind: LighthouseKind, seed: int | None, holes: str | None) -> World:
    if text.startswith("@"):
        file, _, name = text[1:].partition(":")
        if Path(text[1:]).exists():  # with colons of its own
            file, name = text[1:], ""
        entry = entry_named(file, name)
        with in_file(file):
            return entry.world(kind)
    if _is_json(text):
        return entry_of(parse_json(text)).world(kind)
    if _CODE.fullmatch(text):
        return World(map_of_code(text), kind)
    if ":" in text:
        return World(map_of_family(text, holes, seed or 0), kind)
    try:
        return World(named_map(text), kind)
    except NoSuchMap as error:
        return _world_of_corpus(text, kind, error)


def _names_family(given: str | World) -> bool:
    """Whether a WORLD (a text that means a world) names a family, and so depends on a seed."""
    if isinstance(given, World) or _is_json(given):
        return False
    return given.partition(":")[0] in _families()


_CODE = re.compile(r"[0-9.]+/[0-9.]+", re.ASCII)


def code_of(map_: CombinatorialMap, root: Dart = 0) -> str:
    """The canonical code of a map rooted at a dart, as a text ``SIGMA/ALPHA`` that means a world.

    Each of the two permutations is written as its images of 0, 1, 2, ..., with dots between the
    numbers.  Two rooted maps have the same code exactly if they are isomorphic.
    """
    return "/".join(".".join(map(str, each)) for each in rooted_code(map_.sigma, map_.alpha, root))


def map_of_code(text: str) -> CombinatorialMap:
    """The map of a text in the form of :func:`code_of`; its numbering need not be canonical.

    Raises:
        InvalidMap: naming the part that is no map.
    """
    sigma, _, alpha = text.partition("/")
    return CombinatorialMap(*([int(f"0{image}") for image in t.split(".")] for t in (sigma, alpha)))


def names_of_worlds() -> dict[str, tuple[str, ...]]:
    """The names that mean worlds, under the keys ``maps``, ``families`` and ``corpus``.

    The worlds of the corpus that are also named maps stand under ``maps`` alone.  A capital letter
    in a name stands for a number.
    """
    plain = [name for name in named_maps() if name.removesuffix("-N") not in _families()]
    return {
        "maps": tuple(name.replace("-N", ":N") for name in plain),
        "families": tuple(FORMS.split(", ")),
        "corpus": tuple(name for name in _entries() if name not in named_maps()),
    }


def _entries() -> dict[str, CorpusEntry]:
    """The entries of the corpus that are worlds, by their names."""
    return {entry.name: entry for entry in own_corpus().of_kind("world")}


def _world_of_corpus(name: str, kind: LighthouseKind, no_map: NoSuchMap) -> World:
    entries = _entries()
    if name in entries:
        return World.from_json(own_corpus().document(entries[name]), missing=kind)
    if f"{name.rpartition('-')[0]}-N" in named_maps():
        raise no_map
    to_read = f"; to read a file write {show('@' + name)}"
    known = [*named_maps(), *FORMS.split(", ")]
    is_file = Path(name).suffix == ".json"
    hint = to_read if is_file else did_you_mean(name, [*known, *entries], OTHER_WORDS)
    raise InputError(
        f"world {show(name)} is neither JSON, nor @file, nor a name that 'allworlds run --list' "
        f"tells{hint}"
    )


def _is_json(text: str) -> bool:
    return text.lstrip().startswith(("{", "["))


class WorldOptions(Request):
    """The part of a request that says more about the world, or names it by a family.

    A request names its world by a WORLD, which is a text that means a world, or by the option
    ``family``.  The other options choose what a WORLD or a family does not say: the edges to remove
    and the random choices of a family, the lighthouse, and the lighthouse's place.
    """

    family: Annotated[str | None, Option(SCOPE, "F", f"One world of a family: {FORMS}.")] = None
    holes: Annotated[str | None, HOLES] = None
    seed: Annotated[
        int | None,
        Option(
            SCOPE, "S", "Seed for families that are drawn at random [default: 0].", parse=integer_of
        ),
    ] = None
    lighthouse: Annotated[
        Converted[GivenLighthouse | None, LighthouseKind | None],
        Option(
            SCOPE, "KIND", "The lighthouse, if the world names none [default: the explorer's own]."
        ),
    ] = Converted(kind_if_any, None)
    place: Annotated[
        int | None,
        Option(
            SCOPE,
            "P",
            "The place of the lighthouse, by its number in the rows of -o FILE.csv [default: its "
            "usual one].",
            parse=integer_of,
        ),
    ] = None

    def meant(self, given: str | World | None, usual: GivenLighthouse) -> World:
        """The world that the request is about.

        Args:
            given: a world, or a text for :func:`world_named`; if None, the option ``family`` names
                the world.
            usual: the default kind of lighthouse.

        Raises:
            InputError: naming a value that is missing, or that has no effect.
        """
        kind = tried_kind(usual if self.lighthouse is None else self.lighthouse)
        if given is None:
            if self.family is None:
                raise InputError("there is neither a world nor a family")
            world = World(map_of_family(self.family, self.holes, self.seed or 0), kind)
        else:
            # Scripts may give a seed in every run.
            seed = self.seed if isinstance(given, str) and _names_family(given) else None
            world = world_named(given, kind, seed, self.holes)
            lighthouse = self.lighthouse if isinstance(given, World) else None
            for name, value in (("family", self.family), ("lighthouse", lighthouse)):
                if value is not None:
                    raise InputError(f"{name} {value} has no effect on a world that is given")
        return world if self.place is None else at_place(world, self.place)


def map_of_family(text: str, holes: str | None, seed: int) -> CombinatorialMap:
    """The map of a family's member such as ``lattice:5x6``, or a named map such as ``wheel:4``.

    Args:
        text: the name of the member or of the map.
        holes: the share of the edges that are removed at random, as a text such as ``10%`` or
            ``0.1``; None removes none.
        seed: the seed of all random choices.

    Raises:
        InputError: naming a text that is no family, or holes that are illegal for this family.
    """
    kind, _, number = text.partition(":")
    names = {name.removesuffix("-N") for name in named_maps() if name.endswith("-N")}
    if holes is None and kind in names - _families():
        return named_map(f"{kind}-{number}")
    if kind not in names | _families():
        known = [*FORMS.split(", "), *sorted(f"{name}:N" for name in names - _families())]
        raise not_one_of("family", text, known, also=OTHER_WORDS)
    return family(text, holes=0.0 if holes is None else _fraction(holes), seed=seed)


def _families() -> set[str]:
    """The names of the families."""
    return {form.partition(":")[0] for form in FORMS.split(", ")}


def _fraction(text: str) -> float:
    """The number that ``10%`` or ``0.1`` means; raise InputError unless it is from 0 to below 1."""
    match = re.fullmatch(r"([0-9]+(?:\.[0-9]+)?)(%?)", text)
    value = float(match[1]) / (100 if match[2] else 1) if match else -1.0
    if not 0 <= value < 1:
        raise InputError(f"holes {show(text)} is no share of the edges; 0% up to 99% are legal")
    return value
