"""The graph of a search keeps each transition in 64 bits: what does not fit is refused."""

import pytest

from allworlds.inputs.checks import InputError
from allworlds.robots.graph import BITS, INDEX, Graph, Transition


@pytest.mark.parametrize("before", [-1, 0, (1 << 31) - 1])
def test_a_discovery_is_read_as_it_was_added(before):
    graph = Graph()
    most = Transition(before, (1 << BITS) - 1, (1 << INDEX) - 1)
    graph.discover(*most)
    assert graph.discovery(0) == most


def test_more_choices_of_the_adversary_than_are_kept_are_refused():
    with pytest.raises(InputError, match="more than 1,048,576 states after one step"):
        Graph().discover(0, 1, 1 << INDEX)
