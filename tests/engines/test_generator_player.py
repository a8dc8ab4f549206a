"""Generators played in stretches: the logs of the lean loop are those of the episode."""

from itertools import count
from random import Random

import pytest
from numpy import int32

import small
from allworlds import Ambiguous, Checkpoint, Choices, CombinatorialMap, Drop, Estimate, Move
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.engines import PythonEngine, Scope, Tally
from allworlds.engines.compiled.requests import level_of
from allworlds.engines.compiled.stretches import LEAST, THIRD, PlayedByStretches
from allworlds.engines.isolation.generator_player import (
    ByteWorld,
    GeneratorPlayer,
    log_of_run,
    recorded,
)
from allworlds.engines.isolation.jobs import PlayStretch
from allworlds.engines.isolation.messages import StretchResult
from allworlds.engines.isolation.player import PlayerProcess
from allworlds.engines.isolation.shared_logs import StretchMemory
from allworlds.engines.kernel.batches import UnitJudge
from allworlds.engines.kernel.stretch import RUN_NUMBER
from allworlds.engines.kernel.writing import LogEnd, read_log
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.engines.python.play import Recorded
from allworlds.explorers import Subject, algorithm1
from allworlds.judging import Fault, Rules, UncheckedAnswer, perform
from allworlds.maps import Extent, MapClass
from allworlds.protocol import ExplorerFault
from allworlds.world import Directional, World

pytestmark = pytest.mark.usefixtures("compiled")

BUDGET = 60
EDGE = World(small.EDGE, Directional(0))
STRANGE = bytes((LogEnd.STRANGE,))


def scope_of(edges):
    return Scope(Extent(MapClass.MAPS, edges, None), Rules("directional", own_bound="paper"))


def worlds(edges):
    """The worlds of the levels up to there, in the numbering of the kernel."""
    scope = scope_of(edges)
    for level in scope.extent.levels:
        for unit in scope.units(level):
            for map_, places in unit.placed(scope.extent, Directional):
                yield from (World(map_, place, 0) for _, place in places)


def in_bytes(percept):
    return percept.degree, percept.marks, 0 if percept.bearing is None else percept.bearing + 1


def byte_world(world, told=-1):
    """The world as the kernel lays it out."""
    vertices, table = [*world.map.vertex_of], []
    for dart, percept in enumerate(world.percepts):
        table += [vertices.index(vertices[dart]), world.map.alpha[dart], *in_bytes(percept)]
    return ByteWorld(bytes(table), told)


def ready(explore):
    """A generator function as a player."""
    return lambda first, _choices, _told: explore(first)


def log_of(explore, world=None, budget=BUDGET):
    beat = [0, 0]
    log = log_of_run(world or byte_world(EDGE), ready(explore), Choices(), budget, beat)
    assert beat[1] == 0
    return log


def meaning(log):
    """The motions, checkpoints and ending of a log; of a fault, as much as a log records."""
    motions, shown, ending = read_log(log)
    checkpoints = tuple((steps, *published) for steps, published in shown)
    return motions, checkpoints, ending if isinstance(ending, LogEnd) else UncheckedAnswer(*ending)


def by_the_episode(world, explore, budget=BUDGET):
    log = perform(world, ready(explore), Choices(), budget)
    ending = log.ending
    if isinstance(ending, Fault):
        too_often = len(log.checkpoints) > budget
        over = LogEnd.SHOWN_TOO_OFTEN if too_often else LogEnd.OVER_BUDGET
        ending = over if ending.law == "budget" else LogEnd.WITHOUT_ANSWER
    return log.actions, log.checkpoints, ending


def saying(*messages, answer=None):
    """An explorer that says this, whatever it senses."""

    def explore(_first):
        for message in messages:
            _ = yield message  # what is sensed does not matter
        return answer

    return explore


def throwing(error):
    def explore(_first):
        yield Move(0)
        raise error

    return explore


# ---------------------------------------------------------------- as in the episode


SAME_TWICE = [mutant for mutant in WRONG_EXPLORERS if mutant.name != "state-kept"]


@pytest.mark.parametrize("mutant", SAME_TWICE, ids=lambda mutant: mutant.name)
def test_a_log_is_that_of_the_episode_in_a_world_and_against_a_record(mutant):
    explore = mutant.explorer()
    for world in worlds(2):
        log = log_of(explore, byte_world(world))
        expected = by_the_episode(world, explore)
        if meaning(log)[2] is LogEnd.STRANGE:  # it has shown what is larger than any world
            assert max(len(sigma) for _, sigma, _, _ in expected[1]) > 64
            continue
        assert meaning(log) == expected
        state, sensed = world.initial, [world.first]
        for k in expected[0]:
            state, percept = world.step(state, Move(k))
            sensed.append(percept)
        record = recorded(bytes(sum(map(in_bytes, sensed), ())), -1)
        again = Recorded(sensed, None)
        assert meaning(log_of(explore, record)) == by_the_episode(again, explore)


