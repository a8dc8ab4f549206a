"""The graph of a search: the transitions between its configurations; the run that breaks a law.

A configuration is a state of the world, with the minds of all robots.  A set of robots is stored as
a *bit set*, an integer in which bit i stands for robot i.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable
from typing import NamedTuple

from allworlds.inputs.checks import InputError


class Transition(NamedTuple):
    """A step of some robots at once, with a choice of the adversary.

    Attributes:
        before: the number of the configuration before the step; -1 if the step is the choice of a
            state at the start.
        bits: the robots that are activated, as a bit set.
        adversary: the index of the adversary's choice, among the states that the model yields.
    """

    before: int
    bits: int
    adversary: int


class Broken(NamedTuple):
    """A broken law, and the run that breaks it.

    Attributes:
        law: the name of the law.
        seen: how the law is broken, in words.
        at: the number of the last configuration of the run, or of the first configuration of its
            cycle.
        group: the robots whose step from ``at`` breaks the law; empty if no step breaks it.
        cycle: the indices of the transitions from ``at`` that repeat for ever; empty if the run
            ends.
        robot: the robot whose program breaks the law; None if no single program breaks it.
    """

    law: str
    seen: str
    at: int
    group: tuple[int, ...] = ()
    cycle: tuple[int, ...] = ()
    robot: int | None = None


INDEX, BITS = 20, 12
"""The numbers of bits for the adversary's choice, and for a set of robots."""

MOST_ROBOTS = BITS
"""The largest number of robots in a search."""


class Graph:
    """The transitions of a search, each packed into 64 bits and named by its index.

    A transition leads from one configuration to another.  A configuration is a state of the world,
    with the minds of all robots.  In the methods ``number`` is the number of a configuration, and
    ``index`` the index of a transition.

    The transitions from one configuration are consecutive, in the order of the configurations.
    """

    def __init__(self) -> None:
        self._first, self._packed, self._discovered = array("q"), array("q"), array("q")

    def begin(self, number: int) -> None:
        """Begin the list of transitions from a configuration.

        The lists are begun in the ascending order of the configurations; a configuration that is
        skipped has no transitions.
        """
        while len(self._first) <= number:
            self._first.append(len(self._packed))

    def add(self, target: int, bits: int, *, has_action: bool) -> None:
        """Add a transition that leads to the configuration ``target``.

        The transition begins at the configuration for which :meth:`begin` was called last.

        ``bits`` is the bit set of the activated robots; ``has_action`` says whether any of these
        robots acts in the world.
        """
        self._packed.append(target << BITS + 1 | bits << 1 | has_action)

    def discover(self, before: int, bits: int, adversary: int) -> None:
        """Add a new configuration, with the transition that has reached it.

        The arguments are the attributes of this :class:`Transition`.

        Raises:
            InputError: if the adversary has more choices than a search can store.
        """
        if adversary >> INDEX:
            raise InputError(f"a model has more than {1 << INDEX:,} states after one step")
        self._discovered.append(before << BITS + INDEX | bits << INDEX | adversary)

    def __len__(self) -> int:
        return len(self._packed)

    def transitions(self, number: int) -> range:
        """The indices of the transitions from a configuration."""
        first, after = self._first, number + 1
        return range(first[number], first[after] if after < len(first) else len(self._packed))

    def target(self, index: int) -> int:
        """The number of the configuration after a transition."""
        return self._packed[index] >> BITS + 1

    def targets(self, indices: Iterable[int]) -> list[int]:
        """The numbers of the configurations after some transitions."""
        packed = self._packed
        return [packed[index] >> BITS + 1 for index in indices]

    def bits(self, index: int) -> int:
        """The robots that are activated in a transition, as a bit set."""
        return self._packed[index] >> 1 & (1 << BITS) - 1

    def has_action(self, index: int) -> bool:
        """Whether a robot acts in the world in a transition."""
        return bool(self._packed[index] & 1)

    def without_action(self, number: int) -> list[int]:
        """The transitions from a configuration, except those in which a robot acts.

        The transitions are given by their indices.
        """
        return [index for index in self.transitions(number) if not self.has_action(index)]

    def discovery(self, number: int) -> Transition:
        """The transition by which a configuration was reached first."""
        packed = self._discovered[number]
        bits = packed >> INDEX & (1 << BITS) - 1
        return Transition(packed >> BITS + INDEX, bits, packed & (1 << INDEX) - 1)

    def transition(self, number: int, index: int) -> Transition:
        """The transition with this index, from the configuration with this number."""
        bits = self.bits(index)
        alike = [each for each in self.transitions(number) if self.bits(each) == bits]
        return Transition(number, bits, alike.index(index))
