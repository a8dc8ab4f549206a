"""Symmetries of runs: other names of the darts, another first direction, the mirror image."""

import pytest
from hypothesis import given, settings
from hypothesis.strategies import data, permutations

from allworlds.documents.document import replace
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.judging.episode import Answered
from allworlds.protocol.actions import Checkpoint, Estimate, Move
from allworlds.strategies import maps, worlds
from laws.test_symmetry import WRONG, episode_of, flipped, mirrored

EXPLORERS = {"algorithm1": algorithm1, **WRONG}


FEW = settings(max_examples=25)


@pytest.mark.slowest
@pytest.mark.parametrize("explore", EXPLORERS.values(), ids=EXPLORERS)
def test_relabelling_the_world_leaves_the_transcript_and_the_answer_unchanged(explore):
    @FEW
    @given(worlds(maps(max_edges=5)), data())
    def law(world, drawn):
        other = world.relabelled(drawn.draw(permutations(world.map.darts)))
        one, two = episode_of(explore, world), episode_of(explore, other)
        assert one.transcript == two.transcript
        assert one.checkpoints == two.checkpoints
        assert without_traceback(one.ending) == without_traceback(two.ending)

    law()


def without_traceback(ending):
    """The ending of an episode; of a fault, without its traceback."""
    return ending if isinstance(ending, Answered) else replace(ending, detail="")


def behind_a_mirror(explore):
    """The explorer whose motions, percepts and answer are mirrored."""

    def mirror(first, *, choices):
        walk = explore(flipped(first), choices=choices)
        reply = None
        while True:
            try:
                message = walk.send(reply)
            except StopIteration as stop:
                return reflected(stop.value)
            if isinstance(message, Checkpoint):
                reply = yield message
            else:
                reply = flipped((yield Move(-message.k) if isinstance(message, Move) else message))

    return mirror


def reflected(answer):
    if not isinstance(answer, Estimate):
        return answer
    return Estimate(answer.map.mirrored(), answer.here)


@pytest.mark.slowest
@pytest.mark.parametrize("explore", EXPLORERS.values(), ids=EXPLORERS)
def test_a_mirrored_explorer_in_the_mirrored_world_walks_and_answers_mirrored(explore):
    @FEW
    @given(worlds(maps(max_edges=5)))
    def law(world):
        one = episode_of(explore, world)
        two = episode_of(behind_a_mirror(explore), world.mirrored())
        assert two.transcript == mirrored(one.transcript)
        if isinstance(one.ending, Answered):
            assert two.ending.answer == reflected(one.ending.answer)
        else:
            assert two.ending.law == one.ending.law

    law()
