"""Small models, and programs for several robots, that tests of schedules share."""

from dataclasses import dataclass
from typing import NamedTuple

from allworlds.protocol.actions import Do, IllegalAction, Move, Wait, Watch
from allworlds.robots.model import Model


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
        dark: the goal is that it is lit, so often.
    """

    blinks: bool = False
    fails: bool = False
    dark: int = 3

    def initial(self, map_, starts):
        yield Lamps(tuple(starts))
        if self.fails:
            yield Lamps(tuple(starts), 1)

    def told(self, map_, robot):
        return robot

    def sensed(self, map_, state, robot):
        if robot in state.gone:
            return None
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
        return "" if state.lamp % 2 else "it is dark"


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
