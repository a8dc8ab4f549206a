"""What is said of runs without a wrong answer, in worlds and of walks that are made by hand.

The numbers that are expected follow from the drawings, and not from a report.
"""

import pytest

from allworlds import Checkpoint, Estimate, Move
from allworlds.documents.document import replace
from allworlds.judging.belief import believed_percepts
from allworlds.judging.explanations.advice import FLUSH, KEPT, NO_LINE, SANITIZER, STDOUT, UNWRITTEN
from allworlds.judging.explanations.by_law import (
    NAMED,
    SHOW,
    tell_whose_bound,
    tell_whose_budget,
)
from allworlds.judging.rules import Rules
from allworlds.judging.walk import Walk
from allworlds.maps import CombinatorialMap
from allworlds.protocol.actions import Drop, Pick, Write
from allworlds.studies.explain import explain
from allworlds.studies.run import run
from allworlds.world import Directional, Movable, World, world_named
from small import EDGE, LASSO, PATH

PATH_OF_3 = World(PATH, Directional(0), 0)
"""v0 --01-- v1 --23-- v2"""

LEAVES = CombinatorialMap((1, 2, 3, 4, 5, 0, *range(6, 12)), (*range(6, 12), *range(6)))
STAR = World(LEAVES, Directional(0), 0)
"""Round v0 the darts 0 to 5; dart d leads to the leaf v(d + 1), whose only dart is d + 6."""

LEAFY_LOOP = World(LASSO, Directional(0), 0)
"""Round v0 the darts 0 and 1 of a loop, then dart 2, which leads to v1 and its dart 3."""


def walking(*actions, answer=None, then=None):
    def explore(_):
        yield from (action for action in actions)
        while then:
            yield then
        return answer

    return explore


def found(explore, world, **rules):
    return run(explore, world, **rules).finding


def told(explore, world, **rules):
    return [*explain(found(explore, world, **rules)).sentences]


# ---------------------------------------------------------------- where it was


def test_the_last_step_is_told_with_its_place_and_percept():
    # Out of the middle by 2, which leads to v2 with its one dart.
    (_, last) = told(walking(Move(0), Move(1)), PATH_OF_3)
    assert (
        last
        == "After the last step, 2 (move 1), the robot was at v2, dart 3, and sensed 'degree 1'."
    )
    (_, start) = told(walking(), PATH_OF_3)
    assert start == (
        "The robot made no step: it stood at the start, v0, dart 0, and sensed 'degree 1, marked, "
        "bearing 0'."
    )


def test_a_named_vertex_is_told_by_its_name_alone():
    named = World.from_json(PATH_OF_3.to_json() | {"names": ["hall", "stairs", "loft"]})
    (_, last) = told(walking(Move(0)), named)
    assert "was at stairs, dart 1, and" in last


# ---------------------------------------------------------------- what it left out


def test_the_vertices_that_were_never_visited_are_named_up_to_some_number():
    # By the darts 1 and 3 of v0 the robot comes to v2 and v4.
    two = [Move(1), Move(0), Move(2), Move(0)]
    assert NAMED == 3
    said = told(walking(*two, answer=1), STAR, task="cover")
    assert said[1] == "The robot never visited v1, v3, v5 and 1 more."
    three = [*two, Move(1), Move(0)]  # by dart 4 to v5
    said = told(walking(*three, answer=1), STAR, task="stop")
    assert said[1] == "The robot never visited v1, v3 and v6."
    (_, last) = told(walking(Move(0), answer=1), PATH_OF_3, task="home")[1:]
    assert last.startswith("After the last step")
    missed = told(walking(Move(0), answer=1), PATH_OF_3, task="home")[1]
    assert missed == "The robot never visited v2."


