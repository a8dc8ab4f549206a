"""Every schedule in the compiled engine: the same as in the other one, and none is left out."""

from random import Random

import numpy as np
import pytest

from allworlds.document import replace
from allworlds.engines import (
    CostEngine,
    CostTally,
    EnginesDisagree,
    PythonEngine,
    Scope,
    engine_for,
    why_not_compiled,
)
from allworlds.engines.compiled.requests import level_of
from allworlds.engines.compiled.stretches import OF_EVERY_SCHEDULE, PlayedByStretches
from allworlds.engines.isolation.generator_player import GeneratorPlayer
from allworlds.engines.isolation.jobs import SCRIPTS_BEHIND, DueSchedules, PlayStretch
from allworlds.engines.isolation.library_player import LibraryPlayer
from allworlds.engines.isolation.messages import StretchResult
from allworlds.engines.isolation.shared_logs import StretchMemory
from allworlds.engines.kernel.capabilities import MOST_OPTIONS, MOST_PICKS
from allworlds.engines.kernel.rows import BrokenRun
from allworlds.engines.kernel.schedule_judge import ScheduleJudge
from allworlds.engines.kernel.stretch import LONGEST_STRETCH
from allworlds.engines.kernel.writing import read_picks
from allworlds.engines.python.earlier_plays import EarlierPlays
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.explorers import Subject, algorithm1, load
from allworlds.judging import Rules
from allworlds.maps import Extent, MapClass
from allworlds.studies.check import check
from allworlds.studies.worst import worst
from native_libraries import attack, example

pytestmark = pytest.mark.usefixtures("compiled")

ALGORITHM1 = "c/algorithm1.c"
LARGER = OF_EVERY_SCHEDULE + 1
"""A number of edges at which the two engines are not compared on the way."""


def scope_of(edges, map_class="maps", lighthouse="directional", **options):
    rules = Rules(lighthouse, **{"own_bound": "paper", **options})
    return Scope(Extent(MapClass.named(map_class), edges, None), rules, schedules="all")


def of_library(library):
    """A subject, and a maker of its players in compiled code."""
    subject = load(f"native:{library}")
    return subject, lambda: LibraryPlayer(subject.native, bytearray(16))


def of_function(explore):
    """A subject that is a function in Python, and a maker of its players."""

    def ready(first, choices, _told):
        return explore(first, choices=choices)

    subject = Subject("x", frozenset({"choices"}), explore)
    return subject, lambda: GeneratorPlayer(ready, [0, 0], lambda: None)


class PairHere(InProcessPlayers):
    """Both players in this process.

    Args:
        of: the subject, and what makes a player of it.
        most: the largest number of schedules that are due at once.
        said: what is made of the answer of the first player, and its memory.
    """

    def __init__(self, of, most=LONGEST_STRETCH, said=lambda said, _: said):
        subject, player = of
        super().__init__(subject)
        self.random, self._most, self._said = Random(1), most, said
        self._players = {which: player() for which in ("first", "second")}
        self.portions = 0

    def play_stretch(self, which, job):
        if which == "second":
            assert job.schedules == SCRIPTS_BEHIND  # who plays again is not told where it is
            return self._players[which].play(job)
        due = replace(job.schedules, most=min(job.schedules.most, self._most))
        said = self._players[which].play(replace(job, schedules=due))
        self.portions += 1
        return self._said(said, self._players[which]._memories.stretch(job))


def tally_of(players, scope, edges, keep=1):
    """The tally of a level by stretches."""
    general = CostEngine(scope, keep)
    engine = PlayedByStretches(general, "native:x", players, EarlierPlays())
    tally = CostTally(keep)
    for unit in scope.units(edges):
        for _, part in engine.parts(unit):
            tally.add(part)
    return tally


def one_by_one(subject, scope, edges, keep=1):
    """The tally of a level by the Python engine in this process."""
    tally, own = CostTally(keep), CostEngine(scope, keep).for_built_in(subject)
    for unit in scope.units(edges):
        for _, part in own.parts(unit):
            tally.add(part)
    return tally


def told(tally):
    """All of a tally but the findings, with the choices of the most expensive episodes."""
    rows = {size: (row, row.most_expensive) for size, row in tally.rows.items()}
    return rows, tally.best_by_vertices, tally.left_out, tally.checkpoints


# ---------------------------------------------------------------- as in the other engine


@pytest.mark.no_cover
@pytest.mark.parametrize(("of", "edges"), [(of_library, LARGER), (of_function, 2)])
def test_every_schedule_counts_as_in_the_other_engine(of, edges):
    given = of(example(ALGORITHM1)) if of is of_library else of(algorithm1)
    scope = scope_of(edges)
    ours, theirs = tally_of(PairHere(given), scope, edges), one_by_one(given[0], scope, edges)
    assert told(ours) == told(theirs)
    assert ours.findings == theirs.findings == []
    assert all(row.episodes > row.runs for (_, n), row in ours.rows.items() if n <= edges)


