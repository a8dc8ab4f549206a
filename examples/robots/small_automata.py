"""All automata of two states that sense the degree, for models whose percept is a ``Percept``."""

from itertools import product

from allworlds import Automaton, Move, Wait


def tables(degrees):
    """All tables: by state and degree the next state and the turn, or None: it waits."""
    keys = [*product(range(2), degrees)]
    choices = [[*product(range(2), [None, *range(degree)])] for _, degree in keys]
    for chosen in product(*choices):
        yield dict(zip(keys, chosen, strict=True))


def by_table(table):
    """The automaton of a table."""

    def step(state, percept):
        after, turn = table[state, percept.degree]
        return after, Wait() if turn is None else Move(turn)

    return Automaton(0, step)


def two_states(degrees):
    """All automata."""
    return map(by_table, tables(degrees))
