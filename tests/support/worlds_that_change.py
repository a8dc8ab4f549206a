"""Small models, and programs for several robots, that tests of schedules share."""

from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

from allworlds.protocol.actions import Do, IllegalAction, Move, Wait, Watch
from allworlds.protocol.turns import Automaton
from allworlds.robots.model import QUIET, Assumption, Liveness, Model
from allworlds.robots.models.meeting import Meeting
from small import EDGE, LOOP, PATH, TRIANGLE


class Lamps(NamedTuple):
    darts: tuple
    lamp: int = 0
    gone: tuple = ()


@dataclass(frozen=True)
class Lamp(Model):
    """Everybody sees one lamp, that blinks each round, or is switched by ``Do``.

    Attributes:
        blinks: whether each round switches it.
        fails: whether the adversary may leave it as it is.
        dark: how often it may be switched.
        lit: whether it must be lit at the end.
        odd: whether 1 is sensed after one switch, and true after two.
    """

    blinks: bool = False
    fails: bool = False
    dark: int = 3
    lit: bool = True
    odd: bool = False

    def initial(self, map_, starts):
        yield Lamps(tuple(starts))
        if self.fails:
            yield Lamps(tuple(starts), 1)

    def told(self, map_, robot):
        return robot

    def sensed(self, map_, state, robot):
        if robot in state.gone:
            return None
        if self.odd:
            return 1 if state.lamp == 1 else state.lamp == 2
        return [map_.degree_at[state.darts[robot]], state.lamp % 2 == 1]

    def step(self, map_, state, acts):
        darts, lamp, gone = [*state.darts], state.lamp, {*state.gone}
        if self.blinks:
            lamp = min(lamp + 1, 9)
        for robot, action in acts.items():
            match action:
                case Move(k):
                    darts[robot] = map_.move(darts[robot], k)
                case Do("switch"):
                    lamp += 1
                case Do("shoot"):
                    gone |= {*range(len(darts))} - {robot}
                case _:
                    raise IllegalAction(f"{action} means nothing")
        if self.fails and acts and lamp != state.lamp:
            yield state._replace(darts=tuple(darts), gone=tuple(sorted(gone))), "it fails"
        yield Lamps(tuple(darts), lamp, tuple(sorted(gone))), ""

    def bad(self, map_, state):
        return "it is switched too often" if state.lamp > self.dark and not self.blinks else ""

    def flaw(self, map_, state, answers):
        return "it is dark" if self.lit and not state.lamp % 2 else ""


def steps(first, *, told=None):
    """Two motions by what is sensed, then end."""
    seen = yield Move(1)
    yield Move(seen.marks if hasattr(seen, "marks") else seen[0])


def patient(first, *, told=None):
    """Robot 0 waits for ever."""
    if told == 0:
        while True:
            yield Wait()
    yield Move(1)
    yield Move(0)
    yield Move(2)


def watches(first, *, told=None):
    """Robot 0 watches, and moves once when it sees something else."""
    if told == 0:
        yield Watch()
        yield Move(1)
        return 0
    yield Move(1)
    yield Move(1)
    return 1


def switches(first, *, told=None):
    """Switch the lamp while it is dark, twice at most."""
    seen = first
    for _ in range(2):
        if seen[1]:
            return
        seen = yield Do("switch")


def shoots(first, *, told=None):
    """Robot 1 makes an end of all others, that walk."""
    if told == 1:
        yield Do("shoot")
        return
    yield Move(1)
    yield Do("switch")


def counts(first, *, told=None):
    """Switch the lamp until true is sensed, which is not 1."""
    seen = first
    for _ in range(2):
        if seen is True:
            return
        seen = yield Do("switch")


def crashes(first, *, told=None):
    """Raise once the lamp is lit."""
    seen = yield Do("switch")
    if seen[1]:
        seen = yield Move(1)
    return 1 // (1 - seen[1])