def test_the_edges_that_were_never_walked_along_are_named_and_no_other():
    # By the first and the third dart of v0; a finding has darts of its own.
    finding = found(walking(Move(0), Move(0), Move(2), answer=1), STAR, task="cover:edges")
    (left,) = [line for line in explain(finding).sentences if "walked along" in line]
    map_ = finding.world.map
    darts = {k: map_.turn(finding.world.start, k) for k in (1, 3, 4)}
    alpha = map_.alpha
    ends = [
        f"the edge from dart {d} of v0 to dart {alpha[d]} of v{k + 1}" for k, d in darts.items()
    ]
    assert left == f"The robot never walked along {', '.join(ends)} and 1 more."
    said = told(walking(Move(0), answer=1), PATH_OF_3, task="cover:edges")
    assert said[1] == "The robot never walked along the edge from dart 2 of v1 to dart 3 of v2."


def test_who_drops_a_marker_has_walked_along_no_edge():
    world = World(EDGE, Movable(), 0)
    said = told(walking(Drop(), answer=1), world, task="cover:edges")
    assert said[1] == "The robot never walked along the edge from dart 0 of v0 to dart 1 of v1."


@pytest.mark.parametrize("task", ["cover", "cover:edges"])
def test_who_left_nothing_out_is_told_of_nothing(task):
    finding = found(walking(answer=1), PATH_OF_3, task=task)
    all_ = found(walking(Move(0), Move(1), answer=1), PATH_OF_3)
    whole = replace(finding, transcript=all_.transcript)
    assert not [line for line in explain(whole).sentences if "never" in line]


# ---------------------------------------------------------------- how it ended


@pytest.mark.parametrize(
    ("law", "seen", "explorer", "said"),
    [
        ("crash", "its process (signal 11)", "native:./a.so", SANITIZER),
        ("crash", "its process (signal 6)", "native:./a.so", None),
        ("timeout", "silent (signal 11)", "native:./a.so", None),
        ("timeout", "silent", "exec:./a", FLUSH),
        ("timeout", "silent", "a.py:a", None),
        ("illegal-action", "a line that is no JSON", "exec:./a", STDOUT),
        ("illegal-action", "the line 'x'", "exec:./a", STDOUT),
        ("illegal-action", r"a line that is no JSON: '{\x00\"\x00'", "exec:./a", NO_LINE[0][1]),
        ("illegal-action", "a line that is no JSON: ''", "exec:./a", NO_LINE[1][1]),
        ("illegal-action", r"a line that is no JSON: '  \r'", "exec:./a", NO_LINE[1][1]),
        ("illegal-action", "a line that is no JSON: '{'", "exec:./a", NO_LINE[2][1]),
        ("illegal-action", "a line that is no JSON: '{\"move\": 1'", "exec:./a", NO_LINE[2][1]),
        ("illegal-action", "a line that is no JSON: '{move: 1}'", "exec:./a", STDOUT),
        ("illegal-action", "a Drop", "exec:./a", None),
        ("illegal-action", "the line 'x'", "a.py:a", None),
        ("nondeterministic", "the line 'x'", "exec:./a", STDOUT),
        ("nondeterministic", "another move", "exec:./a", KEPT),
        ("nondeterministic", "the line 'x'", "a.py:a", KEPT),
        ("nondeterministic", "another move", "native:./a.so", UNWRITTEN),
        ("task", "the line 'x'", "exec:./a", None),
    ],
)
def test_each_kind_of_end_has_the_advice_that_is_about_it(law, seen, explorer, said):
    finding = replace(found(walking(), PATH_OF_3), law=law, seen=seen, explorer=explorer)
    known = {SANITIZER, FLUSH, STDOUT, KEPT, UNWRITTEN, *(said for _, said in NO_LINE)}
    given = [line for line in explain(finding).sentences if line in known]
    expected = [] if said is None else [KEPT, UNWRITTEN] if said == UNWRITTEN else [said]
    assert given == expected
    last = "The robot made no step: it stood at the start, v0, dart 0, and sensed"
    assert [line.startswith(last) for line in explain(finding).sentences].count(True) == 1


@pytest.mark.parametrize(("law", "told"), [("crash", 1), ("timeout", 0)])
def test_the_last_words_of_a_process_that_ended_are_told(law, told):
    ended = replace(
        found(walking(), PATH_OF_3), law=law, seen="its end (signal 6)", detail="", output="a\nb\n"
    )
    assert explain(ended).sentences.count("The explorer's last message: b") == told
    assert "The explorer's last message: c" in explain(replace(ended, detail="c")).sentences


