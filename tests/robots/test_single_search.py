"""The search of one world in this process."""

from allworlds.protocol.actions import End
from allworlds.protocol.turns import Automaton
from allworlds.robots.single_search import search
from small import EDGE
from worlds_that_change import Never


def test_programs_that_are_equal_but_for_a_type_are_two():
    """Automata that begin with 1 and with True are equal values."""

    def end(memory, percept):
        return memory, End(memory)

    team = [Automaton(start, end) for start in (1, True)]
    found = search(EDGE, (0, 1), Never(), team, "fsync")
    _, minds, _ = found.search.configuration(len(found.search) - 1)
    answers = [found.search.minds.value[mind].answer for mind in minds]
    assert [*map(repr, answers)] == ["1", "True"]
