"""The explanations of findings, one for each law.

``seen`` is the finding's value for what was found instead of the expected: the answer, a number, or
a text about what the explorer did.  The walk in the answer is the walk of the run with the same
actions, but in the answer's map; it diverges from the walk in the world at the first step at which
the answer and the world contradict each other.
"""

import re
from collections import Counter

from allworlds.inputs.checks import InputError
from allworlds.judging.belief import Parting
from allworlds.judging.explanations.advice import advice
from allworlds.judging.explanations.endless import tell_open, tell_round, tell_stack, tell_way_back
from allworlds.judging.explanations.story import (
    Belief,
    Story,
    Teller,
    Telling,
    Walked,
    bearings_anticlockwise,
    mirror_image,
    the_slip,
)
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws import bounds, folding
from allworlds.judging.laws.bounds import default_step_budget
from allworlds.maps.build import completed
from allworlds.maps.combinatorial import (
    CombinatorialMap,
    Dart,
    carries,
    cycles,
    numbering,
    rooted_isomorphism,
)
from allworlds.protocol import actions, playing
from allworlds.words import listed, plural, size
from allworlds.world.lighthouses.marked import Directional
from allworlds.world.world import World

# ---------------------------------------------------------------- the run ended too early


def _say_message(finding: Finding) -> list[str]:
    """Say the explorer's last message: the last line that names an error, or else the last line.

    The lines are those of the traceback, or of stderr.  Some crashes leave neither, for example a
    call of ``abort``; then the lines are those that the explorer printed.  The result is empty if
    there is no line, or if the last line is already a part of the finding's ``seen``.
    """
    said = finding.detail or (finding.output if finding.law == "crash" else "")
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    if not lines or lines[-1] in str(finding.seen):
        return []
    naming = [line for line in lines if re.search("error|exception|panic", line, re.IGNORECASE)]
    return [f"The explorer's last message: {(naming or lines)[-1]}"]


def ending(how: str) -> Teller:
    """The function that explains a run by its ending.

    The explanation begins with the sentence ``how``, which says how the run ended; in this sentence
    ``{seen}`` is replaced by the finding's ``seen``, the text about what the explorer did.  Further
    sentences name likely causes, the first wrong checkpoint, and the last step with its percept.
    """

    def tell(story: Story) -> Telling:
        finding = story.finding
        sentences = [how.format(seen=finding.seen), *advice(finding), *_tell_first_wrong(story)]
        sentences += tell_stack(finding)
        sentences += _say_left(story) if finding.law == "task" else []
        sentences += [] if story.checkpoint is not None else tell_way_back(story)
        sentences += [_say_last_step(story), *_say_message(finding)]
        return Telling(sentences, story.checkpoint)

    return tell


CLOCKWISE = "Bearings, motions and ways back count darts clockwise."
"""The reminder for an explorer that tried to build a map which is none."""


def tell_no_estimate(story: Story) -> Telling:
    """Say how the run ended; if the answer is no map, say which axiom of maps the answer breaks."""
    seen = str(story.finding.seen)
    if not seen.startswith(playing.NO_MAP):
        return ending("The explorer ended without an answer that could be judged.")(story)
    built = [line for line in story.finding.detail.splitlines() if line.startswith(playing.BUILT)]
    message = seen.removeprefix(playing.NO_MAP)
    sentences = [f"The answer is no map: {message}."]
    if built:
        sentences = [f"The explorer tried to build a map that breaks a law of maps: {message}."]
        sentences += [f"The call is {line.removeprefix(playing.BUILT)}." for line in built]
        if "must be a permutation" in message:
            sentences.append(CLOCKWISE)
    return Telling([*sentences, *_tell_first_wrong(story), _say_last_step(story)], story.checkpoint)


