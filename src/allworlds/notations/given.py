"""Worlds that users give instead of a class, and the options of requests that give them.

The worlds come from files, are the embeddings of a graph, or are values in Python.
"""

import re
from array import array
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cached_property, lru_cache
from itertools import chain
from pathlib import Path
from typing import Annotated, Any, TypeAlias

from msgspec import Struct
from typing_extensions import override

from allworlds.documents.document import IfAny, Text, about, replace
from allworlds.inputs.checks import InputError, a_path, existing_file, not_one_of, show
from allworlds.inputs.requests import RARE_SCOPE, SCOPE, Converted, Option, Request
from allworlds.maps.build import named_map
from allworlds.maps.combinatorial import (
    CombinatorialMap,
    Dart,
    inverse,
    numbering,
)
from allworlds.maps.networks import embeddings, to_networkx
from allworlds.notations.entry import at
from allworlds.notations.table import Order, YAxis, entries, entry_at, graph_in
from allworlds.protocol.user_code import digest_of_file, recorded
from allworlds.words import listed, plural
from allworlds.world.labels import PLAIN, Labelling
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.kinds import LighthouseKind, kind_of, lighthouse_from_json
from allworlds.world.lighthouses.options import InvalidWorld
from allworlds.world.world import Entry, World

PIECE = 50
"""The number of given maps that a worker gets at a time."""

MapWithPlaces: TypeAlias = tuple[CombinatorialMap, list[tuple[int, Lighthouse]]]
"""A map rooted at dart 0, and the places of its lighthouse that are tried, with their numbers."""


class GivenMap(Struct, frozen=True):
    """A map that a user gives, perhaps with the start or the lighthouse.

    Attributes:
        map: the map, with any numbering of its darts.
        starts: the darts that the robot may face at the start.
        lighthouse: the lighthouse at its only place; None if every place is tried.
        labels: the user's names of the world and its vertices, and their positions.
    """

    map: CombinatorialMap
    starts: Sequence[Dart]
    lighthouse: Lighthouse | None = None
    labels: Labelling = PLAIN

    def placed(self, kind: type[Lighthouse]) -> Iterator[MapWithPlaces]:
        """Yield for each start the map, renumbered canonically from this start, and the places.

        The places are those of a lighthouse of the kind ``kind`` that are tried: the only place of
        the given lighthouse, or else every place.
        """
        for start in self.starts:
            names = inverse(numbering(self.map.sigma, self.map.alpha, start))
            rooted = self.map.relabelled(names)
            if self.lighthouse is None:
                yield rooted, [*enumerate(kind.places(rooted, 0))]
            else:
                placed = self.lighthouse.relabelled(names)
                yield rooted, [(placed.number(rooted, 0), placed)]


class Digest(Struct, frozen=True):
    """The name of a file of worlds (``plain``), and the SHA-256 of its content (``record``)."""

    plain: str
    record: str


