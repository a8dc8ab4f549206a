"""The words about a walk without an end: its round, and what it leaves open."""

from collections.abc import Sequence
from typing import Any

from msgspec import Struct

from allworlds.judging.explanations.story import Story
from allworlds.words import listed, plural

TIMES = 3
"""A walk goes round if its end is so many times the same steps."""

SHOWN = 8
"""The places of a round, and the lines, that are told."""


class Round(Struct, frozen=True):
    """Steps that the end of a walk repeats.

    Attributes:
        first: the number of the first step of the first round, from 1 on.
        steps: how many are in a round.
        times: how many whole rounds there are.
    """

    first: int
    steps: int
    times: int


def round_of(walk: Sequence[Any]) -> Round | None:
    """The longest end of a walk that is some steps again and again; None if there is none.

    Cost: linear: the borders of the reversed walk, as Knuth, Morris and Pratt find them.
    """
    back = walk[::-1]
    border, found = [0] * len(back), None
    for i in range(1, len(back)):
        k = border[i - 1]
        while k and back[i] != back[k]:
            k = border[k - 1]
        border[i] = k + (back[i] == back[k])
        length = i + 1
        period = length - border[i]
        if length >= TIMES * period:
            found = Round(len(back) - length + 1, period, length // period)
    return found


def tell_round(story: Story) -> list[str]:
    """Tell where a walk begins to go round, by its places and lines; no sentence if it does not."""
    walk = story.walk
    found = round_of([*zip(map(str, walk.actions), walk.darts[1:], strict=True)])
    if found is None:
        return []
    steps = range(found.first, found.first + found.steps)
    places = [story.place(walk.darts[step]) for step in steps]
    more = "; ..." if len(places) > SHOWN else ""
    where = "; ".join(places[:SHOWN]) + more
    code = story.finding.code
    lines = code.steps[found.first - 1 : found.first - 1 + found.steps] if code else ()
    named = ", ".join([line for line in dict.fromkeys(lines) if line][:SHOWN])
    how = f"{plural(found.steps, 'step')}, {found.times} times, to {where}"
    return [f"From step {found.first} on it goes round: {how}{named and f' (lines {named})'}."]


def tell_open(story: Story) -> list[str]:
    """Name the edges that were never walked along; no sentence if there are none."""
    walked = story.walk.crossed
    edges = [
        f"the edge from {story.place(a)}, to {story.place(b)}"
        for a, b in story.map.edges
        if a not in walked
    ]
    if len(edges) > SHOWN:
        edges[SHOWN:] = [f"{len(edges) - SHOWN} more"]
    return [f"It never walked along {listed(edges)}."] if edges else []
