"""The search for twins under a door and under words, against the census."""

import re

import pytest

from allworlds.inputs.checks import InputError
from allworlds.maps import CombinatorialMap, MapClass
from allworlds.maps.combinatorial import numbering
from allworlds.reports.formats import text
from allworlds.studies.ambiguity import census, search, twins
from allworlds.studies.ambiguity.formulas import forbid_other_start, pair_formula
from allworlds.studies.ambiguity.question import Question, Size, Sizes
from allworlds.studies.ambiguity.solvers import solve_with_z3
from allworlds.world import Word, World


def sizes(pair):
    return sorted((world.map.edge_count, world.map.vertex_count) for world in pair or ())


@pytest.mark.parametrize(
    ("kind", "pair"),
    [
        ("word:12", [(2, 1), (2, 1)]),  # one at degree 4
        ("word:1*00", [(1, 1), (2, 2)]),  # blank at degree 2
    ],
)
def test_the_smallest_twins_are_those_of_all_worlds(tmp_path, kind, pair):
    found = search(lighthouse=kind, edges=2, vertices=3, out=tmp_path)
    assert sizes(found.pair) == sizes(census(edges=2, lighthouse=kind).pair) == pair
    assert {world.lighthouse.written for world in found.pair} == {kind}


def test_a_power_of_a_word_that_is_not_its_own_mirror_image_has_twins(tmp_path):
    found = search(lighthouse="word:123", edges=3, vertices=1, degree_marked=6, out=tmp_path)
    assert sizes(found.pair) == [(3, 1), (3, 1)]


@pytest.mark.parametrize(
    ("kind", "more", "error"),
    [
        ("word:x", {}, "'x' is no pattern"),
        ("doors", {}, "'doors' is not one of none, position, directional, compass, door, word"),
        ("door", {"motions": (1,), "percepts": ("3A",)}, "no walk with --lighthouse door"),
    ],
)
def test_what_is_no_question_of_letters_is_refused(kind, more, error):
    with pytest.raises(InputError, match=re.escape(error)):
        search(lighthouse=kind, edges=1, vertices=1, **more)


@pytest.mark.parametrize(("kind", "status"), [("word:1", "unsat"), ("word:12", "sat")])
def test_one_map_started_twice_is_two_worlds_only_if_the_letters_differ(tmp_path, kind, status):
    question = Question(kind, MapClass.MAPS, 1, 2)
    formula, pair = pair_formula(question, Sizes(Size(2, 1, 1), Size(2, 1, 1)))
    # Both are aabb, of which the second is started one dart later: abba.
    for world, alpha in ((pair.one, (1, 0, 3, 2)), (pair.two, (3, 2, 1, 0))):
        order = numbering((1, 2, 3, 0), alpha, 0)
        for dart, name in enumerate(order):
            formula.add(world.alpha[dart, order.index(alpha[name])])
            formula.add(world.sigma[dart, order.index((name + 1) % 4)])
    for start in (1, 2, 3):
        forbid_other_start(formula, pair, start)
    formula.write(tmp_path / "pair.cnf")
    assert solve_with_z3(tmp_path / "pair.cnf", None).status == status


def test_of_a_quotient_the_letters_of_all_darts_are_told():
    plane, turned = (
        World(CombinatorialMap((1, 2, 3, 0), alpha), Word(0, "12"))
        for alpha in ((1, 0, 3, 2), (3, 2, 1, 0))
    )
    assert "degree 4, marked; degree 4, marks 2" in text(twins(plane, turned), 100)
