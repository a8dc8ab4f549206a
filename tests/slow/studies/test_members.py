import pytest

from allworlds.studies.ambiguity import class_of, twins
from studies.test_members import ambiguous


@pytest.mark.parametrize("edges", [2, 3, 4])
def test_no_motion_tells_a_member_from_the_given_world_and_no_two_members_are_the_same(edges):
    for found in ambiguous(edges):
        for i, one in enumerate(found.worlds):
            relation = twins(found.world, one)
            assert not relation.distinguishable
            assert relation.twins == (i > 0)
            assert all(twins(one, other).twins for other in found.worlds[:i])


@pytest.mark.slowest
@pytest.mark.parametrize("edges", [2, 3, 4])
def test_every_member_has_the_same_class(edges):
    for found in ambiguous(edges):
        maps = {one.map for one in found.worlds}
        for one in found.worlds:
            again = class_of(one)
            assert {other.map for other in again.worlds} == maps
            assert (again.size, again.poses) == (found.size, found.poses)
            assert again.quotient == found.quotient
