from collections import Counter

import pytest

from allworlds.evidence.mutants import explorers, matrix, mutants
from allworlds.evidence.mutants.errands import WEAK_TASK_JUDGES
from allworlds.evidence.mutants.explorers import (
    EQUIVALENT_EXPLORERS,
    WRONG_EXPLORERS,
    WrongExplorer,
)
from allworlds.evidence.mutants.judges import WEAK_JUDGES
from allworlds.inputs import InputError
from allworlds.judging import LAWS, PRECEDENCE
from small import long

SMALLER = 1
# Whom it takes three edges to kill, and whom four: every smaller map is its own mirror image.
TAKE_THREE = [
    *("no-retracing", "orientation-not-restored", "one-hypothesis-only", "wrong-in-one-world"),
    "nearest-only",
]
TAKE_FOUR = ["confirmed-too-early", "mirror-accepted"]


@pytest.fixture(scope="module", params=[2, long(4)])
def full(request, untraced):
    """Every mutant; in the long run at the bound of the command, which .ci/run takes, too."""
    with untraced():
        return mutants(edges=request.param)


@pytest.fixture(scope="module")
def small():
    """Every mutant in the worlds with one edge."""
    return mutants(edges=SMALLER)


def row(kill_matrix, name):
    return next(kill for kill in kill_matrix.kill_matrix if kill.mutant == name)


# ---------------------------------------------------------------- the matrix


@pytest.mark.no_cover
def test_no_mutant_survives(full):
    assert sorted(full.survivors) == (sorted(TAKE_THREE + TAKE_FOUR) if full.edges < 4 else [])
    assert full.exit_code == (1 if full.edges < 4 else 0)


def test_there_are_enough_mutants_of_every_kind(full):
    kinds = Counter(kill.kind for kill in full.kill_matrix if not kill.equivalent)
    assert kinds["explorer"] >= 12
    assert kinds["judge"] >= 6
    assert kinds["enumerator"] >= 4
    assert kinds.total() >= 22
    names = [kill.mutant for kill in full.kill_matrix]
    assert len(set(names)) == len(names)


def test_every_mutant_says_what_is_wrong_with_it(full):
    assert all(kill.breaks.endswith(".") for kill in full.kill_matrix)


def test_explorers_are_killed_by_laws_judges_by_the_sound_one_enumerators_by_two_checks(full):
    killers = {
        kind: {
            kill.killed_by for kill in full.kill_matrix if kill.kind == kind and not kill.equivalent
        }
        for kind in ("explorer", "judge", "enumerator")
    }
    killers = {
        kind: by - {None} for kind, by in killers.items()
    }  # whom it takes four edges to kill
    assert killers["explorer"] <= set(PRECEDENCE)
    assert all(by.startswith("sound judge on ") for by in killers["judge"])
    assert killers["enumerator"] == {"count gate", "brute-force enumerator"}


@pytest.mark.parametrize("law", [*LAWS, "ambiguity", "task"])
def test_every_law_kills_some_explorer_and_is_missed_by_some_judge(full, law):
    assert law in {kill.killed_by for kill in full.kill_matrix if kill.kind == "explorer"}
    assert law in {weak.law for weak in (*WEAK_JUDGES, *WEAK_TASK_JUDGES)}


ANY_WORLD = "nondeterministic"  # by what the explorer has kept from other worlds


@pytest.mark.no_cover
def test_every_kill_names_its_smallest_world(full, small):
    for kill in full.kill_matrix:
        if kill.equivalent or kill.mutant in full.survivors or kill.killed_by == ANY_WORLD:
            assert kill.world is None
        else:
            assert 1 <= kill.world.map.edge_count <= full.edges
    # The bound does not change a kill that lies within it.
    for kill in small.kill_matrix:
        if kill.killed_by:
            assert row(full, kill.mutant) == kill


@pytest.mark.parametrize(
    ("mutant", "law", "edges"),
    [
        ("no-answer", "no-estimate", 1),
        ("drops-markers", "illegal-action", 1),
        ("never-stops", "budget", 1),
        ("crashes-at-leaves", "crash", 1),
        ("lucky-guess", "folding", 1),
        ("doubtful-for-no-reason", "ambiguity", 1),
        ("degrees-of-the-quotient", "ambiguity", 2),
        ("quotient-not-compared", "sound judge on doubtful-for-no-reason", 1),
        ("stays-at-home", "task", 1),
        ("does-not-come-home", "task", 1),
        ("counts-one-too-few", "task", 2),
        ("task-not-judged", "sound judge on does-not-come-home", 1),
        ("home-is-enough", "sound judge on stays-at-home", 1),
        ("visits-are-enough", "sound judge on does-not-come-home", 1),
        ("wrong-in-one-world", "pose", 3),
        ("mirror-accepted", "sound judge on mirror-image", 4),
    ],
)
def test_who_is_killed_by_what_and_where(full, mutant, law, edges):
    kill = row(full, mutant)
    if edges > full.edges:
        assert (kill.killed_by, kill.world) == (None, None)
    else:
        assert (kill.killed_by, kill.world.map.edge_count) == (law, edges)


