"""The explanation of each law by the law's name.

``TELLERS`` is **the** table.  A new law is explained by a function from a :class:`Story` to a
:class:`Telling` beside its kin here, and an entry of the table.
"""

from __future__ import annotations

import re

from allworlds.explorers import is_program
from allworlds.inputs import an_integer
from allworlds.judging.explanations.another_world import another_world
from allworlds.judging.explanations.parting import tell_open_darts, tell_parting
from allworlds.judging.explanations.slips import tell_rounds, telling_line, the_slip
from allworlds.judging.explanations.spending import spending
from allworlds.judging.explanations.story import Belief, Story, Teller, Telling
from allworlds.judging.explanations.whose_bound import tell_whose_bound, tell_whose_budget
from allworlds.judging.explanations.wrong_pose import tell_pose
from allworlds.maps import CombinatorialMap
from allworlds.protocol import BUILT, NO_MAP
from allworlds.words import plural, size

GUESSED = "guessed"
"""The cause of a wrong answer that is no slip in drawing the map."""

FLUSH = (
    "Does the program flush its output after every line? A line in a buffer is silence, and so is "
    "an endless loop."
)
"""The question about a program that was silent for too long."""

NEWLINE = "Does every line of the program end in a newline? Until it does, it is not read."
"""The question about one that has begun a line."""

NO_ACTION = ("a line that is no JSON", "a line that is no object", "it has none of the keys")
"""Words of the observation of a program that prints anything else than actions."""

LATE = ("a line before it was asked", "a line after its answer")
"""Words of the observation of a program that prints when it is not its turn."""

STDOUT = "The program's stdout is for its actions alone: output for debugging goes to stderr."
"""The advice for it."""

PANIC = "panicked at"
"""Words by which a program in Rust says itself why and where it ends."""

OUTSIDE = re.compile(r"\(signal (6|7|8|11)\)")
"""The end of a process by what it does to memory: SIGABRT, SIGBUS, SIGFPE, SIGSEGV."""

SHOW = (
    "A checkpoint after each edge would show the first wrong S; where the explorer shows them, all "
    "of them fit the world."
)
"""The advice for a walk without an end and without a wrong checkpoint."""

UNDEFINED = (
    "Was a value undefined: a return that was forgotten, or a generator that had ended already?"
)
"""The question about an empty object, which is how JavaScript writes such a value."""

ANTICLOCKWISE = (
    "A frequent cause is a bearing, a motion or a way back that is counted anticlockwise; all of "
    "them count darts clockwise."
)
"""The advice for an answer that is no map."""

SANITIZER = (
    "Mostly that is an access outside of an array, or to memory that was freed, and it may have "
    "come long before: compile with -g -fsanitize=address,undefined to see the line."
)
"""The advice for such an end."""

KEPT = (
    "Does it keep something from an earlier run: a global or static variable, or a field that is "
    "not reset when an episode begins? Does it go by chance, by time or by addresses?"
)
"""The questions about an explorer that does not repeat itself."""

# ---------------------------------------------------------------- the run ended too early


def ending(how: str) -> Teller:
    """Tell how the run ended, in that sentence, then its last step and the last percept."""

    def tell(story: Story) -> Telling:
        line = telling_line(story.finding.detail)
        why = [f"Its last message: {line}"] if line not in str(story.finding.seen) else []
        wrong = _tell_first_wrong(story)
        return Telling([how, *wrong, _say_last_step(story), *why], story.checkpoint)

    return tell


def tell_crash(story: Story) -> Telling:
    """Tell the error, then the last step; for damaged memory how its place is found."""
    told = ending(f"The explorer crashed: {story.finding.seen}.")(story)
    if OUTSIDE.search(str(story.finding.seen)):
        said = f"{story.finding.detail}\n{story.finding.output}"
        panic = PANIC in said
        told.sentences.insert(1, f"It said: {telling_line(said)}" if panic else SANITIZER)
    return told


def tell_no_estimate(story: Story) -> Telling:
    """Tell the ending, and for a map that could not be built the law of maps that it breaks."""
    seen = str(story.finding.seen)
    if not seen.startswith(NO_MAP):
        return ending("The explorer ended without an answer that could be judged.")(story)
    built = [line for line in story.finding.detail.splitlines() if line.startswith(BUILT)]
    message = seen.removeprefix(NO_MAP)
    told = [f"The answer is no map: {message}."]
    if built:
        told = [f"The explorer tried to build a map that breaks a law of maps: {message}."]
        told += [f"The call is {line.removeprefix(BUILT)}." for line in built]
    if built and "must be a permutation" in message and not story.finding.misreading:
        told.append(ANTICLOCKWISE)
    told += _tell_first_wrong(story)
    return Telling([*told, _say_last_step(story)], story.checkpoint)


def tell_illegal_action(story: Story) -> Telling:
    """Tell the ending, and for a line that is no action what stdout is for."""
    told = ending("The explorer did what no robot can do here.")(story)
    seen = str(story.finding.seen)
    if is_program(story.finding.explorer) and seen.startswith("the line {}:"):
        told.sentences.insert(1, UNDEFINED)
    elif is_program(story.finding.explorer) and any(words in seen for words in NO_ACTION):
        told.sentences.insert(1, STDOUT)
    return told