def tell_nondeterministic(story: Story) -> Telling:
    """Say that two plays of the run differ, and what the usual cause is."""
    how = "In a second run in the same world the explorer acted differently."
    if after := story.finding.earlier:
        before = listed([world.in_words for world in after])
        how = (
            "In this world the explorer acts differently in a new process and in a process in "
            f"which it has explored {before} before."
        )
    return Telling([how, *advice(story.finding), _say_last_step(story)])


SHOW = (
    "If the explorer shows its map in a checkpoint after each edge, the next report tells where "
    "the map first goes wrong."
)
"""The advice for a walk without an end and without a wrong checkpoint."""


def tell_budget(story: Story) -> Telling:
    """Explain a run that has exceeded its budget.

    If a checkpoint is wrong, name the first such checkpoint, as the cause.  Otherwise say after
    which step the robot found no new edge, what it repeated or left out, and where the budget comes
    from.
    """
    how = "The explorer did not end within its step budget, so the run was stopped."
    wrong = _tell_first_wrong(story)
    if wrong:  # that is the cause
        return Telling([*wrong, how], story.checkpoint)
    if str(story.finding.seen).startswith("checkpoint "):
        why = [f"After step {len(story.walk.actions)} it showed more checkpoints than are allowed."]
    else:
        is_map, found = story.finding.rules.task.is_map, tell_round(story)
        why = [_say_progress(story), *found, *tell_way_back(story)]
        why += tell_open(story) if is_map else _say_left(story)
        why += [SHOW] if is_map and not found else []
    return Telling([how, *why, tell_whose_budget(story.finding)], story.checkpoint)


def tell_whose_budget(finding: Finding) -> str:
    """Say where the step budget of a finding comes from: from ``--step-budget``, or from a bound.

    If the budget comes from a bound, and options are known under which no law is broken, name these
    options, too.
    """
    rules, map_ = finding.rules, finding.world.map
    if rules.step_budget is not None:
        return f"--step-budget sets the budget: {plural(rules.step_budget, 'traversal')}."
    value = rules.budget(map_)
    new, closing = bounds.paper_terms(map_.vertex_count, map_.edge_count)
    world = size(map_.edge_count, map_.vertex_count)
    origin = "the bound that the explorer names"
    if value == rules.budget_of_bound(map_.vertex_count, map_.edge_count):
        origin = f"which is 100 x the bound + 100; the bound is {rules.the_bound}"
    elif value == default_step_budget(new + closing):
        origin = f"which is 8 x ({new} + {closing}) + 100; {new} + {closing} is the paper's bound"
    budget = f"In a world with {world} the budget is {plural(value, 'traversal')}, {origin}."
    return " ".join([budget, *_say_tried(finding)])


def _say_tried(finding: Finding) -> list[str]:
    """Name the options in ``finding.tried``, with which the check was repeated and broke no law.

    The result is empty if there are no such options.
    """
    if not finding.tried:
        return []
    return [f"With {finding.tried} no law is broken, in this world and in all others tried."]


def _say_progress(story: Walked) -> str:
    """Say after which step the robot found no new edge any more.

    If the robot found no edge in the whole run, say where it was after its last step, and its
    percept there.
    """
    found_at = story.discoveries.values()
    if not found_at:
        return _say_last_step(story)
    step, left = f"After step {max(found_at)}", story.map.edge_count - len(found_at)
    if left:
        return f"{step} the robot found no new edge; {plural(left, 'edge')} stayed unknown."
    return f"{step} the robot had walked every edge of the world, but the explorer went on."


def _say_left(story: Story) -> list[str]:
    """Name the vertices or edges that the robot left out, if the task asks for all of them.

    The result is empty if the robot left out none, or under other tasks.
    """
    map_, left, task = story.map, list[str](), story.finding.rules.task.name
    if task in ("cover", "stop", "home"):
        visited = story.walk.visited
        left = [story.vertex(v[0]) for v in map_.vertices if map_.vertex_of[v[0]] not in visited]
    elif task == "cover:edges":
        left = story.unwalked
    if len(left) > NAMED:
        left[NAMED:] = [f"{len(left) - NAMED} more"]
    verb = "walked along" if task == "cover:edges" else "visited"
    return [f"The robot never {verb} {listed(left)}."] if left else []


