"""The explanation of each law by the law's name.

``TELLERS`` is **the** table.  A new law is explained by a function from a :class:`Story` to a
:class:`Telling` beside its kin here, and an entry of the table.
"""

from __future__ import annotations

from allworlds.explorers import is_program
from allworlds.inputs import InputError, an_integer
from allworlds.judging.explanations.another_world import another_world
from allworlds.judging.explanations.parting import tell_open_darts, tell_parting
from allworlds.judging.explanations.rounds import tell_rounds
from allworlds.judging.explanations.slips import the_slip
from allworlds.judging.explanations.spending import spending
from allworlds.judging.explanations.story import Belief, Story, Teller, Telling
from allworlds.judging.explanations.traceback_line import telling_line
from allworlds.judging.laws.invariants import at_checkpoint
from allworlds.maps import CombinatorialMap, Dart, carries, numbering
from allworlds.words import plural, size

GUESSED, TURNED, ELSEWHERE = "guessed", "off by a turn", "another vertex"
"""What makes all the difference where it is no slip in drawing the map."""

FLUSH = "Does the program flush its output after every line? A line in a buffer is silence."
"""What is asked of a program that was silent for too long."""

# ---------------------------------------------------------------- the run ended too early


def ending(how: str) -> Teller:
    """Tells how the run ended, in that sentence, then its last step and what was seen."""

    def tell(story: Story) -> Telling:
        line = telling_line(story.finding.detail)
        why = [f"What it wrote of it: {line}"] if line not in str(story.finding.seen) else []
        return Telling([how, _say_last_step(story), story.expected_and_seen(), *why])

    return tell


def tell_timeout(story: Story) -> Telling:
    """As of every ending; of a program that it may be waiting with its line in a buffer."""
    told = ending("The explorer was silent for too long.")(story)
    if is_program(story.finding.explorer):
        told.sentences.insert(1, FLUSH)
    return told


def tell_budget(story: Story) -> Telling:
    """Whether the robot went round, or since when it found nothing new."""
    how = "The explorer went on for longer than it may."
    rounds = tell_rounds(story)
    return Telling([how, *(rounds or [_say_last_step(story)]), story.expected_and_seen()])


def _say_last_step(story: Story) -> str:
    steps, place = story.transcript.steps, story.place(story.walked[-1])
    if not steps:
        return f"It made no step: it stood at the start, {place}, and sensed '{story.sensed[0]}'."
    action, percept = steps[-1]
    return (
        f"Its last step was step {len(steps)}, {action}: to {place}, where it sensed '{percept}'."
    )


# ---------------------------------------------------------------- the answer is wrong


def tell_map(story: Story) -> Telling:
    """How large both maps are, and where the walks in them part."""
    belief = Belief(story)
    slip, parting = the_slip(belief), tell_parting(belief)
    name = slip.name if slip else ""
    if slip:
        told = [slip.sentence, *parting]
    elif belief.parting is None:
        told, name = parting, GUESSED
    else:
        told = [_say_sizes(story.map, belief.answer.map), *parting]
    return Telling(told, belief.step, belief.answer, slip=name)


def _say_sizes(world: CombinatorialMap, answer: CombinatorialMap) -> str:
    if _size(world) == _size(answer):
        return f"The answer has {_size(answer)}, as the world has, but is another map."
    return f"The world has {_size(world)}, the answer {_size(answer)}."


def _size(map_: CombinatorialMap) -> str:
    return size(map_.edge_count, map_.vertex_count)


def tell_pose(story: Story) -> Telling:
    """Where the robot is and where it believes to be, and where the walks to there part."""
    belief = Belief(story)
    images = _images(belief)
    slip = the_slip(belief)
    turned = story.map.vertex_of[story.walked[-1]] in {story.map.vertex_of[d] for d in images}
    right = "This map is its own mirror image, and it may be" if slip else "The map is right, it is"
    alike = len(images) - 1
    symmetry = f" (the map is symmetric: {plural(alike, 'other dart')} would do as well)"
    sentences = [
        *([slip.sentence] if slip else []),
        f"{right} 'here' that is wrong: {_say_where(belief, images)}{symmetry if alike else ''}.",
        *tell_parting(belief),
    ]
    name = slip.name if slip else TURNED if turned else ELSEWHERE
    return Telling(sentences, belief.step, belief.answer, slip=name)


def _images(belief: Belief) -> list[Dart]:
    """The darts of the world that ``here`` can stand for: one, or more by symmetry."""
    answer, map_ = belief.answer, belief.story.map
    sigma, alpha = answer.map.sigma, answer.map.alpha
    order = numbering(sigma, alpha, answer.here)
    images = [d for d in map_.darts if carries(sigma, alpha, order, map_.sigma, map_.alpha, d)]
    if not images:
        raise InputError("the finding's answer is not the map of its world, so its law is not pose")
    return images


