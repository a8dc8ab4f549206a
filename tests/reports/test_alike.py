"""Maps drawn and named like others: what agrees lies in the same place and has the same number."""

from allworlds import worlds
from allworlds.maps import CombinatorialMap, isomorphism, named_map
from allworlds.reports.drawing.layout import (
    dart_names_like,
    extended,
    layout,
    layout_like,
    mirror_of,
    vertex_names_like,
)
from allworlds.reports.parts import Scene

MAPS = [named_map(name) for name in ("k4", "theta", "theta-torus", "wheel-4", "k4-torus")]


def renamed(map_, shift=3):
    """The map with other numbers for its darts, and for each new dart the old one."""
    size = len(map_.sigma)
    new = [(d + shift) % size for d in range(size)]
    sigma, alpha = [0] * size, [0] * size
    for d in range(size):
        sigma[new[d]], alpha[new[d]] = new[map_.sigma[d]], new[map_.alpha[d]]
    return CombinatorialMap(sigma, alpha), {new[d]: d for d in range(size)}


def test_from_one_vertex_the_whole_of_the_same_map_is_reached():
    for map_ in MAPS:
        other, old = renamed(map_)
        vertex = other.vertices[0]
        assert extended({d: old[d] for d in vertex}, other, map_) == old


def test_no_dart_is_used_twice_where_the_maps_differ():
    for a in MAPS:
        for b in MAPS:
            if a.degree_at[0] == b.degree_at[0]:
                ties = {a.turn(0, k): b.turn(0, k) for k in range(a.degree_at[0])}
                found = extended(ties, a, b)
                assert len({*found.values()}) == len(found) >= len(ties)
                for dart, other in found.items():
                    assert found[a.sigma[dart]] == b.sigma[other]


def test_the_same_map_lies_where_the_other_one_does_and_has_its_names():
    for map_ in MAPS:
        other, old = renamed(map_)
        drawn = layout(map_, 0)
        like = layout_like(old, other, 0, map_, drawn)
        assert all(like.ways[d] == drawn.ways[old[d]] for d in other.darts)
        darts = dart_names_like(old, other, len(map_.sigma))
        assert darts == [str(old[d]) for d in other.darts]
        names = vertex_names_like(old, other, Scene(map_))
        for vertex, name in zip(other.vertices, names, strict=True):
            assert name == f"v{map_.vertex_of[old[vertex[0]]]}"


def test_a_mirror_image_is_known_and_drawn_as_one():
    chiral = [w.map for w in worlds(edges=4) if is_chiral(w.map)]
    assert chiral
    for map_ in chiral[:4]:
        mirror = map_.mirrored()
        ties = mirror_of(mirror, map_)
        assert len(ties) == len(map_.sigma)
        drawn = layout(map_, 0)
        like = layout_like(ties, mirror, 0, map_, drawn)
        for d in mirror.darts:
            assert like.ways[d] == tuple(-p.conjugate() for p in drawn.ways[ties[d]])
        assert mirror_of(map_, map_) == {}


def is_chiral(map_):
    """The map is not its own mirror image."""
    return not isomorphism(map_, map_.mirrored())


def test_what_is_new_gets_numbers_that_the_other_map_does_not_have():
    small, large = named_map("edge"), named_map("theta")
    ties = {0: 0, 1: 1}
    assert {*dart_names_like(ties, large, 2)} == {"0", "1", "2", "3", "4", "5"}
    assert vertex_names_like(ties, large, Scene(small)) == ["v0", "new 1"]
    assert vertex_names_like({}, small, Scene(large)) == ["new 1", "new 2"]
    assert dart_names_like({}, small, 6) == ["6", "7"]


def test_a_map_that_agrees_in_part_is_drawn_by_itself():
    a, b = named_map("theta"), named_map("k4")
    drawn = layout(b, 0)
    assert layout_like({0: 0, 1: 1, 2: 2}, a, 0, b, drawn) == layout(a, 0)
    assert layout_like({}, a, 0, b, drawn) == layout(a, 0)


def test_edges_alone_are_no_likeness():
    """One vertex is turned as in the other map, and one as in its mirror image."""
    a, b = named_map("theta-torus"), named_map("theta")
    ties = {dart: dart for dart in a.vertices[0]}
    ties |= {a.alpha[dart]: b.alpha[dart] for dart in a.vertices[0]}
    assert len(ties) == 6
    assert layout_like(ties, a, 0, b, layout(b, 0)) == layout(a, 0)