def _tell_first_wrong(story: Story) -> list[str]:
    """Say which checkpoint is the first wrong one, and why; no sentence if none is wrong."""
    if (step := story.checkpoint) is None:
        return []
    what = story.finding.wrong_checkpoint or "its S is not the explored part"
    wrong = f"The checkpoint after step {step} is already wrong; in the numbers of its S: {what}."
    return [f"{wrong} Mend this first: later mistakes may follow from it."]


def _say_last_step(story: Walked) -> str:
    steps, spot = story.walk.steps, story.spot(story.walk.darts[-1])
    if not steps:
        start = story.in_words(story.sensed[0])
        return f"The robot made no step: it stood at the start, {spot}, and sensed '{start}'."
    action, percept = steps[-1]
    last = f"After the last step, {len(steps)} ({action}), the robot was at {spot}"
    return f"{last}, and sensed '{story.in_words(percept)}'."


# ---------------------------------------------------------------- the answer is wrong

GUESSED = "guessed"
"""The name for the cause of a wrong answer that fits the whole log, in place of a slip's name."""


def tell_map(story: Story) -> Telling:
    """Say how the answer differs from the world, and where the walks in both diverge.

    If a slip is found (one mistake that makes a right answer wrong), describe the slip; else say
    the numbers of edges and vertices of both maps.  If the walks never diverge, say that the answer
    fits the whole log.
    """
    belief = Belief(story)
    slip, parting = the_slip(belief), tell_parting(belief)
    name = slip.name if slip else ""
    if slip:
        sentences = [slip.sentence, *parting]
    elif belief.walk.parting is None:
        sentences, name = parting, GUESSED
    else:
        sentences = [_say_sizes(story.map, belief.answer.map), *parting]
    return Telling(sentences, belief.step, belief.answer, slip=name)


def _say_sizes(world: CombinatorialMap, answer: CombinatorialMap) -> str:
    first, second = (size(map_.edge_count, map_.vertex_count) for map_ in (world, answer))
    if first == second:
        return f"The answer has {second}, as the world has, but is another map."
    return f"The world has {first}, the answer {second}."


def tell_parting(belief: Belief) -> list[str]:
    """Say where the walk in the answer diverges from the walk in the world, and by which percept.

    If every percept fits the answer, say this, and name the open darts.
    """
    parting, misfits = belief.walk.parting, belief.walk.misfits
    if parting is None:
        fits = (
            "The answer is another world that fits the whole log: nothing that the robot sensed "
            "tells the two worlds apart, so the answer was guessed."
        )
        return [fits, *tell_open_darts(belief.story)]
    sentences = [_say_parting(belief, parting)]
    if parting.step in misfits:
        return sentences
    if misfits:
        step, misfit = misfits[0], _say_misfit(belief, misfits[0])
        sentences.append(f"The answer is first contradicted at step {step}: {misfit}.")
        return sentences
    sentences.append(
        "Every percept fits the answer, too: the walk was too short to tell the two maps apart."
    )
    return sentences + tell_open_darts(belief.story)


def _say_parting(belief: Belief, parting: Parting) -> str:
    """The sentence about ``parting``, the first step at which the walks diverge."""
    story = belief.story
    step, robot, taken_for = parting.step, parting.robot, parting.taken_for
    vertex = story.vertex(robot)
    misfit = _say_misfit(belief, step) if step in belief.walk.misfits else ""
    if step == 0:
        return f"The world and the answer differ at the start, at {vertex}: {misfit}."
    if parting.fresh:
        truth = f"At step {step} the robot came to {vertex} for the first time"
    elif type(story.walk.actions[step - 1]) is not actions.Move:
        truth = f"At step {step} the robot stayed at {vertex}"
    else:
        truth = f"At step {step} the robot was back at {vertex}, {story.last_left(robot, step)}"
    if taken_for == (None if parting.fresh else robot):
        return f"{truth}. In the answer this is so, too, but {misfit}."
    if taken_for is None:
        taken = "its answer takes this vertex for a new one"
    elif story.vertex(taken_for) != vertex:
        left = story.last_left(taken_for, step)
        taken = f"its answer takes this vertex for {story.vertex(taken_for)}, {left}"
    else:
        taken = f"in its answer it came in by dart {taken_for}, in truth by dart {robot}"
    return f"{truth}, but {taken}{': ' if misfit else ''}{misfit}."


