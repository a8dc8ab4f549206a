"""Files of a search, read back by programs that share no code with it."""

import pytest

import allworlds
from proofs import test_searched as quick
from proofs.test_searched import asked, needs_python_sat, refusal

searched = quick.searched

CAPTION = {"motions": (1, 1, 2, 2, 1), "percepts": ("3A", "3A", "3A", "3A", "4P")}


WALK = tuple((k, int(p[0]), p[1] == "P") for k, p in zip(*CAPTION.values(), strict=True))


@pytest.mark.slowest
@needs_python_sat
@pytest.mark.parametrize(
    ("lighthouse", "map_class", "edges", "formulas"),
    [
        ("position", "maps", 1, 1),
        ("position", "simple", 4, 4),
        ("position", "planar-simple", 4, 4),
        ("position", "planar", 2, 2),
        ("directional", "maps", 3, 3),
        ("directional", "simple", 4, 4),
        ("none", "simple", 3, 6),  # pairs of sizes
        ("compass", "simple", 3, 6),
    ],
)
def test_formulas_and_proofs_of_a_search_are_those_of_its_question(
    checkers, tmp_path, lighthouse, map_class, edges, formulas
):
    bounds = {"vertices": edges + 1, "edges": edges, "map_class": map_class}
    result = allworlds.search(lighthouse=lighthouse, out=tmp_path, **bounds)
    assert result.certificate == tmp_path
    question = asked(checkers, lighthouse, map_class)
    said = checkers("searched").check(tmp_path, question, edges + 1, edges)
    assert said.startswith(f"no pair: {formulas} formulas are those meant; LRAT, ")
    # Another question has other formulas, or none of that name.
    other = asked(checkers, {"position": "directional"}.get(lighthouse, "position"), map_class)
    with pytest.raises((checkers("lrat").Refused, OSError)):
        checkers("searched").check(tmp_path, other, edges + 1, edges)


@pytest.mark.slowest
@needs_python_sat
def test_a_search_with_degrees_and_a_walk_is_read_back(checkers, tmp_path):
    bounds = {"vertices": 5, "edges": 8, "map_class": "planar-simple"}
    degrees = {"degree_marked": 4, "degree_others": 3}
    result = allworlds.search(lighthouse="position", out=tmp_path, **bounds, **degrees, **CAPTION)
    assert (result.status, result.certificate) == ("unsat", tmp_path)
    caption = asked(checkers, "position", "planar-simple", marked=4, others=3, walk=WALK)
    assert "no pair: 1 formulas" in checkers("searched").check(tmp_path, caption, 5, 8)
    backwards = asked(checkers, "position", "planar-simple", marked=4, others=3, walk=WALK[::-1])
    assert "says what it should not" in refusal(checkers, tmp_path, backwards, 5, 8)


@pytest.mark.parametrize(
    ("lighthouse", "map_class", "vertices", "edges", "size"),
    [
        ("position", "maps", 3, 2, "m = 2, n = 1"),
        ("position", "simple", 4, 6, "m = 6, n = 4"),
        ("none", "maps", 2, 2, "m = 1, n = 1 and m = 2, n = 2"),  # a loop, and two parallel edges
        ("compass", "simple", 4, 4, "m = 3, n = 3 and m = 4, n = 4"),
    ],
)
def test_a_pair_of_a_search_is_verified(
    checkers, tmp_path, lighthouse, map_class, vertices, edges, size
):
    bounds = {"vertices": vertices, "edges": edges, "map_class": map_class}
    result = allworlds.search(lighthouse=lighthouse, out=tmp_path, **bounds)
    assert result.status == "sat"
    question = asked(checkers, lighthouse, map_class)
    said = checkers("searched").check(tmp_path, question, vertices, edges)
    assert said == f"two different worlds look alike: {size}"
    assert "larger than the bounds" in refusal(checkers, tmp_path, question, vertices, edges - 1)
    assert "larger than the bounds" in refusal(checkers, tmp_path, question, 0, edges)
