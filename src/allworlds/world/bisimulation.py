"""The checker of bisimulations; the way in which they were found is not used."""

from __future__ import annotations

from collections.abc import Sequence

from allworlds.world.world import World


def flaw(worlds: Sequence[World], bisimulation: Sequence[Sequence[int]]) -> str | None:
    """The reason why the classes do not prove the worlds indistinguishable; None if they do.

    No motion tells the worlds apart if the starts are in one class, and darts of one class
    sense the same and lead, by sigma and by alpha, to darts of one class: every motion is made
    of these two.

    Args:
        worlds: two of them (or any number).
        bisimulation: for each world the class of each dart.

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
