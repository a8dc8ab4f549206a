"""Runs that are walked as a tree: as one by one; copies that go another way are found."""

from random import Random

import pytest
from numpy import uint8, zeros

from allworlds.engines import PythonEngine, Scope, Tally
from allworlds.engines.compiled.stretches import PlayedByStretches, counts_of
from allworlds.engines.compiled.trees import LATER, PlayedByTrees
from allworlds.engines.compiled.users_kernel import load as load_here
from allworlds.engines.isolation.chunk_player import ChunkPlayer
from allworlds.engines.isolation.failures import Unsettled
from allworlds.engines.isolation.jobs import PlaySegments, PlayTree
from allworlds.engines.isolation.library_player import LibraryPlayer
from allworlds.engines.isolation.shared_logs import OpenedMemories
from allworlds.engines.kernel import chunks
from allworlds.engines.kernel.tree_memory import MOST_SINGLES
from allworlds.engines.python.earlier_plays import EarlierPlays
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.engines.python.tour import Tour
from allworlds.explorers import load
from allworlds.judging import Rules, explain
from allworlds.maps import Extent, MapClass
from allworlds.studies.check import check
from native_libraries import EXAMPLES, FOR_TESTS, built, example

pytestmark = pytest.mark.usefixtures("compiled")

RIGHT = "c/algorithm1.c"
STEPPING = f"{EXAMPLES}/python/stepping.py:Stepping"

SLIPS = {
    "if (r->vertex_count > 2 && !r->phase) action->kind = ALLWORLDS_ANSWER": "no-estimate",
    "if (action->kind == ALLWORLDS_ANSWER) r->here = r->twins[r->here]": "pose",
    "if (r->dart_count == 4) action->kind = 0": "illegal-action",
    "if (r->dart_count == 6 && r->here == 5) action->kind = ALLWORLDS_ANSWER": "no-estimate",
}
"""Code that makes Algorithm 1 wrong."""

ANSWERS_AT_ONCE = "action->kind = ALLWORLDS_ANSWER"

WAYS = ((), ("WITHOUT",))
"""With copies, and without."""

COPIES = (
    "copy->twins = (int32_t *)r->twins",
    "copy->open_count -= copy->open_count > 2",
    "copy->here = copies % 7 ? copy->here : 0",
    "copy->goal = 0",
)
"""Copies that do not go on as they should."""

COPY_IN_LARGE_WORLDS = "copy->here = copy->dart_count < 9 ? copy->here : 0"
"""The same in worlds of five edges or more, which are walked as trees alone."""


LATE = "if (++*steps_of(r) > {} && action->kind == ALLWORLDS_ANSWER) r->here = r->sigma[r->here]"
"""Code that makes an explorer wrong after so many steps, which the longest runs make."""

HIDDEN_ERRORS = {
    "copies forget an error of runs from their start": (LATE.format(40), "*steps_of(to) = 0"),
    "what was copied has an error that runs from their start have not": (
        LATE.format(1024 + 38),
        "*steps_of(to) = (*steps_of(from) |= 1024)",
    ),
}


def copies(slip="", copy="", *more):
    """A library with that slip, and with that copy."""
    given = [f"-DSLIP={slip}", f"-DCOPY={copy}", *(f"-D{name}" for name in more)]
    return built(FOR_TESTS / "copies.c", *given)


def scope_of(edges, lighthouse="directional", map_class="maps", **options):
    rules = Rules(lighthouse, own_bound="paper", **options)
    return Scope(Extent(MapClass.named(map_class), edges, None), rules)


class PairHere(InProcessPlayers):
    """Both players in this process; some jobs may be lost, some answers may be others."""

    in_trees = True

    def __init__(self, name, lost=()):
        subject = load(name)
        super().__init__(subject)
        self.random, self.tour = Random(1), Tour(0, stays=True)
        beat = bytearray(16) if subject.native else [0, 0]
        self.players = {
            which: LibraryPlayer(load(name).native, beat)
            if subject.native
            else ChunkPlayer(load(name).runs_of_copies(), beat, OpenedMemories())
            for which in ("first", "second")
        }
        self.lost, self.asked = {*lost}, []

    def play_stretch(self, which, job):
        self.asked.append(job)
        if isinstance(job, (PlayTree, PlaySegments)) and which in self.lost:
            return None
        return self.players[which].play(job)


