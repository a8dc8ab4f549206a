"""``crash``, ``timeout`` and their kin: the run ended before it could be judged."""

from __future__ import annotations

from allworlds.explaining.story import Story
from allworlds.explaining.telling import Teller, Telling


def ending(how: str) -> Teller:
    """Tells how the run ended, in that sentence, then its last step and what was seen."""

    def tell(story: Story) -> Telling:
        return Telling(
            [how, _say_last_step(story), *story.expected_and_seen(), *_last_line(story)],
        )

    return tell


def _say_last_step(story: Story) -> str:
    steps, place = story.transcript.steps, story.place(story.walked[-1])
    if not steps:
        return f"It made no step: it stood at the start, {place}, and sensed '{story.sensed[0]}'."
    action, percept = steps[-1]
    return (
        f"Its last step was step {len(steps)}, {action}: to {place}, where it sensed '{percept}'."
    )


def _last_line(story: Story) -> list[str]:
    """The last line of the finding's detail, where it has one."""
    detail = story.finding.detail
    lines = detail.split("\n") if detail else []
    last = next((line.strip() for line in reversed(lines) if line.strip()), "")
    return (
        [f"The last line of its traceback, or of what it wrote to stderr: {last}"] if last else []
    )
