from random import Random

import pytest

from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.judging.laws.folding import Contradiction, Folded, fold
from allworlds.maps import CombinatorialMap, rooted_code, rooted_maps
from allworlds.maps.build import cycle
from allworlds.protocol.actions import Checkpoint, Drop, Move, Percept, Pick, Transcript
from allworlds.world import Directional, World
from small import stepped


def worlds(largest):
    for m in range(1, largest + 1):
        for map_ in rooted_maps(m):
            for place in Directional.places(map_, 0):
                yield World(map_, place)


def walk(world, motions):
    """The log, and the robot's dart at its end."""
    dart, steps = world.start, []
    for k in motions:
        dart, percept = stepped(world, dart, Move(k))
        steps.append((Move(k), percept))
    return Transcript(world.first, tuple(steps)), dart


def explored(world):
    """The log of Algorithm 1, and the robot's dart at its end."""
    generator, reply, steps, dart = algorithm1(world.first), None, [], world.start
    while True:
        try:
            message = generator.send(reply)
        except StopIteration:
            return Transcript(world.first, tuple(steps)), dart
        reply = None
        if not isinstance(message, Checkpoint):
            dart, reply = stepped(world, dart, message)
            steps.append((message, reply))


def cut(log, length):
    return Transcript(log.first, log.steps[:length])


def random_walk(world, random, longest=25):
    return walk(world, [random.randrange(12) for _ in range(random.randrange(longest))])


def embedding(folded, world):
    """The dart of the world for each dart of the fold, checked to be a part of the world."""
    image = {0: world.start}
    for x in (queue := [0]):
        pairs = [(folded.sigma[x], world.map.sigma[image[x]])]
        if folded.alpha[x] != x:
            pairs.append((folded.alpha[x], world.map.alpha[image[x]]))
        for y, true in pairs:
            if y not in image:
                image[y] = true
                queue.append(y)
            assert image[y] == true
    assert len(image) == len(folded.sigma), "the fold is connected"
    degrees = world.map.degree_at
    for x, true in image.items():
        degree, y = 1, folded.sigma[x]
        while y != x:
            degree, y = degree + 1, folded.sigma[y]
        assert degree == degrees[true], "whole vertices"
    return image


def naive_fold(log):
    """Folding by brute force: ``(i, j)`` is the dart j places clockwise of the robot's dart
    after i steps.  Names are merged until nothing changes.

    Returns sigma, alpha and here, up to the names of the darts.
    """
    percepts = [log.first, *(percept for _, percept in log.steps)]
    names = [(i, j) for i, percept in enumerate(percepts) for j in range(percept.degree)]
    label = {name: n for n, name in enumerate(names)}

    def turned(name, by):
        i, j = name
        return i, (j + by) % percepts[i].degree

    def same(a, b):
        if label[a] == label[b]:
            return False
        old, new = label[a], label[b]
        for name in names:
            if label[name] == old:
                label[name] = new
        return True

    links = []
    for i, (action, _) in enumerate(log.steps):
        leaving = (i, action.k % percepts[i].degree)
        links += [(leaving, (i + 1, 0)), ((i + 1, 0), leaving)]
    for i, percept in enumerate(percepts):
        if percept.marks:
            same(turned((i, 0), percept.bearing), turned((0, 0), log.first.bearing))
    changed = True
    while changed:
        changed = False
        member = {}
        for name in names:
            other = member.setdefault(label[name], name)
            changed |= same(turned(name, 1), turned(other, 1))
        target = {}
        for source, end in links:
            changed |= same(end, target.setdefault(label[source], end))
    number = {n: d for d, n in enumerate(sorted(set(label.values())))}
    sigma, alpha = [0] * len(number), list(range(len(number)))
    for name in names:
        sigma[number[label[name]]] = number[label[turned(name, 1)]]
    for source, end in links:
        alpha[number[label[source]]] = number[label[end]]
    return sigma, alpha, number[label[len(percepts) - 1, 0]]


def agree(log):
    """Both folds are the same partial map, seen from the robot's dart; the fold."""
    folded = fold(log)
    sigma, alpha, here = naive_fold(log)
    assert folded.open_darts == sum(d == e for d, e in enumerate(alpha))
    assert rooted_code(folded.sigma, folded.alpha, folded.here) == rooted_code(sigma, alpha, here)
    return folded


# ---------------------------------------------------------------- right logs


def test_before_any_step_all_darts_of_v0_are_open():
    for world in worlds(3):
        degree = world.first.degree
        folded = fold(Transcript(world.first))
        assert folded == Folded((*range(1, degree), 0), tuple(range(degree)), 0)
        assert folded.open_darts == degree


def test_the_darts_of_v0_come_first_from_the_dart_faced_at_the_start():
    for world in worlds(3):
        folded = fold(explored(world)[0])
        degree = world.first.degree
        assert folded.sigma[:degree] == (*range(1, degree), 0)


def test_an_injective_fold_is_open_exactly_where_nobody_has_walked():
    random, met = Random(3), 0
    for world in worlds(3):
        log, _ = random_walk(world, random)
        folded = fold(log)
        image = embedding(folded, world)
        if len(set(image.values())) < len(image):
            continue
        met += 1
        dart, walked = world.start, set()
        for action, _ in log.steps:
            dart, _ = stepped(world, dart, action)
            walked |= {dart, world.map.alpha[dart]}
        assert {d for d, e in enumerate(folded.alpha) if d == e} == {
            d for d, true in image.items() if true not in walked
        }
    assert met > 100


