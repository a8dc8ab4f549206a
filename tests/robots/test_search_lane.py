"""Two plays of a program that differ: who is blamed, and in which world; what a lane tells."""

from dataclasses import dataclass
from typing import NamedTuple

import pytest

import allworlds
from allworlds import Move
from allworlds.robots import search_lane
from allworlds.robots.model import Model
from allworlds.robots.models.meeting import Meeting
from allworlds.robots.program_player import ProgramPlayer
from allworlds.robots.search_lane import SearchLane
from allworlds.robots.team import Team, TeamTally

PROGRAMS = """
import random

from allworlds import Automaton, Move, Watch

steady = Automaton(0, lambda memory, percept: (0, Watch()))
wavering = Automaton(0, lambda memory, percept: (0, Move(random.getrandbits(60))))

def wavers(first):
    yield Move(random.getrandbits(60))
    yield Watch()

def waits(first):
    yield Watch()
"""


@dataclass(frozen=True)
class TwoFaces(Meeting):
    """A model that has no start in a map with another number of faces."""

    apart: bool = False

    def starts(self, map_, robots):
        return super().starts(map_, robots) if len(map_.faces) == 2 else ()


@pytest.fixture
def team(tmp_path):
    (tmp_path / "programs.py").write_text(PROGRAMS)

    def searched(*names, **options):
        programs = [f"{tmp_path / 'programs.py'}:{name}" for name in names]
        return allworlds.team(*programs, budget=6, max_findings=99, **options)

    return searched


@pytest.mark.parametrize("names", [("waits", "wavers"), ("steady", "wavering")])
def test_the_robot_whose_program_differs_is_blamed(team, names):
    found = team(*names, model="meeting", edges=1, scheduler="central").findings
    (blamed,) = [each for each in found if each.law == "nondeterministic"]
    (turn,) = blamed.events[-1].robots
    assert blamed.robot == turn.robot == 1
    first, second = blamed.seen.removesuffix(" in another").split(" in one play, ")
    assert first != second


def test_maps_without_a_start_are_passed_by_when_a_world_is_sought(team):
    found = team("waits", "wavers", model=TwoFaces(), edges=3, scheduler="central").findings
    blamed = [each for each in found if each.law == "nondeterministic"]
    assert blamed
    assert {len(each.map.faces) for each in blamed} == {2}


class WithLetter(NamedTuple):
    darts: tuple
    letter: str


@dataclass(frozen=True)
class SometimesOver(Model):
    """A model whose first start is over; it reads each action, since each is a motion."""

    def initial(self, map_, starts):
        yield from (WithLetter(tuple(starts), letter) for letter in "AB")

    def sensed(self, map_, state, robot):
        return "x" if robot == 0 else state.letter

    def over(self, map_, state):
        return state.letter != "B"

    def step(self, map_, state, acts):
        assert all(type(action) is Move for action in acts.values())
        yield state._replace(letter="C"), ""


@pytest.mark.parametrize(
    "names", [("wavering", "steady"), ("wavers", "waits"), ("wavering", "waits")]
)
def test_a_robot_is_not_blamed_where_the_run_is_over_and_no_program_was_asked(team, names):
    found = team(*names, model=SometimesOver(), edges=1, scheduler="fsync").findings
    blamed = [each for each in found if each.law == "nondeterministic"]
    assert blamed
    for each in blamed:
        turns = each.events[-1].robots
        assert [(turn.sensed, turn.did) for turn in turns[1:]] == [("B", "watch")]


@pytest.mark.parametrize("method", ["replies", "plays"])  # of the first play, of the second one
def test_a_process_that_is_lost_once_is_a_remark(team, monkeypatch, method):
    lost = iter(["a process was lost once: signal 9"])

    def losing(player, asked):
        for remark in lost:
            player._remark(remark)
        return getattr(ProgramPlayer, method)(player, asked)

    monkeypatch.setattr(search_lane, "ProgramPlayer", type("P", (ProgramPlayer,), {method: losing}))
    remarks = team("waits", "waits", model="meeting", edges=1).remarks
    assert remarks == ("a process was lost once: signal 9",)


def test_nothing_is_left_at_the_end_of_a_lane():
    class Scope:
        def tally(self):
            return TeamTally(3)

    assert SearchLane(Team((), ()), Scope(), None).end() == TeamTally(3)


def test_each_unit_begins_with_players_that_have_heard_nothing(team, monkeypatch):
    begun = []
    begin = ProgramPlayer.begin_unit

    def noted(player):
        begun.append(player)
        begin(player)

    monkeypatch.setattr(ProgramPlayer, "begin_unit", noted)
    found = team("waits", "waits", model="meeting", edges=2, scheduler="fsync")
    players = {id(player) for player in begun}
    assert len(players) > 1
    assert len(begun) % len(players) == 0  # each player, at every unit
    assert len(begun) > len(players)
    assert found.rows
