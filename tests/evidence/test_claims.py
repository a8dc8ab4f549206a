"""Each claim can fail: what it looks at is damaged, and it says so."""

import re

import pytest
from allworlds.evidence.claims import (
    complexity,
    folds,
    limits,
    machine,
    passes,
    position,
)
from allworlds.evidence.claims.claim_table import CHECKS
from allworlds.evidence.claims.claim_types import Means, NotChecked, Unfinished, of_check
from allworlds.evidence.claims.ledger import entry_of
from allworlds.evidence.claims.manifest import manifest

from allworlds.judging import paper_bound
from allworlds.protocol import Checkpoint, Move
from allworlds.world import Directional, World

BY_NAME = {claim.id: claim for claim in manifest()}


def verdict(name, **bounds):
    return CHECKS[name](Means(), **bounds).verdict


class Wasteful(passes.Watched):
    """Goes back and forth once more in its first pass: two traversals too many, and no more."""

    def follow(self, goal):
        percept = yield from super().follow(goal)
        if len(self.begun) == 1:
            yield Move(0)
            percept = yield Move(0)
        return percept


def test_a_pass_that_costs_too_much_is_found_out_though_the_run_keeps_its_bound(monkeypatch):
    monkeypatch.setattr(passes, "Watched", Wasteful)
    world = World(folds.complete_behind_a_path(3, 1), Directional(0))
    met = passes.passes_of(world)
    total = paper_bound(world.map.vertex_count, world.map.edge_count)
    assert sum(one.cost for one in met) <= total
    assert met[0].cost > complexity.pass_bound(world.map.edge_count, 1, 0)
    assert verdict("pass-cost", edges=3, policies=["fifo"]) == "refuted"
    assert verdict("pass-walk", edges=3, policies=["fifo"]) == "refuted"


def test_a_pass_that_is_not_shown_is_no_pass_to_be_believed(monkeypatch):
    def silent(self):
        exploring, seen = super(passes.Watched, self).explore(), None
        while True:
            try:
                said = exploring.send(seen)
            except StopIteration as end:
                return end.value
            seen = None if type(said) is Checkpoint else (yield said)

    monkeypatch.setattr(passes.Watched, "explore", silent)
    with pytest.raises(Unfinished, match="after each pass"):
        passes.passes_of(World(folds.complete_behind_a_path(3, 1), Directional(0)))


def test_a_check_without_a_verdict_decides_no_claim():
    from allworlds import check

    with pytest.raises(Unfinished, match="inconclusive"):
        of_check(check("algorithm1", edges=5, time_limit=1e-9))


def test_sympy_is_asked_only_where_it_is(monkeypatch):
    monkeypatch.setattr(complexity, "find_spec", lambda _name: None)
    found = complexity.terms_left_out(Means(), edges=2)
    assert isinstance(found, NotChecked)
    assert ".[proofs]" in found.reason


REFERS = re.compile(r"(The same|So (does|do|is|are)|It|They|That|These|Those|This|Such|There)\b")
"""The beginnings of a sentence that is understood beside another one alone."""


@pytest.mark.parametrize("name", BY_NAME)
def test_a_statement_says_by_itself_what_is_claimed(name):
    statement = BY_NAME[name].statement
    assert not REFERS.match(statement)
    assert "The same" not in statement
    assert statement.endswith(".")


SMALL = {
    "pass-hypotheses": {"edges": 2, "policies": ["fifo"]},
    "pass-tests": {"edges": 3, "policies": ["lifo"]},
    "not-both": {"edges": 3},
    "tests-decide": {"edges": 3},
    "every-schedule": {"edges": 1, "most_expensive": 2},
    "no-twins-smt": {"edges": 2},
    "no-twins-with-direction": {"edges": 2},
    "invariant-at-start": {"edges": 2},
    "every-edge-walked": {"edges": 2},
    "dfs-2m": {"edges": 2},
    "order-reached": {"family": "thick:4", "to": 30, "growing": 0.5},
    "below-bound": {"families": ["lattice:3x3"], "seeds": 1, "share": 1.0},
    "cluster": {"edges": 4},
    "natural": {"edges": 4},
    "cluster-multigraphs": {"edges": 2},
    "smallest-twins": {"edges": 2},
    "trees-need-none": {"edges": 2},
    "position-robot": {"edges": 2},
    "two-sheets": {"edges": 2},
    "lookalikes-one-size": {"edges": 2},
    "logs-fold": {"edges": 2},
    "folding-explores": {"edges": 2},
    "entries-of-v0": {"edges": 2, "explorers": ["greedy"]},
    "path-lower-bound": {"sizes": [[3, 2]], "explorers": ["algorithm1"]},
    "optimum": {"edges": 2},
    "remembering-never-more": {"edges": 3, "one": "remembering", "other": "algorithm1"},
    "never-forgetting-in-bound": {"edges": 3, "explorers": ["greedy"]},
    "marker-tells-entry": {"edges": 2},
    "orders-are-shifts": {"edges": 2},
    "two-door-rooms": {"length": 3},
    "orientation-alone": {"length": 4},
    "position-tells-cycles": {"length": 4},
    "two-vertices-order": {"edges": 3},
    "direction-needed": {},
    "position-not-enough": {"pairs": ["pair-two-loops", "pair-k4"]},
    "exact-worst": {"edges": 2},
    "bound": {"edges": 2},
    "lighthouse-suffices": {"edges": 2},
    "invariant-kept": {"edges": 2},
    "variant-falls": {"edges": 2},
}