@pytest.mark.parametrize(
    ("detail", "said"),
    [
        ("x\nTypeError: no\n  at y\n", ["The explorer's last message: TypeError: no"]),
        ("an exception\nPANIC: here\nbye", ["The explorer's last message: PANIC: here"]),
        ("one\n two \n\n", ["The explorer's last message: two"]),
        ("one\nas was seen", []),
        (" \n", []),
    ],
)
def test_the_message_that_is_told_names_an_error_or_is_the_last(detail, said):
    finding = replace(found(walking(), PATH_OF_3), law="crash", seen="as was seen!", detail=detail)
    sentences = explain(finding).sentences
    assert sentences[0] == "The explorer crashed: as was seen!."
    assert [line for line in sentences if "message" in line] == said


# ---------------------------------------------------------------- checkpoints

KNOWN = Checkpoint((0, 1), (1, 0), 1)
"""Of PATH_OF_3 after one step: an edge whose other end is taken for a leaf."""


def test_a_wrong_checkpoint_is_told_with_the_step_place_and_percept_before_it():
    ended = found(walking(Move(0), KNOWN), PATH_OF_3)
    shown = "where the robot stood at v1, dart 1, and had sensed 'degree 2'."
    for law, step in (("invariant-1", 1), ("invariant-2", 1), ("variant", None)):
        said = explain(replace(ended, law=law))
        assert said.sentences[1:] == (f"The checkpoint came after step 1, {shown}",)
        assert said.step == step
    (only,) = explain(replace(ended, law="variant", step=None)).sentences
    assert only.startswith("The explorer ended too early")


def test_the_first_wrong_checkpoint_goes_before_what_followed():
    finding = found(walking(Move(0), KNOWN, Move(0)), PATH_OF_3)
    what = finding.wrong_checkpoint
    assert what
    for law in ("crash", "budget", "no-estimate"):
        for wrong in (what, ""):
            text = explain(replace(finding, law=law, wrong_checkpoint=wrong))
            shown = wrong or "its S is not the explored part"
            first = (
                f"The checkpoint after step 1 is already wrong; in the numbers of its S: {shown}. "
                "Mend this first: later mistakes may follow from it."
            )
            assert text.sentences[0 if law == "budget" else 1] == first
            assert text.step == 1


# ---------------------------------------------------------------- walks without an end


def test_of_an_endless_walk_it_is_told_since_when_nothing_was_new():
    # To the loop's far end, and so on: dart 2 and its edge are never taken.
    loop = told(walking(Move(0), then=Move(0)), LEAFY_LOOP, step_budget=6)
    loop[2] = loop[2].partition(" (line")[0]
    how = "The explorer did not end within its step budget, so the run was stopped."
    whose = "--step-budget sets the budget: 6 traversals."
    assert loop == [
        how,
        "After step 1 the robot found no new edge; 1 edge stayed unknown.",
        "From step 1 on the robot repeated 2 steps, 3 times in all: to v0, dart 1; v0, dart 0",
        "The robot never walked along the edge from dart 2 of v0 to dart 3 of v1.",
        whose,
    ]
    never = told(
        walking(Move(0), Move(0), Move(2), Move(0), then=Move(1)), LEAFY_LOOP, step_budget=6
    )
    assert never[2:] == [SHOW, whose]
    # Out by dart 2 at the third step: then all is known.
    both = told(walking(Move(0), Move(0), Move(2), then=Move(0)), LEAFY_LOOP, step_budget=6)
    went_on = "had walked every edge of the world, but the explorer went on."
    assert both[1] == f"After step 3 the robot {went_on}"
    # Under a task that is not the map no checkpoint is asked for.
    tasked = told(walking(then=Move(0)), LEAFY_LOOP, step_budget=6, task="stop")
    tasked[2] = tasked[2].partition(" (line")[0]
    assert tasked[1:] == [
        "After step 1 the robot found no new edge; 1 edge stayed unknown.",
        "From step 1 on the robot repeated 2 steps, 3 times in all: to v0, dart 1; v0, dart 0",
        "The robot never visited v1.",
        whose,
    ]
    shown = told(walking(Move(0), Move(0), then=Checkpoint((1, 2, 0), (1, 0, 2), 0)), LEAFY_LOOP)
    assert shown[1] == "After step 2 it showed more checkpoints than are allowed."
    still = told(walking(then=Drop()), World(EDGE, Movable(), 0), step_budget=1)
    assert not [line for line in still if "met no new edge" in line]


