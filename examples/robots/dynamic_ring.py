"""A ring of which one edge may be missing in each round, in ``one-interval``.

``catch_and_bounce``: both walk in one direction; who catches one that is held on a port turns back,
once.  All end after a number of rounds: with ports for one and starts at different vertices that
face the same way 3n - 6 are enough, 3n - 5 if both may start at one vertex; robots that face each
other may be held for ever.  ``onward``: one robot that walks on is starved.
"""

from allworlds import Automaton, End, Move


def catch_and_bounce(rounds):
    """The robot that ends after a number of rounds, a function of the number of vertices.

    Its memory: the turn by which it goes on, whether it has met nobody yet, the rounds left, and
    all rounds.
    """

    def start(vertices):
        return 0, True, rounds(vertices), rounds(vertices)

    def step(memory, percept):
        turn, alone, left, every = memory
        _, moved, held, others = percept
        if not left:
            return memory, End()
        turn = 1 if moved and left < every else turn
        if alone and not held and True in others:
            turn, alone = 1 - turn, False  # it catches one that is held
        elif alone and held and False in others:
            alone = False  # it is caught
        return (turn, alone, left - 1, every), Move(turn)

    return Automaton(start, step)


apart = catch_and_bounce(lambda vertices: 3 * vertices - 6)
anywhere = catch_and_bounce(lambda vertices: 3 * vertices - 5)


def walk_on(memory, percept):
    """Walk on in one direction; the memory is the turn."""
    _, moved, _, _ = percept
    turn = 1 if moved and memory is not None else (memory or 0)
    return turn, Move(turn)


onward = Automaton(None, walk_on)
