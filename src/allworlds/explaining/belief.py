"""The walk of a finding in its wrong answer."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from allworlds.explaining.story import Story
from allworlds.findings import Parting, believed_percepts, believed_trail, find_parting
from allworlds.inputs import InputError, show
from allworlds.protocol import Estimate, Percept


class Belief:
    """What the answer makes of the walk, under the laws that are about the answer.

    Attributes:
        story: the finding with its walk in the world.
        answer: the wrong answer.
        believed: the robot's darts in the answer at the start and after each step.

    Raises:
        InputError: if what was seen is no answer.
    """

    def __init__(self, story: Story) -> None:
        self.story = story
        self.answer = _answer(story.finding.seen)
        self.believed = believed_trail(self.answer.map, self.answer.here, story.transcript)

    @cached_property
    def expected(self) -> list[Percept]:
        """What the answer makes expect at each step, as far as that can be said."""
        map_, here = self.answer.map, self.answer.here
        percepts = believed_percepts(self.story.world, map_, here, self.story.transcript)
        if percepts is not None:
            return percepts
        # There is no place for the marker; what is left are the degrees.
        return [Percept(map_.degree_at[dart]) for dart in self.believed]

    @cached_property
    def misfits(self) -> list[int]:
        """The steps at which something else was sensed than the answer makes expect."""
        pairs = zip(self.expected, self.story.sensed, strict=True)
        return [step for step, (expected, sensed) in enumerate(pairs) if expected != sensed]

    @cached_property
    def parting(self) -> Parting | None:
        """Where the walk and the same walk in the answer part; None if they never do."""
        story = self.story
        fits = [step not in self.misfits for step in range(len(story.walked))]
        return find_parting(story.map, story.walked, self.answer.map, self.believed, fits)

    @property
    def step(self) -> int | None:
        """The first step at which belief and truth part."""
        return self.parting.step if self.parting else None


def _answer(seen: object) -> Estimate:
    if not isinstance(seen, Mapping):
        raise InputError(f"seen = {show(seen)} is no rooted map, but the law is about the answer")
    try:
        return Estimate.from_json(seen)
    except InputError as error:
        raise InputError(f"seen.{error}") from None
