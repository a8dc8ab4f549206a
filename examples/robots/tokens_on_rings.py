"""Robots on a ring with one token each, which stays where it is laid down, in ``tokens``.

``round_once``: with one orientation they meet unless the distances between them repeat themselves.
``onward``: two that face each other meet while they walk on, unless the ring is even and their
distance is odd.
"""

from allworlds import Automaton, Drop, Move, Wait


def round_once(robots):
    """Walk round once, count the edges between tokens, and go where the least list begins.

    The memory: the gaps, of which the last one grows; and the moves left, None at first.
    """

    def step(memory, percept):
        gaps, left = memory
        _, tokens, _, hand = percept
        if hand:
            return memory, Drop()
        if left is None and tokens and gaps:
            if len(gaps) == robots:
                turned = [gaps[i:] + gaps[:i] for i in range(robots)]
                left = sum(gaps[: turned.index(min(turned))])
            else:
                gaps = (*gaps, 0)
        if left is None:
            after = (*gaps[:-1], gaps[-1] + 1) if gaps else (1,)
            return (after, None), Move(1 if gaps else 0)
        return (gaps, max(left - 1, 0)), Move(1) if left else Wait()

    return Automaton(((), None), step)


def walk_on(turn, percept):
    """Lay the token down, which is not needed, and walk on."""
    return (turn, Drop()) if percept[3] else (1, Move(turn))


onward = Automaton(0, walk_on)