class GivenMaps:
    """Maps that are given one by one, instead of all maps of a class.

    A copy of this object in another process has no maps; there, each unit of work brings the maps
    of the unit.

    Args:
        noun: the noun for a single map, for messages.
        of: words about the origin of the maps; empty for worlds that were made in this process.
        gate: the reason why no independent count of the maps exists, with which the count gate
            could compare their number; such as ``the maps come from a file``.
        found: for each map three things: its name for error messages, its key (the number of the
            file, the offset in the file, and the number of the map), and the map.
        find: the function that returns the map with a key.
        codes: the digests of the files of the maps; empty for maps that are not from files.

    Attributes:
        count: the number of the maps.
        words: the number and the origin of the maps, such as ``3 maps of plan.json``.
        starts: a mapping from each number of edges, ascending, to the number of starts of all maps
            with so many edges.
        lighthouse: the kind of lighthouse that the given worlds have; None if they have none.
        fixed: whether each map comes with a single start and a single place of its lighthouse.

    Raises:
        InputError: if there are no maps, or lighthouses of two kinds.
    """

    def __init__(
        self,
        noun: str,
        of: str,
        gate: str,
        found: Iterable[tuple[str, tuple[int, int, int], GivenMap]],
        find: Callable[[int, int, int], GivenMap],
        codes: tuple[Digest, ...] = (),
    ) -> None:
        self.of, self.gate, self.codes = of, f"absent, as {gate}: no count to compare with", codes
        self.count, self.fixed, self._find = 0, True, find
        kinds = dict[LighthouseKind, str]()
        self._at: dict[int, array[int]] = defaultdict(lambda: array("Q"))
        for name, key, given in found:
            self.count += 1
            self._at[given.map.edge_count].extend((*key, len(given.starts)))
            self.fixed &= len(given.starts) == 1 and given.lighthouse is not None
            if given.lighthouse:
                kinds.setdefault(kind_of(given.lighthouse), name)
        if len(kinds) > 1:
            one, other, *_ = (f"{name} has {show(str(kind))}" for kind, name in kinds.items())
            raise InputError(f"{one}, and {other}; legal is one lighthouse for all")
        self.lighthouse = next(iter(kinds), None)
        if not self.count:
            empty = f"there is no {noun} of {of}" if of else "worlds = [] is empty"
            raise InputError(f"{empty}; legal is one world or more")
        self.words = f"{plural(self.count, noun)}{of and f' of {of}'}"
        self.starts: Mapping[int, int] = {m: sum(self._at[m][3::4]) for m in sorted(self._at)}

    def __getstate__(self) -> dict[str, Any]:
        return {**vars(self), "_at": None, "_find": None}

    @property
    def described(self) -> dict[str, Any]:
        """The part of the scope of a verdict that describes the given maps: keys with their values.

        The value of ``sha256`` is a mapping from the name of each file to its digest, or None
        without files.  The value of ``given`` is the number of the maps.  For worlds that were made
        in this process, there is also the key ``worlds`` with an empty value: in the scope it
        replaces the worlds themselves, which JSON cannot hold.
        """
        digests = {code.plain: code.record for code in self.codes}
        named = {} if self.of else {"worlds": ()}
        return {"sha256": digests or None, "given": self.count, **named}

    def weights(self, edges: int) -> list[int]:
        """For each piece of the level with ``edges`` edges the number of rooted maps in the piece.

        The maps with ``edges`` edges are divided into pieces of :data:`PIECE` maps; the last piece
        may have fewer.  A map counts once for each of its starts.
        """
        starts = self._at[edges][3::4]
        return [sum(starts[i : i + PIECE]) for i in range(0, len(starts), PIECE)]

    def piece(self, edges: int, number: int) -> tuple[GivenMap, ...]:
        """The maps in the piece with the number ``number``, from 0 on; all have ``edges`` edges."""
        keys = self._at[edges][4 * PIECE * number : 4 * PIECE * (number + 1)]
        return tuple(map(self._find, keys[::4], keys[1::4], keys[2::4]))

    def like(self, world: World) -> Iterator[World]:
        """Yield the given worlds that equal ``world`` up to the numbering of darts.

        Each result has the numbering of darts and the labels with which it was given; if it was
        given without a lighthouse, it gets the lighthouse of ``world``.  The results come in the
        order in which they were given.
        """
        order = numbering(world.map.sigma, world.map.alpha, world.start)
        edges = world.map.edge_count
        pieces = (self.piece(edges, i) for i in range(len(self.weights(edges))))
        for given in chain.from_iterable(pieces):
            for start in given.starts:
                own = numbering(given.map.sigma, given.map.alpha, start)
                again = world.relabelled([own[i] for i in inverse(order)])
                if again.map == given.map and given.lighthouse in (None, again.lighthouse):
                    yield World(given.map, again.lighthouse, start, labels=given.labels)


def held(
    noun: str, of: str, gate: str, maps: Sequence[GivenMap], codes: tuple[Digest, ...] = ()
) -> GivenMaps:
    """The :class:`GivenMaps` of the maps ``maps``, which are kept in memory.

    ``noun``, ``of``, ``gate`` and ``codes`` are the arguments of :class:`GivenMaps`.
    """
    found = ((f"worlds[{i}]", (0, i, i), each) for i, each in enumerate(maps))
    return GivenMaps(noun, of, gate, found, lambda _file, _offset, number: maps[number], codes)


def files_of(*names: str) -> tuple[Digest, ...]:
    """The digests of the files with the names ``names``; a file that is named twice has one digest.

    A merge, for example, happens inside a context of
    :func:`~allworlds.protocol.user_code.as_recorded`, which holds the digests that the files had
    when the shards ran.  In such a context each file must still have its recorded digest.

    Raises:
        InputError: if a file cannot be read, or has another digest than the recorded one.
    """
    found = list[Digest]()
    for name in dict.fromkeys(names):
        digest = digest_of_file(a_path("worlds", name))
        if recorded(name) not in (None, digest):
            raise InputError(f"worlds {show(name)} has another text now than the one recorded")
        found.append(Digest(name, digest))
    return tuple(found)


