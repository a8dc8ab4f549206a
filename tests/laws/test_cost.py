"""Cost counts traversals, adds up, and a way back costs as much as the way."""

from hypothesis import find, given, settings
from hypothesis.strategies import tuples

from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.judging.episode import play
from allworlds.judging.laws.law_table import Case, bound_law
from allworlds.protocol.actions import Checkpoint, Estimate, Move
from allworlds.protocol.choices import Choices
from allworlds.strategies import choices, maps, motions, worlds
from allworlds.world import World
from judges import retracing_not_counted

MANY = settings(max_examples=2000)


def episode_of(world, ks, checkpoints=0):
    """Fixed motions, each with so many checkpoints before it."""

    def scripted(_first, _choices, _told):
        for k in ks:
            for _ in range(checkpoints):
                yield Checkpoint(world.map.sigma, world.map.alpha, 0)
            yield Move(k)
        return Estimate(world.map, 0)

    return play(world, scripted, Choices(), checkpoints * len(ks) + len(ks))


def case_of(world, ks, bound=None):
    episode = episode_of(world, ks)
    return Case(episode.walk, (), episode.ending.answer, bound)


def end(world, ks):
    """The robot's dart after the motions."""
    return case_of(world, ks).walk.here


def back(ks):
    """The motions that undo these, up to a free turn by ``-ks[0]``."""
    return [0, *(-k for k in reversed(ks[1:]))] if ks else []


@given(worlds(), motions())
def test_the_cost_of_a_walk_is_its_number_of_motions(world, ks):
    assert episode_of(world, ks).transcript.cost == len(ks)


@given(worlds(), motions())
def test_checkpoints_cost_nothing_and_change_nothing(world, ks):
    silent, talking = episode_of(world, ks), episode_of(world, ks, checkpoints=2)
    assert silent.transcript == talking.transcript
    assert len(talking.checkpoints) == 2 * len(ks)


@given(worlds(), motions(), motions())
def test_cost_is_additive(world, one, two):
    both = case_of(world, one + two)
    assert both.walk.cost == (case_of(world, one).walk.cost + case_of(world, two).walk.cost)
    # The second walk goes on where the first has ended, whatever was before.
    dart = end(world, one)
    for k in two:
        dart = world.map.alpha[world.map.turn(dart, k)]
    assert both.walk.here == dart


@given(worlds(), motions())
def test_motion_is_reversible_and_the_way_back_costs_as_much_as_the_way(world, ks):
    there_and_back = case_of(world, ks + back(ks))
    turn = -ks[0] if ks else 0
    assert world.map.turn(there_and_back.walk.here, turn) == world.start
    assert there_and_back.walk.cost == 2 * len(ks)


@given(worlds(), motions())
def test_on_the_way_back_the_same_percepts_come_in_reverse_order(world, ks):
    transcript = episode_of(world, ks + back(ks)).transcript
    degrees = [transcript.first.degree, *(percept.degree for _, percept in transcript.steps)]
    assert degrees == degrees[::-1]


def test_a_way_back_that_forgets_the_signs_would_be_noticed():
    def lost(drawn):
        world, ks = drawn
        way_back = [0, *reversed(ks[1:])] if ks else []
        turn = -ks[0] if ks else 0
        return world.map.turn(end(world, ks + way_back), turn) != world.start

    world, ks = find(tuples(worlds(), motions()), lost, settings=MANY)
    assert len(ks) == 2  # the first motion is undone by the free turn alone
    assert world.map.edge_count == 2


def test_a_meter_that_does_not_count_the_way_back_would_be_noticed():
    def too_soft(drawn):
        world, ks = drawn
        case = case_of(world, ks, bound=1)
        return bound_law(case) is not None and retracing_not_counted(case) is None

    _, ks = find(tuples(worlds(), motions()), too_soft, settings=MANY)
    assert len(ks) == 2


@given(worlds(maps(max_edges=8)), choices())
def test_the_cost_of_algorithm_1_is_what_its_walk_costs_once_more(world, own):
    def player(first, choices, _told):
        return algorithm1(first, choices=choices)

    transcript = play(world, player, own, 10_000).transcript
    ks = [action.k for action, _ in transcript.steps]
    assert transcript.cost == len(ks)
    assert episode_of(world, ks).transcript == transcript


@given(worlds())
def test_a_robot_that_stays_pays_nothing(world):
    case = case_of(World(world.map, world.lighthouse, world.start), [])
    assert case.walk.cost == 0
    assert case.walk.darts == [world.start]
