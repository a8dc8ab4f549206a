"""A walk as a list with an item for each step: motion, percept, and percept elsewhere."""

from __future__ import annotations

from collections.abc import Sequence
from xml.etree import ElementTree as ET

from allworlds.judging import Walked
from allworlds.protocol import Move
from allworlds.reports.markup import tag
from allworlds.reports.telling import ToldWalk, View
from allworlds.studies.run import Hypothesis

LONGEST = 1500
"""The number of steps of a longer walk that are told."""


def steps_of(
    walk: ToldWalk, views: Sequence[View], name: str, follows: Sequence[str]
) -> ET.Element:
    """The list of the first :data:`LONGEST` steps.

    Args:
        walk: which one.
        views: the pictures in which it is followed.
        name: of the walk, with which the names of its steps begin.
        follows: a name for each view, by which its picture finds the robot in a step.
    """
    items = [_step(walk, i, f"{name}-step-{i}") for i in range(len(walk.walked.walked[:LONGEST]))]
    for followed, view in zip(follows, views, strict=True):
        for item, dart in zip(items, view.trail, strict=False):
            item.set(f"data-{followed}", str(dart))
    _tell_tests(items, walk.tests, walk.walked)
    return tag(
        "ol",
        *items,
        class_="walk compared" if walk.elsewhere else "walk",
        start="0",
        role="list",
        aria_label="The walk, step by step",
    )


def _step(walk: ToldWalk, i: int, name: str) -> ET.Element:
    walked, parts = walk.walked, i == walk.parting
    action = walked.transcript.steps[i - 1][0] if i else None
    item = tag(
        "li",
        tag("a", str(i), href=f"#{name}", class_="step", aria_label=f"step {i}"),
        tag("span", str(action) if action else "start", class_="motion"),
        tag("span", f"at {walked.place(walked.walked[i])}", class_="place"),
        tag("span", f"sensed: {walked.sensed[i]}", class_="sensed"),
        id=name,
        class_="parting" if parts else None,
        data_moved="" if type(action) is Move else None,
    )
    if walk.elsewhere and i < len(walk.elsewhere.percepts):
        other = walk.elsewhere.percepts[i]
        sign, kind = ("=", "fits") if other == walked.sensed[i] else ("≠", "misfits")
        item.append(tag("span", f"{sign} {walk.elsewhere.where}: {other}", class_=kind))
    if parts:
        item.append(tag("b", "belief and truth diverge here", class_="note"))
    return item


def _tell_tests(steps: Sequence[ET.Element], tests: Sequence[Hypothesis], story: Walked) -> None:
    """Add to each step the hypothesis under test, and the result of the test at its end."""
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
