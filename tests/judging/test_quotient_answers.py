"""The law about an answer that names no map."""

import pytest

from allworlds.documents.document import replace
from allworlds.judging.laws.law_table import PRECEDENCE, Case, first_broken
from allworlds.judging.walk import Walk
from allworlds.protocol.actions import Ambiguous, Estimate, Move
from allworlds.studies.ambiguity import class_of
from allworlds.world import Position, World
from small import EDGE, PLANE, TORUS, all_maps

DEEP = 8


def looks(world, dart, depth=DEEP):
    """The percepts after each word of fewer than ``depth`` sigmas and alphas, each word tried."""
    map_ = world.map
    front, seen = [dart], []
    for _ in range(depth):
        seen.append(tuple(world.percepts[d] for d in front))
        front = [e for d in front for e in (map_.sigma[d], map_.alpha[d])]
    return tuple(seen)


def quotient_of(world, here):
    """The rooted quotient without any refinement: darts that look alike are one."""
    look = [looks(world, dart) for dart in world.map.darts]
    names = {}
    for dart in world.map.darts:
        names.setdefault(look[dart], len(names))
    first = {names[look[dart]]: dart for dart in reversed(world.map.darts)}
    darts = [first[name] for name in range(len(names))]
    of = [names[shown] for shown in look]
    return Ambiguous(
        [of[world.map.sigma[d]] for d in darts],
        [of[world.map.alpha[d]] for d in darts],
        [world.percepts[d].degree for d in darts],
        [world.percepts[d].marks for d in darts],
        of[here],
    )


def case(world, answer, motions=()):
    return Case(Walk.of(world, map(Move, motions)), (), answer)


def worlds(most):
    return [World(map_, Position(0)) for map_ in all_maps(most)]


def broken(*given):
    violation = first_broken(case(*given), [])
    return violation.law if violation else ""


@pytest.mark.parametrize("motions", [(), (0,), (1, 2)])
def test_the_quotient_is_right_exactly_where_the_class_has_two_members(motions):
    right = 0
    for world in worlds(3):
        here = case(world, None, motions).walk.here
        alone = class_of(world).size == 1
        assert broken(world, quotient_of(world, here), motions) == ("ambiguity" if alone else "")
        right += not alone
    assert right


def test_a_world_without_lookalikes_is_not_to_be_left_open():
    world = World(EDGE, Position(0))
    violation = first_broken(case(world, quotient_of(world, 0)), [])
    assert violation.expected == "the map: no other world looks like this one"
    assert violation.seen.startswith("Ambiguous, the quotient rooted at 0 with sigma [0, 1]")


def test_one_look_and_two_maps_have_one_right_answer():
    one, other = (quotient_of(World(map_, Position(0)), 0) for map_ in (PLANE, TORUS))
    assert one == other == Ambiguous([0], [0], [4], [1], 0)


@pytest.mark.parametrize("part", ["here", "marks", "degree", "alpha", "sigma"])
def test_a_quotient_that_is_wrong_in_one_part_is_refuted(part):
    tried = 0
    for world in worlds(3):
        if class_of(world).size == 1:
            continue
        right = quotient_of(world, 0)
        size = len(right.sigma)
        for wrong in changed(right, part, size):
            tried += 1
            assert broken(world, wrong) == "ambiguity"
    assert tried


def changed(right, part, size):
    """Other values of one part that give another rooted quotient."""
    match part:
        case "here":
            # No two darts of a quotient are alike, so every other dart is wrong.
            return [replace(right, here=other) for other in range(size) if other != right.here]
        case "marks":
            return [replace(right, marks=[1 - mark for mark in right.marks])]
        case "degree":
            return [replace(right, degree=[2 * degree for degree in right.degree])]
        case "alpha":
            return [replace(right, alpha=[*range(size)])] * (right.alpha != [*range(size)])
        case "sigma":
            swapped = [right.sigma[d] for d in (1, 0, *range(2, size))] if size > 1 else []
            return [replace(right, sigma=swapped)] * (size > 1)


def test_the_names_of_the_darts_do_not_matter():
    for world in worlds(3):
        right = quotient_of(world, 0)
        size = len(right.sigma)
        names = [*range(1, size), 0]
        renamed = Ambiguous(
            *(moved(values, names, mapped) for values, mapped in both(right)),
            names[right.here],
        )
        assert broken(world, renamed) == broken(world, right)


def both(right):
    return [(right.sigma, True), (right.alpha, True), (right.degree, False), (right.marks, False)]


def moved(values, names, mapped):
    found = [0] * len(values)
    for dart, value in enumerate(values):
        found[names[dart]] = names[value] if mapped else value
    return found


def test_a_map_is_never_held_to_the_law_about_quotients():
    world = World(PLANE, Position(0))
    assert broken(world, Estimate(TORUS, 0)) == ""


def test_it_comes_after_map_and_pose_and_before_the_invariants():
    at = PRECEDENCE.index("ambiguity")
    assert PRECEDENCE[at - 2 : at + 3] == ("map", "pose", "ambiguity", "task", "invariant-1")