def engine_of(players, scope, keep=1):
    load_here()
    python = PythonEngine(scope, keep)
    return PlayedByTrees(PlayedByStretches(python, "native:x", players, EarlierPlays()))


def tally_of(engine, units):
    """The whole tally of these units."""
    tally = Tally(1)
    for unit in units:
        for _, part in engine.parts(unit):
            tally.add(part)
    return tally


def both(library, edges, **options):
    """The tallies of a level by trees and one by one, and the players of the former."""
    scope = scope_of(edges, **options)
    units = [*scope.units(edges)]
    players = PairHere(f"native:{library}")
    engine = engine_of(players, scope)
    by_trees = tally_of(engine, units)
    return by_trees, tally_of(engine.stretches, units), players


def found(tally):
    """The findings of a tally, without the logs."""
    return [(finding.key[:4], finding.law, finding.seen) for finding in tally.findings]


# ---------------------------------------------------------------- as one by one


@pytest.mark.parametrize("map_class", ["maps", "simple", "planar", "planar-simple"])
def test_a_tree_counts_what_single_runs_count(map_class):
    by_trees, one_by_one, players = both(example(RIGHT), 5, map_class=map_class)
    assert counts_of(by_trees) == counts_of(one_by_one)
    assert not by_trees.findings
    assert sum(isinstance(job, PlaySegments) for job in players.asked) >= 3


@pytest.mark.slow
@pytest.mark.parametrize("map_class", ["maps", "simple", "planar", "planar-simple"])
@pytest.mark.parametrize("lighthouse", ["directional", "position", "none"])
def test_a_tree_counts_what_single_runs_count_to_six_edges(map_class, lighthouse):
    library = example(RIGHT) if lighthouse == "directional" else copies(ANSWERS_AT_ONCE)
    by_trees, one_by_one, _ = both(library, 6, map_class=map_class, lighthouse=lighthouse)
    assert counts_of(by_trees) == counts_of(one_by_one)
    assert found(by_trees) == found(one_by_one)


@pytest.mark.parametrize("slip", SLIPS)
def test_an_explorer_with_a_slip_is_wrong_in_the_same_worlds(slip):
    by_trees, one_by_one, players = both(copies(slip), 4)
    assert found(by_trees) == found(one_by_one)
    assert found(by_trees)[0][1] == SLIPS[slip]
    assert any(isinstance(job, PlaySegments) for job in players.asked)


def test_one_chunk_after_the_other_makes_the_whole_tree(monkeypatch):
    monkeypatch.setattr("allworlds.engines.compiled.trees.MOST_RUNS", 40)
    by_trees, one_by_one, players = both(example(RIGHT), 4)
    assert counts_of(by_trees) == counts_of(one_by_one)
    chunks = [job.chunk for job in players.asked if isinstance(job, PlayTree)]
    assert len(chunks) > 80
    assert len({*chunks}) < len(chunks)  # each unit begins at the first place


@pytest.mark.slow
@pytest.mark.long
def test_what_is_walked_as_a_tree_is_told_as_ever():
    with_copies, without = (check(f"native:{copies('', '', *more)}", edges=5) for more in WAYS)
    one, other = (report.to_json() for report in (with_copies, without))
    del one["explorer"], other["explorer"]
    assert one == other


# ---------------------------------------------------------------- in Python, and behind a pipe


@pytest.mark.parametrize("map_class", ["maps", "simple", "planar", "planar-simple"])
def test_python_and_compiled_code_walk_the_same_tree(map_class):
    scope = scope_of(4, map_class=map_class)
    logs = []
    for name in (f"native:{example(RIGHT)}", STEPPING):
        players = PairHere(name)
        engine, heard = engine_of(players, scope), []
        for unit in scope.units(4):
            for _ in engine._walk(unit):
                size = int(engine._memory.first.logs.nonzero()[0][-1]) + 1
                heard.append(engine._memory.first.logs[:size].tobytes())
        logs.append(heard)
    assert logs[0] == logs[1]
    assert sum(map(len, logs[0])) > 1000


