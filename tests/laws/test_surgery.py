"""The effect of deleting, contracting and moving on the counts of a map."""

import pytest
from hypothesis import assume, find, given, settings
from hypothesis.strategies import data, integers, tuples

from allworlds.maps import CombinatorialMap, contracted, deleted, moved
from allworlds.strategies import maps, planar_maps

MANY = settings(max_examples=2000)


def a_dart(drawn, map_):
    return drawn.draw(integers(0, len(map_.sigma) - 1))


def is_loop(map_, dart):
    return map_.vertex_of[dart] == map_.vertex_of[map_.alpha[dart]]


def is_leaf(map_, dart):
    return 1 in (map_.degree_at[dart], map_.degree_at[map_.alpha[dart]])


def faces_beside(map_, dart):
    """The faces on the two sides of an edge."""
    return {face for face in map_.faces if dart in face or map_.alpha[dart] in face}


def is_valid(map_):
    return CombinatorialMap(map_.sigma, map_.alpha) == map_


@given(maps(max_edges=8), data())
def test_deleting_takes_one_edge_and_the_end_of_a_leaf(map_, drawn):
    dart = a_dart(drawn, map_)
    less = deleted(map_, dart)
    assume(less is not None)
    assert is_valid(less)
    assert less.edge_count == map_.edge_count - 1
    assert less.vertex_count == map_.vertex_count - is_leaf(map_, dart)


@given(maps(max_edges=8), data())
def test_deleting_between_two_faces_joins_them_and_within_one_takes_a_handle(map_, drawn):
    dart = a_dart(drawn, map_)
    less = deleted(map_, dart)
    assume(less is not None)
    handle = len(faces_beside(map_, dart)) == 1 and not is_leaf(map_, dart)
    assert less.genus == map_.genus - handle


@given(maps(max_edges=8), data())
def test_only_a_bridge_and_the_last_edge_cannot_be_deleted(map_, drawn):
    dart = a_dart(drawn, map_)
    reached = [map_.sigma[dart], map_.sigma[map_.alpha[dart]]]
    gone = {dart, map_.alpha[dart]}
    # The darts that can be reached without the edge, from one of its ends.
    todo = [d for d in map_.vertices[map_.vertex_of[dart]] if d not in gone]
    seen = set(todo)
    for d in todo:
        for e in (map_.sigma[d], map_.alpha[d], *map_.vertices[map_.vertex_of[d]]):
            if e not in seen and e not in gone:
                seen.add(e)
                todo.append(e)
    bridge = seen and len(seen) < len(map_.sigma) - 2
    assert reached
    assert (deleted(map_, dart) is None) == (map_.edge_count == 1 or bool(bridge))


@given(maps(max_edges=8), data())
def test_contracting_takes_one_edge_and_one_vertex_and_keeps_faces_and_genus(map_, drawn):
    dart = a_dart(drawn, map_)
    less = contracted(map_, dart)
    if is_loop(map_, dart) or map_.edge_count == 1:
        assert less is None
        return
    assert is_valid(less)
    assert less.edge_count == map_.edge_count - 1
    assert less.vertex_count == map_.vertex_count - 1
    assert len(less.faces) == len(map_.faces)
    assert less.genus == map_.genus


@given(maps(max_edges=8), data())
def test_contracting_is_deleting_in_the_dual(map_, drawn):
    dart = a_dart(drawn, map_)
    less = contracted(map_, dart)
    assume(less is not None)
    assert less.dual() == deleted(map_.dual(), dart)


@given(planar_maps(max_edges=8), data())
def test_deleting_is_contracting_in_the_dual_where_both_are_maps(map_, drawn):
    dart = a_dart(drawn, map_)
    less, other = deleted(map_, dart), contracted(map_.dual(), dart)
    assume(less is not None and other is not None)
    assert less.dual() == other


def wrongly_contracted(map_, dart):
    """A contraction that joins the rotations of the two ends the wrong way round."""
    other = map_.alpha[dart]
    one = [map_.turn(dart, k) for k in range(1, map_.degree_at[dart])]
    two = [map_.turn(other, -k) for k in range(1, map_.degree_at[other])]
    names = {d: i for i, d in enumerate(d for d in map_.darts if d not in (dart, other))}
    sigma = {d: map_.sigma[d] for d in names if d not in (*one, *two)}
    merged = one + two
    sigma |= dict(zip(merged, [*merged[1:], *merged[:1]], strict=True))
    return CombinatorialMap([names[sigma[d]] for d in names], [names[map_.alpha[d]] for d in names])


def test_a_contraction_that_turns_one_end_over_would_be_noticed():
    def noticed(pair):
        map_, dart = pair
        dart %= len(map_.sigma)
        if map_.edge_count == 1 or is_loop(map_, dart):
            return False
        return wrongly_contracted(map_, dart).genus != map_.genus

    map_, _ = find(tuples(maps(), integers(0, 11)), noticed, settings=MANY)
    assert map_.edge_count == 3


@given(maps(max_edges=5))
def test_moving_a_dart_keeps_the_edges_and_at_most_loses_a_vertex(map_):
    others = list(moved(map_))
    assert all(is_valid(other) for other in others)
    assert {other.edge_count for other in others} == {map_.edge_count}
    assert {other.vertex_count for other in others} <= {map_.vertex_count, map_.vertex_count - 1}
    # A dart may also stay where it is; where every vertex is a leaf none can move.
    assert map_ in others or max(map_.degrees) == 1


@pytest.mark.parametrize("change", [deleted, contracted])
@given(map_=maps(max_edges=6), drawn=data())
def test_both_darts_of_an_edge_tell_the_same_change(change, map_, drawn):
    dart = a_dart(drawn, map_)
    assert change(map_, dart) == change(map_, map_.alpha[dart])