# The terms by Section VI, summed by hand, of m edges and n vertices:
# (1) s + 2(s-1)(2m - 2(s-1)) for s = 1 .. n-1: of the path (m = 2, n = 3) 1, and 2 + 2 * 2 = 6;
# (2) n + 2(n-1)(2m - 2(n-1) - 2(i-1)) for i = 1 .. m-n+1: of the loop with a leaf 2 + 2 * 2 = 6.
TERMS = [(PATH_OF_3, "2 edges and 3 vertices", 7, 0), (LEAFY_LOOP, "2 edges and 2 vertices", 1, 6)]


@pytest.mark.parametrize(("world", "name", "new", "closing"), TERMS)
def test_whose_the_budget_is_and_of_what_it_is_the_sum(world, name, new, closing):
    finding = found(walking(then=Move(0)), world)
    budget = 8 * (new + closing) + 100
    assert len(finding.transcript.steps) == budget
    assert explain(finding).sentences[-1] == (
        f"In a world with {name} the budget is {budget} traversals, which is "
        f"8 x ({new} + {closing}) + 100; {new} + {closing} is the paper's bound."
    )
    tried = tell_whose_budget(replace(finding, tried="--bound none"))
    assert tried.endswith(
        "bound. With --bound none no law is broken, in this world and in all others tried."
    )
    named = tell_whose_budget(replace(finding, under=Rules(own_bound="1000*n")))
    value = 1000 * world.map.vertex_count
    assert named == (
        f"In a world with {name} the budget is {value:,} traversals, the bound that the explorer "
        "names."
    )


# ---------------------------------------------------------------- walks that are too long


@pytest.mark.parametrize(("world", "name", "new", "closing"), TERMS)
def test_whose_the_bound_is_and_how_its_value_comes_about(world, name, new, closing):
    finding = replace(found(walking(then=Move(0)), world), expected=new + closing)

    def whose(**rules):
        right, told_, *more = tell_whose_bound(replace(finding, under=Rules(**rules)))
        assert not more
        assert right == "The map and the pose are right; the walk is longer than the bound allows."
        return told_

    what = (
        "(1) + (2), which the paper proves for its Algorithm 1 in Section VI: (1) is the cost of "
        "passes that find a new vertex, (2) that of passes that join two known vertices"
    )
    sums = f"In a world with {name} (1) + (2) is {new} + {closing}"
    assert whose(bound="paper") == f"The bound 'paper' is {what}. {sums} = {new + closing}."
    assert whose(bound="two-vertices") == (
        "The bound 'two-vertices' is (1) + (2) + (two traversals for each test of a hypothesis) + "
        f"(the search at the start for the dart to v1). The bound 'paper' is {what}. {sums}, "
        f"and the bound 'two-vertices' is {new + closing}."
    )
    value = f"which is {new + closing} in a world with {name}."
    assert whose(bound="3*m") == f"The bound that was asked for is 3*m, {value}"
    assert whose(own_bound="3*m") == f"The explorer's own bound is 3*m, {value}"
    assert whose(own_bound="3*m", bound="2*m") == (f"The bound that was asked for is 2*m, {value}")


def test_what_else_holds_is_said_of_the_laws_that_were_checked():
    finding = found(walking(then=Move(0)), PATH_OF_3)

    def right(*laws):
        rules = Rules(bound="m", laws=laws)
        return tell_whose_bound(replace(finding, under=rules, tried="--bound none"))[0]

    assert right("bound") == "The walk is longer than the bound allows."
    assert right("map", "bound") == (
        "The walk is longer than the bound allows; every other law that was checked holds: map."
    )
    assert "map and variant" in right("map", "variant", "bound")
    assert right("map", "pose", "bound").startswith("The map and the pose are right")