def _say_where(belief: Belief, images: list[Dart]) -> str:
    """Where the robot stands, and where the answer says that it stands."""
    story = belief.story
    map_, robot = story.map, story.walked[-1]
    stands = f"the robot stands at {story.place(robot)}, and the answer says"
    parting = belief.parting
    meant = parting.taken_for if parting and parting.step == len(story.walked) - 1 else None
    near = [d for d in images if map_.vertex_of[d] == map_.vertex_of[robot]]
    if not near:
        said = map_.alpha[robot] if map_.alpha[robot] in images else images[0]
        told = f"{stands} {story.place(said)}, which is another vertex"
    else:
        said = meant if meant in near else min(near, key=lambda d: map_.offset(d, robot))
        turned, degree = map_.offset(said, robot), map_.degree_at[robot]
        told = (
            f"{stands} dart {said} of the same vertex, off by a turn of {turned} of {degree} darts"
        )
    far = "; that is the far end of the edge by which it came"
    return told + (far if said == map_.alpha[robot] and len(story.walked) > 1 else "")


def tell_ambiguity(story: Story) -> Telling:
    """The quotient that the answer should have been, or that there should have been a map."""
    broken = (
        "The answer says that several worlds look alike, and what they have in common: the "
        "quotient in which darts are one that nothing tells apart, rooted at the robot's."
    )
    stands = f"In the world the robot stands at {story.place(story.walked[-1])}."
    return Telling([broken, stands, story.expected_and_seen()])


# ---------------------------------------------------------------- a checkpoint is wrong


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
    broken = (
        "A pass brought no progress: from one checkpoint to the next S, the explored part, must "
        "gain an edge, and at the last one it must have them all."
    )
    return Telling(_tell_checkpoint(broken, story))


def _tell_checkpoint(broken: str, story: Story) -> list[str]:
    sentences = [broken]
    step, seen = story.checkpoint, str(story.finding.seen)
    if step is not None:
        when = at_checkpoint(step)
        seen = seen.removeprefix(f"{when}: ").removesuffix(f" {when}")
        sentences.append(
            f"The checkpoint came after step {step}, where the robot stood at "
            f"{story.place(story.walked[step])}, and had sensed '{story.sensed[step]}'."
        )
    return [*sentences, f"Expected was: {story.finding.expected}; seen was: {seen}."]


# ---------------------------------------------------------------- the answer was guessed, or dear


def tell_folding(story: Story) -> Telling:
    """What the log leaves open, and another world that agrees with it."""
    guessed = "The log does not determine the map, so the answer, right or not, was guessed."
    other = another_world(story.world, story.transcript)
    assert other is not None
    there = (
        f"Another world agrees with the log as well: one with "
        f"{size(other.map.edge_count, other.map.vertex_count)}, in which the robot would have "
        "sensed the same."
    )
    return Telling([guessed, there, *tell_open_darts(story)], other=other)


def tell_bound(story: Story) -> Telling:
    """What the bound allows, and what the traversals were spent on."""
    spent = spending(story, an_integer("expected", story.finding.expected))
    name = story.finding.rules.the_bound.name
    traversals = plural(spent.cost, "traversal")
    out = spent.cost - spent.back
    told = [
        f"The world has {_size(story.map)}, for which the bound ({name}) allows {spent.bound}.",
        f"The robot made {traversals}: {out} out, {spent.back} to take one back.",
        f"Of those out {len(spent.found)} went along an edge that was new.",
    ]
    return Telling(told, spent=spent)


# ---------------------------------------------------------------- the table


TELLERS: dict[str, Teller] = {
    # A run that ended before it could be judged has one sentence of its own.
    "crash": ending("The explorer crashed."),
    "timeout": tell_timeout,
    "illegal-action": ending("The explorer did what no robot can do here."),
    "no-estimate": ending("The explorer ended without an answer that could be judged."),
    "budget": tell_budget,
    "nondeterministic": ending("Exploring the same world again, the explorer did something else."),
    "map": tell_map,
    "pose": tell_pose,
    "ambiguity": tell_ambiguity,
    "invariant-1": tell_invariant_1,
    "invariant-2": tell_invariant_2,
    "variant": tell_variant,
    "folding": tell_folding,
    "bound": tell_bound,
}
"""What each law of the judge has to tell, in the judge's order."""


def teller_of(law: str) -> Teller:
    """What the law has to tell; of a law that has no entry, no more than its name."""
    return TELLERS.get(law) or ending(f"The law '{law}' is broken.")
