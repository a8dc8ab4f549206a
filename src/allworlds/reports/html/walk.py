"""A walk as a list with one item a step: what happened, and what the answer makes of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from xml.etree import ElementTree as ET

from allworlds.judging import Belief, Walked
from allworlds.maps import Dart
from allworlds.protocol import Move, Percept
from allworlds.reports.markup import tag
from allworlds.studies.run import Hypothesis

LONGEST = 1500
"""Of a longer walk so many steps are told."""


def walk(
    story: Walked,
    name: str,
    belief: Belief | None = None,
    parting: int | None = None,
    others: Mapping[str, Sequence[Dart]] = MappingProxyType({}),
    instead: Sequence[Percept] | None = None,
) -> ET.Element:
    """The list of the first :data:`LONGEST` steps, and of how many there are.

    Args:
        story: the walk.
        name: of the walk, with which the names of its steps begin.
        belief: what the answer makes of it, where there is a wrong one.
        parting: the step at which belief and truth part, if they do.
        others: the robot's darts in other pictures, by what these follow.
        instead: what is sensed in another world, where that is to be compared.
    """
    items = [
        _step(story, belief, i, f"{name}-step-{i}", i == parting)
        for i in range(len(story.walked[:LONGEST]))
    ]
    for follows, trail in others.items():
        for item, dart in zip(items, trail, strict=False):
            item.set(f"data-{follows}", str(dart))
    for item, here, there in zip(items, story.sensed, instead or (), strict=False):
        item.append(_beside(here, "in B", there))
    return tag(
        "ol",
        *items,
        class_="walk compared" if belief or instead else "walk",
        start="0",
        role="list",
        aria_label="The walk, step by step",
    )


def tell_tests(steps: ET.Element, tests: Sequence[Hypothesis], story: Walked) -> None:
    """Say at each step of a walk's list which hypothesis is under test, and how it ends."""
    told: dict[int, list[str]] = {}
    for test in tests:
        for step, dart in enumerate(test.supposed, test.first):
            if step >= len(steps):
                break
            steps[step].set("data-tested", str(test.dart))
            steps[step].set("data-supposed", str(dart))
            words = told.setdefault(step, [])
            if step == test.first:
                words.append(f"whether it has come by dart {test.dart}")
            else:
                words.append(f"if by dart {test.dart}, it is now at {story.place(dart)}")
            if step == test.last:
                words[-1] += ": yes" if test.right else ": no"
    for step, words in told.items():
        steps[step].append(tag("span", f"test: {'; '.join(words)}", class_="test"))


def _step(story: Walked, belief: Belief | None, i: int, name: str, parts: bool) -> ET.Element:
    action = story.transcript.steps[i - 1][0] if i else None
    robot = story.walked[i]
    item = tag(
        "li",
        tag("a", str(i), href=f"#{name}", class_="step", aria_label=f"step {i}"),
        tag("span", str(action) if action else "start", class_="motion"),
        tag("span", f"at {story.place(robot)}", class_="place"),
        tag("span", f"sensed: {story.sensed[i]}", class_="sensed"),
        id=name,
        class_="parting" if parts else None,
        data_robot=robot,
        data_moved="" if type(action) is Move else None,
    )
    if belief:
        item.set("data-believed", str(belief.believed[i]))
        item.append(_beside(story.sensed[i], "the answer makes expect", belief.expected[i]))
    if parts:
        item.append(tag("b", "here belief and truth part", class_="note"))
    return item


def _beside(sensed: Percept, where: str, other: Percept) -> ET.Element:
    """What is sensed, or to be expected, elsewhere; and whether it is the same."""
    sign, kind = ("=", "fits") if other == sensed else ("≠", "misfits")
    return tag("span", f"{sign} {where}: {other}", class_=kind)
