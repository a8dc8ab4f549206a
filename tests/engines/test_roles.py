"""A player and a referee, each in this process, and asked from a thread.

So what they do is seen from inside, too; elsewhere they are forked, and killed when they are
no longer needed.
"""

import os
import signal
import socket
import threading
from contextlib import closing, suppress
from multiprocessing import Pipe
from pathlib import Path

import pytest

import processes
import small
from allworlds.engines import GivenWorlds, Limits, PythonEngine, Scope, subject_of
from allworlds.engines.isolation import process, process_tree, world_player
from allworlds.engines.isolation.failures import GuardianLost, HarnessError
from allworlds.engines.isolation.jobs import PlayerSetup, PlayRecords, PlayRuns, Trace
from allworlds.engines.isolation.messages import (
    ExplorerDescription,
    Failure,
    Refusal,
    RunLogs,
    TraceEvent,
    read_message,
)
from allworlds.engines.isolation.one_player import start_player
from allworlds.engines.isolation.player import PlayerProcess
from allworlds.engines.isolation.process import Guardian, guardian
from allworlds.engines.isolation.process_tree import is_stopped
from allworlds.engines.isolation.referee import RefereeProcess
from allworlds.engines.isolation.referee_jobs import RefereeSetup, UnitJob, UnitProgress
from allworlds.engines.isolation.world_player import WorldPlayer
from allworlds.engines.python.play import ExplorerRunner, Record
from allworlds.explorers import built_in, load
from allworlds.inputs import InputError
from allworlds.judging import Fault, Rules, UncheckedAnswer
from allworlds.maps import Extent, MapClass
from allworlds.protocol import Percept
from allworlds.world import Directional, World

WRONG = Path(__file__).parents[1] / "support" / "explorers_for_tests" / "wrong.py"
EDGE, LOOP = World(small.EDGE, Directional(0)), World(small.LOOP, Directional(0))
UNIT = GivenWorlds(((EDGE, 0), (LOOP, 0)))
ENGINE = PythonEngine(Scope(Extent(MapClass.MAPS, 1), Rules()), 4)


def setup(name):
    limits = Limits(workers=1)
    subject = subject_of(f"{WRONG}:{name}", limits)
    return PlayerSetup.of(subject, limits)


@pytest.fixture
def live():
    """Live a life here while a thread talks to it; the thread's result."""
    before = signal.getsignal(signal.SIGTERM)

    def run(life, talk):
        ours, theirs = Pipe()
        told, beat = [], [0, 0]

        def in_thread():
            try:
                told.append(talk(ours))
            finally:
                ours.close()

        thread = threading.Thread(target=in_thread)
        thread.start()
        try:
            with suppress(EOFError, OSError):
                life(theirs, beat).run()
        finally:
            theirs.close()
            thread.join(60)
        return told[0]

    yield run
    signal.signal(signal.SIGTERM, before)


def of_player(*messages):
    """A talk: each is sent after the answers to the one before; all answers."""

    def talk(connection):
        told = []
        for message in messages:
            connection.send(message)
            told.append(read_message(connection.recv_bytes()))
            while isinstance(told[-1], TraceEvent):
                told.append(read_message(connection.recv_bytes()))
        return told

    return talk


def test_a_player_describes_itself_and_plays_runs_records_and_a_trace(live):
    runs = PlayRuns(ENGINE, UNIT, (0, 1), 7, None)
    record = Record((Percept(1, 1, 0), Percept(1)), None, (), 10, "")
    trace = Trace(Rules(), EDGE, "one", ())
    description, played, again, *traced = live(
        PlayerProcess, of_player(setup("right"), runs, PlayRecords((record,), "fifo", 3), trace)
    )
    assert isinstance(description, ExplorerDescription)
    assert len(description.digest) == 64
    assert isinstance(played, RunLogs)
    logs = dict(played.logs)
    assert sorted(played.finished) == [0, 1]
    assert logs[0].ending == UncheckedAnswer((0, 1), (1, 0), 1)
    assert [log.actions for log in again.logs] == [logs[0].actions]
    assert traced[0] == TraceEvent(None)
    assert traced[1] == TraceEvent((0, Percept(1)))
    assert traced[-1].logs[0].ending == logs[0].ending


@pytest.mark.parametrize("schedules", ["one", "all"])
@pytest.mark.parametrize(("limit", "value"), [("CHUNK", 1), ("CHUNK_SECONDS", -1.0)])
def test_the_last_log_of_a_run_comes_with_the_word_that_the_run_is_finished(
    monkeypatch, limit, value, schedules
):
    # A run whose log has come, and that is not finished, would be played again; if its player is
    # lost in it then, it would be told twice.
    monkeypatch.setattr(world_player, limit, value)
    engine = PythonEngine(Scope(Extent(MapClass.MAPS, 1), Rules(), schedules=schedules), 4)
    told = []
    player = WorldPlayer(ExplorerRunner(built_in("algorithm1").player()), told.append)
    player.play_runs(PlayRuns(engine, UNIT, (0, 1), 7, None))
    assert len(told) > 1
    last = {number: at for at, each in enumerate(told) for number, _ in each.logs}
    assert {number: at for at, each in enumerate(told) for number in each.finished} == last


def test_a_player_traces_every_schedule_and_its_choices(live):
    trace = Trace(Rules(), LOOP, "all", ())
    _, *events, traced = live(PlayerProcess, of_player(setup("one_schedule"), trace))
    assert events[0] == TraceEvent(None)
    assert {type(one.what) for one in events} >= {type(None), int}
    assert len(traced.logs) == 1


