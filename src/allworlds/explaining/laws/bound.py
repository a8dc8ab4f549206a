"""``bound``: the robot made too many traversals."""

from __future__ import annotations

from allworlds.explaining.story import Story
from allworlds.explaining.telling import Telling
from allworlds.maps.combinatorial import Dart
from allworlds.protocol import Move
from allworlds.words import plural, size


def tell_bound(story: Story) -> Telling:
    """What the bound allows, and what the traversals were spent on."""
    map_, cost, bound = story.map, story.transcript.cost, story.finding.expected
    name = story.finding.rules.the_bound.name
    back, first = _back_and_first(story)
    out = cost - back
    world = size(map_.edge_count, map_.vertex_count)
    return Telling(
        [
            f"The world has {world}, for which the bound ({name}) allows {bound}.",
            f"The robot made {plural(cost, 'traversal')}: {out} out, {back} to take one back.",
            f"Of those out {first} went along an edge that was new.",
        ]
    )


def _back_and_first(story: Story) -> tuple[int, int]:
    """The traversals that take back the last one not yet taken back, and those of new edges."""
    map_, back, first = story.map, 0, 0
    path: list[Dart] = []
    known: set[Dart] = set()
    for (action, _), before, arrived in zip(
        story.transcript.steps, story.walked, story.walked[1:], strict=False
    ):
        if type(action) is not Move:
            continue
        if path and map_.turn(before, action.k) == path[-1]:
            path.pop()
            back += 1
        else:
            path.append(arrived)
        first += arrived not in known
        known |= {arrived, map_.alpha[arrived]}
    return back, first