def blind(first, *, told=None):
    """Do what nobody knows, after a motion where the degree is 2."""
    degree = first[0] if isinstance(first, list) else first.degree
    if degree == 2:
        yield Move(1)
    if degree == 3:
        return
    yield Do("fly")


def sleeps(first, *, told=None):
    """Watch until the lamp is lit, then switch it off; robot 0 lights it."""
    if told == 0:
        yield Move(1)
        yield Do("switch")
        return
    yield Watch()
    yield Do("switch")
    yield Do("switch")


MEETING = Meeting(labels=True)
CASES = {
    "steps": (Meeting(), steps, 3),
    "never out of step": (MEETING, patient, 2),
    "watches": (MEETING, watches, 2),
    "weak": (Meeting(multiplicity="weak", apart=False), steps, 2),
    "blind": (Meeting(), blind, 2),
    "switches": (Lamp(), switches, 2),
    "fails": (Lamp(fails=True), switches, 1),
    "blinks": (Lamp(blinks=True), switches, 1),
    "too often": (Lamp(dark=1), switches, 2),
    "shoots": (Lamp(), shoots, 2),
    "shoots, dark": (Lamp(lit=False), shoots, 2),
    "counts": (Lamp(lit=False, odd=True), counts, 1),
    "crashes": (Lamp(), crashes, 2),
    "unknown": (Lamp(), blind, 2),
    "sleeps": (Lamp(), sleeps, 2),
    "sleeps while it blinks": (Lamp(blinks=True), sleeps, 1),
    "sleeps while it fails": (Lamp(blinks=True, fails=True), sleeps, 1),
}


@dataclass(frozen=True)
class Together(Meeting):
    """Robots with another aim than to meet once.

    Attributes:
        aim: the kind of the condition.
    """

    aim: str = "GF"

    def over(self, map_, state):
        return False

    def progress(self, map_):
        def met(state):
            return len({map_.vertex_of[dart] for dart in state.darts}) == 1

        yield QUIET if self.aim == "quiet" else Liveness("together", self.aim == "FG", met)


@dataclass(frozen=True)
class Gate(Together):
    """The adversary lets nobody move, or all; it must let them again and again.

    Attributes:
        opens: whether it must.
    """

    opens: bool = True

    def step(self, map_, state, acts):
        yield state, "shut"
        yield from ((after, "open") for after, _ in super().step(map_, state, acts))

    def assumes(self, map_):
        if self.opens:
            yield Assumption("open", lambda _before, _after, words: words == "open")


WAIT = Wait()


def automata(other=WAIT):
    """All 256 with two states that sense whether somebody is here, and move or do the other."""
    acts = Move(1), other
    for does in product(acts, repeat=4):
        for after in product((0, 1), repeat=4):
            yield Automaton(0, table(does, after))


def table(does, after):
    def step(memory, percept):
        at = 2 * memory + (percept.marks > 0)
        return after[at], does[at]

    return step


WORLDS = [
    (EDGE, (0, 1), Meeting()),
    (EDGE, (0, 1), Together(aim="GF")),
    (EDGE, (0, 0), Together(aim="FG")),
    (LOOP, (0, 1), Together(aim="quiet")),
    (PATH, (0, 3), Together(aim="GF")),
    (PATH, (0, 1), Together(aim="FG")),
    (PATH, (0, 2), Together(aim="quiet")),
    (TRIANGLE, (0, 3), Together(aim="GF")),
    (TRIANGLE, (0, 1), Together(aim="FG")),
]
GATES = [
    (EDGE, (0, 1), Gate()),
    (PATH, (0, 3), Gate(aim="FG")),
    (PATH, (0, 1), Gate(opens=False)),
    (TRIANGLE, (0, 3), Gate()),
]


@dataclass(frozen=True)
class Never(Meeting):
    """A goal that is never reached."""

    def over(self, map_, state):
        return False
