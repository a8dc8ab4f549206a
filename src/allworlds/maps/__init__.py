"""Maps: the mathematics everything else stands on.

Glossary
--------
dart
    Half of an edge: one of the integers ``0..2m-1``.  A robot stands *at* a dart:
    it faces it, or has come in by it.
sigma
    Permutation of the darts: the next dart **clockwise** round the same vertex.
alpha
    Involution without fixed points: the other dart of the same edge.
map
    The pair ``(sigma, alpha)``, connected.  Also called rotation system, combinatorial
    map or embedded graph.  Loops and parallel edges are allowed.
vertex, edge, face
    A cycle of sigma, of alpha, of ``phi = sigma . alpha`` (first alpha, then sigma).
degree
    The number of darts of a vertex.  A loop counts twice.
genus
    ``g`` in Euler's formula ``n - m + f = 2 - 2g``.
same map
    There is a bijection of darts that commutes with sigma and alpha.  It preserves
    orientation: a mirror image is in general another map.  This is the *extended
    isomorphism* of the paper (Section V).
rooted map
    A map with one distinguished dart, the root.  Only the identity fixes a dart, so a
    rooted map has no automorphism but the identity.
canonical code
    Of a rooted map: its ``(sigma, alpha)`` after renumbering the darts breadth-first from
    the root (see :mod:`allworlds.maps.canonical`).  Of a map: the least code of its
    rootings.
class
    Which maps are meant: one of :class:`allworlds.maps.classes.MapClass`.

Modules
-------
``combinatorial``, ``canonical``
    the map itself; codes, automorphisms and isomorphisms;
``classes``
    **the** table of the classes of maps;
``enumeration``, ``bruteforce``, ``counting``
    every map of a class: glued together, by all permutations, and counted without making one;
``completions``
    how many maps a partial gluing can become;
``build``, ``families``, ``large``
    maps by hand and by name, and large ones by a text and a seed;
``surgery``, ``networks``
    small changes to a map; to networkx and back;
``refinement``, ``quotient``, ``criterion``
    which darts nothing tells apart, these taken together, and how many worlds share that.

Inside this package a map in a hot place is a bare pair of tuples or lists; everywhere
else it is a :class:`CombinatorialMap`.

The names below are for programs of one's own, too: some of them, such as ``dual`` of a map,
:func:`from_planar_embedding` and :func:`rooted_isomorphism`, this package itself uses nowhere
but in its tests.
"""

from allworlds.maps.build import (
    cycle,
    dense,
    from_cycles,
    from_rotation,
    lattice,
    named_map,
    named_maps,
)
from allworlds.maps.canonical import (
    Code,
    Mismatch,
    automorphisms,
    isomorphism,
    rooted_code,
    rooted_isomorphism,
    unrooted_code,
)
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.maps.networks import from_planar_embedding, to_networkx

__all__ = [
    "Code",
    "CombinatorialMap",
    "InvalidMap",
    "Mismatch",
    "automorphisms",
    "cycle",
    "dense",
    "from_cycles",
    "from_planar_embedding",
    "from_rotation",
    "isomorphism",
    "lattice",
    "named_map",
    "named_maps",
    "rooted_code",
    "rooted_isomorphism",
    "to_networkx",
    "unrooted_code",
]