def _say_misfit(belief: Belief, step: int) -> str:
    seen = belief.walk.expected[step], belief.story.sensed[step]
    expected, sensed = map(belief.story.in_words, seen)
    if belief.walk.percepts is None:
        lacks = f"the answer has {expected}, and its map has no place for the lighthouse"
        return f"the robot sensed '{sensed}', where {lacks}"
    return f"the robot sensed '{sensed}', where the answer predicts '{expected}'"


TURNED, ELSEWHERE = "off by a turn", "another vertex"
"""Two names for mistakes, in place of a slip's name: ``here`` is another dart of the robot's
vertex, or a dart of another vertex."""


def tell_pose(story: Story) -> Telling:
    """Say the robot's dart, the answer's ``here``, and where the walks in answer and world diverge.

    If bearings or rotations that count anticlockwise could be the cause, say that, too.
    """
    belief = Belief(story)
    images = _images(belief)
    alike, robot = len(images) - 1, story.walk.darts[-1]
    others = f"As the map is symmetric, {plural(alike, 'other dart')} would be right besides"
    where = f"{_say_where(belief, images)}{f' {others} dart {robot}.' if alike else ''}"
    turned = story.map.vertex_of[robot] in {story.map.vertex_of[d] for d in images}
    name = TURNED if turned else ELSEWHERE
    bearings = bearings_anticlockwise(belief)
    sentences = [f"The map is right, but 'here' is wrong: {where}"]
    if mirror_image(belief):
        causes = ["'here' is wrong", "sigma of the answer goes anticlockwise"]
        causes += ["the bearings are counted anticlockwise"] if bearings else []
        sentences = [
            f"Either {', or '.join(causes)}: {where}",
            "This world is its own mirror image, so a run here cannot show which mistake was made.",
        ]
    elif bearings:
        name = bearings.name
        sentences.append(f"Or: {bearings.sentence}")
    return Telling([*sentences, *tell_parting(belief)], belief.step, belief.answer, slip=name)


def _images(belief: Belief) -> list[Dart]:
    """The darts of the world for which the answer's ``here`` can stand.

    The answer's map equals the world's map; if this map is symmetric, there are several darts.

    Raises:
        InputError: if the two maps differ.
    """
    answer, map_ = belief.answer, belief.story.map
    sigma, alpha = answer.map.sigma, answer.map.alpha
    order = numbering(sigma, alpha, answer.here)
    images = [d for d in map_.darts if carries(sigma, alpha, order, map_.sigma, map_.alpha, d)]
    if not images:
        raise InputError("the finding's answer is not the map of its world, so its law is not pose")
    return images


def _say_where(belief: Belief, images: list[Dart]) -> str:
    """Say at which dart of the world the robot is, and at which dart it is by the answer.

    ``images`` are the darts that :func:`_images` has returned; one of them is named.
    """
    story = belief.story
    map_, robot = story.map, story.walk.darts[-1]
    stands = f"the robot stands at {story.spot(robot)}; the answer says"
    parting = belief.walk.parting
    meant = parting.taken_for if parting and parting.step == len(story.walk.darts) - 1 else None
    near = [d for d in images if map_.vertex_of[d] == map_.vertex_of[robot]]
    if not near:
        said = map_.alpha[robot] if map_.alpha[robot] in images else images[0]
        where = f"{stands} {story.spot(said)}."
    else:
        said = meant if meant in near else min(near, key=lambda d: map_.offset(d, robot))
        turned, degree = map_.offset(said, robot), map_.degree_at[robot]
        back = degree - turned
        darts, way = (turned, "anticlockwise") if turned < back else (back, "clockwise")
        where = f"{stands} dart {said} of the same vertex, {plural(darts, 'dart')} too far {way}."
    if said != map_.alpha[robot] or not story.walk.cost:
        return where
    return f"{where} Dart {said} is the other end of the edge by which the robot came."


