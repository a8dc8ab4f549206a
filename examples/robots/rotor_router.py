"""The rotor-router: a robot without memory, and a pointer at each vertex, in a model of its own.

It leaves by the dart to which the pointer points, which then points to the next one clockwise.  The
adversary chooses the pointers at first.  ``goes`` is a generator, whose activations are counted:
``--model rotor_router.py:RotorRouter:cover=true --within 9`` is enough for paths of three edges.
"""

from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

from allworlds import Automaton, Do, Model


class Pointed(NamedTuple):
    """A state: where the robot is, the dart to which each vertex points, the edges crossed."""

    darts: tuple
    pointers: tuple
    crossed: frozenset = frozenset()


def pointed_way(map_, vertex, pointers):
    """The dart of arrival, and the pointers, after a step."""
    leave = pointers[vertex]
    turned = (*pointers[:vertex], map_.turn(leave, 1), *pointers[vertex + 1 :])
    return map_.alpha[leave], turned


@dataclass(frozen=True)
class RotorRouter(Model):
    """With ``cover`` the run ends when every edge was crossed; else it never ends."""

    cover: bool = False

    def initial(self, map_, starts):
        """With all pointers."""
        for pointers in product(*map_.vertices):
            yield Pointed((starts[0],), pointers)

    def sensed(self, map_, state, robot):
        """Nothing."""
        return 0

    def step(self, map_, state, acts):
        """Follow the pointer; of the dart of arrival its vertex alone matters."""
        dart, pointers = pointed_way(map_, map_.vertex_of[state.darts[0]], state.pointers)
        edge = {min(dart, map_.alpha[dart])} if self.cover else set()
        here = map_.vertices[map_.vertex_of[dart]][0]
        yield Pointed((here,), pointers, state.crossed | edge), ""

    def over(self, map_, state):
        """Whether all is crossed."""
        return self.cover and len(state.crossed) == map_.edge_count

    def progress(self, map_):
        """That all is crossed, if it is asked for."""
        return super().progress(map_) if self.cover else ()


go = Automaton(None, lambda memory, percept: (memory, Do("go")))


def goes(first):
    """Go on."""
    while True:
        yield Do("go")
