"""Walks that come to no end."""

import re

import pytest

from allworlds import Checkpoint, CombinatorialMap, Move
from allworlds.judging.explanations.by_law import SHOW
from allworlds.studies.explain import explain
from allworlds.studies.run import run
from allworlds.world import Directional, World, world_named


def explained(explore, world):
    finding = run(explore, world_named(world, "directional")).finding
    assert finding.law == "budget"
    return explain(finding).sentences


def test_who_walks_round_a_face_is_told_the_edges_that_it_never_met():
    def round_and_round(first):
        del first
        while True:
            yield Move(1)

    told = explained(round_and_round, "k4")
    assert re.fullmatch(r"After step [34] it met no new edge; [23] edges it never met\.", told[1])
    assert told[2] == SHOW
    assert "8 times the paper's bound, and 100 more: 8 x (" in told[3]
    assert "--step-budget" not in told[3]


def test_who_wanders_is_told_when_nothing_was_new_any_more():
    def wandering(first):
        del first
        n = 0
        while True:
            n += 1
            yield Move(int(n**0.5 // 1) % 3)

    told = explained(wandering, "k4")
    assert "it had walked every edge of the world, and yet it went on" in told[1]


def test_the_budget_that_was_asked_for_is_told_as_that():
    def to_and_fro(_):
        while True:
            yield Move(0)

    told = explain(
        run(to_and_fro, world_named("theta", "directional"), step_budget=7).finding
    ).sentences
    assert told[-1] == "The budget is that of --step-budget: 7 traversals."


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
    named = [each for each in told.sentences if "is wrong already" in each]
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
    assert told[1] == "After step 1 it only showed checkpoints."
