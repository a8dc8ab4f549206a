"""Maps: the mathematics on which everything else is built.

Glossary
--------
dart
    Half of an edge: one of the integers ``0..2m-1``.  A robot stands *at* a dart if it
    faces the dart, or has arrived by it.
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
    A map with one distinguished dart, the root.  An automorphism that fixes a dart is the
    identity, so the identity is the only automorphism of a rooted map.
canonical code
    For a rooted map: its ``(sigma, alpha)`` after renumbering the darts breadth-first from
    the root (see :mod:`allworlds.maps.combinatorial`).  For a map: the least code among the
    codes of its rootings.
class
    A set of maps: a member of :class:`allworlds.maps.classes.MapClass`.

Modules
-------
``combinatorial``
    the map itself; codes, automorphisms and isomorphisms;
``mixture``
    the distributions of random maps, for samples beyond the exhaustive bound;
``classes``
    **the** tables of the classes of maps, and of the conditions that narrow them;
``enumeration``, ``counting``
    all maps of a class, glued together; the number of these maps, computed without making a map;
``count_source``
    the numbers and fingerprints with which the enumerated maps of an extent (a class of bounded
    size, under a condition) are compared; the number of maps that an unfinished map can become;
``build``, ``families``
    maps made by hand and by name, and small changes to a map; large maps that a text and a seed
    determine;
``networks``
    maps to networkx and back, and every embedding of a graph;
``quotient``
    the classes of indistinguishable darts, the quotient of a map by these classes, and the number
    of worlds that share a quotient.

Code of this package that must be fast takes maps as bare pairs of tuples or lists; all other code
takes a :class:`CombinatorialMap`.

``dir(allworlds.maps)`` lists the names for users' programs.  All other names are for this program;
a few of these names are only for its tests.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.maps.build import (
        contracted as contracted,
        deleted as deleted,
        from_cycles as from_cycles,
        from_rotation as from_rotation,
        moved as moved,
        named_map as named_map,
        named_maps as named_maps,
    )
    from allworlds.maps.classes import MapClass as MapClass, girth as girth
    from allworlds.maps.combinatorial import (
        CombinatorialMap as CombinatorialMap,
        InvalidMap as InvalidMap,
        automorphisms as automorphisms,
        distances as distances,
        isomorphism as isomorphism,
        rooted_code as rooted_code,
        rooted_isomorphism as rooted_isomorphism,
        unrooted_code as unrooted_code,
    )
    from allworlds.maps.enumeration import rooted_maps as rooted_maps
    from allworlds.maps.families import (
        CorridorShape as CorridorShape,
        family as family,
        random_map as random_map,
        usual_degree as usual_degree,
    )
    from allworlds.maps.networks import (
        embeddings as embeddings,
        from_faces as from_faces,
        from_networkx as from_networkx,
        from_positions as from_positions,
        to_networkx as to_networkx,
    )
    from allworlds.maps.quotient import (
        Quotient as Quotient,
        class_size as class_size,
        is_ambiguous as is_ambiguous,
        project as project,
    )
else:
    open_door(__name__)
