"""Depth-first search under labels: the yardstick of all other explorers."""

from __future__ import annotations

from collections.abc import Callable

from allworlds.explorers.builtin.algorithm1 import Walk, nobody
from allworlds.explorers.builtin.partial_map import PartialMap, bearing_of, walks
from allworlds.protocol.actions import Move, Percept
from allworlds.protocol.answers import Estimate
from allworlds.protocol.choices import Choices


def dfs(
    first: Percept,
    *,
    choices: Choices | None = None,
    notice: Callable[[str], None] = nobody,
) -> Walk[Estimate]:
    """Explore under labels: the number tells the vertex, and the bearing the dart of entry.

    A choice (``edge``) is by which open dart the robot leaves a vertex; events are ``known`` and
    ``unknown`` vertices beyond a dart.

    Cost: at most 2m traversals: an edge is walked along once, and back once at most.
    """
    choices = choices or Choices()
    s, here = PartialMap(first), 0
    # The number of each vertex, and its reference dart.
    reference = {first.marks: s.turn(0, bearing_of(first))}
    way: list[int] = []  # the darts that lead back to the first vertex
    while s.unexplored:
        at = s.first[s.vertex[here]]
        around = range(at, at + s.expected[at].degree)
        options = [dart for dart in around if s.alpha[dart] == dart]
        if not options:
            back = way.pop()
            yield Move(s.offset(here, back))
            here = s.alpha[back]
            continue
        cost = walks(s, s.vertex[here], options)
        dart = choices.pick(options, of="edge", cost=cost)
        seen = yield Move(s.offset(here, dart))
        if seen.marks in reference:
            notice("known")
            entry = s.turn(reference[seen.marks], -bearing_of(seen))
            s.add_loop(dart, entry)
            if s.vertex[entry] == s.vertex[dart]:
                here = entry
            elif s.unexplored:
                yield Move(0)
                here = dart
            else:
                here = entry
        else:
            notice("unknown")
            here = s.add_vertex(dart, seen)
            reference[seen.marks] = s.turn(here, bearing_of(seen))
            way.append(here)
        yield s.checkpoint(here)
    return s.estimate(here)