def tell_ambiguity(story: Story) -> Telling:
    """Say that the answer had to be the rooted quotient, and where the robot is in the world."""
    broken = (
        "The answer says that several worlds look alike. Then it must be the quotient of these "
        "worlds, where darts that look alike are one dart, rooted at the robot's dart."
    )
    stands = f"In the world the robot stands at {story.spot(story.walk.darts[-1])}."
    return Telling([broken, stands])


# ---------------------------------------------------------------- a checkpoint is wrong


TOO_EARLY = "The explorer ended too early: the S of its last checkpoint lacks edges of the world."
"""The explanation of the law ``variant`` in a run whose checkpoints all gain edges."""


def checkpoint(broken: str) -> Teller:
    """The function that explains a run by the checkpoint that breaks a law.

    The explanation is the sentence ``broken``, which says what is wrong, and a sentence that says
    after which step the checkpoint came.
    """

    def tell(story: Story) -> Telling:
        sentences, step = [broken], story.checkpoint
        if step is None:
            sentences = [TOO_EARLY]
        else:
            sentences.append(
                f"The checkpoint came after step {step}, where the robot stood at "
                f"{story.spot(story.walk.darts[step])}, and had sensed "
                f"'{story.in_words(story.sensed[step])}'."
            )
        # If a pass makes no progress, S may be right; then the walks do not diverge.
        return Telling(sentences, None if story.finding.law == "variant" else step)

    return tell


# ---------------------------------------------------------------- the answer was guessed, or dear


NAMED = 3
"""The largest number of open darts, vertices or edges that are named; the others are counted."""


def tell_open_darts(story: Story) -> list[str]:
    """Name the open darts of the folded log, and the vertices that occur in it more than once.

    The result is empty if no dart is open, or if the lighthouse is none under which logs are
    folded.
    """
    if not story.world.lighthouse.as_kind.folds:
        return []
    folded, map_ = folding.fold(story.walk.transcript), story.map
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
    twice = [f"{vertex} by {count} paths" for vertex, count in sorted(copies.items()) if count > 1]
    sentences = [f"After this walk it is not known {open_}."]
    if twice:
        one = "each of these" if len(twice) > 1 else "this"
        sentences.append(
            f"The robot came to {listed(twice)}, and the log does not show that {one} was always "
            "the same vertex."
        )
    return sentences


def another_world(world: World, transcript: actions.Transcript) -> World | None:
    """Another world than ``world`` that agrees with the log; None if the log determines the world.

    The other world is the folded log with a new vertex of degree 1 at the end of each open dart.
    If this is ``world`` again, the first new vertex gets a second edge, to one more new vertex.
    None of the new edges is a loop.  ``transcript`` is the log of a run in ``world``.

    Cost: the folding, and linear in the log.
    """
    folded, bearing = folding.fold(transcript), transcript.first.bearing
    if not folded.open_darts:
        return None
    assert bearing is not None
    sigma, alpha = [*folded.sigma], [*folded.alpha]
    map_ = completed(sigma, alpha)
    if rooted_isomorphism(map_, 0, world.map, world.start):
        longer = next(dart for dart, end in enumerate(alpha) if dart == end)
        alpha[longer] = new = len(sigma)
        sigma += [new + 1, new]
        map_ = completed(sigma, [*alpha, longer, new + 1])
    return World(map_, Directional(map_.turn(0, bearing)), 0)


