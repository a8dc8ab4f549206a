"""Native explorers in the compiled engine: the same as in the other one, and no less guarded."""

import json
from collections import Counter
from random import Random

import numpy as np
import pytest

import small
from allworlds.document import replace
from allworlds.engines import (
    EnginesDisagree,
    GivenWorlds,
    Job,
    LevelRuns,
    Limits,
    PythonEngine,
    Scope,
    Tally,
    why_not_compiled,
)
from allworlds.engines.compiled.requests import level_of
from allworlds.engines.compiled.stretches import PlayedByStretches
from allworlds.engines.compiled.users_engine import KERNEL, UsersEngine
from allworlds.engines.compiled.users_kernel import is_kept, load as load_here
from allworlds.engines.isolation.jobs import PlayStretch
from allworlds.engines.isolation.library_player import LibraryPlayer
from allworlds.engines.isolation.messages import StretchResult, read_message, write_message
from allworlds.engines.isolation.shared_logs import StretchMemory
from allworlds.engines.kernel.batches import UnitJudge
from allworlds.engines.kernel.capabilities import COMPILING
from allworlds.engines.kernel.native import shuffle
from allworlds.engines.kernel.rows import BrokenRun, Rows
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.explorers import load
from allworlds.judging import Rules
from allworlds.maps import Extent, MapClass
from allworlds.outcome import Verdict
from allworlds.studies.check import check
from allworlds.world import Directional, World
from native_libraries import ATTACKS, attack, example, quotient
from processes import PATIENCE, SOON
from small import long

EDGE = World(small.EDGE, Directional(0))

pytestmark = pytest.mark.usefixtures("compiled")


def native(library):
    return f"native:{library}"


def told(report):
    """All of a report but the explorer, its engine, and what only built-in explorers tell."""
    document = report.to_json()
    for finding in document["findings"]:
        for key in ("explorer", "reproduce"):
            del finding[key]
    events = document["witnesses"]
    document["witnesses"] = {key: events.get(key) for key in ("loop-edge", "parallel-edge")}
    return {key: value for key, value in document.items() if key not in ("explorer", "engine")}


# ---------------------------------------------------------------- as in the other engine


def test_algorithm_1_in_c_is_algorithm_1():
    ours = check(native(example("c/algorithm1.c")), edges=4, engine="kernel", policy="nearest")
    assert told(ours) == told(check(edges=4, engine="python", policy="nearest"))


@pytest.mark.slow
@pytest.mark.parametrize("policy", ["fifo", long("lifo"), long("nearest")])
def test_algorithm_1_in_c_is_algorithm_1_to_six_edges(policy):
    theirs = check(edges=6, engine="kernel", policy=policy).to_json()["rows"]
    scope, players = scope_of(6, policy=policy), PairHere(example("c/algorithm1.c"))
    tally = Tally(1)
    for edges in scope.extent.levels:
        tally.add(parts(players, edges, units=scope.units(edges), scope=scope))
    assert not tally.findings
    for row, told_row in zip(sorted(tally.rows.items()), theirs, strict=True):
        (edges, vertices), counts = row
        assert (edges, vertices) == (told_row["edges"], told_row["vertices"])
        assert counts.runs == told_row["runs"]
        assert counts.traversals == told_row["traversals"]
        assert (counts.max_cost, counts.bound) == (told_row["max_cost"], told_row["bound"])


@pytest.mark.no_cover
@pytest.mark.parametrize("map_class", ["simple", "planar", "planar-simple"])
@pytest.mark.parametrize("source", ["c/algorithm1.c", "c/hasty.c"])
def test_every_class_is_judged_as_in_the_other_engine(map_class, source):
    extent = Extent(MapClass.named(map_class), 3, None)
    scope = Scope(extent, scope_of(3).rules)
    # Both engines do all of it, and a difference is an exception.
    tally = parts(PairHere(example(source)), 3, keep=3, scope=scope)
    assert (tally.findings == []) == (source == "c/algorithm1.c")


@pytest.mark.no_cover
@pytest.mark.parametrize(
    "lighthouse", ["none", "position", "compass", "cluster", "cluster:single=true", "natural"]
)
def test_every_lighthouse_is_judged_as_in_the_other_engine(lighthouse):
    rules = Rules(lighthouse, step_budget=30, own_bound="none")
    scope = Scope(Extent(MapClass.MAPS, 3, None), rules)
    tally = parts(PairHere(example("c/hasty.c")), 3, keep=3, scope=scope)
    assert tally.runs
    assert tally.findings