def test_a_player_tells_a_crash(live):
    runs = PlayRuns(ENGINE, UNIT, (0,), 7, None)
    _, played = live(PlayerProcess, of_player(setup("raises"), runs))
    ((_, log),) = played.logs
    assert isinstance(log.ending, Fault)
    assert log.ending.law == "crash"


def test_a_player_that_cannot_load_its_explorer_refuses(live, tmp_path):
    (tmp_path / "broken.py").write_text("def explore(first): yield\n")
    given = PlayerSetup(f"{tmp_path / 'broken.py'}:another", None, 10.0, None)
    (refused,) = live(PlayerProcess, of_player(given))
    assert isinstance(refused, Refusal)


def test_a_player_that_fails_says_so(live):
    broken = PlayRecords((None,), "fifo", 3)
    _, failed = live(PlayerProcess, of_player(setup("right"), broken))
    assert isinstance(failed, Failure)


def test_a_referee_examines_a_unit_and_tells_tallies(live):
    subject = subject_of(f"{WRONG}:right", Limits(workers=1))
    units = [UnitJob(ENGINE, UNIT, 0), UnitJob(ENGINE, UNIT, 0)]

    def talk(connection):
        connection.send(RefereeSetup(subject, Limits(), 5))
        told = []
        for unit in units:
            connection.send(unit)
            told.append(connection.recv())
            while not told[-1].last:
                told.append(connection.recv())
        return told

    told = live(lambda pipe, beat: RefereeProcess(pipe, beat, guardian()), talk)
    assert all(isinstance(one, UnitProgress) for one in told)
    assert sum(one.result.runs for one in told) == 4
    assert [one.result.findings for one in told if one.last] == [[], []]


def test_a_referee_plays_an_explorer_of_ours_itself(live):
    subject = subject_of("algorithm1", Limits(workers=1))

    def talk(connection):
        connection.send(RefereeSetup(subject, Limits(), 5))
        connection.send(UnitJob(ENGINE, UNIT, 0))
        return connection.recv()

    told = live(lambda pipe, beat: RefereeProcess(pipe, beat, guardian()), talk)
    assert (told.result.runs, told.result.findings) == (2, [])


def test_a_guardian_of_nobody_is_gone():
    ours, theirs = socket.socketpair()
    theirs.close()
    with pytest.raises(HarnessError, match="guardian"):
        Guardian(ours, os.getpid()).exit_code(1)


@pytest.fixture
def stopped():
    """A guardian that stands still."""
    guardian = process.start_guardian()
    assert guardian.exit_code(1) is None
    os.kill(guardian._pid, signal.SIGSTOP)
    assert processes.wait(lambda: is_stopped(guardian._pid))
    yield guardian
    guardian.close()


@pytest.mark.early
def test_a_guardian_that_was_stopped_goes_on_when_it_is_asked(stopped):
    assert stopped.exit_code(1) is None


def test_a_guardian_that_was_stopped_ends_when_nobody_needs_it(stopped):
    stopped.close()
    assert stopped._process.returncode == 0


@pytest.mark.parametrize("act", [lambda one: one.exit_code(1), lambda one: one.close()])
def test_a_guardian_that_is_stopped_for_ever_is_not_waited_for(stopped, monkeypatch, act):
    monkeypatch.setattr(process.Guardian, "wake", lambda _: None)
    monkeypatch.setattr(process_tree, "MOST_STOPS", 3)
    with suppress(GuardianLost):
        act(stopped)
    assert stopped._process.returncode == -signal.SIGKILL


def test_a_guardian_that_does_not_answer_is_not_waited_for(stopped, monkeypatch):
    monkeypatch.setattr(process.Guardian, "wake", lambda _: None)
    monkeypatch.setattr(process, "ANSWERS", 0.2)
    said = "the guardian of the processes does not answer, perhaps because of the explorer"
    with pytest.raises(GuardianLost, match=said):
        stopped.exit_code(1)


def test_a_child_of_a_guardian_that_is_stopped_goes_on_at_once():
    player, _ = start_player(guardian(), setup("right"))
    for _ in range(3):
        os.kill(player.pid, signal.SIGSTOP)
        assert processes.wait(lambda: not is_stopped(player.pid))
    player.close()


def test_an_explorer_of_ours_beats_while_it_walks_and_not_after():
    class Heard(list):
        def __setitem__(self, index, value):
            beats.append((index, value))
            super().__setitem__(index, value)

    beats = []
    scope = Scope(Extent(MapClass.MAPS, 2), Rules("directional"))
    unit = next(iter(scope.units(2)))
    for _ in PythonEngine(scope, 1).for_built_in(load("folding"), Heard([0, 0])).parts(unit):
        pass
    assert max(beats) > (1, 0)
    assert beats[-1] == (1, 0)


def test_what_plays_in_worlds_is_loaded_before_the_explorer_where_it_is_asked_for(tmp_path):
    file = tmp_path / "looks.py"
    file.write_text(
        "import sys\n"
        "assert 'allworlds.engines.isolation.world_player' in sys.modules\n"
        "def explore(first):\n    yield\n"
    )
    setup = PlayerSetup(f"{file}:explore", None, 2.0, None)
    with closing(process.start_guardian()) as own:
        with pytest.raises(InputError, match="AssertionError"):
            start_player(own, setup, 3)
        for seed in (None, 3):
            player, _ = start_player(own, setup, seed, in_worlds=True)
            player.close()
