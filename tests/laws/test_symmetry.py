"""Symmetries of runs: other names of the darts, another first direction, the mirror image."""

from hypothesis import find, given, settings
from hypothesis.strategies import data, integers, permutations, tuples

from allworlds.corpus.explorers import EQUIVALENT_EXPLORERS, WRONG_EXPLORERS
from allworlds.documents.document import replace
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.judging.episode import play
from allworlds.judging.laws.folding import fold
from allworlds.maps import rooted_code, rooted_maps
from allworlds.protocol.actions import Estimate, Move, Transcript
from allworlds.protocol.choices import Choices
from allworlds.strategies import choices, maps, motions, worlds

WRONG = {
    mutant.name: mutant.explorer()
    for mutant in (*WRONG_EXPLORERS, *EQUIVALENT_EXPLORERS)
    if mutant.name != "state-kept"  # whose runs depend on how many there were before
}
MANY = settings(max_examples=2000)
STEPS = 300


def episode_of(explore, world, own=None):
    """A run of an explorer that takes choices."""

    def player(first, choices, _told):
        return explore(first, choices=choices)

    return play(world, player, own or Choices(), STEPS)


def walked(world, ks):
    """The transcript of fixed motions."""

    def scripted(_first, _choices, _told):
        for k in ks:
            yield Move(k)
        return Estimate(world.map, 0)

    return play(world, scripted, Choices(), len(ks)).transcript


def code(answer, root):
    return rooted_code(answer.sigma, answer.alpha, root)


def mirrored(transcript):
    """The transcript of the same walk as a robot behind a mirror would have it."""
    degrees = [transcript.first.degree, *(percept.degree for _, percept in transcript.steps)]
    return Transcript(
        flipped(transcript.first),
        tuple(
            (Move(-action.k % degree), flipped(percept))
            for (action, percept), degree in zip(transcript.steps, degrees, strict=False)
        ),
    )


# ---------------------------------------------------------------- names of darts


@given(worlds(), data(), motions())
def test_relabelling_the_world_leaves_every_walk_unchanged(world, drawn, ks):
    other = world.relabelled(drawn.draw(permutations(world.map.darts)))
    assert walked(world, ks) == walked(other, ks)


def test_a_robot_that_sees_the_name_of_its_dart_would_be_noticed():
    def cheating(world):
        def explore(_first, *, choices):
            yield Move(world.start)
            return Estimate(world.map, 0)

        return episode_of(explore, world).transcript

    def noticed(pair):
        world, swap = pair
        darts = list(world.map.darts)
        darts[0], darts[swap % len(darts)] = darts[swap % len(darts)], 0
        return cheating(world) != cheating(world.relabelled(darts))

    world, _ = find(tuples(worlds(), integers(1, 5)), noticed, settings=MANY)
    # A loop looks the same from both its ends, but not with a marker at one of them.
    assert (world.map.edge_count, world.map.vertex_count) == (1, 1)


# ---------------------------------------------------------------- the way it looks at the start


def turned(world, k):
    """The world of a robot that faces another dart of v0 at the start."""
    return replace(world, start=world.map.turn(world.start, k))


@given(worlds(), integers(-12, 12), integers(-12, 12), motions())
def test_turning_the_start_shifts_the_first_motion_and_nothing_else(world, k, first, ks):
    other = turned(world, k)
    one, two = walked(world, [first, *ks]), walked(other, [first - k, *ks])
    assert [percept for _, percept in one.steps] == [percept for _, percept in two.steps]
    assert one.steps[1:] == two.steps[1:]
    assert two.first.bearing == (one.first.bearing - k) % one.first.degree


@given(worlds(), integers(-12, 12), choices(), choices())
def test_turning_the_start_turns_the_answer_whatever_is_chosen(world, k, own, others):
    one = episode_of(algorithm1, world, own).ending.answer
    two = episode_of(algorithm1, turned(world, k), others).ending.answer
    # Dart 0 of an estimate of Algorithm 1 is the dart that the robot faced at the start.
    assert code(one.map, one.map.turn(0, k)) == code(two.map, 0)


def test_an_answer_turned_the_wrong_way_would_be_noticed():
    def noticed(drawn):
        world, k = drawn
        explore = WRONG["mirror-image"]
        one, two = (episode_of(explore, at).ending.answer.map for at in (world, turned(world, k)))
        return code(one, one.turn(0, k)) != code(two, 0)

    world, _ = find(tuples(worlds(), integers(0, 5)), noticed, settings=MANY)
    assert world.first.degree > 2  # a turn by one of two darts is the same either way


# ---------------------------------------------------------------- the mirror


@given(worlds(), motions())
def test_in_a_mirrored_world_mirrored_motions_are_answered_by_mirrored_percepts(world, ks):
    there = walked(world.mirrored(), [-k for k in ks])
    assert there == mirrored(walked(world, ks))


def test_motions_that_are_not_mirrored_would_be_noticed():
    def noticed(drawn):
        world, ks = drawn
        return walked(world.mirrored(), ks) != mirrored(walked(world, ks))

    world, ks = find(tuples(worlds(), motions()), noticed, settings=MANY)
    # A turn by 1 of 3 darts, for by 1 of 2 either way is the same.
    assert world.map.edge_count == 2
    assert len(ks) == 1


def flipped(percept):
    """The percept behind a mirror: other bearings are counted anticlockwise."""
    if percept.bearing is None:
        return percept
    return replace(percept, bearing=-percept.bearing % percept.degree)


def test_algorithm_1_is_not_its_own_mirror_image():
    def noticed(world):
        here, there = episode_of(algorithm1, world), episode_of(algorithm1, world.mirrored())
        return there.transcript != mirrored(here.transcript)

    assert find(worlds(), noticed, settings=MANY).map.edge_count == 2


@given(worlds(maps(max_edges=8)))
def test_but_its_map_of_the_mirrored_world_is_the_mirrored_map(world):
    here = episode_of(algorithm1, world).ending.answer.map
    there = episode_of(algorithm1, world.mirrored()).ending.answer.map
    assert code(there, 0) == code(here.mirrored(), 0)


@given(worlds(), motions())
def test_the_folded_log_of_the_mirrored_world_is_mirrored(world, ks):
    here, there = fold(walked(world, ks)), fold(walked(world.mirrored(), [-k for k in ks]))
    inverse = [here.sigma.index(d) for d in range(len(here.sigma))]
    assert rooted_code(there.sigma, there.alpha, 0) == rooted_code(inverse, here.alpha, 0)
    assert rooted_code(there.sigma, there.alpha, there.here) == rooted_code(
        inverse, here.alpha, here.here
    )


def test_a_mirror_image_is_in_general_another_map():
    def chiral(map_):
        return all(code(map_.mirrored(), root) != code(map_, 0) for root in map_.darts)

    assert not any(chiral(map_) for edges in (1, 2, 3) for map_ in rooted_maps(edges))
    assert find(maps(max_edges=4), chiral, settings=MANY).edge_count == 4
