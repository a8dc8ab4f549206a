from math import log2
from random import Random

import pytest
from test_quotient import labelled_maps, looked_at

from allworlds.documents.document import replace
from allworlds.maps import named_map, project, random_map
from allworlds.maps.quotient import classes_of_union


@pytest.mark.slowest
def test_rooted_quotients_are_equal_exactly_if_the_roots_share_a_class_of_the_union():
    some = list(labelled_maps(3))
    for one in some:
        for other in some[::4]:
            first, second = classes_of_union(one, other)
            mine, theirs = (project(part).quotient for part in (one, other))
            alike = first[0] == second[0]
            assert alike == (replace(mine, sheets=0) == replace(theirs, sheets=0))
            assert first == project(one).classes
            assert set(first) | set(second) == set(range(max(first + second) + 1))


@pytest.mark.parametrize("name", ["cycle-5000", "wheel-2500", "path-5001", "random"])
def test_no_dart_is_looked_at_more_than_log2_times_for_each_permutation(name, monkeypatch):
    # 'Process the smaller half': a dart's block is a splitter again only after it has halved.
    map_ = random_map(5000, Random(2)) if name == "random" else named_map(name)
    assert len(map_.sigma) == 10_000
    assert looked_at(map_, monkeypatch) <= 2 * 10_000 * (log2(10_000) + 1)