ODD = {
    "a motion of any integer": saying(Move(7), Move(-1), Move(10**30), answer=1),
    "no motion": saying(Move(0), Move(0.5)),
    "a boolean": saying(Move(k=True)),
    "a marker": saying(Drop()),
    "nothing": saying(None),
    "a crash": throwing(ZeroDivisionError()),
    "an exit": throwing(SystemExit()),
    "no answer": saying(Move(0)),
    "a walk without end": saying(*[Move(0)] * (BUDGET + 1)),
    "checkpoints without end": saying(*[Checkpoint((0,), (0,), 0)] * (BUDGET + 2)),
    "the last checkpoint": saying(*[Checkpoint((0,), (0,), 0)] * (BUDGET + 1), answer=1),
    "a checkpoint of no integers": saying(Checkpoint((0,), "a", 0)),
    "a checkpoint in other clothes": saying(Checkpoint([0], range(1), int32(0)), answer=1),
}


@pytest.mark.parametrize("case", ODD)
def test_what_an_explorer_should_not_do_ends_its_log(case):
    assert meaning(log_of(ODD[case])) == by_the_episode(EDGE, ODD[case])


UNFIT = {
    "a quotient": saying(answer=Ambiguous((0,), (0,), (1,), (0,), 0)),
    "a checkpoint too large": saying(Checkpoint((0,) * 65, (0,) * 65, 0)),
    "a checkpoint of two sizes": saying(Checkpoint((0, 1), (0,), 0)),
    "a checkpoint below 0": saying(Checkpoint((-1,), (0,), 0)),
    "a checkpoint of nothing": saying(Checkpoint((), (), 0)),
}


@pytest.mark.parametrize("case", UNFIT)
def test_what_a_log_has_no_words_for_is_strange(case):
    assert log_of(UNFIT[case])[:1] == STRANGE


def test_an_answer_that_is_too_large_is_none():
    sigma = (*range(1, 300), 0)
    alpha = tuple(d ^ 1 for d in range(300))
    explore = saying(answer=Estimate(CombinatorialMap(sigma, alpha), 0))
    assert log_of(explore) == bytes((LogEnd.WITHOUT_ANSWER,))


@pytest.mark.parametrize(
    "error", [MemoryError(), ExplorerFault("timeout", "silent", machine=True)], ids=repr
)
def test_what_may_be_the_machines_doing_is_said_of_no_run(error):
    assert log_of(throwing(error)) is None
    assert log_of(throwing(ExplorerFault("crash", "it"))) == bytes((0, LogEnd.WITHOUT_ANSWER))


def test_against_a_record_there_is_nothing_behind_its_end():
    record = recorded(bytes((1, 1, 1, 1, 0, 0)), -1)
    log = log_of(saying(*[Move(0)] * 3), record)
    assert log == bytes((0, 0, LogEnd.STRANGE))


def test_what_is_told_is_handed_on():
    heard = []

    def player(first, choices, told):
        heard.append(told)
        return algorithm1(first)

    for told in (-1, 0, 3):
        log_of_run(byte_world(EDGE, told), player, Choices(), BUDGET, [0, 0])
    assert heard == [None, 0, 3]


@pytest.mark.parametrize("log", [b"", bytes((0, 0)), bytes((200,)), bytes((201, 2, 0, 1)), b"\xff"])
def test_a_log_without_an_end_is_none(log):
    with pytest.raises(ValueError, match=r"no end|not a valid LogEnd"):
        read_log(log)


# ---------------------------------------------------------------- stretches


def first_of(edges):
    """Memory for two players, and who judges what they leave in it."""
    memory = StretchMemory(edges), StretchMemory(edges)
    scope = scope_of(edges)
    level = level_of("x", scope.rules, scope.extent, edges)
    judge = UnitJudge(level, (-1,), 1, *(each.stretch for each in memory))
    return *memory, judge


def test_a_stretch_is_played_judged_and_played_again():
    first, second, judge = first_of(2)
    batch = judge.lay_out(100)
    player = GeneratorPlayer(ready(algorithm1), [0, 0], lambda: None)
    said = player.play(PlayStretch(first.file, 2, batch.runs, 1, "fifo", again=False))
    rows, readable = judge.judge(batch, said.size)
    assert readable
    assert rows.broken == ()
    again = player.play(PlayStretch(second.file, 2, batch.runs, 2, "fifo", again=True))
    assert judge.differing(again.size) == []


def test_who_plays_again_is_not_told_which_run_it_is():
    first, second, judge = first_of(2)
    batch = judge.lay_out(100)
    player = GeneratorPlayer(ready(algorithm1), [0, 0], lambda: None)
    job = PlayStretch(first.file, 2, batch.runs, 1, "fifo", again=False)
    judge.judge(batch, player.play(job).size)
    assert len({int(head[RUN_NUMBER]) for head in first.stretch.heads[: batch.runs]}) > 1
    assert {int(head[RUN_NUMBER]) for head in second.stretch.heads[: batch.runs]} == {0}


