"""Worlds as JSON objects or Python literals: sigma and alpha, rotations, fat graphs.

========================================  ========================================================
``{"sigma": [...], "alpha": [...]}``      the notation of this program; it may also have the keys
                                          ``start``, ``lighthouse``, ``name``, and ``names`` and
                                          ``positions`` of the vertices
``{"hall": ["a", ["b", 0], ...], ...}``   a rotation: the neighbours of each vertex; parallel edges
                                          have keys, which stand at both ends
``{"vertices": [[0, 1], ...], "edges":``  a fat graph: for each vertex, edge and face the cycle of
``..., "faces": ...}``                    its darts; two of the three keys suffice
========================================  ========================================================

The darts or neighbours of a vertex are clockwise; if a file has them anticlockwise, the user must
give the option ``--order anticlockwise``.

In a face of a fat graph, the dart after d must be the dart that the file lists just *before*
alpha(d) in the cycle of a vertex; this holds with and without the option.  (In a face of the
glossary, the dart after d is the dart that comes *after* alpha(d), clockwise.)  A ``FatGraph`` of
the package surface_dynamics for Sage has such faces; but its vertices are anticlockwise, so it
needs the option.
"""

from collections import Counter
from collections.abc import Mapping
from typing import Any

from allworlds.documents.reading import parse
from allworlds.inputs.checks import InputError, show
from allworlds.maps.build import from_rotation
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap, cycles, inverse
from allworlds.maps.networks import permutation
from allworlds.notations.entry import at
from allworlds.world.labels import Labelling
from allworlds.world.lighthouses.options import InvalidWorld
from allworlds.world.world import Entry, WorldDocument

FAT = {"vertices", "edges", "faces"}
"""The keys of a fat graph, which has at least two of them."""


def entry_of(given: object, name: str = "") -> Entry:
    """The world of a JSON object or Python dictionary in one of the forms of this module.

    ``name`` is the world's name, unless an object with ``sigma`` has a key ``name``.

    Raises:
        InputError: if ``given`` is no world; the message names the wrong key, vertex or dart.
    """
    if not isinstance(given, Mapping) or not given:
        raise InvalidWorld(
            "a world is an object with 'sigma' and 'alpha', a rotation, or cycles of vertices and "
            f"edges, not {show(given)}"
        )
    if {"sigma", "alpha"} & given.keys():
        return Entry.from_json(given, name)
    rotation = all(isinstance(each, list) for each in given.values())
    if given.keys() & {"findings", "finding", "law"} and not rotation:
        raise InputError("this is a report or a finding, not a world; see replay and explain")
    if len(given) > 1 and given.keys() <= FAT:
        return Entry(_fat(given), Labelling(name))
    if all(isinstance(vertex, str) for vertex in given):  # in JSON all names are texts
        given = {v: [*map(_end, ends)] if type(ends) is list else ends for v, ends in given.items()}
    return Entry(from_rotation(given), Labelling(name, tuple(map(str, given))))


def _end(given: Any) -> Any:
    return [str(given[0]), *given[1:]] if type(given) is list and given else str(given)


def rotation_of(entry: Entry) -> dict[str, list[str | list[str | int]]]:
    """The rotation of a world: by the name of each vertex its neighbours, see :func:`doors_of`."""
    return {entry.labels.vertex(v): ends for v, ends in enumerate(doors_of(entry))}


def doors_of(entry: Entry) -> list[list[str | list[str | int]]]:
    """For each vertex, in the order of ``map.vertices``, its neighbours, clockwise.

    A neighbour is given by its name.  If several edges join the same two vertices, or if a vertex
    has several loops, a list ``[name, key]`` replaces the name; the key is the number of the edge
    in ``map.edges``.
    """
    map_, at_ = entry.map, entry.map.vertex_of
    edge = {dart: number for number, darts in enumerate(map_.edges) for dart in darts}
    ends = [frozenset((at_[d], at_[e])) for d, e in map_.edges]
    count = Counter(ends)

    def end(dart: int) -> str | list[str | int]:
        name = entry.labels.vertex(at_[map_.alpha[dart]])
        return name if count[ends[edge[dart]]] == 1 else [name, edge[dart]]

    return [[*map(end, darts)] for darts in map_.vertices]


def _fat(given: Mapping[str, Any]) -> CombinatorialMap:
    """The map of a fat graph; ``given`` has two or three of the keys :data:`FAT`.

    The value of a key is a permutation of the darts, written as its cycles.  If there are three
    permutations, the faces must be those that follow from the vertices and edges.
    """
    images = dict[str, list[int]]()
    for key, value in given.items():
        with at(key):
            images[key] = permutation(parse(value, list[list[int]], show(value)))
    if len({*map(len, images.values())}) > 1:
        raise InvalidMap(f"{' and '.join(images)} do not have the same darts")
    sigma, alpha, phi = map(images.get, ("vertices", "edges", "faces"))
    if alpha is None:
        alpha = [images["vertices"][dart] for dart in images["faces"]]
    if sigma is None:
        sigma = [alpha[dart] for dart in inverse(images["faces"])]
    map_, back = CombinatorialMap(sigma, alpha), inverse(sigma)
    for dart, after in enumerate(phi or ()):
        if (right := back[alpha[dart]]) != after:
            rest = f"by {right}, as vertices and edges say"
            raise InvalidMap(f"in faces dart {dart} is followed by {after}; legal is {rest}")
    return map_


def fat_of(entry: Entry) -> dict[str, list[list[int]]]:
    """The fat graph of a world: the cycles of darts under each of the keys :data:`FAT`."""
    map_, faces = entry.map, entry.map.mirrored().faces
    parts = {"vertices": map_.vertices, "edges": cycles(map_.alpha), "faces": faces}
    return {key: [[*cycle] for cycle in found] for key, found in parts.items()}


def own_of(entry: Entry) -> dict[str, Any]:
    """The JSON object of a world in this program's notation; keys without a value are left out."""
    labels, map_ = entry.labels, entry.map
    fixed = map_.sigma, map_.alpha, entry.start, entry.lighthouse
    values = *fixed, labels.name, labels.vertices, labels.positions
    named = zip(WorldDocument.__struct_fields__, values, strict=True)
    return {key: value for key, value in named if value not in ("", None, ())}
