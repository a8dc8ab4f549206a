"""``invariant-1``, ``invariant-2`` and ``variant``: a checkpoint is wrong."""

from __future__ import annotations

from allworlds.explaining.story import Story
from allworlds.explaining.telling import Telling


def tell_invariant_1(story: Story) -> Telling:
    """The checkpoint that shows a wrong S."""
    broken = "What was published as S, the explored part, does not lie so in the world."
    return Telling(_tell_checkpoint(broken, story), story.checkpoint)


def tell_invariant_2(story: Story) -> Telling:
    """The checkpoint that shows a wrong U."""
    broken = "What was published as U, the unexplored darts, holds one that is explored."
    return Telling(_tell_checkpoint(broken, story), story.checkpoint)


def tell_variant(story: Story) -> Telling:
    """The checkpoint that shows no progress; what it shows may be true, so nothing parts."""
    broken = "A pass brought no progress: the edges missing in S did not get fewer, or not none."
    return Telling(_tell_checkpoint(broken, story))


def _tell_checkpoint(broken: str, story: Story) -> list[str]:
    sentences = [broken]
    step = story.checkpoint
    if step is not None:
        sentences.append(
            f"The checkpoint came after step {step}, where the robot stood at "
            f"{story.place(story.walked[step])}, and had sensed '{story.sensed[step]}'."
        )
    return sentences + story.expected_and_seen()