@pytest.mark.slow
@pytest.mark.long
def test_an_object_that_can_be_copied_is_told_as_one_that_cannot(tmp_path):
    plain = tmp_path / "plain.py"
    text = (EXAMPLES / "python" / "stepping.py").read_text(encoding="utf-8")
    plain.write_text(text.replace("def copy", "def not_called"), encoding="utf-8")
    reports = [check(name, edges=4) for name in (STEPPING, f"{plain}:Stepping")]
    one, other = (report.to_json() for report in reports)
    del one["explorer"], other["explorer"]
    assert one == other
    assert reports[0].exit_code == 0


# ---------------------------------------------------------------- copies that go another way


@pytest.mark.parametrize(
    "copy",
    [
        COPIES[0],
        *(pytest.param(copy, marks=pytest.mark.slow) for copy in COPIES[1:]),
    ],
)
def test_a_copy_that_goes_another_way_is_a_finding_with_a_hint(copy):
    report = check(f"native:{copies('', copy)}", edges=3)
    (finding,) = report.findings
    assert finding.law == "nondeterministic"
    assert "copies" in finding.seen
    told = " ".join(explain(finding).sentences)
    assert "acted differently" in told
    assert "static variable" not in told  # a copy has a question of its own


@pytest.mark.slow
def test_a_copy_that_goes_another_way_in_large_worlds_is_found_in_trees():
    report = check(f"native:{copies('', COPY_IN_LARGE_WORLDS)}", edges=5)
    (finding,) = report.findings
    assert (finding.law, finding.world.map.edge_count) == ("nondeterministic", 5)
    assert "copies" in finding.seen


@pytest.mark.slow
@pytest.mark.parametrize("how", HIDDEN_ERRORS)
def test_an_error_that_copies_hide_or_bring_in_a_few_worlds_is_found(how):
    report = check(f"native:{copies(*HIDDEN_ERRORS[how])}", edges=5)
    (finding,) = report.findings
    assert (finding.law, finding.world.map.edge_count) == ("nondeterministic", 5)
    assert "copies" in finding.seen


def walked(library, keep=1):
    """The tally of a level with five edges, whose trees are walked in this process."""
    scope = scope_of(5)
    return tally_of(engine_of(PairHere(f"native:{library}"), scope, keep), scope.units(5))


def test_a_run_in_which_two_walks_differ_is_found_however_long_it_is(monkeypatch):
    monkeypatch.setattr(chunks, "_KEPT", zeros((MOST_SINGLES, 16), uint8))
    (finding,) = walked(copies("", COPIES[2])).findings
    assert finding.law == "nondeterministic"
    assert "copies" in finding.seen


def test_walks_that_differ_without_a_run_to_blame_settle_nothing(monkeypatch):
    monkeypatch.setattr(chunks, "_SUSPECT", zeros((1, 16), uint8))
    with pytest.raises(Unsettled, match=r"two walks .* differ, and no single run is wrong; mend"):
        walked(copies("", COPIES[2]))


def test_more_runs_are_kept_for_single_plays_at_the_beginning(monkeypatch):
    kept, judge = [], chunks.UnitTree.judge

    def judged(tree, *told, samples, **more):
        kept.append(samples)
        return judge(tree, *told, samples=samples, **more)

    load_here()
    monkeypatch.setattr("allworlds.engines.compiled.users_kernel.load_trees", lambda: None)
    monkeypatch.setattr(chunks.UnitTree, "judge", judged)
    monkeypatch.setattr("allworlds.engines.compiled.trees.BEGINNING", 2)
    walked(example(RIGHT))
    assert kept[:3] == [MOST_SINGLES, MOST_SINGLES, LATER]


def test_a_tree_that_counts_otherwise_than_single_runs_settles_nothing(monkeypatch):
    monkeypatch.setattr("allworlds.engines.compiled.trees.counts_of", id)
    with pytest.raises(Unsettled, match="count otherwise than runs from the start"):
        walked(example(RIGHT))


def test_a_player_that_is_lost_in_trees_alone_settles_nothing():
    scope = scope_of(5)
    engine = engine_of(PairHere(f"native:{example(RIGHT)}", lost=["second"]), scope)
    with pytest.raises(Unsettled, match="2 walks from copies of the explorer were lost"):
        tally_of(engine, scope.units(5))


@pytest.mark.slow
def test_a_library_whose_copies_end_its_process_is_no_verdict():
    library = copies("", "if (copies > 10000) raise(SIGSEGV)")
    report = check(f"native:{library}", edges=5)
    assert report.exit_code == 3
    assert "mend the copying" in report.scope.stopped
