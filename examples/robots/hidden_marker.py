"""Algorithm 1, whose marker is hidden once, in ``hidden:1+lighthouse:directional``.

One fault is enough for a wrong map: the smallest world has two edges.
"""

from allworlds.explorers import algorithm1


def mapper(first):
    """Algorithm 1, unchanged."""
    return (yield from algorithm1(first))
