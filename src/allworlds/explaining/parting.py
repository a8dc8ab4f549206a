"""Where belief and truth part, and what the log leaves open, in sentences."""

from __future__ import annotations

from collections import Counter

from allworlds.explaining.story import Belief, Story
from allworlds.findings import Parting
from allworlds.judge import fold
from allworlds.maps.combinatorial import cycles
from allworlds.words import darts


def tell_parting(belief: Belief) -> list[str]:
    """Where the walk and the same walk in the answer part, and how that could be sensed."""
    parting, misfits = belief.parting, belief.misfits
    sentences = ["Follow the log in the world and in the answer."]
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


def tell_open_darts(story: Story) -> list[str]:
    """The darts that the folded log leaves open, and the vertices that it has several times.

    Nothing where it leaves none open, or where the lighthouse allows no folding.
    """
    if not story.world.lighthouse.folds:
        return []
    folded, map_ = fold(story.transcript), story.map
    image = {0: story.world.start}
    for x in (queue := [0]):
        for y, true in ((folded.sigma[x], map_.sigma), (folded.alpha[x], map_.alpha)):
            if y not in image:
                image[y] = true[image[x]]
                queue.append(y)
    unsettled = sorted({image[x] for x, y in enumerate(folded.alpha) if x == y})
    if not unsettled:
        return []
    at: dict[str, list[str]] = {}
    for dart in unsettled:
        at.setdefault(story.vertex(dart), []).append(str(dart))
    names = "; ".join(f"{vertex}: {darts(open_)}" for vertex, open_ in at.items())
    leads = [
        f"dart {d} to dart {map_.alpha[d]} of {story.vertex(map_.alpha[d])}" for d in unsettled
    ]
    sentences = [
        f"It was never settled where these darts lead: {names}.",
        f"In the world they lead as follows: {', '.join(leads)}.",
    ]
    copies = Counter(story.vertex(image[group[0]]) for group in cycles(folded.sigma))
    for vertex, count in sorted(copies.items()):
        if count > 1:
            sentences.append(
                f"The robot came to {vertex} in {count} ways of which the log does not tell that "
                "they lead to one vertex."
            )
    return sentences