def test_what_several_worlds_look_like_is_judged_by_the_other_engine():
    scope = Scope(Extent(MapClass.MAPS, 2, None), Rules("position", own_bound="none"))
    tally = parts(PairHere(quotient()), 2, keep=3, scope=scope)
    assert {found.law for found in tally.findings} == {"ambiguity"}


IN_COMPILED_CODE = (
    *("raise(SIGSEGV)", "for (;;) pause()", "grow()", "count = 1000000", "kind = 0"),
    *("memset(action + 1, 1, 1 << 13)", "in_another_thread(wait_for_ever, 0)"),
    *("kind = ALLWORLDS_CHECKPOINT; count = 1 << 20", "in_another_thread(do_nothing, 1)"),
)


@pytest.mark.slow
@pytest.mark.parametrize("code", IN_COMPILED_CODE)
def test_what_it_does_to_its_process_is_a_finding_in_that_world(code):
    law, seen = ATTACKS[code]
    limit = SOON if law == "timeout" else PATIENCE
    report = check(native(attack(code)), edges=1, engine="kernel", answer_timeout=limit)
    assert report.runs == 3
    if not law:
        assert report.exit_code == 0
        return
    (finding,) = report.findings
    assert (finding.law, finding.world) == (law, EDGE)
    assert seen in finding.seen


def test_what_the_kernel_cannot_do_is_told_and_done_by_the_other_engine():
    subject = load(native(example("c/algorithm1.c")))
    scope = scope_of(5, policy="random:1")
    assert "random:1" in why_not_compiled(scope, subject)
    assert not why_not_compiled(scope_of(4, policy="random:1"), subject)
    assert not why_not_compiled(scope, load("algorithm1"))


# ---------------------------------------------------------------- from inside, in this process


def scope_of(edges, bound="paper", **options):
    rules = Rules("directional", own_bound=bound, **options)
    return Scope(Extent(MapClass.MAPS, edges, None), rules)


class PairHere(InProcessPlayers):
    """Both players in this process, which some jobs may be lost in."""

    def __init__(self, library, lost=(), differs=(), logs=None):
        subject = load(native(library))
        super().__init__(subject)
        self.random = Random(1)
        self.stretch_players = {
            which: LibraryPlayer(subject.native, bytearray(16)) for which in ("first", "second")
        }
        self.lost, self.asked, self.logs = {*lost}, Counter(), logs

    def play_stretch(self, which, job):
        self.asked[which] += 1
        if (which, self.asked[which]) in self.lost:
            return None
        said = self.stretch_players[which].play(job)
        return said if self.logs is None else self.logs(which, said)


def parts(players, edges, keep=1, units=None, scope=None):
    """The tally of a level by stretches, in this process."""
    scope = scope or scope_of(edges)
    general = PythonEngine(scope, keep)
    engine = PlayedByStretches(general, "native:x", players)
    tally = Tally(keep)
    for unit in units or scope.units(edges):
        for _, part in engine.parts(unit):
            tally.add(part)
    return tally


@pytest.mark.no_cover
def test_stretches_count_what_the_other_engine_counts():
    tally = parts(PairHere(example("c/algorithm1.c")), 4)
    whole = Tally(1)
    own = PythonEngine(scope_of(4), 1).for_built_in(load("algorithm1"))
    for unit in scope_of(4).units(4):
        for _, part in own.parts(unit):
            whole.add(part)
    assert tally.rows == whole.rows
    assert (tally.checkpoints, tally.findings) == (whole.checkpoints, [])


@pytest.mark.no_cover
@pytest.mark.parametrize("which", ["first", "second"])
def test_a_stretch_over_which_a_player_is_lost_is_played_by_the_general_engine(which):
    library = example("c/algorithm1.c")
    lost = parts(PairHere(library, lost={(which, 1), (which, 2)}), 3)
    assert lost.rows == parts(PairHere(library), 3).rows


