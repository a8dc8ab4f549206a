from functools import cache
from itertools import permutations
from random import Random

import pytest

from allworlds.documents.document import replace
from allworlds.judging.laws.law_table import Case, Violation, invariant_1, invariant_2, variant
from allworlds.judging.walk import Walk
from allworlds.maps import rooted_maps
from allworlds.protocol.actions import Checkpoint, Drop, Estimate, Move
from allworlds.world import Directional, Movable, World
from finished import finished
from small import EDGE, LOLLIPOP, LOOP


@cache
def runs(m):
    return tuple(
        finished(World(map_, place))
        for map_ in rooted_maps(m)
        for place in Directional.places(map_, 0)
    )


def up_to(m):
    return [case for edges in range(1, m + 1) for case in runs(edges)]


def published(case, *checkpoints):
    return replace(case, checkpoints=checkpoints)


def single(case, i, **parts):
    """The case with its i-th checkpoint alone, some of its parts changed."""
    steps, checkpoint = case.checkpoints[i]
    return published(case, (steps, replace(checkpoint, **parts)))


def every(m):
    """``(case, i, checkpoint)`` for every checkpoint of every run up to m edges."""
    for case in up_to(m):
        for i, (_, checkpoint) in enumerate(case.checkpoints):
            yield case, i, checkpoint


def put(entries, changes):
    return tuple(changes.get(d, e) for d, e in enumerate(entries))


def kept(case):
    return (invariant_1(case), invariant_2(case), variant(case)) == (None, None, None)


def walked_darts(case, steps):
    """The darts of the edges traversed in the first steps, from the log alone."""
    dart, darts = case.start, set()
    for action, _ in case.walk.steps[:steps]:
        dart = case.map.alpha[case.map.turn(dart, action.k)]
        darts |= {dart, case.map.alpha[dart]}
    return darts, dart


def embeds(case, i, checkpoint):
    """I-1 by brute force: every injection of S into the world is tried."""
    darts, robot = walked_darts(case, case.checkpoints[i][0])
    sigma, alpha, size = checkpoint.sigma, checkpoint.alpha, len(checkpoint.sigma)
    if len(alpha) != size or not all(0 <= d < size for d in (*sigma, *alpha, checkpoint.here)):
        return False
    joined = [{d} for d in range(size)]
    for d in range(size):
        for e in (sigma[d], alpha[d]):
            both = joined[d] | joined[e]
            for x in both:
                joined[x] = both
    if len(joined[0]) < size:
        return False
    glued = [d for d in range(size) if alpha[d] != d]
    return any(
        image[checkpoint.here] == robot
        and all(image[sigma[d]] == case.map.sigma[image[d]] for d in range(size))
        and all(image[alpha[d]] == case.map.alpha[image[d]] for d in glued)
        and all(image[d] in darts for d in glued)
        for image in permutations(case.map.darts, size)
    )


# ---------------------------------------------------------------- right checkpoints


def test_what_is_never_shown_cannot_be_wrong():
    for case in up_to(3):
        assert kept(published(case))


def test_s_before_the_first_step_may_be_shown():
    for case in up_to(3):
        degree = case.map.degree_at[case.start]
        start = Checkpoint((*range(1, degree), 0), tuple(range(degree)), 0)
        assert kept(published(case, (0, start), *case.checkpoints))


@pytest.mark.parametrize("seed", range(3))
def test_the_names_of_the_darts_do_not_matter(seed):
    random = Random(seed)
    for case in up_to(3):
        renamed = []
        for steps, c in case.checkpoints:
            names = list(range(len(c.sigma)))
            random.shuffle(names)
            sigma, alpha = [0] * len(names), [0] * len(names)
            for d, name in enumerate(names):
                sigma[name], alpha[name] = names[c.sigma[d]], names[c.alpha[d]]
            renamed.append((steps, Checkpoint(tuple(sigma), tuple(alpha), names[c.here])))
        assert kept(published(case, *renamed))


def test_steps_that_are_no_motions_walk_no_edge():
    world = World(EDGE, Movable(markers=2))
    whole = Checkpoint((0, 1), (1, 0), 0)
    case = Case(Walk.of(world, (Drop(), Move(0), Drop())), (), Estimate(EDGE, 1))
    assert invariant_1(published(case, (1, whole))).law == "invariant-1"
    assert invariant_1(published(case, (2, replace(whole, here=1)))) is None
    assert invariant_1(published(case, (3, replace(whole, here=1)))) is None


# ---------------------------------------------------------------- I-1


def test_two_entries_of_sigma_exchanged_break_invariant_1():
    for case, i, checkpoint in every(3):
        sigma = checkpoint.sigma
        for d in range(len(sigma)):
            for e in range(d):
                swapped = put(sigma, {d: sigma[e], e: sigma[d]})
                assert invariant_1(single(case, i, sigma=swapped)).law == "invariant-1"


