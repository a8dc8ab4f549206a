"""What is to be checked: every option that the counts and the verdict depend on."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import Any, Literal, Protocol, TypeAlias

from allworlds.episode import default_step_budget
from allworlds.errors import InputError
from allworlds.judge import LAWS, Bound, bound_named, paper_bound
from allworlds.maps.classes import Bounds, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.enumeration import prefixes, rooted_maps
from allworlds.protocol import Choices, Schedules, policy_named
from allworlds.world import Lighthouse, World, lighthouse_named

Schedule: TypeAlias = Literal["one", "all"]
Shard: TypeAlias = tuple[int, int]

DEFAULT_EDGES = 5


class ScopeError(InputError):
    """Options that do not go together, or an option out of its range."""


@dataclass(frozen=True)
class Rules:
    """How one run is played and judged, whatever the world.

    Attributes:
        lighthouse: the kind of lighthouse.
        policy: answers the explorer's choices.
        bound: as named; ``""`` takes the lighthouse's own.
        laws: those of :data:`allworlds.judge.LAWS` that are checked; empty takes all that
            apply.
        step_budget: the largest legal number of traversals; None takes 8 x ((1)+(2)) + 100.
        folds: folding is a law in this universe (a promise such as planarity can make an
            explorer right without it).
    """

    lighthouse: str = "directional"
    policy: str = "fifo"
    bound: str = ""
    laws: tuple[str, ...] = ()
    step_budget: int | None = None
    folds: bool = True

    def __post_init__(self) -> None:
        lighthouse_named(self.lighthouse)
        policy_named(self.policy)
        bound_named(self.bound or "none")
        for law in self.laws:
            if law not in LAWS:
                raise ScopeError(f"law {law!r} is none of {', '.join(LAWS)}")
        if "folding" in self.laws and not (self.folds and self.kind.folds):
            raise ScopeError(
                "law 'folding' holds only under the directional lighthouse in the classes maps "
                "and simple: a promise can make an explorer right without it"
            )
        if self.step_budget is not None and self.step_budget < 1:
            raise ScopeError(f"step budget {self.step_budget} is not positive")

    @property
    def kind(self) -> type[Lighthouse]:
        """The kind of lighthouse as a type."""
        return lighthouse_named(self.lighthouse)

    @cached_property
    def the_bound(self) -> Bound:
        """The bound on traversals."""
        return bound_named(self.bound or self.kind.default_bound)

    @cached_property
    def applying(self) -> tuple[str, ...]:
        """The laws that are checked, in the order of precedence."""
        folds = self.folds and self.kind.folds
        chosen = self.laws or tuple(law for law in LAWS if law != "folding" or folds)
        return tuple(law for law in LAWS if law in chosen)

    def budget(self, map_: CombinatorialMap) -> int:
        """The largest legal number of traversals in a world."""
        if self.step_budget is not None:
            return self.step_budget
        return default_step_budget(paper_bound(map_.vertex_count, map_.edge_count))

    def choices(self, run: str, script: Sequence[int] = ()) -> Choices:
        """Fresh choices for the run of that name."""
        return Choices(policy_named(self.policy, run), script)

    def to_json(self) -> dict[str, Any]:
        """The options as they stand in a finding."""
        return {
            "policy": self.policy,
            "bound": self.the_bound.name,
            "step_budget": self.step_budget,
            "laws": list(self.applying),
        }

    @classmethod
    def from_json(cls, options: Mapping[str, Any], world: World) -> Rules:
        """The rules of a finding's options.

        Raises:
            InputError: naming the option that is none.
        """
        laws = options.get("laws", ())
        if not isinstance(laws, list | tuple) or not all(isinstance(law, str) for law in laws):
            raise ScopeError(f"options.laws must be a list of names, not {laws!r}")
        budget = options.get("step_budget")
        if budget is not None and (not isinstance(budget, int) or isinstance(budget, bool)):
            raise ScopeError(f"options.step_budget must be an integer or null, not {budget!r}")
        for key in ("policy", "bound"):
            if not isinstance(options.get(key, ""), str):
                raise ScopeError(f"options.{key} must be a text, not {options[key]!r}")
        return cls(
            lighthouse=world.lighthouse.kind,
            policy=options.get("policy", "fifo"),
            bound=options.get("bound", ""),
            laws=tuple(laws),
            step_budget=budget,
        )


@dataclass(frozen=True)
class Scope:
    """A class of worlds with its bounds, and the rules.

    Attributes:
        bounds: class and bounds.
        rules: how each run is played and judged.
        schedules: ``one`` (the policy's) or ``all`` (every sequence of choices).
        shard: ``(K, N)``: only every N-th unit of work, beginning with the K-th.
        sample: how the worlds were drawn, if they are only a sample of the class.
    """

    bounds: Bounds
    rules: Rules
    schedules: Schedule = "one"
    shard: Shard = (0, 1)
    sample: Mapping[str, int] | None = None

    def __post_init__(self) -> None:
        index, count = self.shard
        if count < 1 or not 0 <= index < count:
            raise ScopeError(
                f"shard {index}/{count} is out of range; K/N needs 0 <= K < N, counted from 0"
            )
        if self.schedules not in ("one", "all"):
            raise ScopeError(f"schedules {self.schedules!r} is none of one, all")

    def units(self, edges: int) -> Iterator[Unit]:
        """The pieces of a level that one worker does at a time; the same for any workers."""
        index, count = self.shard
        depth = 1 if edges < 4 else 3
        map_class, limit = self.bounds.map_class, self.bounds.vertices
        for i, prefix in enumerate(prefixes(edges, map_class, limit, depth)):
            if i % count == index:
                yield Unit(edges, prefix)

    def schedule(self, run: str) -> Iterator[Choices]:
        """Choices for each schedule of a run."""
        if self.schedules == "one":
            yield self.rules.choices(run)
        else:
            yield from Schedules()


Placed: TypeAlias = tuple[CombinatorialMap, list[tuple[int, Lighthouse]]]
"""A map rooted at dart 0, and the numbered places of its lighthouse that are to be tried."""


class Work(Protocol):
    """What one worker does at a time."""

    def placed(self, scope: Scope) -> Iterator[Placed]:
        """Every map with its places, in a fixed order."""


@dataclass(frozen=True, slots=True)
class Unit:
    """All maps of a level whose history begins with ``prefix``, with every place."""

    edges: int
    prefix: tuple[int, ...]

    def placed(self, scope: Scope) -> Iterator[Placed]:
        """The maps in the order of the enumeration."""
        kind, bounds = scope.rules.kind, scope.bounds
        for map_ in rooted_maps(self.edges, bounds.map_class, bounds.vertices, self.prefix):
            yield map_, list(enumerate(kind.places(map_, 0)))


@dataclass(frozen=True, slots=True)
class Picked:
    """Worlds that somebody has picked, each with its own place; their start is dart 0."""

    worlds: tuple[tuple[World, int], ...]

    def placed(self, scope: Scope) -> Iterator[Placed]:  # noqa: ARG002  # they are all there
        """The worlds as they are."""
        for world, place in self.worlds:
            yield world.map, [(place, world.lighthouse)]


@dataclass(frozen=True, slots=True)
class Limits:
    """What bounds the effort, and not the meaning, of a check.

    Attributes:
        workers: processes.
        answer_timeout: seconds of silence after which an explorer is killed.
        time_limit: seconds for everything, or None.
        memory: MB of address space of a worker, or None.
        max_findings: with so many findings in finished levels the check ends.

    Raises:
        ScopeError: for values that are not positive, and for infinite ones.
    """

    workers: int = 1
    answer_timeout: float = 10.0
    time_limit: float | None = None
    memory: int | None = None
    max_findings: int = 1

    def __post_init__(self) -> None:
        for name in ("workers", "answer_timeout", "time_limit", "memory", "max_findings"):
            value = getattr(self, name)
            if value is not None and not 0 < value < inf:
                raise ScopeError(f"{name.replace('_', '-')} {value} is not positive and finite")

    def deadline(self) -> float | None:
        """When the time is up, on the monotonic clock, if the check begins now."""
        return None if self.time_limit is None else time.monotonic() + self.time_limit


def make_scope(
    *,
    edges: int | None = None,
    vertices: int | None = None,
    map_class: str = "maps",
    schedules: str = "one",
    shard: Shard = (0, 1),
    **rules: Any,
) -> Scope:
    """The scope of the options of ``check``, with the default bound where none is named.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if map_class not in list(MapClass):
        raise ScopeError(f"class {map_class!r} is none of {', '.join(MapClass)}")
    if edges is None and vertices is None:
        edges = DEFAULT_EDGES
    chosen = MapClass(map_class)
    return Scope(
        Bounds(chosen, edges, vertices),
        Rules(**rules, folds=not chosen.planar),
        schedules,  # type: ignore[arg-type]  # validated there
        shard,
    )