@pytest.mark.no_cover
def test_logs_that_cannot_be_read_are_not_believed():
    library = example("c/algorithm1.c")
    spoilt = PairHere(library, logs=lambda _, said: StretchResult(said.size // 2, 0))
    assert parts(spoilt, 3).rows == parts(PairHere(library), 3).rows
    threads = PairHere(library, logs=lambda _, said: StretchResult(said.size, 1))
    assert parts(threads, 3).rows == parts(PairHere(library), 3).rows


def test_the_smallest_of_the_broken_runs_is_found_with_its_law():
    (finding,) = parts(PairHere(example("c/hasty.c")), 4).findings
    (general,) = check(native(example("c/hasty.c")), edges=4, engine="python").findings
    assert finding.law == "map"
    assert general.key[0] == 1
    assert finding.key[0] == 4


@pytest.mark.parametrize("edges", [1, 4])
def test_a_law_that_the_other_engine_does_not_find_broken_is_a_disagreement(monkeypatch, edges):
    judge = UnitJudge.judge
    unit = next(iter(scope_of(edges).units(edges)))
    map_ = next(unit.maps(scope_of(edges).extent))
    world = BrokenRun(map_.vertex_count, map_.sigma, map_.alpha, 0, "map")

    def blames(self, batch, size):
        rows, good = judge(self, batch, size)
        return Rows(rows.counts, {}, rows.met, rows.most_expensive, (world,)), good

    monkeypatch.setattr(UnitJudge, "judge", blames)
    # In small worlds both judges look at everything, in large ones at what is broken.
    said = "count differently" if edges == 1 else "the kernel says that map is broken"
    with pytest.raises(EnginesDisagree, match=said):
        parts(PairHere(example("c/algorithm1.c")), edges, units=[unit])


def test_most_expensive_runs_that_differ_are_a_disagreement(monkeypatch):
    judge = UnitJudge.judge

    def misses_the_first_place(self, batch, size):
        rows, good = judge(self, batch, size)
        others = tuple(run._replace(place=run.place + 1) for run in rows.most_expensive)
        return replace(rows, most_expensive=others), good

    monkeypatch.setattr(UnitJudge, "judge", misses_the_first_place)
    with pytest.raises(EnginesDisagree, match="count differently"):
        parts(PairHere(example("c/algorithm1.c")), 2)


def test_counts_that_differ_are_a_disagreement(monkeypatch):
    count = PythonEngine.count_run

    def counts(self, run, tally):
        tally.left_out += 1
        return count(self, run, tally)

    monkeypatch.setattr(PythonEngine, "count_run", counts)
    with pytest.raises(EnginesDisagree, match="count differently"):
        parts(PairHere(example("c/algorithm1.c")), 2)


def test_a_disagreement_ends_a_check_with_70(monkeypatch):
    def ready(_self, _job):
        raise EnginesDisagree("as it were")

    monkeypatch.setattr("allworlds.engines.engine_table.Compiled.ready", ready)
    report = check(native(example("c/algorithm1.c")), edges=2, engine="kernel")
    assert report.verdict is Verdict.ERROR
    assert report.exit_code == 70


def test_state_that_is_kept_is_found_whatever_it_does():
    (finding,) = parts(PairHere(attack("here_is = episodes % 2")), 1).findings
    assert finding.law == "nondeterministic"


def test_the_least_of_each_kind_are_those_of_the_other_engine():
    hasty = native(example("c/hasty.c"))
    several = [check(hasty, edges=4, engine=e, max_findings=5) for e in ("kernel", "python")]
    assert told(several[0])["findings"] == told(several[1])["findings"]
    assert len(several[0].findings) > 1


def test_a_byte_that_is_wrong_in_a_log_is_noticed_wherever_it_stands():
    scope, random = scope_of(3), Random(1)
    level = level_of("native:x", scope.rules, scope.extent, 3)
    first, second = StretchMemory(3), StretchMemory(3)
    subject = load(native(example("c/algorithm1.c")))
    player = LibraryPlayer(subject.native, bytearray(16))
    unlike = Counter()
    for _ in range(400):
        judge = UnitJudge(level, (-2,), 1, first.stretch, second.stretch)
        batch = judge.lay_out(100)
        size = player.play(PlayStretch(first.file, 3, batch.runs, 1, "fifo", again=False)).size
        at = random.choice(np.flatnonzero(first.stretch.logs[:size]))  # behind an S are zeros
        first.stretch.logs[at] ^= random.randrange(1, 256)
        rows, good = judge.judge(batch, size)
        again = player.play(PlayStretch(second.file, 3, batch.runs, 2, "fifo", again=True)).size
        differs = bool(judge.differing(again))
        unlike[good, bool(rows.broken)] += 1
        assert differs or not good or rows.broken
    assert {key for key, times in unlike.items() if times > 5} >= {(False, True), (True, True)}
    first.close()
    second.close()


def test_runs_are_played_in_an_order_that_a_seed_draws():
    drawn = Counter()
    for seed in range(2400):
        order = np.arange(4)
        shuffle(order, seed * 7919 << 20)
        drawn[tuple(order.tolist())] += 1
    assert len(drawn) == 24
    assert min(drawn.values()) > 60
    same = [np.arange(100), np.arange(100)]
    for order in same:
        shuffle(order, 5)
    assert same[0].tolist() == same[1].tolist()
    assert sorted(same[0].tolist()) == list(range(100)) != same[0].tolist()


def test_the_rest_of_a_unit_whose_referee_was_lost_goes_to_the_general_engine():
    players = PairHere(example("c/algorithm1.c"))
    engine = UsersEngine(PythonEngine(scope_of(2), 1))
    bound = engine.for_users("native:x", players)
    unit = next(iter(scope_of(2).units(2)))
    whole, rest = Tally(1), Tally(1)
    for _, part in bound.parts(unit):
        whole.add(part)
    for _, part in bound.parts(unit, 1):
        rest.add(part)
    assert rest.runs == whole.runs - 1
    given = GivenWorlds(((EDGE, 0),))
    assert sum(part.runs for _, part in bound.parts(given)) == 1
    assert engine.keep == 1


def test_our_own_explorers_are_played_as_ever():
    own = UsersEngine(PythonEngine(scope_of(1), 1)).for_built_in(load("algorithm1"))
    units = [*scope_of(1).units(1)]
    assert sum(part.runs for unit in units for _, part in own.parts(unit)) == 3


def test_what_is_needed_is_compiled_once_and_said(monkeypatch):
    load_here()
    notices = []
    subject = load(native(example("c/algorithm1.c")))
    job = Job(scope_of(2), subject, Limits(), 1, None, notices.append)
    engine = UsersEngine(PythonEngine(job.scope, 1))
    engine.compiled(job)
    notices.clear()  # in a fresh cache there is something to be compiled
    engine.compiled(job)
    assert not notices
    assert is_kept() == 1
    monkeypatch.setattr("allworlds.engines.compiled.users_kernel.is_compiled", lambda _: False)
    asked = []

    class Fresh:
        def prepare(self, module, function):
            asked.append((module, function, notices[:]))
            return is_kept() if function == "is_kept" else None

    monkeypatch.setattr("allworlds.engines.compiled.users_engine.guardian", Fresh)
    engine.compiled(job)
    assert asked == [(KERNEL, "is_kept", []), (KERNEL, "load", [COMPILING])]


def test_a_message_of_a_stretch_is_read_as_it_was_written():
    assert read_message(write_message(StretchResult(5, 0))) == StretchResult(5, 0)


def test_a_stretch_without_room_for_its_logs_says_so():
    subject = load(native(example("c/algorithm1.c")))
    level = level_of("native:x", scope_of(2).rules, scope_of(2).extent, 2)
    first = StretchMemory(2)
    judge = UnitJudge(level, (-1,), 1, first.stretch, first.stretch)
    batch = judge.lay_out(100)
    player = LibraryPlayer(subject.native, bytearray(16))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(first.stretch, "logs", first.stretch.logs[:10])
        assert player.native.play(first.stretch, batch.runs, 1, "fifo", again=False) == -1
    first.close()
    with pytest.raises(OSError, match="No such file"):
        player.play(PlayStretch("/proc/self/fd/none", 2, 1, 1, "fifo", again=False))


def test_a_report_of_the_compiled_engine_is_a_document():
    report = check(native(example("c/hasty.c")), edges=2, engine="kernel")
    assert json.loads(json.dumps(report.to_json()))["engine"] == "kernel"
    assert LevelRuns(1, (-1,)).key == "1:-1"
