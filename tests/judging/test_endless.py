"""Walks that come to no end."""

import re
from collections import Counter

import pytest
from hypothesis import given, settings, strategies as st

import allworlds
from allworlds import Checkpoint, CombinatorialMap, Drop, Move, Pick
from allworlds.documents.document import replace
from allworlds.judging.explanations.by_law import SHOW
from allworlds.judging.explanations.endless import TIMES, Round, round_of
from allworlds.maps import named_map
from allworlds.protocol.code_lines import LATELY, TracedPlay
from allworlds.reports.formats import file_of, text
from allworlds.studies.explain import explain
from allworlds.studies.run import run
from allworlds.world import Directional, World, world_named


def explained(explore, world, lighthouse="directional"):
    finding = run(explore, world_named(world, lighthouse)).finding
    assert finding.law == "budget"
    return explain(finding).sentences


def test_who_walks_round_a_face_is_told_the_edges_that_it_never_met():
    def round_and_round(first):
        del first
        while True:
            yield Move(1)

    told = explained(round_and_round, "k4")
    assert re.fullmatch(
        r"After step [34] the robot found no new edge; [23] edges stayed unknown\.", told[1]
    )
    walked = "From step 1 on the robot repeated 3 steps, [0-9,]+ times in all: to v[0-3], dart"
    assert re.match(walked, told[2]), told[2]
    assert told[3].startswith("The robot never walked along the edge from dart")
    assert SHOW not in told
    assert "traversals, which is 8 x (" in told[4]
    assert "--step-budget" not in told[4]