def tell_folding(story: Story) -> Telling:
    """Say that another world agrees with the log, and name the open darts of the folded log."""
    guessed = "The log does not determine the map, so the answer, right or not, was guessed."
    other = another_world(story.world, story.walk.transcript)
    assert other is not None
    there = (
        f"Another world agrees with the log as well: one with "
        f"{size(other.map.edge_count, other.map.vertex_count)}, in which the robot would have "
        "sensed the same."
    )
    return Telling([guessed, there, *tell_open_darts(story)], other=other)


def tell_bound(story: Story) -> Telling:
    """Explain a walk that is longer than the bound.

    Say which other laws hold, where the bound comes from, and how many edges the walk found.
    """
    made, new = plural(story.walk.cost, "traversal"), len(story.discoveries)
    used = f"The robot made {made}, of which {new} found a new edge."
    return Telling([*tell_whose_bound(story.finding), used])


def tell_whose_bound(finding: Finding) -> list[str]:
    """Say which laws other than ``bound`` hold, and where the bound comes from.

    If options are known under which no law is broken, name these options, too.
    """
    others = [law for law in finding.rules.applying if law != "bound"]
    rest = f"every other law that was checked holds: {listed(others)}" if others else ""
    if {"map", "pose"} <= {*others}:
        right = "The map and the pose are right; the walk is longer than the bound allows."
    else:
        right = f"The walk is longer than the bound allows{'; ' if rest else ''}{rest}."
    return [right, _whose(finding), *_say_tried(finding)]


def _whose(finding: Finding) -> str:
    rules, map_ = finding.rules, finding.world.map
    name, value = rules.the_bound.name, finding.expected
    world = size(map_.edge_count, map_.vertex_count)
    new, closing = bounds.paper_terms(map_.vertex_count, map_.edge_count)
    paper = (
        "(1) + (2), which the paper proves for its Algorithm 1 in Section VI: (1) is the cost of "
        "passes that find a new vertex, (2) that of passes that join two known vertices"
    )
    sums = f"In a world with {world} (1) + (2) is {new} + {closing}"
    if name == "paper":
        return f"The bound 'paper' is {paper}. {sums} = {value}."
    if name == "two-vertices":
        return (
            "The bound 'two-vertices' is (1) + (2) + (two traversals for each test of a "
            "hypothesis) + (the search at the start for the dart to v1). The bound 'paper' is "
            f"{paper}. {sums}, and the bound 'two-vertices' is {value}."
        )
    own = rules.the_bound == rules.own_bound
    owner = "The explorer's own bound" if own else "The bound that was asked for"
    which = "" if name == str(value) else f", which is {value} in a world with {world}"
    return f"{owner} is {name}{which}."


# ---------------------------------------------------------------- the table


TELLERS: dict[str, Teller] = {
    "crash": ending("The explorer crashed: {seen}."),
    "timeout": ending("The explorer was silent for too long."),
    "illegal-action": ending("What the explorer sent last is not legal here."),
    "no-estimate": tell_no_estimate,
    "budget": tell_budget,
    "nondeterministic": tell_nondeterministic,
    "map": tell_map,
    "pose": tell_pose,
    "ambiguity": tell_ambiguity,
    "task": ending("The explorer did not do what the task asks for."),
    "invariant-1": checkpoint("S is not the explored part, or 'here' is not the robot's dart."),
    "invariant-2": checkpoint(
        "The U of a checkpoint must hold only unexplored darts, but it holds an explored one."
    ),
    "variant": checkpoint("S must gain an edge from each checkpoint to the next; here it did not."),
    "folding": tell_folding,
    "bound": tell_bound,
}
"""The explanation of each law, in the order of precedence."""


def teller_of(law: str) -> Teller:
    """The function that explains a violation of ``law``.

    For a law that is not in :data:`TELLERS`, the explanation only names the law and says how the
    run ended.
    """
    return TELLERS.get(law) or ending(f"The law '{law}' is broken.")