@pytest.mark.parametrize("name", SMALL)
def test_a_claim_holds_in_a_small_scope_too(name):
    assert verdict(name, **SMALL[name]) == "holds"


@pytest.mark.parametrize(
    ("name", "bounds"),
    [
        ("movable-marker-multigraphs", {"edges": 2}),
        ("natural-multigraphs", {"edges": 4}),
        ("greedy-never-more", {"edges": 3, "one": "greedy", "other": "algorithm1"}),
        ("transit-explains", {"families": ["lattice:4x4"], "seeds": 1, "share": 0.5}),
        ("order-reached", {"family": "thick:4", "to": 30, "growing": 9.0}),
        ("smallest-twins", {"edges": 1}),
        ("position-not-enough", {"pairs": ["pair-two-loops"]}),
    ],
)
def test_a_claim_that_is_false_is_refuted(monkeypatch, name, bounds):
    if name == "position-not-enough":
        world = World(folds.complete_behind_a_path(3, 1), Directional(0))
        monkeypatch.setattr(position, "pair_of_corpus", lambda _name: (world, world))
    assert verdict(name, **bounds) == "refuted"


# ---------------------------------------------------------------- certificates and proofs

CHECKER = """
import sys
if {code} == 2:
    print("check.py: a file is missing", file=sys.stderr)
    sys.exit(2)
print("claim verdict seconds what")
print("cycles                holds        0.1  one thing")
print(" " * 40 + "another")
sys.exit({code})
"""


@pytest.fixture
def proofs(tmp_path):
    def made(code):
        (tmp_path / "check.py").write_text(CHECKER.format(code=code))
        return Means(proofs=tmp_path, budget="full")

    return made


def test_a_certificate_counts_as_its_checker_says(proofs):
    found = machine.certificate(proofs(0), claim="cycles")
    assert (found.verdict, found.witnesses) == ("holds", {"statements": 2})
    assert found.told == "one thing; another"
    assert machine.certificate(proofs(1), claim="cycles").verdict == "refuted"
    assert machine.certificate(proofs(2), claim="cycles").reason == "check.py: a file is missing"


def test_without_a_folder_or_coq_or_time_nothing_is_said(proofs, monkeypatch):
    assert "--proofs" in machine.certificate(Means(), claim="cycles").reason
    assert "--proofs" in machine.theorem(Means(), names=["x"]).reason
    quick = Means(proofs=proofs(0).proofs)
    assert "--budget full" in machine.theorem(quick, names=["x"]).reason
    monkeypatch.setenv("PATH", "")
    assert machine.theorem(proofs(0), names=["x"]).reason == "Coq is not installed"


MAKEFILE = """
assumptions:
	@test -f Main.v && test ! -f Main.vo && {command}
"""


@pytest.fixture
def coq(tmp_path, monkeypatch):
    def made(command):
        folder = tmp_path / "coq"
        folder.mkdir()
        (folder / "Makefile").write_text(MAKEFILE.format(command=command))
        (folder / "Main.v").touch()
        (folder / "Main.vo").touch()
        monkeypatch.setattr(machine.shutil, "which", lambda name: name)
        machine._assumptions.cache_clear()
        return Means(proofs=tmp_path, budget="full")

    yield made
    machine._assumptions.cache_clear()


def test_a_theorem_counts_if_it_is_built_anew_and_rests_on_nothing(coq):
    means = coq("printf 'a: Closed under the global context\\nb: Axioms:\\n'")
    assert machine.theorem(means, names=["a"]).verdict == "holds"
    found = machine.theorem(means, names=["a", "b", "c"])
    assert (found.verdict, found.told) == ("refuted", "not proved without axioms: b, c")


def test_a_build_that_fails_refutes(coq):
    found = machine.theorem(coq("echo wrong && false"), names=["a"])
    assert found.verdict == "refuted"
    assert "wrong" in found.told


def test_every_theorem_that_is_named_is_a_headline():
    from evidence.write import ROOT

    coq = ROOT / "proofs" / "coq"
    headlines = "".join((coq / f"{name}.v").read_text() for name in ("Main", "Further"))
    for claim in manifest():
        for name in claim.scopes["quick"].bounds.get("names", []):
            assert f"Theorem {name} " in headlines or f"Theorem {name}\n" in headlines, name


def test_every_certificate_that_is_named_has_its_checker():
    from evidence.write import ROOT

    named = {c.scopes["quick"].bounds["claim"] for c in manifest() if c.id.startswith("cert-")}
    assert named == {path.parent.name for path in (ROOT / "proofs").glob("*/checker.py")}


def test_an_explorer_that_breaks_a_law_is_no_measure_for_another(monkeypatch):
    with pytest.raises(Unfinished, match="breaks a law"):
        limits.run_by_run(Means(), edges=2, one="dudek91", other="algorithm1")


def test_an_entry_is_made_of_a_claim_and_what_its_function_finds():
    entry = entry_of(BY_NAME["bound-order"], CHECKS["bound-order"], Means())
    assert entry.standing == "as-expected"
    assert entry.to_json()["expected_witnesses"] == entry.to_json()["witnesses"]
