"""Algorithm 1 pass by pass: the cost of each, and the bound that the paper gives.

The cost of a pass is taken from the log: the traversals between two checkpoints.  Walk and tests
are told apart by an Algorithm 1 whose own methods say where it is; what it walks is counted from
the outside.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence, Sized
from typing import Any, NamedTuple

from msgspec import Struct, field
from typing_extensions import override

from allworlds import Checkpoint, Choices, Estimate, Percept, World, worlds
from allworlds.claims import Algorithm1, Unfinished
from formulas import paper_bound


class PassWalked(Struct, frozen=True):
    """One pass through the loop.

    Attributes:
        vertices, explored: n_s and the edges of S when it begins.
        cost: traversals, according to the log.
        walk: to the unknown end of the dart.
        tests: the traversals of each test, retracing included.
        hypotheses: how many there were.
        found: whether it has found a vertex.
    """

    vertices: int
    explored: int
    cost: int
    walk: int
    tests: tuple[int, ...]
    hypotheses: int
    found: bool


class _BegunPass(Struct):
    vertices: int
    explored: int
    at: int
    walked: int = 0
    hypotheses: int = 0
    tests: list[int] = field(default_factory=list)


class _Policy:
    """First in, first out: the first option of every kind."""

    def choose(self, kind: str, options: Sized, cost: Sequence[int] | None) -> int:
        """Return the index of the option."""
        return self.edge(len(options), cost or ()) if kind == "edge" else 0

    def edge(self, _count: int, _cost: Sequence[int]) -> int:
        """Return the index of the dart that leaves U."""
        return 0


class _Lifo(_Policy):
    def edge(self, count: int, _cost: Sequence[int]) -> int:
        return count - 1


class _Nearest(_Policy):
    def edge(self, _count: int, cost: Sequence[int]) -> int:
        return min(range(len(cost)), key=cost.__getitem__, default=0)


class _Last(_Policy):
    """The last option of every kind: in a test a longest path."""

    def choose(self, kind: str, options: Sized, cost: Sequence[int] | None) -> int:  # noqa: ARG002
        return len(options) - 1


POLICIES = {"fifo": _Policy, "lifo": _Lifo, "nearest": _Nearest, "last": _Last}
"""Which dart leaves U next; ``last`` answers the other choices, too."""


class Played(NamedTuple):
    """A run without a judge.

    Attributes:
        checkpoints: each with the traversals before it.
        cost: traversals.
        answer: of the explorer.
    """

    checkpoints: list[tuple[int, Checkpoint]]
    cost: int
    answer: Estimate


class Watched(Algorithm1):
    """Algorithm 1 that notes when a pass, its tests and its augmentation begin."""

    def __init__(self, first: Percept, choices: Choices) -> None:
        super().__init__(first, choices)
        self.steps = 0
        self.begun: list[_BegunPass] = []

    @override
    def take_from_u(self) -> int:
        s = self.s
        explored = (len(s.alpha) - len(s.unexplored)) // 2
        self.begun.append(_BegunPass(len(s.first), explored, self.steps))
        return super().take_from_u()

    @override
    def hypotheses(self, goal: int, percept: Percept) -> list[int]:
        told = super().hypotheses(goal, percept)
        self.begun[-1].walked, self.begun[-1].hypotheses = self.steps, len(told)
        return told

    @override
    def path_to_v0(self, partner: int) -> list[int]:
        self.begun[-1].tests.append(self.steps)
        return super().path_to_v0(partner)


def passes_of(world: World, policy: str = "fifo") -> list[PassWalked]:
    """The passes of Algorithm 1 in a world, in their order.

    Raises:
        Unfinished: where the run does not end, or shows no checkpoint for a pass.
    """
    watched = Watched(world.first, Choices(POLICIES[policy]()))
    met = played(watched.explore(), world, watched)
    return list(_passes(watched, met))


def played(
    exploring: Generator[Any, Any, Estimate], world: World, watched: Watched | None = None
) -> Played:
    """A run without a judge: each checkpoint with the traversals before it, and how many in all.

    Raises:
        Unfinished: where it takes more than eight times the bound.
    """
    state, seen, cost = world.initial, None, 0
    most = 8 * paper_bound(world.map.vertex_count, world.map.edge_count) + 100
    shown: list[tuple[int, Checkpoint]] = []
    while True:
        try:
            said = exploring.send(seen)
        except StopIteration as end:
            return Played(shown, cost, end.value)
        seen = None
        if isinstance(said, Checkpoint):
            shown.append((cost, said))
            continue
        cost += 1
        if cost > most:
            raise Unfinished(f"Algorithm 1 has no answer after {most} traversals")
        if watched is not None:
            watched.steps = cost
        state, seen = world.step(state, said)


def _passes(watched: Watched, episode: Played) -> Iterator[PassWalked]:
    """Passes, each with the traversals between the checkpoints before and after it."""
    if len(watched.begun) != len(episode.checkpoints):
        raise Unfinished("Algorithm 1 has not shown its map after each pass")
    before, known = 0, 1
    for begun, (steps, shown) in zip(watched.begun, episode.checkpoints, strict=True):
        ends = [*begun.tests[1:], steps] if begun.tests else []
        vertices = len(_vertices(shown.sigma))
        tests = tuple(end - start for start, end in zip(begun.tests, ends, strict=True))
        walk = begun.walked - begun.at
        if walk + sum(tests) != steps - before:
            raise Unfinished("a pass is not its walk and its tests")
        yield PassWalked(
            begun.vertices,
            begun.explored,
            steps - before,
            walk,
            tests,
            begun.hypotheses,
            vertices > known,
        )
        before, known = steps, vertices


def _vertices(sigma: Sequence[int]) -> list[int]:
    """One dart of each cycle of sigma."""
    least, seen = [], set[int]()
    for first in range(len(sigma)):
        if first not in seen:
            least.append(first)
        dart = first
        while dart not in seen:
            seen.add(dart)
            dart = sigma[dart]
    return least


def pass_bound(edges: int, vertices: int, explored: int) -> int:
    """The bound on a pass with s vertices and p edges known: ``s + 2(s-1)(2m-2p)``."""
    return vertices + 2 * (vertices - 1) * (2 * edges - 2 * explored)


def every_run(edges: int, policies: list[str]) -> Iterator[tuple[World, list[PassWalked]]]:
    """The passes of every run under each policy."""
    for world in worlds(edges=edges, places="all"):
        for policy in policies:
            yield world, passes_of(world, policy)