def test_of_a_long_walk_the_traversals_and_the_edges_are_counted():
    # Over the path and back, twice: 8 traversals, 2 edges; right, with its bound exceeded.
    over = [Move(0), Move(1), Move(0), Move(1)] * 2
    finding = found(walking(*over, answer=Estimate(PATH, 0)), PATH_OF_3, bound="m")
    assert finding.law == "bound"
    assert explain(finding).sentences[-1] == (
        "The robot made 8 traversals, of which 2 found a new edge."
    )


# ---------------------------------------------------------------- marks of its own


@pytest.mark.parametrize(
    ("lighthouse", "actions", "marks"),
    [
        # v1 is the middle: what is left there is sensed there again, and not elsewhere.
        ("whiteboard", [Write(1), Move(0), Move(0)], [0, 1, 0, 1]),
        ("whiteboard", [Move(0), Write(1), Move(1), Move(0)], [0, 0, 1, 0, 1]),
        # On the middle's dart 1 alone: by dart 2 the robot comes to another one.
        ("doormarks", [Move(0), Write(1), Move(1), Move(0)], [0, 0, 1, 0, 0]),
        ("movable", [Drop(), Move(0), Move(0), Pick()], [0, 1, 0, 1, 0]),
        ("movable:distinct=true,markers=2", [Drop(), Drop(), Move(0), Move(0)], [0, 1, 3, 0, 3]),
    ],
)
def test_an_answer_predicts_the_marks_that_the_robot_leaves_itself(lighthouse, actions, marks):
    world = World.from_json(
        PATH_OF_3.to_json() | {"lighthouse": world_named("theta", lighthouse).lighthouse.to_json()}
    )
    finding = found(walking(*actions, answer=Estimate(EDGE, 0)), world)
    log = Walk.recorded(world, finding.transcript)
    assert [percept.marks for percept in log.percepts] == marks
    trail = [0]
    for action in actions:
        dart = trail[-1]
        trail.append(PATH.alpha[PATH.turn(dart, action.k)] if type(action) is Move else dart)
    assert believed_percepts(log, PATH, trail) == log.percepts


def test_a_marker_that_the_answer_does_not_have_there_is_not_taken_up_in_it():
    world = World(PATH, Movable(), 0)
    log = Walk.of(world, [Drop(), Move(0), Move(0), Pick()])
    # A walk that is somewhere else when it takes the marker up.
    assert [each.marks for each in believed_percepts(log, PATH, [0, 0, 1, 3, 3])] == [
        *(0, 1, 0, 0, 0)
    ]


def test_who_has_not_moved_did_not_come_by_an_edge():
    world = World(LASSO, Movable(), 0)
    said = told(walking(Drop(), Pick(), answer=Estimate(LASSO, 1)), world, laws=("pose",))
    assert "stands at v0, dart 0; the answer says dart 1 of the same vertex" in said[0]
    assert "other end" not in said[0]
    moved = told(walking(Move(1), answer=Estimate(LASSO, 1)), world, laws=("pose",))
    assert ". Dart 1 is the other end of the edge by which the robot came." in moved[0]


def test_who_acts_last_without_a_move_has_stayed_where_the_answer_leaps():
    # Out by dart 2 to v1, where the marker is dropped: the answer is at v0 all of a sudden.
    world = World(LASSO, Movable(), 0)
    explanation = explain(found(walking(Move(2), Drop(), answer=Estimate(LASSO, 0)), world))
    assert (explanation.law, explanation.step) == ("pose", 2)
    assert explanation.sentences[1] == (
        "At step 2 the robot stayed at v1, but its answer takes this vertex for v0, which it had "
        "left at step 1: the robot sensed 'degree 1, marked', where the answer predicts 'degree 3, "
        "marked'."
    )