@pytest.mark.no_cover
@pytest.mark.parametrize("map_class", ["simple", "planar", "planar-simple"])
@pytest.mark.parametrize("lighthouse", ["directional", "compass", "cluster", "natural"])
def test_every_class_and_lighthouse_is_judged_as_in_the_other_engine(map_class, lighthouse):
    given = of_library(attack("count -= pick(asked, 0, 2, 0)", CHOOSES="1"))
    scope = scope_of(OF_EVERY_SCHEDULE, map_class, lighthouse, own_bound="none")
    # Both engines do all of it, and a difference is an exception.
    tally = tally_of(PairHere(given), scope, OF_EVERY_SCHEDULE, keep=3)
    assert tally.findings if tally.runs else tally.left_out


@pytest.mark.no_cover
@pytest.mark.parametrize(("edges", "most"), [(1, 1), (2, 1), (2, 3), (LARGER, 60)])
def test_a_run_may_be_played_in_portions(edges, most):
    given, scope = of_library(example(ALGORITHM1)), scope_of(edges)
    whole, players = tally_of(PairHere(given), scope, edges), PairHere(given, most)
    assert told(tally_of(players, scope, edges)) == told(whole)
    assert players.portions >= sum(row.episodes for row in whole.rows.values()) // most


@pytest.mark.no_cover
def test_what_is_found_is_what_the_other_engine_finds(wrong):
    both = [
        check(
            wrong("one_schedule"), edges=3, schedules="all", max_findings=5, engine=engine
        ).to_json()
        for engine in ("kernel", "python")
    ]
    for document in both:
        del document["engine"]
    assert both[0] == both[1]
    assert both[0]["findings"]


@pytest.mark.no_cover
def test_the_worst_and_the_best_are_those_of_the_other_engine(monkeypatch):
    library = f"native:{example(ALGORITHM1)}"
    theirs = worst(library, edges=2).to_json()
    monkeypatch.setattr("allworlds.engines.compiled.sizes.SCHEDULES_FROM", 1)
    assert worst(library, edges=2).to_json() == theirs


def test_the_cheapest_schedule_may_cost_nothing():
    given = of_library(attack("if (pick(asked, 0, 2, 0)) kind = ALLWORLDS_ANSWER", CHOOSES="1"))
    tally = tally_of(PairHere(given), scope_of(1), 1)
    assert tally.rows[1, 2].max_cost == 1
    assert tally.best[2] == 0


def test_one_schedule_of_many_that_is_wrong_is_found_with_its_choices():
    given = of_library(
        attack("count = pick(asked, 1, 3, 0) < 2 || pick(asked, 2, 2, 0) ? 2 : 1", CHOOSES="1")
    )
    (finding,) = tally_of(PairHere(given), scope_of(1), 1).findings
    assert (finding.law, finding.choices) == ("no-estimate", (2, 0))


def test_every_schedule_is_compiled_from_four_edges_on():
    subject = load(f"native:{example(ALGORITHM1)}")
    for edges, name in ((3, "python"), (4, "kernel")):
        assert engine_for("auto", scope_of(edges), subject).name == name
        assert engine_for("auto", scope_of(edges), load("algorithm1")).name == "python"
    assert "random:1" in why_not_compiled(scope_of(4, policy="random:1"), subject)
    assert not why_not_compiled(scope_of(4), subject)


# ---------------------------------------------------------------- what has no room


@pytest.mark.parametrize(
    "code",
    [
        f"count -= pick(asked, 1, {MOST_OPTIONS}, 0) == {MOST_OPTIONS - 1}",
        f"count -= pick(asked, 1, {MOST_OPTIONS + 1}, 0) == {MOST_OPTIONS}",
        f"for (int i = 0; i < {MOST_PICKS}; i++) count -= pick(asked, 0, 1 + (i == 9), 0)",
        f"for (int i = 0; i <= {MOST_PICKS}; i++) count -= pick(asked, 0, 1 + (i == 9), 0)",
    ],
)
def test_choices_for_which_there_is_no_room_are_left_to_the_other_engine(code):
    given = of_library(attack(code, CHOOSES="1"))
    (finding,) = tally_of(PairHere(given), scope_of(1), 1).findings
    assert finding.law == "no-estimate"
    (theirs,) = one_by_one(given[0], scope_of(1), 1).findings
    assert (finding.key, finding.law, finding.seen) == (theirs.key, theirs.law, theirs.seen)


# ---------------------------------------------------------------- two players, one log


