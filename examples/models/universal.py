"""A universal sequence: one word of turns that visits every room of every small cubic graph.

Source: R. Aleliunas and others, Random walks, universal traversal sequences (1979); M. Koucký,
Universal traversal sequences with backtracking (2002), for words of turns.

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