@lru_cache(maxsize=4)
def worlds_of_files(codes: tuple[Digest, ...], order: Order | None, y: YAxis | None) -> GivenMaps:
    """All worlds of the files ``codes``.

    The worlds are not kept in memory: each world is read now, and again when it is needed.
    ``order`` and ``y`` are the options of :class:`FileOptions`, which explains them.

    Raises:
        InputError: naming the file, the world in it, and what would be legal.
    """

    def found() -> Iterator[tuple[str, tuple[int, int, int], GivenMap]]:
        for file, code in enumerate(codes):
            for number, (offset, entry) in enumerate(entries(code.plain, order, y), 1):
                name = f"{entry.labels.name or f'world {number}'} of {code.plain}"
                yield name, (file, offset, number), _given(entry, name)

    def entry_of(file: int, offset: int, number: int) -> GivenMap:
        name = codes[file].plain
        entry = entry_at(name, offset, order, y)
        called = entry.labels.name or f"{number} of {name}"
        return replace(_given(entry, called), labels=replace(entry.labels, name=called))

    of = listed([code.plain for code in codes])
    return GivenMaps("map", of, "the maps come from a file", found(), entry_of, codes)


@lru_cache(maxsize=4)
def embeddings_of(
    graph: str, codes: tuple[Digest, ...], which: str, order: Order | None, y: YAxis | None
) -> GivenMaps:
    """All embeddings, up to isomorphism, of a graph; or only those of one genus.

    Args:
        graph: the name of the graph, or of a file that holds the graph.
        codes: the digest of the file; empty for the name of a graph.
        which: ``all``, or ``genus:G`` for the embeddings of genus G.
        order: the option of :class:`FileOptions`, for the file.
        y: the option of :class:`FileOptions`, for the file.

    Raises:
        InputError: naming an illegal graph, or an illegal ``which``; or if no embedding has the
            genus G.
    """
    of_genus = re.fullmatch(r"genus:([0-9]{1,5})", which)
    if which != "all" and not of_genus:
        raise not_one_of("embeddings", which, ("all", "genus:G"), ", as in genus:1")
    edges, labels = graph_in(graph, order, y) if codes else (to_networkx(named_map(graph)), PLAIN)
    genus = int(of_genus[1]) if of_genus else None
    every = embeddings(edges, genus=genus)
    maps = [GivenMap(map_, map_.darts, labels=labels) for map_ in every]
    of = graph if genus is None else f"{graph} of genus {genus}"
    return held("embedding", of, "the maps are embeddings of a graph", maps, codes)


def _given(entry: Entry, name: str) -> GivenMap:
    """The map of an entry of a file, with the lighthouse and the starts of the entry.

    If the entry has no start, the starts are all darts for which the entry's lighthouse is legal;
    if the entry has no lighthouse either, all darts.  ``name`` is for error messages.
    """
    map_, placed = entry.map, None
    starts: Sequence[Dart] = map_.darts if entry.start is None else (entry.start,)
    if entry.lighthouse is not None:
        with at(name):
            placed = lighthouse_from_json(entry.lighthouse, map_, starts[0])
            held = list[Dart]()
            for start in starts:
                with suppress(InvalidWorld):
                    placed.check(map_, start)
                    held.append(start)
            starts = held or starts
            placed.check(map_, starts[0])
    return GivenMap(map_, starts, placed, entry.labels)


# ---------------------------------------------------------------- options


def _worlds(given: object) -> tuple[Any, ...] | None:
    """The names of files, or the worlds, in ``given``, as a tuple; None if ``given`` is None.

    ``given`` may be a single name, several names, or several objects :class:`World`; a name is a
    text or a Path.

    Raises:
        InputError: for any other value, also if names and worlds are mixed.
    """
    if given is None:
        return None
    every = [given] if isinstance(given, str | Path) else given
    if not isinstance(every, Iterable):
        raise InputError(f"worlds = {show(given)} is no series of worlds")
    every = [*every]
    made = any(isinstance(world, World) for world in every)
    for number, world in enumerate(every):
        if not isinstance(world, World if made else str | Path):
            raise InputError(f"worlds[{number}] = {show(world)} is no World")
    return tuple(every if made else map(str, every))


