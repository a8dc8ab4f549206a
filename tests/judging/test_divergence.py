"""Where two walks part."""

from allworlds.judging.belief import Parting, find_parting
from small import EDGE, PATH


def test_a_walk_does_not_part_from_itself():
    walk = [0, 1, 3, 2, 0]
    assert find_parting(PATH, walk, PATH, walk, [True] * 5) is None


def test_a_walk_does_not_part_from_its_renamed_self():
    names = [2, 0, 3, 1]
    walk = [0, 1, 3, 2, 0]
    renamed = [names[dart] for dart in walk]
    assert find_parting(PATH, walk, PATH.relabelled(names), renamed, [True] * 5) is None


def test_a_misfit_parts_even_where_the_darts_agree():
    parting = find_parting(EDGE, [0, 1, 0], EDGE, [0, 1, 0], [True, True, False])
    assert parting == Parting(2, robot=0, taken_for=0, fresh=False)


def test_a_new_vertex_taken_for_a_known_one_parts():
    parting = find_parting(EDGE, [0, 1], EDGE, [0, 0], [True, True])
    assert parting == Parting(1, robot=1, taken_for=0, fresh=True)


def test_a_known_vertex_taken_for_a_new_one_parts():
    parting = find_parting(EDGE, [0, 0], EDGE, [0, 1], [True, True])
    assert parting == Parting(1, robot=0, taken_for=None, fresh=False)


def test_the_whole_rotation_is_tied_when_a_vertex_is_first_met():
    # The robot comes to v1 by dart 1, then to its dart 2, which the answer takes for dart 1.
    parting = find_parting(PATH, [1, 2], PATH, [1, 1], [True, True])
    assert parting == Parting(1, robot=2, taken_for=1, fresh=False)
