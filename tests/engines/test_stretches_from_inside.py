"""The work of processes for stretches, tested without processes."""

import gc
import socket
from multiprocessing import Pipe
from random import Random

import pytest

from allworlds.engines import Limits, PythonEngine, Scope
from allworlds.engines.compiled.stretches import PlayedByStretches
from allworlds.engines.compiled.users_engine import UsersEngine
from allworlds.engines.isolation.guardian import Prepare, _Guardian
from allworlds.engines.isolation.jobs import PlayerSetup, PlayStretch
from allworlds.engines.isolation.memory_limit import address_space
from allworlds.engines.isolation.messages import StretchResult
from allworlds.engines.isolation.one_player import PlayerLost
from allworlds.engines.isolation.player import PlayerProcess
from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.isolation.referee import RefereeProcess
from allworlds.engines.isolation.referee_jobs import RefereeSetup
from allworlds.engines.isolation.shared_logs import StretchMemory
from allworlds.explorers import load
from allworlds.judging import Rules
from allworlds.maps import Extent, MapClass
from native_libraries import example

JOB = PlayStretch("", 1, 0, 1, "fifo", again=False)
SETUP = PlayerSetup("native:x", None, 1.0, None)

pytestmark = pytest.mark.usefixtures("compiled")


class Deaf:
    """A process that hears nothing, and counts how often it is ended."""

    def __init__(self):
        self.ended = 0

    def send(self, message):
        assert message == JOB

    def close(self):
        self.ended += 1


def answering(monkeypatch, answer):
    pair, deaf = PlayerPair(None, SETUP, Random(1)), Deaf()
    pair._processes["first", None] = deaf

    def receive(*_):
        if isinstance(answer, Exception):
            raise answer
        return answer

    monkeypatch.setattr("allworlds.engines.isolation.player_pair.receive", receive)
    return pair.play_stretch("first", JOB), deaf.ended


def test_a_player_that_has_played_a_stretch_is_believed_and_kept(monkeypatch):
    assert answering(monkeypatch, StretchResult(5, 0)) == (StretchResult(5, 0), 0)


@pytest.mark.parametrize("answer", [PlayerLost("crash", "gone", None, machine=True), [], None])
def test_a_player_that_is_lost_or_sends_another_message_is_ended(monkeypatch, answer):
    assert answering(monkeypatch, answer) == (None, 1)


@pytest.mark.parametrize(("answer", "times"), [(None, 1), (0, 2), (1, 2)])
def test_what_is_prepared_is_called_once_and_what_is_asked_each_time(monkeypatch, answer, times):
    called = []
    monkeypatch.setattr(gc, "told", lambda: [called.append(0), answer][1], raising=False)
    ours, theirs = socket.socketpair()
    with ours, theirs:
        guardian = _Guardian(ours, {})
        try:
            answers = [guardian._prepare(Prepare("gc", "told")) for _ in range(2)]
        finally:
            gc.unfreeze()
    assert answers == [answer, answer]
    assert len(called) == times
    assert guardian._prepared == ({Prepare("gc", "told")} if answer is None else set())


def test_a_player_plays_a_stretch_that_it_is_shown():
    ours, theirs = Pipe()
    with ours, theirs:
        subject = load(f"native:{example('c/algorithm1.c')}")
        player, shared = PlayerProcess(theirs, bytearray(16)), StretchMemory(1)
        job = PlayStretch(shared.file, 1, 0, 1, "fifo", again=False)
        for _ in range(2):
            assert player._play_stretch(subject, job) == StretchResult(0, 0)
        shared.close()


def test_a_referee_takes_the_engine_of_native_explorers():
    ours, theirs = Pipe()
    with ours, theirs:
        subject = load(f"native:{example('c/algorithm1.c')}")
        scope = Scope(Extent(MapClass.MAPS, 1, None), Rules("directional", own_bound="paper"))
        referee = RefereeProcess(theirs, bytearray(16), None)
        pair = PlayerPair(None, SETUP, Random(1))
        engine = referee._bind(
            UsersEngine(PythonEngine(scope, 1)),
            RefereeSetup(subject, Limits(), 1),
            pair,
        )
        assert isinstance(engine, PlayedByStretches)
        assert engine.players is pair


def test_a_process_knows_how_large_it_is():
    assert address_space() > 1
