"""The folded log of an explorer that is right is the world."""

from random import Random

from hypothesis import find, given, settings
from hypothesis.strategies import integers, tuples

from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.documents.document import replace
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.judging.episode import play
from allworlds.judging.laws.folding import Contradiction, fold
from allworlds.judging.laws.law_table import Case
from allworlds.maps import CombinatorialMap, rooted_code
from allworlds.protocol.actions import Estimate, Move, Transcript
from allworlds.protocol.choices import Choices
from allworlds.strategies import choices, maps, motions, worlds

LONG = 3000
MANY = settings(max_examples=2000)


def random_walk(seed):
    """Walks at random, folds what it has sensed, and stops when no dart is open."""

    def explore(first, _choices, _told):
        random = Random(seed)
        steps = []
        while True:
            folded = fold(Transcript(first, tuple(steps)))
            if not folded.open_darts:
                return Estimate(CombinatorialMap(folded.sigma, folded.alpha), folded.here)
            for _ in range(8):
                move = Move(random.randrange(12))
                steps.append((move, (yield move)))

    return explore


def paper(first, own, _told):
    return algorithm1(first, choices=own)


def case_of(world, player, own=None):
    episode = play(world, player, own or Choices(), LONG)
    return Case(episode.walk, episode.checkpoints, episode.ending.answer)


def folds_to_the_world(case, log=None):
    """Whether the log alone gives the world, the robot's first and its last dart included."""
    folded = fold(log or case.walk.transcript)
    return all(
        rooted_code(folded.sigma, folded.alpha, mine)
        == rooted_code(case.map.sigma, case.map.alpha, true)
        for mine, true in ((0, case.start), (folded.here, case.walk.here))
    )


@given(worlds(maps(max_edges=8)), choices())
def test_the_folded_log_of_algorithm_1_is_the_world(world, own):
    case = case_of(world, paper, own)
    assert case.answer == "right"
    assert folds_to_the_world(case)


@given(worlds(maps(max_edges=4)), integers(0, 99))
def test_the_folded_log_of_a_random_walk_is_the_world_when_it_is_closed(world, seed):
    case = case_of(world, random_walk(seed))
    assert case.answer == "right"
    assert folds_to_the_world(case)


def test_the_folded_log_of_one_who_guesses_is_not_the_world():
    guess = next(m for m in WRONG_EXPLORERS if m.name == "lucky-guess").explorer()

    def player(first, own, _told):
        return guess(first, choices=own)

    def lucky(world):
        case = case_of(world, player)
        return case.answer == "right" and not folds_to_the_world(case)

    assert find(worlds(), lucky, settings=MANY).map.edge_count == 1


@given(worlds(), motions())
def test_what_is_folded_from_any_walk_is_a_part_of_the_world(world, ks):
    def scripted(_first, _choices, _told):
        for k in ks:
            yield Move(k)
        return Estimate(world.map, 0)

    case = case_of(world, scripted)
    folded = fold(case.walk.transcript)
    # Dart by dart into the world, from the start; a known edge is one there.
    place = {0: world.start}
    for dart in (order := [0]):
        image = place[dart]
        steps = [(folded.sigma[dart], world.map.sigma[image])]
        if folded.alpha[dart] != dart:
            steps.append((folded.alpha[dart], world.map.alpha[image]))
        for mine, true in steps:
            assert place.setdefault(mine, true) == true
            if mine not in order:
                order.append(mine)
    assert place[folded.here] == case.walk.here


def test_a_log_with_a_wrong_first_bearing_does_not_fold_to_its_world():
    def misfolded(drawn):
        world, shift = drawn
        case = case_of(world, paper)
        first = case.walk.first
        wrong = replace(first, bearing=(first.bearing + shift) % first.degree)
        if wrong == first:
            return False
        log = Transcript(wrong, tuple(case.walk.steps))
        try:
            return not folds_to_the_world(case, log)
        except Contradiction:
            return True

    world, _ = find(tuples(worlds(), integers(1, 3)), misfolded, settings=MANY)
    # A loop whose dart leads back to itself.
    assert (world.map.edge_count, world.map.vertex_count) == (1, 1)