@pytest.mark.parametrize(("changes", "differ"), [("shown", False), ("here", True)])
def test_what_is_published_may_differ_and_what_is_done_may_not(changes, differ):
    first, second, judge = first_of(2)
    turn = count()

    def explore(_first):
        yield Checkpoint((0,), (0,), next(turn) if changes == "shown" else 0)
        yield Move(0)
        yield Checkpoint((0, 1), (0, 1), 0)
        return Estimate(small.EDGE, next(turn) if changes == "here" else 0)

    batch = judge.lay_out(4)
    play = GeneratorPlayer(ready(explore), [0, 0], lambda: None).play
    judge.judge(batch, play(PlayStretch(first.file, 2, batch.runs, 1, "fifo", again=False)).size)
    again = play(PlayStretch(second.file, 2, batch.runs, 2, "fifo", again=True))
    assert len(judge.differing(again.size)) == (batch.runs if differ else 0)


def test_logs_without_room_are_left_to_others(monkeypatch):
    first, _, judge = first_of(2)
    batch = judge.lay_out(100)
    player = GeneratorPlayer(ready(algorithm1), [0, 0], lambda: None)
    job = PlayStretch(first.file, 2, batch.runs, 1, "fifo", again=False)
    monkeypatch.setattr(player._memories.stretch(job), "logs", first.stretch.logs[:10])
    assert player.play(job) == StretchResult(-1, 0)
    failing = ready(throwing(MemoryError()))
    lost = GeneratorPlayer(failing, [0, 0], lambda: None)
    assert lost.play(job) == StretchResult(-1, 0)


def test_a_generator_is_played_by_a_generator_player():
    shared = StretchMemory(1)
    player = PlayerProcess.__new__(PlayerProcess)
    player._stretches, player._beat, player._intact = None, [0, 0], lambda: None
    job = PlayStretch(shared.file, 1, 0, 1, "fifo", again=False)
    assert player._play_stretch(Subject("x", frozenset(), ready_made), job) == StretchResult(0, 0)
    assert isinstance(player._stretches, GeneratorPlayer)


class PairHere(InProcessPlayers):
    """Both players of a function in this process; ``IN_STRETCHES`` is what they do."""

    def __init__(self, explore):
        super().__init__(Subject("x", frozenset(), explore))
        self.random = Random(1)
        self.scribes = {
            which: GeneratorPlayer(ready(explore), [0, 0], lambda: None)
            for which in ("first", "second")
        }

    def play_stretch(self, which, job):
        IN_STRETCHES.append(True)
        try:
            return self.scribes[which].play(job)
        finally:
            IN_STRETCHES.clear()


IN_STRETCHES = []


def engine_of(explore, edges):
    general = PythonEngine(scope_of(edges), 1)
    return PlayedByStretches(general, "x", PairHere(explore))


def first_unit(explore, edges):
    """The tally of the first unit of a level, and the engine."""
    engine, tally = engine_of(explore, edges), Tally(1)
    for _, part in engine.parts(next(iter(scope_of(edges).units(edges)))):
        tally.add(part)
    return tally, engine


def test_an_explorer_is_judged_by_what_it_does_in_stretches():
    tally, _ = first_unit(ready_made, 4)
    assert tally.runs
    assert not tally.findings


def ready_made(first):
    return (yield from algorithm1(first))


def misled(first):
    answer = yield from algorithm1(first)
    return Estimate(small.EDGE, 0) if IN_STRETCHES else answer


def crashing(first):
    if IN_STRETCHES:
        raise ZeroDivisionError
    return (yield from algorithm1(first))


@pytest.mark.parametrize("explore", [misled, crashing])
def test_who_is_wrong_twice_and_right_the_third_time_is_not_the_same_each_time(explore):
    tally, _ = first_unit(explore, 4)
    (finding,) = tally.findings
    assert (finding.law, finding.seen) == ("nondeterministic", THIRD)


def test_who_is_wrong_elsewhere_alone_is_found_in_small_worlds():
    def explore(first):
        answer = yield from algorithm1(first)
        return answer if IN_STRETCHES else Estimate(small.EDGE, 0)

    tally, _ = first_unit(explore, 2)
    assert [found.law for found in tally.findings] == ["map"]


def test_stretches_that_take_long_become_shorter(monkeypatch):
    slow = "allworlds.engines.compiled.stretches.REPORT_EVERY"
    monkeypatch.setattr(slow, float("inf"))  # however busy the machine is
    _, engine = first_unit(ready_made, 4)
    usual = engine._most
    monkeypatch.setattr(slow, -1.0)
    _, engine = first_unit(ready_made, 4)
    assert LEAST <= engine._most < usual
