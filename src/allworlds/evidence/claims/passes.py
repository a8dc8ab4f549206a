"""Algorithm 1 pass by pass: the cost of each, and the bound that the paper gives.

The cost of a pass is taken from the log: the traversals between two checkpoints.  Walk and tests
are told apart by an Algorithm 1 whose own methods say where it is; what it walks is counted from
the outside.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from typing import Any

from msgspec import Struct, field
from typing_extensions import override

from allworlds.evidence.claims.claim_types import Unfinished
from allworlds.explorers import Algorithm1
from allworlds.judging import Answered, Episode, paper_bound, play
from allworlds.maps import cycles
from allworlds.protocol import Choices, Estimate, Move, Percept, Told, policy_named
from allworlds.world import World, worlds


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
        Unfinished: where the run has no answer, or shows no checkpoint for a pass.
    """
    met: list[Watched] = []

    def player(
        first: Percept,
        choices: Choices,
        told: Told,  # noqa: ARG001  # nothing is told under this lighthouse
    ) -> Generator[Any, Any, Estimate]:
        watched = Watched(first, choices)
        met.append(watched)
        return (yield from _counted(watched))

    budget = 8 * paper_bound(world.map.vertex_count, world.map.edge_count) + 100
    episode = play(world, player, Choices(policy_named(policy)), budget)
    if not isinstance(episode.ending, Answered):
        raise Unfinished(f"Algorithm 1 has no answer in {world}")
    return list(_passes(met[0], episode))


def _counted(watched: Watched) -> Generator[Any, Any, Estimate]:
    """The exploration, with its traversals counted."""
    exploring, seen = watched.explore(), None
    while True:
        try:
            said = exploring.send(seen)  # type: ignore[arg-type]  # None begins a generator
        except StopIteration as end:
            answer: Estimate = end.value
            return answer
        watched.steps += type(said) is Move
        seen = yield said


def _passes(watched: Watched, episode: Episode) -> Iterator[PassWalked]:
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
    return [min(cycle) for cycle in cycles(sigma)]


def pass_bound(edges: int, vertices: int, explored: int) -> int:
    """The bound on a pass with s vertices and p edges known: ``s + 2(s-1)(2m-2p)``."""
    return vertices + 2 * (vertices - 1) * (2 * edges - 2 * explored)


def every_run(edges: int, policies: list[str]) -> Iterator[tuple[World, list[PassWalked]]]:
    """The passes of every run under each policy."""
    for world in worlds(edges=edges, places="all"):
        for policy in policies:
            yield world, passes_of(world, policy)
