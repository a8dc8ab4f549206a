"""Worlds as objects of JSON, or of Python's literals: sigma and alpha, rotations, fat graphs.

========================================  ========================================================
``{"sigma": [...], "alpha": [...]}``      our own; also ``start``, ``lighthouse``, ``name``,
                                          ``names`` and ``positions`` of the vertices
``{"hall": ["a", ["b", 0], ...], ...}``   a rotation: the neighbours of each vertex; an edge that
                                          is one of several has a key, at both its ends
``{"vertices": [[0, 1], ...], "edges":``  a fat graph: cycles of darts, also as ``"(0,1)(2,3)"``;
``..., "faces": ...}``                    two of the three; also as ``vp``, ``ep`` and ``fp``
========================================  ========================================================

In a face a dart is followed by the one before its other half in the order round the vertex, as in
``FatGraph`` of the package surface_dynamics for Sage, whose vertices are anticlockwise.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Hashable, Iterable, Mapping, Sequence
from math import isfinite
from typing import Any

from allworlds.inputs.checks import InputError, a_text, an_integer, show
from allworlds.maps.build import from_rotation
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap, cycles, inverse
from allworlds.notations.entry import Entry
from allworlds.world.labels import Labels, Position

OWN = ("sigma", "alpha", "start", "lighthouse", "name", "names", "positions")
CYCLES = {"vp": "vertices", "ep": "edges", "fp": "faces"}
"""Other names of the keys of a fat graph."""

LEGAL = "an object with sigma and alpha, a rotation, or cycles of vertices and edges"


def entry_of(given: object, name: str = "") -> Entry:
    """The world of an object; ``name`` is that of the world in its file.

    Raises:
        InputError: naming the key, the vertex or the dart.
    """
    if not isinstance(given, Mapping) or not given:
        raise InputError(f"{show(given)} is no world, which is {LEGAL}")
    if {"sigma", "alpha"} & given.keys():
        return _own(given, name)
    if given.keys() & {"findings", "finding", "law"} and given.keys() & {"schema", "version"}:
        raise InputError("this is a report or a finding, not a world; see replay and explain")
    fat = {CYCLES.get(key, key): value for key, value in given.items()}
    if 1 < len(fat) == len(given) and fat.keys() <= {*CYCLES.values()}:
        return Entry(_fat(fat), Labels(name))
    return entry_of_rotation(given, name)


def _own(given: Mapping[str, Any], name: str) -> Entry:
    for key in given:
        if key not in OWN:
            raise InputError(f"a world has no {show(key)}; legal are {', '.join(OWN)}")
    if given.get("lighthouse", "") is None:
        raise InputError("lighthouse = None is no object; without one any may stand there")
    map_ = CombinatorialMap.from_json(given)
    start = given.get("start")
    if start is not None and an_integer("start", start) not in map_.darts:
        raise InputError(f"start = {show(start)} is no dart; darts are 0..{len(map_.sigma) - 1}")
    names = _each("names", given.get("names", ()), map_)
    positions = _each("positions", given.get("positions", ()), map_)
    labels = Labels(
        a_text("name", given.get("name", name)),
        distinct(a_text("a name", each) for each in names),
        tuple(position(f"v{v}", each) for v, each in enumerate(positions)),
    )
    return Entry(map_, labels, start, given.get("lighthouse"))


def _each(key: str, given: Any, map_: CombinatorialMap) -> Sequence[Any]:
    """The list of what each vertex has; an empty one stands for none."""
    if not isinstance(given, list | tuple) or len(given) not in (0, map_.vertex_count):
        raise InputError(f"{key} = {show(given)} is no list of {map_.vertex_count}, one a vertex")
    return given


def distinct(names: Iterable[str], of: str = "vertices") -> tuple[str, ...]:
    """The names of vertices, or of something else.

    Raises:
        InputError: if one is empty, or two have it.
    """
    found = tuple(names)
    for name, count in Counter(found).items():
        if not name or count > 1:
            raise InputError(f"{count} {of} are called {show(name)}; each has its own name")
    return found


def position(name: str, given: Any) -> Position:
    """The two coordinates of a vertex.

    Raises:
        InputError: naming the vertex, for what is no pair of finite numbers.
    """
    try:
        x, y = map(float, given)
    except (TypeError, ValueError, OverflowError):
        x = y = float("nan")
    if not isfinite(x) or not isfinite(y):
        raise InputError(f"vertex {show(name)} is at {show(given)}, which is no pair of numbers")
    return x, y


def entry_of_rotation(given: Mapping[Any, Any], name: str = "") -> Entry:
    """The world of a rotation, whose vertices keep their names.

    Raises:
        InputError: naming the vertex.
    """
    names = distinct(map(str, given))
    rotation = {v: _ends(v, ends) for v, ends in zip(names, given.values(), strict=True)}
    return Entry(from_rotation(rotation), Labels(name, names))


def _ends(vertex: str, given: object) -> list[Any]:
    if not isinstance(given, list | tuple) or not given:
        rule = "each vertex has one edge at least"
        raise InvalidMap(f"vertex {show(vertex)} lists {show(given)}; legal is a list, {rule}")
    return [
        [*map(str, end)] if isinstance(end, list) else str(end)
        for end in given
    ]


def rotation_of(entry: Entry) -> dict[str, list[str | list[str | int]]]:
    """The rotation of a world, by names; edges that are parallel, and loops, have keys."""
    map_, at = entry.map, entry.map.vertex_of
    ends = {d: (min(at[d], at[e]), max(at[d], at[e])) for d, e in enumerate(map_.alpha)}
    seen, keys = Counter[tuple[int, int]](), dict[int, int]()
    for d, e in map_.edges:
        keys[d] = keys[e] = seen[ends[d]]
        seen[ends[d]] += 1

    def end(dart: int) -> str | list[str | int]:
        name = entry.labels.vertex(at[map_.alpha[dart]])
        alone = seen[ends[dart]] == 1 and len({*ends[dart]}) == 2
        return name if alone else [name, keys[dart]]

    return {entry.labels.vertex(v): [*map(end, ds)] for v, ds in enumerate(map_.vertices)}


def _fat(given: Mapping[str, Any]) -> CombinatorialMap:
    """The map of two or three of the permutations; vertices clockwise."""
    told = {key: _cycles(key, value) for key, value in given.items()}
    names = list(dict.fromkeys(dart for each in told.values() for cycle in each for dart in cycle))
    number = {dart: i for i, dart in enumerate(names)}
    images = dict[str, list[int]]()
    for key, found in told.items():
        times = Counter(dart for cycle in found for dart in cycle)
        for dart in names:
            if times[dart] != 1:
                raise InvalidMap(f"dart {show(dart)} stands {times[dart]} times in {key}, not once")
        image = {a: b for cycle in found for a, b in zip(cycle, cycle[1:] + cycle[:1], strict=True)}
        images[key] = [number[image[dart]] for dart in names]
    sigma, alpha, phi = map(images.get, ("vertices", "edges", "faces"))
    if alpha is None:
        alpha = [images["vertices"][d] for d in images["faces"]]
    if sigma is None:
        sigma = [alpha[d] for d in inverse(images["faces"])]
    map_, back = CombinatorialMap(sigma, alpha), inverse(sigma)
    for dart, told_next in enumerate(phi or ()):
        if (right := back[alpha[dart]]) != told_next:
            wrong = f"{show(names[dart])} is followed by {show(names[told_next])}"
            raise InvalidMap(f"in faces {wrong}; after vertices and edges by {show(names[right])}")
    return map_


def _cycles(key: str, given: object) -> list[list[Hashable]]:
    """The cycles of a permutation, of lists or of a text."""
    if isinstance(given, str) and re.fullmatch(r"(\(\d+(, ?\d+)*\) ?)+", given):
        return [[*map(int, each.split(","))] for each in re.findall(r"\(([^)]*)", given)]
    good = isinstance(given, list | tuple) and all(
        isinstance(cycle, list | tuple)
        and all(isinstance(dart, int | str) for dart in cycle)
        and cycle
        for cycle in given
    )
    if not good:
        raise InputError(f"{key} = {show(given)} is no list of cycles such as [[0, 1], [2]]")
    return [[*cycle] for cycle in given]  # type: ignore[attr-defined]  # it is a list of lists


def fat_of(entry: Entry) -> dict[str, list[list[int]]]:
    """The fat graph of a world."""
    map_ = entry.map
    faces = map_.mirrored().faces
    parts = {"vertices": map_.vertices, "edges": cycles(map_.alpha), "faces": faces}
    return {key: [[*cycle] for cycle in found] for key, found in parts.items()}


def own_of(entry: Entry) -> dict[str, Any]:
    """The object of a world in our notation."""
    labels = entry.labels
    told = {
        "name": labels.name,
        "sigma": [*entry.map.sigma],
        "alpha": [*entry.map.alpha],
        "start": entry.start,
        "lighthouse": entry.lighthouse,
        "names": [*labels.vertices],
        "positions": [*map(list, labels.positions)],
    }
    return {key: value for key, value in told.items() if value not in ("", None, [])}
