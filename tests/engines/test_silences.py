"""Silences that end a job with a finding: after other runs only, or too many."""

from types import SimpleNamespace

import pytest

from allworlds.engines import GivenWorlds, Scope
from allworlds.engines.isolation.failures import Unsettled
from allworlds.engines.isolation.jobs import PlayerSetup
from allworlds.engines.isolation.one_player import receive
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.second_play import PlayedTwice
from allworlds.engines.transports.inline import with_last
from allworlds.explorers import algorithm1, in_process_subject
from allworlds.judging import Fault, Log, LostRun, Rules, place_of
from allworlds.maps import Extent, MapClass
from allworlds.world import worlds


def right():
    def explore(first):
        return (yield from algorithm1(first))

    return explore


class Silences(InProcessPlayers):
    """Players in this process, which say that one run was silent."""

    def __init__(self, *, machine):
        super().__init__(in_process_subject(right()))
        self.lost = LostRun("timeout", "an action", "silent after others", "", machine)

    def play_runs(self, engine, unit, numbers, script=None):
        for logs in super().play_runs(engine, unit, numbers, script):
            yield [(number, Log((), (), self.lost) if number == 3 else log) for number, log in logs]


def parts(players):
    """The parts of a unit, as a transport hands them over, up to the end or to an exception."""
    scope = Scope(Extent(MapClass.MAPS, 2), Rules())
    unit = GivenWorlds(tuple((world, place_of(world)) for world in worlds(edges=2, places="all")))
    twice = PlayedTwice(PythonEngine(scope, keep=1), "explore", players)
    handed_over = []
    try:
        for (_, tally), _ in with_last(twice.parts(unit)):
            handed_over.append(tally)
    except Unsettled as error:
        return handed_over, str(error)
    return handed_over, ""


class Talking:
    """A player whose next message is always there."""

    def __init__(self):
        self.connection = SimpleNamespace(poll=lambda _: True)

    def silent_for(self):
        return 0.0

    def receive(self):
        return "a log"


def test_a_run_with_many_schedules_is_no_silence_of_the_referee():
    beats = []
    setup = PlayerSetup("right", None, 60.0, None)
    assert [receive(Talking(), setup, lambda: beats.append(1)) for _ in range(3)] == ["a log"] * 3
    assert len(beats) == 3


def test_a_silence_after_others_ends_the_job_and_its_finding_is_handed_over():
    (tally,), reason = parts(Silences(machine=False))
    assert reason == "the explorer keeps a state: silent after others"
    assert [found.law for found in tally.findings] == ["timeout"]


def test_a_silence_of_a_world_leaves_the_others_to_be_done():
    tallies, reason = parts(Silences(machine=True))
    assert reason == ""
    assert sum(tally.runs for tally in tallies) == 30
    assert [found.law for tally in tallies for found in tally.findings] == ["timeout"]


class ManySilences(InProcessPlayers):
    """Players in this process, which say that all runs from the third one on were silent.

    ``lost``: whether the players were lost with them, as those of an explorer in Python; else the
    fault is a program's, and comes in the second play, too.
    """

    def __init__(self, timeout, *, lost):
        super().__init__(in_process_subject(right()))
        self.kind = LostRun if lost else Fault
        self.timeout = timeout
        self.asked = 0

    @property
    def answer_timeout(self):
        return self.timeout

    def play_runs(self, engine, unit, numbers, script=None):
        del engine, unit, script
        for number in numbers:
            self.asked += 1
            yield [(number, Log((), (), self.kind("timeout", "an action", "silent", machine=True)))]

    def send_records(self, records, policy):
        del policy
        silent = Fault("timeout", "an action", "silent", machine=True)
        self._logs = [Log((), (), silent) for _ in records]


@pytest.mark.parametrize("lost", [False, True])
@pytest.mark.parametrize(("timeout", "silences"), [(2.0, 15), (10.0, 3), (60.0, 2)])
def test_silences_that_take_too_long_end_the_job_with_a_finding(timeout, silences, lost):
    players = ManySilences(timeout, lost=lost)
    handed_over, reason = parts(players)
    told = f"silent in {silences} runs, for {timeout:g} s each"
    assert reason == f"the explorer was {told}, and the other runs would take too long"
    assert [found.law for tally in handed_over for found in tally.findings] == ["timeout"]
    assert players.asked == silences


@pytest.mark.parametrize("lost", [False, True])
def test_short_silences_leave_the_others_to_be_done(lost):
    tallies, reason = parts(ManySilences(0.5, lost=lost))
    assert reason == ""
    assert sum(tally.runs for tally in tallies) == 30


def test_silences_that_are_not_repeated_do_not_count():
    class Recovering(ManySilences):
        def play_runs(self, engine, unit, numbers, script=None):
            if len(numbers) > 1:
                yield from super().play_runs(engine, unit, numbers, script)
            else:
                yield from InProcessPlayers.play_runs(self, engine, unit, numbers, script)

        def send_records(self, records, policy):
            InProcessPlayers.send_records(self, records, policy)

    tallies, reason = parts(Recovering(1.0, lost=False))
    assert reason == ""
    assert not [found for tally in tallies for found in tally.findings]