def test_an_edge_that_has_never_been_walked_breaks_invariant_1():
    met = 0
    for case in up_to(3):
        whole = case.checkpoints[-1][1]
        for steps, checkpoint in case.checkpoints[:-1]:
            darts, robot = walked_darts(case, steps)
            if len(darts) == len(case.map.sigma):
                continue
            met += 1
            # The true map, but too early.
            early = Checkpoint(case.map.sigma, case.map.alpha, robot)
            violation = invariant_1(published(case, (steps, early)))
            assert violation.law == "invariant-1"
            assert "never been walked" in violation.seen
            assert f"step {steps}" in violation.seen
            assert len(checkpoint.sigma) <= len(whole.sigma)
    assert met > 100


def test_a_part_that_is_not_connected_breaks_invariant_1():
    for case, i, checkpoint in every(3):
        size = len(checkpoint.sigma)
        apart = single(case, i, sigma=(*checkpoint.sigma, size), alpha=(*checkpoint.alpha, size))
        assert f"dart {size} of S is not connected" in invariant_1(apart).seen


def test_a_missing_dart_breaks_invariant_1():
    met = 0
    for case, i, checkpoint in every(3):
        last = len(checkpoint.sigma) - 1
        if checkpoint.alpha[last] != last or last in (0, checkpoint.here):
            continue
        met += 1
        # The open dart is cut out of its vertex, and S is in order otherwise.
        before = checkpoint.sigma.index(last)
        sigma = put(checkpoint.sigma, {before: checkpoint.sigma[last]})[:last]
        case_without = single(case, i, sigma=sigma, alpha=checkpoint.alpha[:last])
        assert invariant_1(case_without).law == "invariant-1"
    assert met > 100


@pytest.mark.parametrize("name", ["sigma", "alpha"])
@pytest.mark.parametrize("far", [-1, -(10**9), 10**9, None])
def test_entries_out_of_range_break_invariant_1(name, far):
    for case, i, checkpoint in every(2):
        entries = getattr(checkpoint, name)
        size = len(entries)
        for d in range(size):
            value = size if far is None else far
            bad = single(case, i, **{name: put(entries, {d: value})})
            violation = invariant_1(bad)
            assert violation.seen.endswith(f"{name}({d}) = {value} is no dart of S")
            assert violation.law == "invariant-1"
            # The other laws raise nothing.
            assert invariant_2(bad) is None or name == "alpha"
            variant(bad)


@pytest.mark.parametrize("name", ["sigma", "alpha", "here"])
def test_a_number_of_thousands_of_digits_breaks_invariant_1_and_nothing_else(name):
    huge = 10**5000
    case, i, checkpoint = next(every(2))
    entries = getattr(checkpoint, name)
    value = huge if name == "here" else put(entries, {0: huge})
    violation = invariant_1(single(case, i, **{name: value}))
    assert violation.law == "invariant-1"
    assert "an object of type int" in violation.seen


@pytest.mark.parametrize("here", [-1, 10**9])
def test_a_here_out_of_range_breaks_invariant_1(here):
    for case, i, checkpoint in every(2):
        for value in (here, len(checkpoint.sigma)):
            assert f"here = {value}" in invariant_1(single(case, i, here=value)).seen


def test_sequences_of_different_lengths_break_invariant_1():
    for case, i, checkpoint in every(2):
        size = len(checkpoint.sigma)
        for parts in (
            {"sigma": (*checkpoint.sigma, 0)},
            {"alpha": (*checkpoint.alpha, size)},
            {"alpha": checkpoint.alpha[:-1]},
            {"sigma": (), "alpha": ()},
        ):
            broken = single(case, i, **parts)
            assert "darts in sigma" in invariant_1(broken).seen
            invariant_2(broken)
            variant(broken)


@pytest.mark.parametrize("name", ["sigma", "alpha"])
def test_every_change_of_one_entry_is_judged_as_by_brute_force(name):
    fitting = 0
    for case, i, checkpoint in every(2):
        entries = getattr(checkpoint, name)
        for d in range(len(entries)):
            for value in range(len(entries)):
                other = replace(checkpoint, **{name: put(entries, {d: value})})
                fits = embeds(case, i, other)
                fitting += fits
                assert (invariant_1(published(case, (case.checkpoints[i][0], other))) is None) == (
                    fits
                ), (case.map, other)
    assert fitting


