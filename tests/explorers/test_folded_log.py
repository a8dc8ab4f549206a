"""The folded log: nodes that are merged, and percepts that contradict each other."""

import pytest

from allworlds.explorers.builtin.folding import FoldedLog, way
from allworlds.protocol.actions import Percept


def test_a_dart_is_the_one_with_which_its_node_was_merged_in_two_steps():
    log = FoldedLog(Percept(3))
    assert [log._add_node(3), log._add_node(3)] == [3, 6]
    log._merge(4, 6)  # node 2 into node 1
    log._merge(2, 3)  # node 1 into node 0
    for _ in range(2):
        assert [*map(log.canonical, range(9))] == [0, 1, 2, 2, 0, 1, 0, 1, 2]
    assert log.merges == 2


def test_a_vertex_has_one_degree():
    log = FoldedLog(Percept(2, 1, 0))
    with pytest.raises(ValueError, match=r"^the percepts contradict each other: no world shows t"):
        log.arrive(0, Percept(3, 1, 0))


def test_a_dart_leads_to_one_dart():
    log = FoldedLog(Percept(3, 1, 0))
    assert log.arrive(0, Percept(3)) == 3
    with pytest.raises(ValueError, match=r"^the percepts contradict each other: no world shows t"):
        log.arrive(4, Percept(3, 1, 0))


def test_a_way_leads_to_the_first_goal_and_there_is_one():
    log = FoldedLog(Percept(2, 1, 0))
    log.arrive(1, Percept(2))
    assert way(log, 0, lambda dart: dart == 3) == [1, 3]
    assert way(log, 2, lambda dart: dart == 0) == [2, 0]
    with pytest.raises(AssertionError, match="the folded log is connected"):
        way(log, 0, lambda dart: dart == 4)