def test_a_fold_may_hold_copies_of_a_vertex():
    # Round a triangle at the end of a bridge, from v0: nothing tells yet how long it is.
    sigma = (0, 2, 3, 1, 5, 4, 7, 6)  # v0; a with darts 1, 2, 3; b; c
    world = World(CombinatorialMap(sigma, (1, 0, 4, 7, 2, 6, 5, 3)), Directional(0))
    log, _ = walk(world, [0, 1, 1, 1])
    folded = agree(log)
    image = embedding(folded, world)
    assert len(folded.sigma) > len(set(image.values()))


def test_a_truncated_log_leaves_open_darts_at_the_right_places():
    for world in worlds(3):
        log, _ = explored(world)
        opened = [agree(cut(log, i)).open_darts for i in range(len(log.steps) + 1)]
        assert opened[0] == world.first.degree
        assert opened[-1] == 0
        assert all(opened[: world.map.edge_count]), "an edge never walked is open"


def test_the_lollipop_step_by_step():
    # v0 - a, and a loop at a.
    world = World(CombinatorialMap((0, 2, 3, 1), (1, 0, 3, 2)), Directional(0))
    log, _ = walk(world, [0, 1, 1, 0, 1, 0])
    # After one step the two other darts of a are open.  By the loop the robot comes to what
    # may be a third vertex, with two open darts, and to v0 only after leaving by sigma.
    assert fold(cut(log, 1)) == Folded((0, 2, 3, 1), (1, 0, 2, 3), 1)
    assert fold(cut(log, 2)).open_darts == 3
    # At dart 3 a turn by one is dart 1: arriving at v0 proves that it was a all the time.
    assert fold(cut(log, 3)) == Folded((0, 2, 3, 1), (1, 0, 3, 2), 0)


def test_where_one_of_two_darts_has_a_partner_merging_and_the_pointer_are_both_needed():
    # Round a triangle: to a and back, then the other way by b to a and to v0.  On the last
    # arrival both copies of a are merged, and the first one still lacks its way to b.
    world = World(cycle(3), Directional(0))
    log, dart = walk(world, [0, 0, 1, 1, 1])
    assert agree(cut(log, 4)).open_darts > 0
    folded = agree(log)
    assert folded.open_darts == 0
    assert len(folded.sigma) == 6
    assert embedding(folded, world)[folded.here] == dart


@pytest.mark.parametrize("k", range(4))
def test_two_ways_of_folding_agree_on_algorithm_1(k):
    for i, world in enumerate(worlds(3)):
        if i % 4 == k:
            assert agree(explored(world)[0]).open_darts == 0


def test_actions_that_do_not_move_fold_to_nothing():
    for world in worlds(2):
        log, _ = explored(world)
        steps = []
        seen = log.first
        for action, percept in log.steps:
            steps += [(Drop(), seen), (Pick(), seen), (action, percept)]
            seen = percept
        assert fold(Transcript(log.first, tuple(steps))) == fold(log)


def test_motions_count_modulo_the_degree():
    for world in worlds(2):
        log, _ = explored(world)
        seen, steps = log.first, []
        for action, percept in log.steps:
            steps.append((Move(action.k - 3 * seen.degree), percept))
            seen = percept
        assert fold(Transcript(log.first, tuple(steps))) == fold(log)


# ---------------------------------------------------------------- contradictory logs

V0 = Percept(1, 1, 0)


def log_of(first, *steps):
    return Transcript(first, tuple((Move(k), percept) for k, percept in steps))


@pytest.mark.parametrize(
    "log",
    [
        Transcript(Percept(1, 0, None)),
        Transcript(Percept(2, 1, None)),
        log_of(V0, (0, Percept(2, 1, None))),
        log_of(V0, (0, Percept(1, 1, None))),
        log_of(V0, (0, Percept(2, 1, 0))),
        log_of(V0, (0, Percept(2)), (0, Percept(2, 1, 0))),
        log_of(V0, (0, Percept(2)), (0, V0), (0, Percept(3))),
        log_of(V0, (0, Percept(2)), (1, V0)),
        log_of(V0, (0, Percept(2)), (1, V0), (0, Percept(1))),
    ],
    ids=lambda log: " / ".join(str(p) for p in [log.first, *(p for _, p in log.steps)]),
)
def test_a_log_of_no_world_is_a_contradiction(log):
    with pytest.raises(Contradiction):
        fold(log)


@pytest.mark.parametrize(
    "log",
    [
        log_of(V0, (0, Percept(1)), (0, Percept(1))),
        log_of(V0, (0, Percept(2)), (0, V0), (0, V0)),
        log_of(V0, (0, V0)),
        log_of(Percept(2, 1, 0), (0, Percept(2, 1, 0))),
        Transcript(Percept(2, 1, 2)),
        Transcript(Percept(2, 0, 0)),
        Transcript(Percept(0, 1, 0)),
        log_of(Percept(2, 1, 0), (0, Percept(2, 1, 5))),
        log_of(V0, (0, Percept(2, 0, 1))),
        log_of(V0, (0, Percept(0))),
    ],
    ids=[
        "home without its mark",
        "a mark where there was none",
        "a dart that leads to itself",
        "a dart of two that leads to itself",
        "first bearing too large",
        "a bearing without a mark at first",
        "first degree 0",
        "bearing too large",
        "a bearing without a mark",
        "degree 0",
    ],
)
def test_a_log_of_no_world_is_a_contradiction_in_these_ways_too(log):
    with pytest.raises(Contradiction):
        fold(log)
