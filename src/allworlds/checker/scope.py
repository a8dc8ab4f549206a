"""What is to be checked: every option that the counts and the verdict depend on."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import Any, Literal, Protocol, TypeAlias

from allworlds.episode import default_step_budget
from allworlds.errors import InputError, a_text, an_integer, show
from allworlds.judge import LAWS, Bound, bound_named, paper_bound
from allworlds.maps.classes import Bounds, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.enumeration import prefixes, rooted_maps
from allworlds.protocol import Choices, Schedules, policy_named
from allworlds.world import Lighthouse, World, lighthouse_named

Schedule: TypeAlias = Literal["one", "all"]
Shard: TypeAlias = tuple[int, int]

DEFAULT_EDGES = 5

LEAST_TIMEOUT = 0.1
"""Seconds; explorers are not looked at more often."""


class ScopeError(InputError):
    """Options that do not go together, or an option out of its range."""


@dataclass(frozen=True)
class Rules:
    """How one run is played and judged, whatever the world.

    Attributes:
        lighthouse: the kind of lighthouse.
        policy: answers the explorer's choices.
        bound: as named; None takes the explorer's own, else the lighthouse's.
        laws: those of :data:`allworlds.judge.LAWS` that are checked; None takes all that
            apply.
        step_budget: the largest legal number of traversals; None takes 8 x ((1)+(2)) + 100.
        folds: folding is a law in this universe (a promise such as planarity can make an
            explorer right without it).
        own_bound: the bound that the explorer brings for this lighthouse; None if it has none.
    """

    lighthouse: str = "directional"
    policy: str = "fifo"
    bound: str | None = None
    laws: tuple[str, ...] | None = None
    step_budget: int | None = None
    folds: bool = True
    own_bound: str | None = None

    def __post_init__(self) -> None:
        lighthouse_named(a_text("lighthouse", self.lighthouse))
        policy_named(a_text("policy", self.policy))
        bound_named("none" if self.bound is None else a_text("bound", self.bound))
        for law in self.laws or ():
            if law not in list(LAWS):  # a key would have to be hashable
                raise ScopeError(f"law {show(law)} is none of {', '.join(LAWS)}")
        if self.laws == ():
            raise ScopeError(f"laws = () names no law; legal are {', '.join(LAWS)}")
        if "folding" in (self.laws or ()) and not (self.folds and self.kind.folds):
            raise ScopeError(
                "law 'folding' holds only under the directional lighthouse in the classes maps "
                "and simple: a promise can make an explorer right without it"
            )
        self._refuse_bounds_without_effect()
        if self.step_budget is not None and an_integer("step_budget", self.step_budget) < 1:
            raise ScopeError(f"step budget {self.step_budget} is not positive")

    def _refuse_bounds_without_effect(self) -> None:
        laws = self.laws
        if laws and "bound" not in laws and self.bound not in (None, "none", self.default_bound):
            raise ScopeError(
                f"bound {show(self.bound)} has no effect without the law 'bound'; the laws are "
                f"{', '.join(laws)}"
            )
        if laws and "bound" in laws and self._named_bound.name == "none":
            raise ScopeError("law 'bound' has no effect where the bound is none; name a bound too")

    @property
    def kind(self) -> type[Lighthouse]:
        """The kind of lighthouse as a type."""
        return lighthouse_named(self.lighthouse)

    @cached_property
    def the_bound(self) -> Bound:
        """The bound on traversals; none where that law is not checked."""
        return self._named_bound if "bound" in self.applying else bound_named("none")

    @property
    def _named_bound(self) -> Bound:
        return bound_named(self.default_bound if self.bound is None else self.bound)

    @property
    def default_bound(self) -> str:
        """The bound where none is named."""
        return self.own_bound or self.kind.default_bound

    @cached_property
    def applying(self) -> tuple[str, ...]:
        """The laws that are checked, in the order of precedence."""
        if self.laws is not None:
            return tuple(law for law in LAWS if law in self.laws)
        idle = set() if self.folds and self.kind.folds else {"folding"}
        idle |= {"bound"} if self._named_bound.name == "none" else set()
        return tuple(law for law in LAWS if law not in idle)

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
    def from_json(
        cls, options: Mapping[str, Any], world: World, own_bound: str | None = None
    ) -> Rules:
        """The rules of a finding's options; its explorer may bring a bound of its own.

        A bound without its law, or the law without a bound, was not checked: it is left out.

        Raises:
            InputError: naming the option that is none.
        """
        laws = options.get("laws")
        if "laws" in options and (
            not isinstance(laws, list | tuple) or not all(isinstance(law, str) for law in laws)
        ):
            raise ScopeError(f"options.laws must be a list of names, not {show(laws)}")
        budget = options.get("step_budget")
        if budget is not None and (not isinstance(budget, int) or isinstance(budget, bool)):
            raise ScopeError(f"options.step_budget must be an integer or null, not {show(budget)}")
        for key in ("policy", "bound"):
            if not isinstance(options.get(key, ""), str):
                raise ScopeError(f"options.{key} must be a text, not {show(options[key])}")
        bound = options.get("bound")
        if laws is not None:
            default = own_bound or world.lighthouse.default_bound
            if (default if bound is None else bound) == "none":
                laws = [law for law in laws if law != "bound"]
            elif "bound" not in laws:
                bound = None
        return make_rules(
            lighthouse=world.lighthouse.kind,
            policy=options.get("policy", "fifo"),
            bound=bound,
            own_bound=own_bound,
            laws=laws,
            step_budget=budget,
        )


def make_rules(
    *, bound: str | int | None = None, laws: Iterable[str] | None = None, **others: Any
) -> Rules:
    """The rules of the options of ``check`` and ``run``.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if bound is not None and not isinstance(bound, str):
        bound = str(an_integer("bound", bound))
    if laws is not None:
        if isinstance(laws, str) or not isinstance(laws, Iterable):
            raise ScopeError(f"laws = {show(laws)} is not a list of names of {', '.join(LAWS)}")
        laws = tuple(laws)
        for law in laws:
            if laws.count(law) > 1:
                raise ScopeError(f"law {show(law)} is named twice")
    return Rules(bound=bound, laws=laws, **others)


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
        try:
            index, count = self.shard
        except (TypeError, ValueError):
            raise ScopeError(f"shard = {show(self.shard)} is not a pair (K, N)") from None
        index, count = an_integer("shard K", index), an_integer("shard N", count)
        object.__setattr__(self, "shard", (index, count))
        if count < 1 or not 0 <= index < count:
            raise ScopeError(
                f"shard {index}/{count} is out of range; K/N needs 0 <= K < N, counted from 0"
            )
        if self.schedules not in ("one", "all"):
            raise ScopeError(f"schedules {show(self.schedules)} is none of one, all")

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
        ScopeError: for values that are not positive, for infinite ones, and for a timeout that
            is too short to be kept.
    """

    workers: int = 1
    answer_timeout: float = 10.0
    time_limit: float | None = None
    memory: int | None = None
    max_findings: int = 1

    def __post_init__(self) -> None:
        for name in ("workers", "answer_timeout", "time_limit", "memory", "max_findings"):
            value, legal = getattr(self, name), name.replace("_", "-")
            if value is None and name in ("time_limit", "memory"):
                continue
            if not isinstance(value, int | float) or isinstance(value, bool):
                raise ScopeError(f"{legal} = {show(value)} is not a number")
            if not name.startswith(("answer", "time")):
                an_integer(legal, value)
            if not 0 < value < inf:
                raise ScopeError(f"{legal} {value} is not positive and finite")
        if self.answer_timeout < LEAST_TIMEOUT:
            raise ScopeError(
                f"answer-timeout {self.answer_timeout} s is shorter than silence is noticed; the "
                f"least is {LEAST_TIMEOUT} s"
            )

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
        raise ScopeError(f"class {show(map_class)} is none of {', '.join(MapClass)}")
    if edges is None and vertices is None:
        edges = DEFAULT_EDGES
    chosen = MapClass(map_class)
    return Scope(
        Bounds(chosen, edges, vertices),
        make_rules(**rules, folds=not chosen.planar),
        schedules,  # type: ignore[arg-type]  # validated there
        shard,
    )