def tell_nondeterministic(story: Story) -> Telling:
    """Tell that two plays differ, and what is mostly the cause."""
    told = ["In a second run of the same world the explorer acted differently."]
    seen = str(story.finding.seen)
    if is_program(story.finding.explorer) and any(words in seen for words in LATE):
        told.append(STDOUT)
    else:
        told.append(KEPT)
    return Telling([*told, _say_last_step(story)])


def tell_timeout(story: Story) -> Telling:
    """Tell the ending, and that a program may be waiting with its line in a buffer."""
    told = ending("The explorer was silent for too long.")(story)
    if is_program(story.finding.explorer):
        begun = "of one)" in str(story.finding.seen)
        told.sentences.insert(1, NEWLINE if begun else FLUSH)
    return told


def tell_budget(story: Story) -> Telling:
    """Tell whose the budget is, and whether the robot went round, or found no new edge."""
    how = "The explorer did not end within its step budget, so the run was stopped."
    wrong = _tell_first_wrong(story)
    if wrong or story.finding.misreading:  # that is the cause
        return Telling([*wrong, how], story.checkpoint)
    if str(story.finding.seen).startswith("checkpoint "):
        why = [f"After step {len(story.transcript.actions)} it only showed checkpoints."]
    else:
        why = tell_rounds(story) or [_say_last_step(story)]
        if story.finding.rules.task.is_map:
            why = [*why, SHOW]
    return Telling([how, *why, tell_whose_budget(story.finding)], story.checkpoint)


def _tell_first_wrong(story: Story) -> list[str]:
    """Tell the first checkpoint with a wrong S; no sentence where there is none."""
    if story.checkpoint is None:
        return []
    step = story.checkpoint
    what = story.finding.wrong_checkpoint or "it shows another S than the explored part"
    told = (
        f"The checkpoint after step {step} is wrong already: {what}. Mend that first: all that "
        "followed may be built on it."
    )
    return [told]


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
    """Tell the sizes of both maps, and the step where the walks in them diverge."""
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


def tell_ambiguity(story: Story) -> Telling:
    """Tell the quotient that the answer should have been, or that it should have been a map."""
    broken = (
        "The answer says that several worlds look alike, and what they have in common: the "
        "quotient in which darts are one that nothing tells apart, rooted at the robot's."
    )
    stands = f"In the world the robot stands at {story.place(story.walked[-1])}."
    return Telling([broken, stands])


# ---------------------------------------------------------------- a checkpoint is wrong


def tell_invariant_1(story: Story) -> Telling:
    """Tell the checkpoint that shows a wrong S."""
    broken = "What was published as S, the explored part, does not lie so in the world."
    return Telling(_tell_checkpoint(broken, story), story.checkpoint)


def tell_invariant_2(story: Story) -> Telling:
    """Tell the checkpoint that shows a wrong U."""
    broken = "What was published as U, the unexplored darts, holds one that is explored."
    return Telling(_tell_checkpoint(broken, story), story.checkpoint)


def tell_variant(story: Story) -> Telling:
    """Tell the checkpoint without progress; its S may be right, so no step of divergence."""
    broken = (
        "A pass brought no progress: from one checkpoint to the next S, the explored part, must "
        "gain an edge, and at the last one it must have them all."
    )
    return Telling(_tell_checkpoint(broken, story))


def _tell_checkpoint(broken: str, story: Story) -> list[str]:
    sentences = [broken]
    step = story.checkpoint
    if step is not None:
        sentences.append(
            f"The checkpoint came after step {step}, where the robot stood at "
            f"{story.place(story.walked[step])}, and had sensed '{story.sensed[step]}'."
        )
    return sentences


# ---------------------------------------------------------------- the answer was guessed, or dear


def tell_folding(story: Story) -> Telling:
    """Tell the open darts of the log, and another world that agrees with it."""
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
    """Tell that the answer is right, whose bound was exceeded, and the uses of the traversals."""
    spent = spending(story, an_integer("expected", story.finding.expected))
    traversals = plural(spent.cost, "traversal")
    out = spent.cost - spent.back
    told = [
        *tell_whose_bound(story.finding),
        f"The robot made {traversals}: {out} forward and {spent.back} back along the way it came.",
        f"Of those forward {len(spent.found)} found a new edge.",
    ]
    return Telling(told, spent=spent)


# ---------------------------------------------------------------- the table


TELLERS: dict[str, Teller] = {
    "crash": tell_crash,
    "timeout": tell_timeout,
    "illegal-action": tell_illegal_action,
    "no-estimate": tell_no_estimate,
    "budget": tell_budget,
    "nondeterministic": tell_nondeterministic,
    "map": tell_map,
    "pose": tell_pose,
    "ambiguity": tell_ambiguity,
    "task": ending("The explorer did not do what the task asks for."),
    "invariant-1": tell_invariant_1,
    "invariant-2": tell_invariant_2,
    "variant": tell_variant,
    "folding": tell_folding,
    "bound": tell_bound,
}
"""The explanation of each law of the judge, in the judge's order."""


def teller_of(law: str) -> Teller:
    """The explanation of a law; for a law without an entry, no more than its name."""
    return TELLERS.get(law) or ending(f"The law '{law}' is broken.")
