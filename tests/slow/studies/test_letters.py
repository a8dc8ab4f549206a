"""The search for twins under words, and the census of all worlds, up to three edges."""

import pytest

from allworlds.studies.ambiguity import census, search
from studies.test_letters import sizes

PATTERNS = ["10*", "1*0", "12", "1", "110", "122", "102", "1020*", "1*00"]


@pytest.mark.slowest
@pytest.mark.parametrize("pattern", PATTERNS)
def test_a_search_finds_twins_of_the_sizes_that_all_worlds_have(tmp_path, pattern):
    kind = f"word:{pattern}"
    found = search(lighthouse=kind, edges=3, vertices=4, out=tmp_path)
    assert sizes(found.pair) == sizes(census(edges=3, lighthouse=kind).pair)


@pytest.mark.slowest
def test_constant_words_of_degree_five_have_twins_from_five_edges_on(tmp_path):
    options = {"lighthouse": "word:1", "degree_marked": 5, "vertices": 5, "out": tmp_path}
    assert search(edges=4, **options).status == "unsat"
    assert search(edges=5, **options).status == "sat"


@pytest.mark.parametrize(
    ("kind", "vertices", "degree"),
    # The second is blank at degree 1: v0 is not always known.
    [("door", 1, 4), ("word:1*0", 2, 2)],
)
def test_words_that_are_no_powers_have_none(tmp_path, kind, vertices, degree):
    found = search(lighthouse=kind, edges=2, vertices=vertices, degree_marked=degree, out=tmp_path)
    assert (found.status, found.pair) == ("unsat", None)
