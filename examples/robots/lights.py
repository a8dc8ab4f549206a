"""Two robots on a line with lights of two colours that shall be at one point, in an own model.

The rules are Viglietta's (2013), as in the public models of xdefago/spin-light.  They hold in async
if the light changes with the look, ``lights.py:Lights``, and fail if it changes with the move,
``lights.py:Lights:late=true``.  Points are exact, up to similarity; the map means nothing.
"""

from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from allworlds import Automaton, Do, Model, Wait
from allworlds.robots import Liveness

BLACK, WHITE = "black", "white"

RULES = {
    (BLACK, BLACK): (WHITE, "0"),
    (BLACK, WHITE): None,
    (WHITE, BLACK): (WHITE, "1"),
    (WHITE, WHITE): (BLACK, "1/2"),
}
"""By one's own light and the other's: the next light, and the share of the way to the other one."""


class Lit(NamedTuple):
    """A state: points and lights; and the light and the point that each has decided, or None."""

    points: tuple
    lights: tuple
    due: tuple = (None, None)
    darts: tuple = (0, 1)


def alike(state):
    """The similar state with robot 0 at 0, and the first other point at 1."""
    zero = state.points[0]
    every = [*state.points, *(due[1] for due in state.due if due)]
    scale = next((point - zero for point in every if point != zero), Fraction(1))
    points = tuple((point - zero) / scale for point in state.points)
    due = tuple(due and (due[0], (due[1] - zero) / scale) for due in state.due)
    return state._replace(points=points, due=due)


@dataclass(frozen=True)
class Lights(Model):
    """A percept is one's own light, and the other's; ``Do([light, share])`` changes it and goes."""

    late: bool = False

    def initial(self, map_, starts):
        """Both black, apart."""
        yield Lit((Fraction(0), Fraction(1)), (BLACK, BLACK))

    def sensed(self, map_, state, robot):
        """Both lights."""
        return [state.lights[robot], state.lights[1 - robot]]

    def looked(self, map_, state, robot, action):
        """Decide the point; the light changes now, or late."""
        lights, due = [*state.lights], [*state.due]
        due[robot] = decided(state, robot, action)
        if not self.late:
            lights[robot] = due[robot][0]
        yield alike(state._replace(lights=tuple(lights), due=tuple(due))), ""

    def step(self, map_, state, acts):
        """Go to the points."""
        points, lights, due = [*state.points], [*state.lights], [*state.due]
        for robot, action in acts.items():
            lights[robot], points[robot] = due[robot] or decided(state, robot, action)
            due[robot] = None
        yield alike(Lit(tuple(points), tuple(lights), tuple(due))), ""

    def progress(self, map_):
        """One point, for ever."""
        yield Liveness("one point", forever=True, holds=lambda s: s.points[0] == s.points[1])


def decided(state, robot, action):
    """The light and the point of an action."""
    light, share = action.value
    here, there = state.points[robot], state.points[1 - robot]
    return light, here + Fraction(share) * (there - here)


def by_rules(memory, percept):
    """Follow the rules."""
    rule = RULES[tuple(percept)]
    return memory, Wait() if rule is None else Do(rule)


two_colours = Automaton(None, by_rules)
