"""Another world with the same log, which shows that the log does not determine the world."""

from __future__ import annotations

from collections.abc import Iterator

from allworlds.judging.findings.walks import true_walk
from allworlds.judging.laws.folding import Folded, fold
from allworlds.maps import CombinatorialMap, Dart, rooted_isomorphism
from allworlds.protocol import Transcript
from allworlds.world import Directional, IllegalAction, World


def another_world(world: World, transcript: Transcript) -> World | None:
    """A world that is not this one, and agrees with the log; None if the log determines it.

    The other world extends the folded log: its open darts are joined with each other, or lead to
    new vertices.  Of these worlds it is one with the fewest edges, and simple if the world is.

    Cost: exponential in the number of these darts at the worst; the first try is nearly always
    another world.
    """
    folded = fold(transcript)
    if not folded.open_darts:
        return None
    return next(
        other
        for map_ in _completions(folded)
        if (map_.is_simple or not world.map.is_simple)
        and (other := _agreeing(map_, transcript))
        and not rooted_isomorphism(other.map, other.start, world.map, world.start)
    )


def _agreeing(map_: CombinatorialMap, transcript: Transcript) -> World | None:
    """The world of this map with the marker of the log; None if it does not have this log."""
    bearing = transcript.first.bearing
    assert bearing is not None
    other = World(map_, Directional(map_.turn(0, bearing)), 0)
    try:
        sensed = [percept for _, percept in true_walk(other, transcript)]
    except IllegalAction:
        return None
    return other if sensed == transcript.percepts else None


def _completions(folded: Folded) -> Iterator[CombinatorialMap]:
    """The folded log with every open dart joined or led to a new vertex, fewest edges first."""
    unsettled = [dart for dart, end in enumerate(folded.alpha) if dart == end]
    for leaves in range(len(unsettled) % 2, len(unsettled) + 1, 2):
        for pairs in _matchings(unsettled, leaves):
            yield _completed(folded, pairs, [1] * leaves)
    # Leaves everywhere may be the world itself; then one of them goes on.
    yield _completed(folded, [], [2, *[1] * (len(unsettled) - 1)])


def _matchings(darts: list[Dart], leaves: int) -> Iterator[list[tuple[Dart, Dart]]]:
    """Every way to pair the darts with ``leaves`` of them left over."""
    if not darts:
        yield []
        return
    first, *others = darts
    for other in others if len(darts) > leaves else ():
        for pairs in _matchings([dart for dart in others if dart != other], leaves):
            yield [(first, other), *pairs]
    if leaves:
        yield from _matchings(others, leaves - 1)


def _completed(
    folded: Folded, pairs: list[tuple[Dart, Dart]], degrees: list[int]
) -> CombinatorialMap:
    """The folded log with these darts joined; the others lead to new vertices of these degrees.

    From a new vertex of degree 2 an edge leads on to a leaf.
    """
    sigma, alpha = [*folded.sigma], [*folded.alpha]

    def join(a: Dart, b: Dart) -> None:
        alpha[a], alpha[b] = b, a

    def grow(degree: int) -> list[Dart]:
        new = [*range(len(sigma), len(sigma) + degree)]
        sigma.extend([*new[1:], new[0]])
        alpha.extend(new)
        return new

    for a, b in pairs:
        join(a, b)
    unsettled = [dart for dart, end in enumerate(alpha) if dart == end]
    for dart, degree in zip(unsettled, degrees, strict=True):
        back, *onward = grow(degree)
        join(dart, back)
        for end in onward:
            join(end, *grow(1))
    return CombinatorialMap(sigma, alpha)
