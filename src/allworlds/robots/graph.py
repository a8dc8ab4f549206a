"""The graph of a search: its steps, and a law that is broken in it."""

from __future__ import annotations

from array import array
from typing import NamedTuple

from msgspec import Struct, field


class GraphStep(NamedTuple):
    """A step of a set of robots, and of the adversary.

    Attributes:
        before: the number of the configuration; -1: the adversary chooses the first state.
        group: the robots, as bits.
        adversary: the index of what it does, among what the model yields.
    """

    before: int
    group: int
    adversary: int


class Broken(NamedTuple):
    """A law that is broken, and where.

    Attributes:
        law: its name.
        seen: in words.
        at: the number of the last configuration.
        group: the robots that are activated there, if it is their step that breaks the law.
        cycle: the steps from ``at`` that repeat for ever, by their numbers in the graph.
        robot: whose program is to blame; None: nobody's alone.
    """

    law: str
    seen: str
    at: int
    group: tuple[int, ...] = ()
    cycle: tuple[int, ...] = ()
    robot: int | None = None


class Graph(Struct):
    """The steps of a search: of each configuration in one piece, in the order of their numbers.

    Attributes:
        first: where the steps of each configuration begin.
        to: to which configuration each step leads.
        group: the robots of each step, as bits.
        acts: whether somebody acts in it.
    """

    first: array[int] = field(default_factory=lambda: array("i"))
    to: array[int] = field(default_factory=lambda: array("i"))
    group: array[int] = field(default_factory=lambda: array("i"))
    acts: array[int] = field(default_factory=lambda: array("b"))

    def steps(self, number: int) -> range:
        """The steps of a configuration."""
        last = self.first[number + 1] if number + 1 < len(self.first) else len(self.to)
        return range(self.first[number], last)

    def still_steps(self, number: int) -> list[int]:
        """The steps of a configuration in which nobody acts."""
        return [step for step in self.steps(number) if not self.acts[step]]
