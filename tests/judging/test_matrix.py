from collections import Counter

import pytest

import matrix
from allworlds.corpus import explorers
from allworlds.corpus.explorers import EQUIVALENT_EXPLORERS, WRONG_EXPLORERS, WrongExplorer
from allworlds.judging.laws.law_table import LAWS, PRECEDENCE
from errands import WEAK_TASK_JUDGES
from judges import WEAK_JUDGES
from matrix import mutants, survivors
from small import slowest

SMALLER = 1
# Whom it takes three edges to kill, and whom four: every smaller map is its own mirror image.
TAKE_THREE = [
    *("no-retracing", "orientation-not-restored", "one-hypothesis-only", "wrong-in-one-world"),
    "nearest-only",
]
TAKE_FOUR = ["confirmed-too-early", "mirror-accepted"]


@pytest.fixture(scope="module", params=[2, slowest(4)])
def edges(request):
    """The bound; in ``nox -s full`` that of the program, which .ci/run takes, too."""
    return request.param


@pytest.fixture(scope="module")
def full(edges):
    """Every mutant within the bound."""
    return list(mutants(edges))


@pytest.fixture(scope="module")
def small():
    """Every mutant in the worlds with one edge."""
    return list(mutants(SMALLER))


def row(kill_matrix, name):
    return next(kill for kill in kill_matrix if kill.mutant == name)


# ---------------------------------------------------------------- the matrix


def test_no_mutant_survives(full, edges):
    assert sorted(survivors(full)) == (sorted(TAKE_THREE + TAKE_FOUR) if edges < 4 else [])


def test_there_are_enough_mutants_of_every_kind(full):
    kinds = Counter(kill.kind for kill in full if not kill.equivalent)
    assert kinds["explorer"] >= 12
    assert kinds["judge"] >= 6
    assert kinds["enumerator"] >= 4
    assert kinds.total() >= 22
    names = [kill.mutant for kill in full]
    assert len(set(names)) == len(names)


def test_every_mutant_says_what_is_wrong_with_it(full):
    assert all(kill.breaks.endswith(".") for kill in full)


def test_explorers_are_killed_by_laws_judges_by_the_sound_one_enumerators_by_two_checks(full):
    killers = {
        kind: {kill.killed_by for kill in full if kill.kind == kind and not kill.equivalent}
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
    assert law in {kill.killed_by for kill in full if kill.kind == "explorer"}
    assert law in {weak.law for weak in (*WEAK_JUDGES, *WEAK_TASK_JUDGES)}


ANY_WORLD = "nondeterministic"  # by what the explorer has kept from other worlds


def test_every_kill_names_its_smallest_world(full, small, edges):
    for kill in full:
        if kill.equivalent or kill.mutant in survivors(full) or kill.killed_by == ANY_WORLD:
            assert kill.world is None
        else:
            assert 1 <= kill.world.map.edge_count <= edges
    # The bound does not change a kill that lies within it.
    for kill in small:
        if kill.killed_by:
            assert row(full, kill.mutant) == kill


@pytest.mark.parametrize(
    ("mutant", "law", "least"),
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
def test_who_is_killed_by_what_and_where(full, edges, mutant, law, least):
    kill = row(full, mutant)
    if least > edges:
        assert (kill.killed_by, kill.world) == (None, None)
    else:
        assert (kill.killed_by, kill.world.map.edge_count) == (law, least)


def test_an_equivalent_mutant_is_listed_with_its_reason_and_lives(full):
    for mutant in EQUIVALENT_EXPLORERS:
        kill = row(full, mutant.name)
        assert kill.equivalent == mutant.equivalent != ""
        assert kill.killed_by is None


def test_the_text_has_a_line_for_every_mutant(full, edges):
    lines = list(matrix.told(full, edges))
    assert lines[0].startswith("SURVIVORS  51 mutants" if edges < 4 else "ALL KILLED  51 mutants")
    for kill in full:
        assert any(
            line.startswith((f"{kill.mutant} ", f"EQUIVALENT {kill.mutant}:")) for line in lines
        )


# ---------------------------------------------------------------- when something is missing


@pytest.mark.parametrize("law", LAWS)
def test_without_any_one_law_a_mutant_survives_that_it_kills(full, monkeypatch, law):
    def killed(mutants_):
        rows = [(mutant, row(full, mutant.name)) for mutant in mutants_]
        return [mutant for mutant, kill in rows if kill.world and kill.world.map.edge_count <= 2]

    explorers_ = [m for m in killed(WRONG_EXPLORERS) if row(full, m.name).killed_by == law]
    judges = [m for m in killed(WEAK_JUDGES) if m.law == law]
    assert only(monkeypatch, explorers_, judges=judges) == []
    monkeypatch.delitem(LAWS, law)
    assert only(monkeypatch, explorers_, judges=judges)


def test_a_bound_that_is_too_small_shows_in_the_survivors(small):
    assert "mirror-accepted" in survivors(small)
    assert row(small, "mirror-accepted").killed_by is None


class Right(explorers.Algorithm1):
    """Algorithm 1 without a fault."""


def only(monkeypatch, wrong, equivalent=(), judges=()):
    """The survivors among these mutants and nothing else."""
    for name, values in (
        ("WRONG_EXPLORERS", tuple(wrong)),
        ("WRONG_LEARNERS", ()),
        ("EQUIVALENT_EXPLORERS", tuple(equivalent)),
        ("WEAK_JUDGES", tuple(judges)),
        ("BROKEN_ENUMERATORS", ()),
    ):
        monkeypatch.setattr(matrix, name, values)
    return survivors([*mutants(2)])


def test_a_mutant_that_is_not_killed_is_a_survivor(monkeypatch):
    assert only(monkeypatch, [WrongExplorer(Right)]) == ["right"]


def test_an_equivalent_mutant_that_is_killed_is_a_survivor_too(monkeypatch):
    wrong = WrongExplorer(explorers.PoseLost, "it is said to be right")
    assert only(monkeypatch, [], [wrong]) == ["pose-lost"]


def test_where_all_is_as_it_should_be_none_is_a_survivor(monkeypatch):
    killed, alive = WrongExplorer(explorers.PoseLost), WrongExplorer(Right, "it is Algorithm 1")
    assert only(monkeypatch, [killed], [alive]) == []


# ---------------------------------------------------------------- names


def test_names_are_the_classes_in_words():
    names = {mutant.kind.__name__: mutant.name for mutant in WRONG_EXPLORERS}
    assert names["NoRetracing"] == "no-retracing"
    assert names["PartnerLeftInU"] == "partner-left-in-U"
