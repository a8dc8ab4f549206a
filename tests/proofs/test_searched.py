"""Files of a search, read back by programs that share no code with it."""

import json
import subprocess
import sys

import pytest

import allworlds
from allworlds.studies.ambiguity import solvers, twin_search

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


def wrong_dimacs(path):
    """As the producer's reader, but every clause that it reads is empty."""
    variables, clauses = READ_DIMACS(path)
    return variables, [() for _ in clauses]


READ_DIMACS = twin_search.read_dimacs


@needs_python_sat
def test_a_producer_that_reads_every_clause_as_empty_is_found_out(checkers, tmp_path, monkeypatch):
    """Its own checker would not notice: it is handed the same clauses."""
    monkeypatch.setattr(twin_search, "read_dimacs", wrong_dimacs)
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
