from functools import cache
from itertools import permutations
from math import factorial, gcd

import pytest

from allworlds.documents.document import replace
from allworlds.maps import (
    Quotient,
    class_size,
    is_ambiguous,
    named_map,
    rooted_code,
    rooted_maps,
)
from allworlds.maps.build import cycle
from allworlds.maps.combinatorial import cycles
from allworlds.maps.quotient import _uniform, pose_count
from allworlds.protocol.actions import Percept
from allworlds.studies.ambiguity import class_of, projection_of
from allworlds.studies.ambiguity.members import (
    least_rooting,
    lifts,
    uniform_permutations,
)
from allworlds.world import Position, World
from small import is_least_rooting


@cache
def quotient_of(map_):
    return projection_of(World(map_, Position(0))).quotient


@cache
def marked_maps(edges):
    return [map_ for map_ in rooted_maps(edges) if is_least_rooting(map_)]


WRONG = {
    "no exception": lambda q: q.sheets >= 2,
    "every beta1 = 0 is rigid": lambda q: q.sheets >= 2 and bool(q.beta1),
    "k = 2 is always rigid": lambda q: q.sheets > 2 and is_ambiguous(q),
    "k = 2 is never rigid": lambda q: q.sheets == 2 or is_ambiguous(q),
    "semi-edges do not matter": lambda q: (
        q.sheets >= 2
        and not (q.beta1 == 0 and (q.sheets == 2 or all(b == 1 for b in q.cone_indices[1:])))
    ),
    "cone indices do not matter": lambda q: (
        q.sheets >= 2 and not (q.beta1 == 0 and (q.sheets == 2 or not q.semi_edges))
    ),
}


@pytest.mark.parametrize("wrong", WRONG.values(), ids=WRONG)
def test_a_criterion_with_one_condition_changed_is_wrong_for_some_small_map(wrong):
    for edges in (1, 2, 3, 4, 5, 6):
        for map_ in marked_maps(edges):
            quotient = quotient_of(map_)
            if wrong(quotient) != (class_size(quotient) > 1):
                return
    pytest.fail("nothing up to six edges tells it from the criterion")


@pytest.mark.parametrize("edges", [1, 2, 3, 4])
def test_there_are_as_many_pose_hypotheses_as_lifts(edges):
    for map_ in marked_maps(edges):
        quotient = quotient_of(map_)
        assert sum(1 for _ in lifts(quotient)) == pose_count(quotient)


@pytest.mark.parametrize("k", range(1, 7))
def test_uniform_permutations_are_those_with_cycles_of_one_length(k):
    for b in range(1, k + 1):
        found = list(uniform_permutations(k, b))
        naive = [p for p in permutations(range(k)) if {len(c) for c in cycles(p)} == {b}]
        assert sorted(found) == naive
        assert len(naive) == (
            factorial(k) // (b ** (k // b) * factorial(k // b)) if k % b == 0 else 0
        )


@pytest.mark.parametrize("k", range(1, 7))
def test_the_permutations_that_commute_with_a_rotation_are_counted_right(k):
    for j in range(k):
        turn = tuple((i + j) % k for i in range(k))
        for b in range(1, k + 1):
            commuting = [
                p
                for p in uniform_permutations(k, b)
                if all(p[turn[i]] == turn[p[i]] for i in range(k))
            ]
            assert _uniform(k, gcd(k, j), b) == len(commuting)


def test_with_two_sheets_a_class_has_two_to_the_beta1_members():
    for edges in (2, 3, 4, 5):
        for map_ in marked_maps(edges):
            quotient = quotient_of(map_)
            if quotient.sheets == 2:
                assert class_size(quotient) == 2**quotient.beta1


@pytest.mark.parametrize("loops", range(5))
def test_two_sheets_and_some_loops_make_two_to_the_loops_members(loops):
    # v0, of degree 2, hangs by one class at a vertex with so many loops; every class there is
    # told by its offset from that one.
    alpha = [1, 0, *(q ^ 1 for q in range(2, 2 + 2 * loops))]
    sigma = [0, *range(2, 2 + 2 * loops), 1]
    labels = [Percept(2, 1), *[Percept(2 * loops + 1)] * (2 * loops + 1)]
    degree = tuple(label.degree for label in labels)
    quotient = Quotient(tuple(sigma), tuple(alpha), degree, tuple(labels), 2)
    assert quotient.beta1 == loops
    assert class_size(quotient) == 2**loops
    for lift in lifts(quotient):
        found = class_of(World(lift, Position(0)))
        assert found.size == len(found.worlds) == 2**loops
        assert projection_of(found.world).quotient == quotient.rerooted(0)


def test_trees_cycles_and_a_marked_vertex_of_degree_one_are_never_ambiguous():
    for edges in (1, 2, 3, 4, 5):
        for map_ in marked_maps(edges):
            if map_.vertex_count == edges + 1 or map_.degree_at[0] == 1:
                assert not is_ambiguous(quotient_of(map_))
    for n in range(1, 30):
        assert not is_ambiguous(quotient_of(cycle(n)))


def test_a_large_class_is_counted_without_being_made():
    # One vertex, twelve loops: 23!! gluings of 24 darts up to rotation (A007769(12)).
    quotient = quotient_of(named_map("bouquet-12"))
    assert pose_count(quotient) == 316234143225
    assert class_size(quotient) == 13176573910


@pytest.mark.parametrize(("loops", "diagrams"), [(2, 2), (3, 5), (4, 18), (5, 105), (6, 902)])
def test_the_maps_with_one_vertex_are_one_class_counted_like_chord_diagrams(loops, diagrams):
    # Chord diagrams with so many chords, up to rotation: A007769.
    assert class_size(quotient_of(named_map(f"bouquet-{loops}"))) == diagrams


def test_a_marked_map_has_one_least_rooting_and_its_symmetries_are_counted():
    for edges in (1, 2, 3):
        for map_ in rooted_maps(edges):
            at_v0 = map_.vertices[map_.vertex_of[0]]
            code, times = least_rooting(map_, at_v0)
            assert is_least_rooting(map_) == (rooted_code(map_.sigma, map_.alpha, 0) == code)
            assert len(at_v0) % times == 0


def test_a_quotient_of_one_sheet_is_not_ambiguous_even_with_cycles():
    quotient = quotient_of(named_map("fig1-left"))
    assert is_ambiguous(replace(quotient, sheets=2))
    assert not is_ambiguous(replace(quotient, sheets=1))
