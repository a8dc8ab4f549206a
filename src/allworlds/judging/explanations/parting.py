"""The divergence of belief and truth, and the open darts of the log, in sentences."""

from __future__ import annotations

from collections import Counter

from allworlds.judging.explanations.story import Belief, Story
from allworlds.judging.findings.belief import Parting
from allworlds.judging.laws.folding import fold
from allworlds.maps import cycles
from allworlds.words import listed, plural

NAMED = 3
"""The number of open darts that are named, the others are counted."""


def tell_parting(belief: Belief) -> list[str]:
    """Tell where the walk and its image in the answer diverge, and how that could be sensed."""
    parting, misfits = belief.parting, belief.misfits
    if parting is None:
        fits = (
            "The answer is another world that fits the whole log: nothing that the robot sensed "
            "tells the two apart, so it was guessed."
        )
        return [fits, *tell_open_darts(belief.story)]
    sentences = [_say_parting(belief, parting)]
    if parting.step in misfits:
        return sentences
    if misfits:
        step, misfit = misfits[0], _say_misfit(belief, misfits[0])
        sentences.append(f"The first percept against the answer came at step {step}: {misfit}.")
        return sentences
    sentences.append(
        "Every percept fits the answer, too: the walk was too short to tell the two apart."
    )
    return sentences + tell_open_darts(belief.story)


def _say_parting(belief: Belief, parting: Parting) -> str:
    """The step at which they diverge, as one sentence."""
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
        taken = f"in its answer it came by dart {taken_for}, in truth by dart {robot}"
    return f"{truth}, but {taken}{': ' if misfit else ''}{misfit}."


def _say_misfit(belief: Belief, step: int) -> str:
    expected, sensed = belief.expected[step], belief.story.sensed[step]
    return f"it sensed '{sensed}', where the answer predicts '{expected}'"


def tell_open_darts(story: Story) -> list[str]:
    """Tell the open darts of the folded log, and the vertices that it has several times.

    No sentence if no dart is open, or if the lighthouse allows no folding.
    """
    if not story.world.lighthouse.as_kind.folds:
        return []
    folded, map_ = fold(story.transcript), story.map
    image = {0: story.world.start}
    for x in (queue := [0]):
        for y, true in ((folded.sigma[x], map_.sigma), (folded.alpha[x], map_.alpha)):
            if y not in image:
                image[y] = true[image[x]]
                queue.append(y)
    unsettled = {image[x] for x, y in enumerate(folded.alpha) if x == y}
    if not unsettled:
        return []
    named = [f"dart {dart} of {story.vertex(dart)}" for dart in sorted(unsettled)]
    if len(named) > NAMED:
        named[NAMED:] = [plural(len(named) - NAMED, "other dart")]
    open_ = f"where {listed(named)} {'lead' if len(named) > 1 else 'leads'}"
    copies = Counter(story.vertex(image[group[0]]) for group in cycles(folded.sigma))
    twice = [f"{vertex} in {count} ways" for vertex, count in sorted(copies.items()) if count > 1]
    told = [f"After this walk it is not known {open_}."]
    if twice:
        one = "each of these" if len(twice) > 1 else "this"
        told.append(
            f"The robot came to {listed(twice)}, and the log does not show that {one} is one "
            "vertex."
        )
    return told
