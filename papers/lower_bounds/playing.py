"""Explorers of this folder by their names, and one run of an explorer, played by hand."""

from __future__ import annotations

from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any, NamedTuple, Protocol

import explorers
from allworlds import Checkpoint, Estimate, Move, Percept, run

HERE = Path(__file__).parent
OURS = {"remembering", "greedy", "prudent"}
"""The explorers of this folder; other names are those of built-in ones."""

Explorer = Callable[[Percept], Generator[Any, Any, Any]]


def named(name: str) -> str:
    """The name by which ``allworlds`` finds an explorer."""
    return f"{HERE / 'explorers.py'}:{name}" if name in OURS else name


def run_here(name: str, world: Any) -> Any:
    """The judged run of an explorer in a world, in this process."""
    if name not in OURS:
        return run(name, world)
    explore = getattr(explorers, name)

    def closure(first: Percept) -> Generator[Any, Any, Estimate]:
        return (yield from explore(first))

    return run(closure, world)


class Environment(Protocol):
    """A world, or an adversary, as an explorer meets it."""

    initial: Any
    first: Percept

    def step(self, state: Any, action: Move) -> tuple[Any, Percept]:
        """The state and the percept after a motion."""


class Played(NamedTuple):
    """A run without a judge: the motions, modulo the degree, and what the explorer returned."""

    actions: tuple[Move, ...]
    answer: Estimate


def played(
    explore: Explorer, world: Environment, watch: Callable[[Checkpoint], object] = lambda _: None
) -> Played:
    """Send an explorer's generator what it senses, until it returns.

    Args:
        explore: the generator function.
        world: is asked for each percept.
        watch: sees each checkpoint when it is published.
    """
    state, actions = world.initial, list[Move]()
    exploring, seen, at = explore(world.first), None, world.first
    while True:
        try:
            said = exploring.send(seen)
        except StopIteration as end:
            return Played(tuple(actions), end.value)
        seen = None
        if isinstance(said, Checkpoint):
            watch(said)
        else:
            actions.append(Move(said.k % at.degree))
            state, at = world.step(state, said)
            seen = at
