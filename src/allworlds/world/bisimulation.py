"""The checker of bisimulations, independent of the search for twins; the equality of worlds."""

from collections.abc import Sequence

from allworlds.maps.combinatorial import Dart, carries, numbering
from allworlds.protocol.actions import Move, Percept
from allworlds.world.world import World


def flaw(worlds: Sequence[World], bisimulation: Sequence[Sequence[int]]) -> str | None:
    """The reason why ``bisimulation`` does not prove that ``worlds`` look alike; None if it does.

    A bisimulation puts each dart of the worlds into a class.
    The classes are a proof if the starts are in one class, and if any two darts of one class agree
    in three things: their percepts are equal, sigma leads from both into one class, and alpha leads
    from both into one class.
    Then no motions distinguish the worlds, because each motion consists of sigma and alpha.

    Args:
        worlds: two worlds, or any other number of worlds.
        bisimulation: for each world a sequence, with the number of the class of each dart.

    Cost: O(m).
    """
    if [len(classes) for classes in bisimulation] != [len(w.map.sigma) for w in worlds]:
        return "there must be one class for each dart of each world"
    if len({classes[w.start] for w, classes in zip(worlds, bisimulation, strict=True)}) != 1:
        return "the starts are in different classes"
    seen: dict[int, tuple[str, object, int, int]] = {}
    for i, (world, classes) in enumerate(zip(worlds, bisimulation, strict=True)):
        for d, q in enumerate(classes):
            sigma, alpha = classes[world.map.sigma[d]], classes[world.map.alpha[d]]
            mine = (f"dart {d} of world {i}", world.percepts[d], sigma, alpha)
            first = seen.setdefault(q, mine)
            for what, a, b in zip(("sense", "sigma", "alpha"), first[1:], mine[1:], strict=True):
                if a != b:
                    return f"{first[0]} and {mine[0]} are in class {q}, but differ in {what}"
    return None


def same_world_from(a: World, b: World) -> Dart | None:
    """A dart of ``b``: with this dart as its start, ``b`` is the same world as ``a``.

    If the start of ``b`` is such a dart, it is the result; if no dart is, the result is None.  Two
    worlds are the same if an isomorphism of their maps preserves the percepts, and takes the start
    of one world to the start of the other.

    Cost: O(m) if the result is the start of ``b``, O(m^2) at worst.
    """
    if len(a.map.sigma) != len(b.map.sigma):
        return None
    order = numbering(a.map.sigma, a.map.alpha, a.start)
    images: list[Dart] = [b.start, *b.map.darts]
    for image in images:
        if a.first == b.percepts[image] and carries(
            a.map.sigma, a.map.alpha, order, b.map.sigma, b.map.alpha, image
        ):
            pairs = zip(order, numbering(b.map.sigma, b.map.alpha, image), strict=True)
            if all(a.percepts[d] == b.percepts[e] for d, e in pairs):
                return image
    return None


def sensed(world: World, motions: Sequence[int]) -> tuple[Percept, ...]:
    """The percepts of a robot in ``world``, at the start and after each of the motions."""
    state, percepts = world.initial, [world.first]
    for k in motions:
        state, percept = world.step(state, Move(k))
        percepts.append(percept)
    return tuple(percepts)