def by_trying(walk):
    """The round of the longest end that repeats some first steps thrice, by trying all."""
    for first in range(len(walk)):
        end = walk[first:]
        for steps in range(1, len(end) // TIMES + 1):
            if all(end[i] == end[i + steps] for i in range(len(end) - steps)):
                return Round(first + 1, steps, len(end) // steps)
    return None


@settings(deadline=None, max_examples=300)
@given(st.text("ab", max_size=6), st.text("ab", min_size=1, max_size=4), st.integers(0, 6))
def test_the_round_of_a_walk_is_the_longest_end_that_repeats(before, again, times):
    walk = before + again * times
    assert round_of(walk) == by_trying(walk)


FORGETS = """from allworlds import Move


def go(k):
    return (yield Move(k))


def explore(first):
    rooms = 0
    while True:
        for _ in range(3):
            rooms += 1
        yield from go(1)
"""


@pytest.mark.processes
def test_an_endless_walk_names_its_lines(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "forgets.py").write_text(FORGETS)
    report = allworlds.check("forgets.py:explore", edges=1, map_class="simple")
    (finding,) = report.findings
    assert finding.law == "budget"
    assert finding.code.busy[:2] == ("forgets.py:11", "forgets.py:12")
    (round_,) = [said for said in explain(finding).sentences if "times in all: to" in said]
    assert round_.endswith("(line forgets.py:5).")
    said = text(report, 200)
    assert "line       forgets.py:5: return (yield Move(k))" in said
    assert "ran often  forgets.py:11: for _ in range(3):; forgets.py:12: rooms += 1" in said
    assert "::error file=forgets.py,line=5" in file_of("annotations", report)


def test_lines_of_the_last_turns_alone_are_counted():
    def explore(_):
        for _ in range(LATELY + 5):
            yield 1
        yield 2

    traced = TracedPlay()
    play = traced.player(explore)(None)
    for _ in range(LATELY + 6):
        play.send(None)
    lines = {
        line - explore.__code__.co_firstlineno: n
        for (_, line), n in sum(traced.lately, Counter()).items()
    }
    assert lines == {1: LATELY, 2: LATELY - 1, 3: 1}
    assert [line - explore.__code__.co_firstlineno for _, line in traced.busiest()] == [1, 2, 3]


def test_who_wanders_is_told_when_nothing_was_new_any_more():
    def wandering(first):
        del first
        n = 0
        while True:
            n += 1
            yield Move(int(n**0.5 // 1) % 3)

    told = explained(wandering, "k4")
    assert "the robot had walked every edge of the world, but the explorer went on" in told[1]


def test_the_budget_that_was_asked_for_is_told_as_that():
    def to_and_fro(_):
        while True:
            yield Move(0)

    told = explain(
        run(to_and_fro, world_named("theta", "directional"), step_budget=7).finding
    ).sentences
    assert told[-1] == "--step-budget sets the budget: 7 traversals."


def test_a_run_a_hundred_times_dearer_than_the_bound_is_given_up():
    def to_and_fro(_):
        while True:
            yield Move(0)

    world = world_named("theta", "compass")
    finding = run(to_and_fro, world, bound="m-2").finding
    assert (finding.law, finding.transcript.cost) == ("budget", 100 * (3 - 2) + 100)
    told = explain(finding).sentences[-1]
    assert told.startswith("In a world with 3 edges and 2 vertices the budget is 200 traversals, ")
    assert "which is 100 x the bound + 100; the bound is m-2" in told


LOOP = World(CombinatorialMap((1, 0), (1, 0)), Directional(0), 0)


@pytest.mark.parametrize("ends", ["budget", "crash", "no-estimate", "illegal-action"])
@pytest.mark.parametrize("right_for", [0, 2, None])
def test_a_run_without_an_answer_names_its_first_wrong_checkpoint(ends, right_for):
    """S of a world with one loop: right until the loop is said to be known before it is walked."""

    def explore(_):
        for step in range(4):
            yield Move(0)
            wrong = right_for is not None and step >= right_for
            yield Checkpoint((1, 0) if not wrong else (0,), (1, 0) if not wrong else (0,), 0)
        if ends == "budget":
            while True:
                yield Move(0)
        if ends == "crash":
            raise ArithmeticError
        if ends == "illegal-action":
            yield "east"

    finding = run(explore, LOOP).finding
    told = explain(finding)
    assert finding.law == ends
    assert finding.step == (None if right_for is None else right_for + 1) == told.step
    named = [each for each in told.sentences if "is already wrong" in each]
    assert [each.split(" is ")[0] for each in named] == (
        [] if right_for is None else [f"The checkpoint after step {right_for + 1}"]
    )


def test_who_does_not_ask_for_invariants_is_not_told_of_checkpoints():
    def explore(_):
        yield Checkpoint((0,), (0,), 0)
        raise ArithmeticError

    assert run(explore, LOOP).finding.step == 0
    assert run(explore, LOOP, laws=["map", "pose"]).finding.step is None


def shows(*checkpoint):
    def explore(_):
        yield Move(0)
        yield Checkpoint(*checkpoint)
        raise ArithmeticError

    return explore


@pytest.mark.parametrize(
    ("checkpoint", "wrong"),
    [
        (((0, 2, 3, 1), (1, 1, 2, 3), 1), "dart 1 is in U, but it is the other end of"),
        (
            ((0, 2, 1), (1, 0, 2), 1),
            "with the robot at dart 1, sigma(2) = 1 is not so in the world",
        ),
        (((0, 2, 3, 1), (1, 0, 2, 3), 2), "S is right, but here = 2; the robot stands at dart 1"),
    ],
)
def test_what_is_wrong_with_a_checkpoint_is_named(checkpoint, wrong):
    """The world is an edge with a loop at its far end; the robot has come there by the edge."""
    world = World(CombinatorialMap((0, 2, 3, 1), (1, 0, 3, 2)), Directional(0), 0)
    finding = run(shows(*checkpoint), world).finding
    assert finding.step == 1
    assert wrong in finding.wrong_checkpoint
    assert finding.wrong_checkpoint in " ".join(explain(finding).sentences)


def test_a_walk_that_ends_in_checkpoints_is_told_so():
    def explore(_):
        yield Move(0)
        while True:
            yield Checkpoint((1, 0), (1, 0), 0)

    told = explain(run(explore, LOOP).finding).sentences
    assert told[1] == "After step 1 it showed more checkpoints than are allowed."


STUCK = """from allworlds import Move


def search(rooms):
    while rooms:
        rooms = rooms[::-1]


def explore(first):
    yield Move(0)
    search([first])
"""


@pytest.mark.processes
def test_a_silent_run_tells_the_lines_in_which_it_was(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "stuck.py").write_text(STUCK)
    report = allworlds.check(
        "stuck.py:explore", edges=1, map_class="simple", answer_timeout=0.5, workers=1
    )
    (finding,) = report.findings
    assert (finding.law, finding.detail) == ("timeout", "")
    told = [said for said in explain(finding).sentences if said.startswith("It was then in")]
    searches, explores = r"search \(stuck\.py:[56]\)", r"explore \(stuck\.py:11\)\."
    assert re.fullmatch(f"It was then in the function {searches}, called by {explores}", told[0])
    assert "::error file=stuck.py,line=" in file_of("annotations", report)
    assert not [said for said in explain(replace(finding, output="")).sentences if "was in" in said]


STAR = World(named_map("star-3"), Directional(0), 0)


def rooms_from_the_hall(count, ends):
    """An explorer that enters each room and comes back, with what it counts for the next door."""

    def explore(first):
        for door in range(first.degree):
            yield Move(count(door))
            yield Move(0)
        while ends is None:
            yield Move(0)
        if ends == "crash":
            raise ArithmeticError

    return explore


@pytest.mark.parametrize("ends", [None, "crash", "no-estimate"])
def test_who_takes_one_door_for_another_after_a_way_back_is_told_the_step(ends):
    wrong = run(rooms_from_the_hall(lambda door: door, ends), STAR).finding
    told = [said for said in explain(wrong).sentences if said.startswith("Before step")]
    (sentence,) = told
    assert sentence.startswith(
        "Before step 5 the robot was back at v0 and faced dart 1, by which it had"
    )
    assert "so move 2 led along dart 0, which was already walked. Counted" in sentence
    assert "Counted from dart 0, where the robot stood before it left," in sentence
    assert "would lead along dart 3, which was new" in sentence
    right = run(rooms_from_the_hall(lambda door: min(door, 1), ends), STAR).finding
    assert not [said for said in explain(right).sentences if said.startswith("Before step")]


def test_who_counts_from_the_door_it_went_out_by_is_not_told_otherwise_later():
    def explore(_):
        for k in (0, 0, 1, 0, 1, 0, 3, 0):  # right at first; at last it walks an old door again
            yield Move(k)

    finding = run(explore, World(named_map("star-5"), Directional(0), 0)).finding
    assert not [said for said in explain(finding).sentences if said.startswith("Before step")]


def test_a_loop_is_no_other_door_by_which_it_came():
    def explore(first):
        for k in range(1, first.degree + 1):
            yield Move(k)
            yield Move(0)

    world = World(CombinatorialMap((1, 2, 0, 3), (1, 0, 3, 2)), Directional(0), 0)
    told = explain(run(explore, world).finding).sentences
    (sentence,) = [said for said in told if said.startswith("Before step")]
    assert sentence.startswith(
        "Before step 3 the robot was back at v0 and faced dart 1, by which it had"
    )
    assert "Counted from dart 0, where the robot stood before it left" in sentence
    assert "would lead along dart 2, which was new" in sentence


def test_the_way_back_through_a_loop_is_counted_from_the_door_before_it():
    def explore(_):
        for k in (1, 0, 3, 0, 3, 0):  # the loop has the doors 1 and 2
            yield Move(k)

    map_ = CombinatorialMap((1, 2, 3, 4, 0, 5, 6, 7), (5, 2, 1, 6, 7, 0, 3, 4))
    told = explain(run(explore, World(map_, Directional(0), 0)).finding).sentences
    (sentence,) = [said for said in told if said.startswith("Before step")]
    assert sentence.startswith(
        "Before step 5 the robot was back at v0 and faced dart 5, by which it had"
    )
    assert "led along dart 3, which was already walked. Counted from dart 0" in sentence
    assert "Doors count from this dart" in sentence


def test_who_only_lays_markers_down_and_takes_them_up_is_told_its_last_step():
    def explore(_):
        while True:
            yield Drop()
            yield Pick()

    sentences = explained(explore, "edge", "movable")
    assert sentences[1].startswith(
        "After the last step, 1090 (pick), the robot was at v0, dart 0, and sen"
    )


@pytest.mark.parametrize(("rooms", "more"), [(9, ""), (10, " and 1 more"), (11, " and 2 more")])
def test_of_the_edges_that_were_left_out_eight_are_named(rooms, more):
    def explore(_):
        while True:
            yield Move(0)

    told = explained(explore, f"bouquet-{rooms}")[3]
    assert told.startswith(
        "The robot never walked along the edge from dart 2 of v0 to dart 3 of v0, the edge"
    )
    assert told.count("the edge from") == 8
    assert told.endswith(f"dart 17 of v0{more}.")


def test_three_rounds_are_a_round_and_two_are_none():
    assert round_of([1, 2] * 2) is None
    assert round_of([1, 2] * 3) == Round(1, 2, 3)


@pytest.mark.parametrize(("rooms", "more"), [(8, False), (9, True)])
def test_of_a_round_the_first_eight_places_are_named(rooms, more):
    def explore(_):
        while True:
            yield Move(1)

    told = explained(explore, f"cycle-{rooms}")[2]
    assert f"repeated {rooms} steps, " in told
    assert told.count(", dart ") == 8
    assert ("; ..." in told) is more