def test_an_equivalent_mutant_is_listed_with_its_reason_and_lives(full):
    for mutant in EQUIVALENT_EXPLORERS:
        kill = row(full, mutant.name)
        assert kill.equivalent == mutant.equivalent != ""
        assert kill.killed_by is None


def test_the_document_has_a_row_for_every_mutant(full):
    document = full.to_json()
    assert document["mutants"] == len(document["kill_matrix"]) == len(full.kill_matrix)
    assert document["survivors"] == [*full.survivors]
    assert {"mutant", "killed_by", "world"} <= set(document["kill_matrix"][0])


# ---------------------------------------------------------------- when something is missing


@pytest.mark.no_cover
@pytest.mark.parametrize("law", LAWS)
def test_without_any_one_law_a_mutant_survives_that_it_kills(full, monkeypatch, law):
    def killed(mutants_):
        rows = [(mutant, row(full, mutant.name)) for mutant in mutants_]
        return [mutant for mutant, kill in rows if kill.world and kill.world.map.edge_count <= 2]

    explorers_ = [m for m in killed(WRONG_EXPLORERS) if row(full, m.name).killed_by == law]
    judges = [m for m in killed(WEAK_JUDGES) if m.law == law]
    assert only(monkeypatch, explorers_, judges=judges).survivors == ()
    monkeypatch.delitem(LAWS, law)
    without = only(monkeypatch, explorers_, judges=judges)
    assert without.survivors
    assert without.exit_code == 1


def test_a_bound_that_is_too_small_shows_in_the_survivors(small):
    assert "mirror-accepted" in small.survivors
    assert small.exit_code == 1
    assert row(small, "mirror-accepted").to_json()["killed_by"] is None


class Right(explorers.Algorithm1):
    """Algorithm 1 without a fault."""


def only(monkeypatch, wrong, equivalent=(), judges=()):
    """The matrix of these mutants and nothing else."""
    for name, values in (
        ("WRONG_EXPLORERS", tuple(wrong)),
        ("WRONG_LEARNERS", ()),
        ("EQUIVALENT_EXPLORERS", tuple(equivalent)),
        ("WEAK_JUDGES", tuple(judges)),
        ("BROKEN_ENUMERATORS", ()),
    ):
        monkeypatch.setattr(matrix, name, values)
    return mutants(edges=2)


def test_a_mutant_that_is_not_killed_is_a_survivor(monkeypatch):
    result = only(monkeypatch, [WrongExplorer(Right)])
    assert result.survivors == ("right",)
    assert result.exit_code == 1


def test_an_equivalent_mutant_that_is_killed_is_a_survivor_too(monkeypatch):
    result = only(monkeypatch, [], [WrongExplorer(explorers.PoseLost, "it is said to be right")])
    assert result.survivors == ("pose-lost",)
    assert result.exit_code == 1


def test_where_all_is_as_it_should_be_the_exit_code_is_0(monkeypatch):
    killed, alive = WrongExplorer(explorers.PoseLost), WrongExplorer(Right, "it is Algorithm 1")
    result = only(monkeypatch, [killed], [alive])
    assert result.survivors == ()
    assert result.exit_code == 0


@pytest.mark.parametrize("edges", [0, 5, -1])
def test_other_bounds_are_refused(edges):
    with pytest.raises(InputError, match=f"edges = {edges}"):
        mutants(edges=edges)


# ---------------------------------------------------------------- names


def test_names_are_the_classes_in_words():
    names = {mutant.kind.__name__: mutant.name for mutant in WRONG_EXPLORERS}
    assert names["NoRetracing"] == "no-retracing"
    assert names["PartnerLeftInU"] == "partner-left-in-U"


# ---------------------------------------------------------------- interruptions


def test_an_interruption_ends_the_matrix_and_makes_no_row_of_it(monkeypatch):
    class Interrupted(WrongExplorer):
        def explorer(self):
            def explore(first):
                # As a Ctrl-C in the middle of a run, which the check inside keeps to itself.
                raise KeyboardInterrupt
                yield

            return explore

    first = WRONG_EXPLORERS[0]
    monkeypatch.setattr(matrix, "WRONG_EXPLORERS", (first, Interrupted(first.kind)))
    told = mutants(edges=1)
    assert (told.complete, told.exit_code) == (False, 130)
    assert [kill.mutant for kill in told.kill_matrix] == [first.name]