class Stretch:
    """The first runs of a level, laid out: for players, and for a judge."""

    def __init__(self, given, edges=2):
        scope = scope_of(edges)
        self.first, self.second = StretchMemory(edges), StretchMemory(edges)
        self._edges, self.player = edges, given[1]()
        level, memories = (
            level_of("native:x", scope.rules, scope.extent, edges),
            (self.first, self.second),
        )
        self.judge = ScheduleJudge(level, (-3,), 3, *(memory.stretch for memory in memories))
        self.batch = self.judge.lay_out(100)

    def play(self, row=0, script=(), most=LONGEST_STRETCH):
        """The bytes of the logs of the first play."""
        due, runs = DueSchedules(row, script, most), self.batch.runs
        job = PlayStretch(self.first.file, self._edges, runs, 1, "fifo", again=False, schedules=due)
        return self.first.stretch.logs[: self.player.play(job).size].tobytes()

    def play_again(self, player=None, order=2):
        """The bytes of the logs of the second play, and where each begins."""
        logs = self.judge.logs
        job = PlayStretch(
            self.second.file, self._edges, logs, order, "fifo", again=True, schedules=SCRIPTS_BEHIND
        )
        size = (player or self.player).play(job).size
        return self.second.stretch.logs[:size].tobytes(), self.second.stretch.begins[:logs].tolist()

    def judged(self, logs):
        """Whether these logs are those of all schedules, and break no law."""
        self.first.stretch.logs[: len(logs)] = np.frombuffer(logs, np.uint8)
        rows, good = self.judge.judge(self.batch, len(logs))
        return good and not rows.broken and self.judge.is_done(self.batch)


@pytest.fixture
def stretch():
    return Stretch(of_library(example(ALGORITHM1)))


def split(stretch):
    """The logs of a stretch, one by one; they have been judged."""
    logs = stretch.play()
    assert stretch.judged(logs)
    return [stretch.judge.kept(row).log.tobytes() for row in range(stretch.judge.logs)]


def test_a_library_writes_the_same_logs_with_compiled_code_and_without(stretch):
    player = load(f"native:{example(ALGORITHM1)}").player()
    without = GeneratorPlayer(player, [0, 0], lambda: None)
    compiled, stretch.player = stretch.player, without
    slowly = stretch.play()
    stretch.player = compiled
    assert stretch.play() == slowly
    assert stretch.judged(slowly)
    quickly, begins = stretch.play_again()
    in_order = sorted(zip(begins, range(len(begins)), strict=True))
    logs = {row: stretch.judge.kept(row).log.tobytes() for row in range(len(begins))}
    assert quickly == b"".join(logs[row] for _, row in in_order)
    again, begins = stretch.play_again(without)
    assert again == b"".join(logs[row] for _, row in sorted(zip(begins, logs, strict=True)))
    assert stretch.judge.differing(len(again)) == []


@pytest.mark.parametrize("of", [of_library, of_function])
def test_logs_end_where_there_is_no_more_room_and_go_on_from_there(of, monkeypatch):
    stretch = Stretch(of(example(ALGORITHM1) if of is of_library else algorithm1))
    logs = split(stretch)
    fresh = Stretch((None, lambda: stretch.player))
    room = sum(map(len, logs[:5])) + 20
    for module in ("isolation.generator_player", "kernel.batches"):
        monkeypatch.setattr(f"allworlds.engines.{module}.SCHEDULE_BYTES", room)
    some = fresh.play()
    assert some
    assert b"".join(logs).startswith(some)
    assert not fresh.judged(some)
    monkeypatch.undo()
    assert some + fresh.play(*fresh.judge.next) == b"".join(logs)


CHANGES = {
    "one is left out": lambda logs, at: [*logs[:at], *logs[at + 1 :]],
    "one is there twice": lambda logs, at: [*logs[: at + 1], *logs[at:]],
    "two have changed places": lambda logs, at: [
        *logs[:at],
        logs[at + 1],
        logs[at],
        *logs[at + 2 :],
    ],
    "one pick is another": lambda logs, at: with_byte(logs, at, -2),
    "there is another number of options": lambda logs, at: with_byte(logs, at, -1),
    "one has a choice less": lambda logs, at: with_byte(
        logs, at, len(logs[at]) - picks(logs[at]) - 2, -1
    ),
    "one has a choice more": lambda logs, at: with_byte(
        logs, at, len(logs[at]) - picks(logs[at]) - 2, 1
    ),
}


def picks(log):
    return 2 * len(read_picks(log))


def with_byte(logs, at, place, by=1):
    """The logs, with another byte at a place of the log number ``at``."""
    changed = bytearray(logs[at])
    changed[place] = (changed[place] + by) % 256
    return [*logs[:at], bytes(changed), *logs[at + 1 :]]


