"""``invariant-1``, ``invariant-2`` and ``variant``: a checkpoint is wrong."""

from __future__ import annotations

import re

from allworlds.explaining.story import Story
from allworlds.explaining.telling import Telling


def tell_invariant_1(story: Story) -> Telling:
    """The checkpoint that shows a wrong S."""
    broken = "What was published as S, the explored part, does not lie so in the world."
    return Telling(_tell_checkpoint(broken, story), _checkpoint_step(story))


def tell_invariant_2(story: Story) -> Telling:
    """The checkpoint that shows a wrong U."""
    broken = "What was published as U, the unexplored darts, holds one that is explored."
    return Telling(_tell_checkpoint(broken, story), _checkpoint_step(story))


def tell_variant(story: Story) -> Telling:
    """The checkpoint that shows no progress; what it shows may be true, so nothing parts."""
    broken = "A pass brought no progress: the edges missing in S did not get fewer, or not none."
    return Telling(_tell_checkpoint(broken, story))


def _tell_checkpoint(broken: str, story: Story) -> list[str]:
    sentences = [broken]
    step = _checkpoint_step(story)
    if step is not None:
        sentences.append(
            f"The checkpoint came after step {step}, where the robot stood at "
            f"{story.place(story.walked[step])}, and had sensed '{story.sensed[step]}'."
        )
    return sentences + story.expected_and_seen()


def _checkpoint_step(story: Story) -> int | None:
    """The step before the checkpoint that breaks the law; None where none is named."""
    named = re.search(r"\bcheckpoint after step ([0-9]{1,9})\b", str(story.finding.seen))
    step = int(named[1]) if named else None
    return step if step is not None and step < len(story.walked) else None
