"""Files of a search, read back by programs that share no code with it."""

import json
import subprocess
import sys

import pytest

import allworlds
from allworlds.studies.ambiguity import solvers, twin_search as searching

CAPTION = {"motions": (1, 1, 2, 2, 1), "percepts": ("3A", "3A", "3A", "3A", "4P")}
WALK = tuple((k, int(p[0]), p[1] == "P") for k, p in zip(*CAPTION.values(), strict=True))
needs_python_sat = pytest.mark.skipif(
    not solvers.python_sat_is_installed(), reason="python-sat is not installed: no certificates"
)


@pytest.fixture
def searched(checkers):
    return checkers("searched")


def asked(checkers, lighthouse, map_class="maps", **more):
    return checkers("world_clauses").Asked(lighthouse, map_class, **more)


def refusal(checkers, *arguments):
    with pytest.raises(checkers("lrat").Refused) as error:
        checkers("searched").check(*arguments)
    return str(error.value)


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.long
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


def wrong_dimacs(path):
    """As the producer's reader, but every clause that it reads is empty."""
    variables, clauses = READ_DIMACS(path)
    return variables, [() for _ in clauses]


READ_DIMACS = searching.read_dimacs


@needs_python_sat
def test_a_producer_that_reads_every_clause_as_empty_is_found_out(checkers, tmp_path, monkeypatch):
    """Its own checker would not notice: it is handed the same clauses."""
    monkeypatch.setattr(searching, "read_dimacs", wrong_dimacs)
    result = allworlds.search(lighthouse="directional", vertices=3, edges=2, out=tmp_path)
    assert result.certificate == tmp_path
    said = refusal(checkers, tmp_path, asked(checkers, "directional"), 3, 2)
    assert said.startswith("m1n1to2.lrat: line 1: ")


@needs_python_sat
@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (lambda lines: lines[:-1], "announces"),
        (lambda lines: [*lines[:-1], "1 0"], "says what it should not: [1]"),
        (lambda lines: [*lines[:-1], lines[-2]], "does not say"),
        (lambda lines: [*lines[:-1], "0"], "says what it should not: []"),
    ],
)
def test_a_producer_that_writes_another_formula_is_found_out(checkers, tmp_path, damage, message):
    allworlds.search(lighthouse="directional", vertices=3, edges=1, out=tmp_path)
    path = tmp_path / "m1n1to2.cnf"
    path.write_text("\n".join(damage(path.read_text().splitlines())) + "\n")
    said = refusal(checkers, tmp_path, asked(checkers, "directional"), 3, 1)
    assert said.startswith("m1n1to2.cnf: ")
    assert message in said


@pytest.mark.slow
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


def test_a_pair_must_be_as_asked_for(checkers, tmp_path, proofs):
    pairs = json.loads((proofs / "smallest-pairs" / "pairs.json").read_text())
    figure = json.loads((proofs / "fig1" / "pairs.json").read_text())["planar-simple"]

    def said(entry, **question):
        (tmp_path / "pair.json").write_text(json.dumps(entry))
        wanted = asked(checkers, "position", **question)
        return refusal(checkers, tmp_path, wanted, 9, 14)

    assert "not of the class planar" in said(pairs["maps"], map_class="planar")
    assert "not of the class simple" in said(pairs["maps"], map_class="simple")
    assert "another degree" in said(figure, marked=3)
    assert "another degree" in said(figure, others=4)
    assert "the walk senses" in said(figure, walk=((1, 3, True),))
    assert "the walk senses" in said(figure, walk=((1, 4, False),))
    twice = {
        **figure,
        "pair": figure["pair"][:1] * 2,
        "bisimulation": figure["bisimulation"][:1] * 2,
    }
    assert said(twice) == "the two worlds are the same"


def run(proofs, folder, *options):
    command = [sys.executable, "-E", "-s", "-S", str(proofs / "searched.py"), str(folder), *options]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    return ran.returncode, ran.stdout, ran.stderr


def test_the_program_needs_no_package_and_says_one_line(proofs, tmp_path):
    allworlds.search(lighthouse="position", vertices=3, edges=2, out=tmp_path)
    bounds = ("--lighthouse", "position", "--vertices", "3", "--edges", "2")
    code, out, err = run(proofs, tmp_path, *bounds)
    assert (code, out, err) == (0, "VERIFIED: two different worlds look alike: m = 2, n = 1\n", "")
    code, out, err = run(proofs, tmp_path, *bounds, "--motions", "1,0", "--percepts", "4P")
    assert (code, err) == (1, "")
    assert out == "REFUSED: 2 motions and 1 percepts: one after each motion\n"
    (tmp_path / "pair.json").unlink()
    code, out, err = run(proofs, tmp_path, *bounds)
    assert (code, out) == (2, "")
    assert err.endswith(".lrat: No such file or directory\n")
    assert run(proofs, tmp_path, *bounds[:-1], "0")[:2] == (
        1,
        "REFUSED: no world has these sizes, so there is nothing to verify\n",
    )


@pytest.mark.parametrize(
    "options",
    [
        ("--motions", "1,x"),
        ("--percepts", "3B"),
        ("--degree-marked", "0"),
        ("--degree-others", "-1"),
    ],
)
def test_bad_options_are_refused_in_one_line_that_names_them(proofs, tmp_path, options):
    bounds = ("--lighthouse", "position", "--vertices", "3", "--edges", "2")
    code, out, err = run(proofs, tmp_path, *bounds, *options)
    assert (code, len(out.splitlines()), err) == (1, 1, "")
    assert options[1] in out
