"""The graph of a search: its steps, and a law that is broken in it."""

from __future__ import annotations

from array import array
from collections.abc import Iterable
from typing import NamedTuple


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


INDEX, BITS = 20, 12
"""The bits of the index of what the adversary does, and those of a set of robots."""

MOST_ROBOTS = BITS
"""The largest number of robots."""


class Graph:
    """The steps of a search, each in a number of 64 bits.

    Those of a configuration are in one piece, in the order in which configurations are met.
    """

    def __init__(self) -> None:
        self._first, self._steps, self._came = array("q"), array("q"), array("q")

    def begin(self, number: int) -> None:
        """Begin the steps of a configuration; those between have none."""
        while len(self._first) <= number:
            self._first.append(len(self._steps))

    def add(self, to: int, group: int, *, acts: bool) -> None:
        """Add a step of a set of robots, as bits, and whether one of them acts."""
        self._steps.append(to << BITS + 1 | group << 1 | acts)

    def meet(self, before: int, group: int, adversary: int) -> None:
        """Add a configuration, with the step by which it is met first."""
        self._came.append(before << BITS + INDEX | group << INDEX | adversary)

    def __len__(self) -> int:
        return len(self._steps)

    def steps(self, number: int) -> range:
        """The steps of a configuration."""
        first, after = self._first, number + 1
        return range(first[number], first[after] if after < len(first) else len(self._steps))

    def to(self, step: int) -> int:
        """The configuration to which a step leads."""
        return self._steps[step] >> BITS + 1

    def following(self, steps: Iterable[int]) -> list[int]:
        """The configurations to which steps lead."""
        every = self._steps
        return [every[step] >> BITS + 1 for step in steps]

    def group(self, step: int) -> int:
        """The robots of a step, as bits."""
        return self._steps[step] >> 1 & (1 << BITS) - 1

    def acts(self, step: int) -> bool:
        """Whether somebody acts in a step."""
        return bool(self._steps[step] & 1)

    def still_steps(self, number: int) -> list[int]:
        """The steps of a configuration in which nobody acts."""
        return [step for step in self.steps(number) if not self.acts(step)]

    def came(self, number: int) -> GraphStep:
        """The step by which a configuration was met first."""
        came = self._came[number]
        group = came >> INDEX & (1 << BITS) - 1
        return GraphStep(came >> BITS + INDEX, group, came & (1 << INDEX) - 1)

    def step(self, number: int, step: int) -> GraphStep:
        """A step from a configuration."""
        group = self.group(step)
        every = [each for each in self.steps(number) if self.group(each) == group]
        return GraphStep(number, group, every.index(step))
