"""A walk as a list with one item a step: what happened, and what the answer makes of it."""

from __future__ import annotations

from xml.etree import ElementTree as ET

from allworlds.explaining import Belief, Explanation, Walked
from allworlds.findings import true_trail
from allworlds.markup import tag
from allworlds.protocol import Move


def walk(story: Walked, belief: Belief | None, told: Explanation | None, name: str) -> ET.Element:
    """The list, with the step at which belief and truth part, if they do."""
    parting = told.step if told else None
    items = [
        _step(story, belief, i, f"{name}-step-{i}", i == parting) for i in range(len(story.walked))
    ]
    if told and told.other:
        for item, dart in zip(items, true_trail(told.other, story.transcript), strict=True):
            item.set("data-believed", str(dart))
    return tag(
        "ol",
        *items,
        class_="walk compared" if belief else "walk",
        start="0",
        role="list",
        aria_label="The walk, step by step",
    )


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
        expected = belief.expected[i]
        as_sensed = expected == story.sensed[i]
        sign = "=" if as_sensed else "≠"
        words = f"{sign} the answer makes expect: {expected}"
        item.append(tag("span", words, class_="fits" if as_sensed else "misfits"))
    if parts:
        item.append(tag("b", "here belief and truth part", class_="note"))
    return item
