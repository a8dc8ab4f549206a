"""Where belief and truth part, in sentences."""

from __future__ import annotations

from allworlds.explaining.belief import Belief
from allworlds.explaining.open_darts import tell_open_darts
from allworlds.findings import Parting


def tell_parting(belief: Belief) -> list[str]:
    """Where the walk and the same walk in the answer part, and how that could be sensed."""
    parting, misfits = belief.parting, belief.misfits
    sentences = [
        "Follow the log in the world and, traced back from 'here', in the answer.",
    ]
    if parting is None:
        sentences.append(
            "They never part: the log fits the world and the answer, and the rest was guessed."
        )
        return sentences + tell_open_darts(belief.story)
    sentences.append(_say_parting(belief, parting))
    if parting.step in misfits:
        return sentences
    if misfits:
        step, misfit = misfits[0], _say_misfit(belief, misfits[0])
        sentences.append(f"The first percept against the answer came at step {step}: {misfit}.")
        return sentences
    sentences.append(
        "Every percept fits the answer all the same: the log does not tell them apart."
    )
    return sentences + tell_open_darts(belief.story)


def _say_parting(belief: Belief, parting: Parting) -> str:
    """The step at which they part, as one sentence."""
    story = belief.story
    step, robot, taken_for = parting.step, parting.robot, parting.taken_for
    vertex = story.vertex(robot)
    misfit = _say_misfit(belief, step) if step in belief.misfits else ""
    if step == 0:
        return f"They part at the start, at {vertex}: {misfit}."
    if parting.fresh:
        truth = f"At step {step} the robot came to {vertex} for the first time"
    else:
        truth = f"At step {step} the robot was back at {vertex}, {story.last_left(robot, step)}"
    if taken_for == (None if parting.fresh else robot):
        return f"{truth}, and so it is in its answer, but {misfit}."
    if taken_for is None:
        taken = "its answer takes the place for a new vertex"
    elif story.vertex(taken_for) != vertex:
        left = story.last_left(taken_for, step)
        taken = f"its answer takes the place for {story.vertex(taken_for)}, {left}"
    else:
        taken = f"its answer takes dart {robot}, by which it came, for dart {taken_for}"
    return f"{truth}, but {taken}{': ' if misfit else ''}{misfit}."


def _say_misfit(belief: Belief, step: int) -> str:
    expected, sensed = belief.expected[step], belief.story.sensed[step]
    return f"it sensed '{sensed}', where the answer makes expect '{expected}'"