def _said(meaning: str) -> Any:
    note = about(f"{meaning}; left out: it was not said")
    return Annotated[IfAny[Text | None], note]  # type: ignore[misc]  # a value here


class FileOptions(Request):
    """The part of a request that says how files of worlds are to be read.

    ``order``: whether a file that lists the edges round a vertex lists them clockwise or
    anticlockwise; None is clockwise.  ``y``: whether the second coordinate of positions in a file
    grows upward or downward; None is as usual in the notation of the file.
    """

    order: Annotated[
        Order | None,
        Option(
            RARE_SCOPE,
            "clockwise|anticlockwise",
            "How files list the edges round a vertex [default: clockwise].",
            document_type=_said("how files list the edges round a vertex"),
        ),
    ] = None
    y: Annotated[
        YAxis | None,
        Option(
            RARE_SCOPE,
            "up|down",
            "Where the y of positions in files grows [default: as in their notation].",
            document_type=_said("where the y of positions in files grows"),
        ),
    ] = None


class GivenOptions(FileOptions):
    """The part of a request that gives worlds instead of a class."""

    worlds: Annotated[
        Converted[Any, tuple[Any, ...] | None],
        Option(
            SCOPE,
            "FILE",
            "Every world of a file in place of a class, from every start, with every place of the "
            "lighthouse, unless the file fixes them. Of several files: repeat the option.",
            repeated=True,
            document_type=Annotated[
                IfAny[tuple[Text, ...] | None], about("the files of the worlds, if there are any")
            ],
        ),
    ] = Converted(_worlds, None)
    graph: Annotated[
        str | None,
        Option(
            RARE_SCOPE,
            "FILE|NAME",
            "Every embedding of a graph in place of a class, each once up to isomorphism: of k4, "
            "k33, k5, petersen, of another map with a name, or of the edges in a file, as .g6.",
            document_type=_said("the graph of which every embedding is tried"),
        ),
    ] = None
    embeddings: Annotated[
        str | None,
        Option(
            RARE_SCOPE,
            "all|genus:G",
            "Which embeddings of the graph [default: all].",
            document_type=_said("which of them"),
        ),
    ] = None

    @cached_property
    def given(self) -> GivenMaps | None:
        """The given worlds; None if the request asks for the worlds of a class.

        Raises:
            InputError: naming the file and the world in it that is illegal, or the illegal option.
        """
        order, y, graph, which = self.order, self.y, self.graph, self.embeddings
        if graph is not None and self.worlds is not None:
            raise InputError(f"graph = {show(graph)} cannot be given together with worlds")
        files = graph or (self.worlds and not isinstance(self.worlds[0], World))
        for name, beside, needed, what in (
            ("order", order, files, "worlds of a file"),
            ("y", y, files, "worlds of a file"),
            ("embeddings", which, graph, "a graph"),
        ):
            if beside is not None and not needed:
                raise InputError(f"{name} = {show(beside)} has no effect without {what}")
        if graph is not None:
            codes = files_of(graph) if existing_file("graph", graph) else ()
            return embeddings_of(graph, codes, which or "all", order, y)
        if files and self.worlds:
            return worlds_of_files(files_of(*self.worlds), order, y)
        if self.worlds is not None and getattr(self, "run", None) is not None:
            raise InputError(
                "run keeps no worlds that live in this process alone; write them into a file, and "
                "name that"
            )
        if self.worlds is None:
            return None
        made = [GivenMap(it.map, (it.start,), it.lighthouse, it.labels) for it in self.worlds]
        return held("given world", "", "the worlds are given", made)

    @property
    @override
    def in_effect(self) -> dict[str, Any]:
        return {**super().in_effect, **(self.given.described if self.given else {})}

    def lighthouse_of_given(self, named: Any) -> Any:
        """The kind of lighthouse that the given worlds have; if they have none, the kind ``named``.

        ``named`` is the kind that the request names, or None.

        Raises:
            InputError: if the worlds have a lighthouse of another kind than ``named``.
        """
        fixed = self.given and self.given.lighthouse
        if named and fixed and named != fixed:
            words = f"{self.given.words} have {show(str(fixed))}"  # type: ignore[union-attr]
            raise InputError(f"lighthouse = {show(str(named))}, but {words}")
        return fixed or named
