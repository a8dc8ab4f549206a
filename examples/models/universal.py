"""A universal sequence: one word of turns that visits every room of every small cubic graph.

Source: R. Aleliunas, R. Karp, R. Lipton, L. Lovász, C. Rackoff, Random walks, universal traversal
sequences, and the complexity of maze problems, FOCS 1979, 218-223. The letters here are turns.

    $ allworlds check universal.py:whole --lighthouse none --task cover --where cubic --edges 3
    HOLDS
    $ allworlds check universal.py:shorter --lighthouse none --task cover --where cubic --edges 3
    REFUTED
"""

from allworlds import Move


def walks(word):
    """The explorer that takes these turns."""

    def explore(first):
        for turn in word:
            yield Move(int(turn))

    return explore


whole = walks("112")
shorter = walks("11")