@pytest.mark.parametrize("k", range(4))
def test_seeded_changes_in_worlds_of_three_edges_are_judged_as_by_brute_force(k):
    random = Random(k)
    wrong = 0
    for _ in range(150):
        case = random.choice(runs(3))
        i = random.randrange(3)
        steps, checkpoint = case.checkpoints[i]
        size = len(checkpoint.sigma)
        d, e = random.randrange(size), random.randrange(size)
        alpha = {a: a for a in (checkpoint.alpha[d], checkpoint.alpha[e])} | {d: e, e: d}
        other = replace(checkpoint, alpha=put(checkpoint.alpha, alpha))
        fits = embeds(case, i, other)
        wrong += not fits
        assert (invariant_1(published(case, (steps, other))) is None) == fits
    assert wrong


# ---------------------------------------------------------------- I-2


def test_a_partner_left_in_u_breaks_invariant_2_and_not_invariant_1():
    met, wrong = 0, []
    for case, i, checkpoint in every(3):
        for d, e in enumerate(checkpoint.alpha):
            if d == e:
                continue
            met += 1
            left = single(case, i, alpha=put(checkpoint.alpha, {e: e}))
            violation = invariant_2(left)
            assert violation.law == "invariant-2"
            assert f"dart {e} is in U" in violation.seen
            assert f"explored dart {d}" in violation.seen
            if invariant_1(left) is not None:
                wrong.append((case.map, left.checkpoints))
    assert met > 1000
    assert not wrong, f"I-1 is blamed {len(wrong)} of {met} times, for example in {wrong[0]}"


def test_a_partner_left_in_u_in_the_lollipop_where_the_robot_stands_behind_the_bridge():
    case = finished(World(LOLLIPOP, Directional(0)))
    # After one step: v0's dart 0 leads to dart 1, where the robot is; dart 1 is still in U.
    left = published(case, (1, Checkpoint((0, 2, 3, 1), (1, 1, 2, 3), 1)))
    assert invariant_2(left).law == "invariant-2"
    assert invariant_1(left) is None


def test_open_darts_alone_do_not_break_invariant_2():
    for case, i, checkpoint in every(3):
        alone = single(case, i, alpha=tuple(range(len(checkpoint.alpha))))
        assert invariant_2(alone) is None


# ---------------------------------------------------------------- the variant


def test_a_checkpoint_shown_twice_breaks_the_variant():
    for case in up_to(3):
        for i, again in enumerate(case.checkpoints):
            t = case.map.edge_count - i - 1
            shown = case.checkpoints
            violation = variant(published(case, *shown[: i + 1], again, *shown[i + 1 :]))
            assert violation == Violation(
                "variant",
                f"t = |E_G| - |E_S| below {t} after the next pass",
                f"t = {t} at the checkpoint after step {again[0]}",
                step=again[0],
            )


def test_checkpoints_out_of_order_break_the_variant():
    for case in up_to(3):
        if case.map.edge_count > 1:
            assert variant(published(case, *reversed(case.checkpoints))).law == "variant"


def test_the_last_checkpoint_missing_breaks_the_variant():
    for case in up_to(4):
        if case.map.edge_count > 1:
            assert variant(published(case, *case.checkpoints[:-1])) == Violation(
                "variant", "t = |E_G| - |E_S| = 0 at the end", "t = 1"
            )


def test_a_checkpoint_left_out_on_the_way_breaks_nothing():
    for case in up_to(3):
        assert kept(published(case, *case.checkpoints[1:]))
        assert kept(published(case, case.checkpoints[-1]))


def test_more_edges_than_there_are_break_the_variant():
    case = finished(World(EDGE, Directional(0)))
    many = Checkpoint((1, 0, 3, 2), (1, 0, 3, 2), 0)
    assert variant(published(case, (1, many))).seen == "t = -1"


def test_an_edge_known_from_one_end_counts_once():
    case = finished(World(EDGE, Directional(0)))
    assert variant(published(case, (1, Checkpoint((0, 1), (1, 1), 1)))) is None


@pytest.mark.parametrize("entries", [p for n in (1, 2, 3) for p in permutations(range(n))])
def test_one_tuple_for_sigma_and_alpha_is_judged_as_two_equal_ones(entries):
    for case in up_to(2):
        for here in range(len(entries)):
            once = Checkpoint(entries, entries, here)
            twice = Checkpoint(entries, tuple(iter(entries)), here)
            steps = len(case.walk.steps)
            assert invariant_1(published(case, (steps, once))) == invariant_1(
                published(case, (steps, twice))
            )


def test_one_tuple_for_both_is_no_way_past_invariant_1():
    only = (0,)
    case = published(finished(World(EDGE, Directional(0))), (0, Checkpoint(only, only, 0)))
    assert invariant_1(case) is None  # the edge's dart, alone at its vertex
    loop = finished(World(LOOP, Directional(0)))
    assert invariant_1(published(loop, (0, Checkpoint(only, only, 0)))).step == 0