@pytest.mark.parametrize("change", CHANGES)
def test_logs_that_are_not_those_of_every_schedule_are_not_believed(change):
    given = of_library(example(ALGORITHM1))
    logs = split(Stretch(given))
    believed = 0
    for at in range(len(logs) - 1):
        changed = CHANGES[change](logs, at)
        if changed == logs:
            continue
        stretch = Stretch(given)
        believed += stretch.judged(b"".join(changed))
    assert believed == 0


@pytest.mark.no_cover
@pytest.mark.parametrize(("more", "step"), [("pick(asked, 0, 1, 0)", 0), ("", 301)])
def test_long_logs_are_played_and_judged_in_portions(more, step, monkeypatch):
    # Many choices, or many motions: a portion ends where logs or percepts have no more room.
    code = f"pick(asked, 0, 200, 0); for (int i = 0; i < 400; i++) {{ {more or '(void)i'}; }}"
    named = {"STEPS": str(step)} if step else {}
    given = of_library(attack(code, CHOOSES="1", **named))
    scope = scope_of(1, own_bound="none", step_budget=500)
    general = []
    monkeypatch.setattr(PlayedByStretches, "_by_the_general_engine", lambda *a: general.append(a))
    monkeypatch.setattr(PlayedByStretches, "_compared", 0)
    tally = tally_of(PairHere(given), scope, 1)
    assert tally.rows[1, 2].episodes == 200
    assert not tally.findings
    assert not general


def test_choices_that_were_not_made_show_in_the_second_play(stretch):
    logs = split(stretch)
    row = next(row for row, log in enumerate(logs) if any(read_picks(log)))
    again, begins = stretch.play_again()
    place = begins[row] + len(logs[row]) - 2
    stretch.second.stretch.logs[place] ^= 1
    assert stretch.judge.differing(len(again)) == [row]


def test_a_script_is_played_again_and_not_what_the_first_play_said(stretch):
    split(stretch)
    heads = stretch.second.stretch.heads[: stretch.judge.logs]
    lengths = [
        len(np.trim_zeros(stretch.judge.kept(row).choices, "b"))
        for row in range(stretch.judge.logs)
    ]
    assert heads[:, 4].tolist() == lengths
    assert not heads[:, 2].any()


# ---------------------------------------------------------------- what is wrong


@pytest.mark.parametrize(
    "code",
    [
        "pick(asked, 0, 1 + episodes % 3, 0)",  # other options
        "count -= episodes % 2; pick(asked, 0, 2, 0)",  # another answer
        "if (episodes % 2) pick(asked, 0, 2, 0)",  # no choice at all
    ],
)
def test_state_that_is_kept_from_schedule_to_schedule_is_found(code):
    given = of_library(attack(code, CHOOSES="1"))
    (finding,) = tally_of(PairHere(given), scope_of(1), 1).findings
    assert finding.law == "nondeterministic"


@pytest.mark.no_cover
def test_logs_that_cannot_be_read_are_not_believed(monkeypatch):
    given, scope = of_library(example(ALGORITHM1)), scope_of(2)
    whole = one_by_one(given[0], scope, 2)
    monkeypatch.setattr(PlayedByStretches, "_compared", 0)

    def half(said, _):
        return StretchResult(said.size // 2, 0)

    def few(_said, _):
        return StretchResult(3, 0)

    def none(_said, _):
        return StretchResult(0, 0)

    for said in (half, few, none):
        assert told(tally_of(PairHere(given, said=said), scope, 2)) == told(whole)


@pytest.mark.parametrize("edges", [1, LARGER])
def test_a_law_that_the_other_engine_does_not_find_broken_is_a_disagreement(monkeypatch, edges):
    examine = ScheduleJudge.judge
    scope = scope_of(edges)
    unit = next(iter(scope.units(edges)))
    map_ = next(unit.maps(scope.extent))
    world = BrokenRun(map_.vertex_count, map_.sigma, map_.alpha, 0, "map")

    def blames(self, batch, size, earlier=()):
        rows, good = examine(self, batch, size, earlier)
        return replace(rows, broken=(world,)), good

    monkeypatch.setattr(ScheduleJudge, "judge", blames)
    said = "count differently" if edges == 1 else "the kernel says that map is broken"
    with pytest.raises(EnginesDisagree, match=said):
        tally_of(PairHere(of_library(example(ALGORITHM1))), scope, edges)


def test_a_schedule_that_is_not_counted_is_a_disagreement(monkeypatch):
    count = PythonEngine.count_outcome

    def counts(self, referee, world, place, outcome, tally):
        if outcome.choices != (1,):
            count(self, referee, world, place, outcome, tally)

    monkeypatch.setattr(CostEngine, "count_outcome", counts)
    given = of_library(attack("pick(asked, 0, 2, 0)", CHOOSES="1"))
    with pytest.raises(EnginesDisagree, match="count differently"):
        tally_of(PairHere(given), scope_of(1), 1)
