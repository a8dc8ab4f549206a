import pytest

from allworlds.judging.laws.law_table import (
    LAWS,
    PRECEDENCE,
    Case,
    Violation,
    bound_law,
    first_broken,
    folding_law,
    map_law,
    pose_law,
)
from allworlds.judging.walk import Walk
from allworlds.maps import CombinatorialMap, rooted_maps
from allworlds.protocol.actions import Estimate, Move
from allworlds.world import Directional, World
from finished import finished
from small import EDGE, LOLLIPOP, LOOP, PLANE, TORUS


def walked(world, *motions):
    """The walk of these motions."""
    return Walk.of(world, map(Move, motions))


def answered(map_, dart, estimate, here, **rest):
    world = World(map_, Directional(dart), dart)
    return Case(walked(world), (), Estimate(estimate, here), **rest)


def test_the_laws_stand_in_the_order_in_which_they_are_reported():
    assert list(LAWS) == [
        "map",
        "pose",
        "invariant-1",
        "invariant-2",
        "variant",
        "folding",
        "bound",
    ]
    assert tuple(PRECEDENCE) == (
        "crash",
        "timeout",
        "illegal-action",
        "no-estimate",
        "budget",
        "nondeterministic",
        "map",
        "pose",
        "ambiguity",
        "task",
        *list(LAWS)[2:],
    )


def test_the_right_answer_breaks_neither_law():
    for case in (answered(LOLLIPOP, 0, LOLLIPOP, 0), answered(EDGE, 0, EDGE, 1)):
        assert case.answer == "right"
        assert map_law(case) is None
        assert pose_law(case) is None


def test_the_right_map_with_a_wrong_here_breaks_the_pose_alone():
    case = answered(LOLLIPOP, 0, LOLLIPOP, 2)
    assert case.answer == "pose"
    assert map_law(case) is None
    assert pose_law(case) == Violation("pose", Estimate(LOLLIPOP, 0), Estimate(LOLLIPOP, 2))


@pytest.mark.parametrize(
    ("truth", "estimate"),
    [(PLANE, TORUS), (TORUS, PLANE), (EDGE, LOOP), (LOOP, EDGE), (EDGE, PLANE), (PLANE, EDGE)],
)
def test_another_map_breaks_the_map_alone(truth, estimate):
    case = answered(truth, 0, estimate, 0)
    assert case.answer == "map"
    assert pose_law(case) is None
    assert map_law(case) == Violation("map", Estimate(truth, 0), Estimate(estimate, 0))


def test_the_mirror_image_is_another_map_where_it_is_not_the_same():
    # A vertex of degree 4 whose neighbours clockwise are a leaf, a vertex with a loop, and a
    # digon: with three different things around it the sense of rotation shows.
    chiral = CombinatorialMap((1, 2, 3, 0, 4, 6, 7, 5, 9, 8), (4, 5, 8, 9, 0, 1, 7, 6, 2, 3))
    assert answered(chiral, 0, chiral, 0).answer == "right"
    assert answered(chiral, 0, chiral.mirrored(), 0).answer == "map"


def test_the_pose_is_that_at_the_end_of_the_log():
    world = World(LOLLIPOP, Directional(0))
    log = walked(world, 0, 1)  # to dart 1, then leave by 2 and arrive by 3
    for here, worth in ((0, "pose"), (1, "pose"), (2, "pose"), (3, "right")):
        assert Case(log, (), Estimate(LOLLIPOP, here)).answer == worth


def test_renaming_the_darts_of_the_answer_changes_nothing():
    names = (2, 0, 3, 1)
    renamed = LOLLIPOP.relabelled(names)
    for dart in LOLLIPOP.darts:
        for here in LOLLIPOP.darts:
            plain = answered(LOLLIPOP, dart, LOLLIPOP, here).answer
            assert answered(LOLLIPOP, dart, renamed, names[here]).answer == plain


def test_the_bound_may_be_reached_and_not_passed():
    world = World(EDGE, Directional(0))
    log = walked(world, 0, 0, 0)
    estimate = Estimate(EDGE, 1)
    for bound in (None, 3, 4):
        assert bound_law(Case(log, (), estimate, bound)) is None
    for bound in (2, 0, -1):
        case = Case(log, (), estimate, bound)
        assert bound_law(case) == Violation("bound", bound, 3)


def test_an_answer_before_the_log_determines_the_map_breaks_folding():
    world = World(LOLLIPOP, Directional(0))
    guess = Case(walked(world), (), Estimate(LOLLIPOP, 0))
    violation = folding_law(guess)
    assert violation.law == "folding"
    assert "1 open dart " in violation.seen
    later = Case(walked(world, 0), (), Estimate(LOLLIPOP, 1))
    assert "2 open darts " in folding_law(later).seen


def checks(*names):
    """The checks of the laws of these names; without names, those of all laws."""
    return [LAWS[name].check for name in names or LAWS]


def test_the_judge_reports_the_first_broken_law_of_those_it_is_given():
    world = World(LOLLIPOP, Directional(0))
    case = Case(walked(world, 0), (), Estimate(EDGE, 0), 0)
    assert first_broken(case, checks()).law == "map"
    without = checks(*(name for name in LAWS if name != "map"))
    assert first_broken(case, without).law == "folding"
    assert first_broken(case, [bound_law, folding_law]).law == "bound"
    assert first_broken(case, []) is None


def test_every_run_of_algorithm_1_keeps_every_law():
    for m in (1, 2, 3, 4):
        for map_ in rooted_maps(m):
            for place in Directional.places(map_, 0):
                assert first_broken(finished(World(map_, place)), checks()) is None
