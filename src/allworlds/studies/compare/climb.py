"""Runs of explorers in larger and larger worlds."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from random import Random
from typing import Self

from msgspec import Struct
from typing_extensions import override

from allworlds.document.struct import replace
from allworlds.engines.scope import GivenWorlds
from allworlds.engines.units import Shard, SweptLevel, dealt
from allworlds.inputs.checks import InputError, an_integer, show
from allworlds.maps.classes import Extent, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.families import edges_of, rootings
from allworlds.outcome import Ending
from allworlds.studies.compare.compare_request import CompareRequest
from allworlds.studies.compare.contestants import (
    Contest,
    Contestant,
    CostsOfAll,
    CostTally,
    UnitOfOne,
    key_of,
)
from allworlds.studies.compare.growing_families import FORMS, LEAST, Member, distinct, members_of
from allworlds.studies.compare.growth import GrownWorld, GrowRow, Growth
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.world import World

WORLDS, PLACES, SEED = 10, 8, 1
"""Defaults: seeds of a size, places in a world, and the first seed."""


def growing(contestants: Sequence[Contestant], request: CompareRequest, to: int) -> GrowingWorlds:
    """Run explorers in larger and larger worlds: of each family some members of each size.

    Every run is judged.

    Args:
        contestants: the explorers.
        request: for families of :data:`~allworlds.studies.compare.growing_families.GROWING`, with
            a degree where they have one: ``regular:6``.
        to: the largest number of edges.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: that of the walks, which grow with the square of the edges and more.
    """
    for name in ("edges", "vertices", "holes"):
        if (given := getattr(request, name)) is not None:
            raise InputError(f"{name} = {show(given)} has no effect on worlds that grow")
    if request.where is not None:
        raise InputError(f"where {show(request.where.name)} has no effect on worlds that grow")
    if request.map_class is not MapClass.MAPS:
        raise InputError(f"class {show(request.map_class.value)} has no effect on worlds that grow")
    if not contestants:
        raise InputError("compare with to takes an explorer at least, not none")
    if not request.family:
        raise InputError(f"compare with to takes a family at least: {FORMS}")
    usual = {"worlds": WORLDS, "seed": SEED, "places": PLACES}
    numbers = {"to": to} | {
        name: default if (given := getattr(request, name)) is None else given
        for name, default in usual.items()
    }
    for option, least in (("to", LEAST), ("worlds", 1), ("places", 1), ("seed", 0)):
        if an_integer(option, numbers[option]) < least:
            raise InputError(f"{option} = {show(numbers[option])} is less than {least}")
    request, places = replace(request, **numbers), numbers.pop("places")
    ladders = {family: members_of(family, **numbers) for family in request.family or ()}
    return GrowingWorlds(contestants, ladders, request, partial(drawn_places, most=places))


def drawn_places(member: Member, places: int, most: int) -> Sequence[int]:
    """The numbers of all places, or of that many of them, drawn by the name of the world."""
    if places <= most:
        return range(places)
    return sorted(Random(f"places/{member.name}").sample(range(places), most))  # noqa: S311  # reproducible, not secret


class _Size(Struct, frozen=True):
    """The members of a family of one size.

    Attributes:
        number: of the family.
        family: its name.
        seeds: the number of members that were drawn.
        maps: those of the different members that are walked in.
        drawn_from: the number of different members that seeds draw; None if it is not known.
    """

    number: int
    family: str
    seeds: int
    maps: Mapping[Member, CombinatorialMap]
    drawn_from: int | None

    @classmethod
    def of(cls, number: int, family: str, members: Sequence[Member]) -> Self:
        """The size with these members."""
        member, map_ = next(iter((maps := distinct(members)).items()))
        drawn_from = rootings(member.text, map_, member.holes)
        return cls(number, family, len(members), maps, drawn_from)

    @property
    def edges(self) -> int:
        """The edges of a member before holes are made."""
        return edges_of(next(iter(self.maps)).text)


class GrowingWorlds(Contest[Growth]):
    """The sweep of explorers through growing worlds, from the smallest size of any family on.

    So what is finished when the time is up is a part of each family.

    Args:
        contestants: who walks.
        ladders: of each family the worlds of each size, ascending.
        request: for the effort.
        choose: the numbers of the places that are run, ascending, from the world and how many
            places it has.
    """

    def __init__(
        self,
        contestants: Sequence[Contestant],
        ladders: Mapping[str, list[list[Member]]],
        request: CompareRequest,
        choose: Callable[[Member, int], Sequence[int]],
    ) -> None:
        self._families, self._choose = tuple(ladders), choose
        sizes = [
            _Size.of(number, family, members)
            for number, (family, ladder) in enumerate(ladders.items())
            for members in ladder
        ]
        self._sizes = sorted(sizes, key=lambda size: size.edges)
        edges = [edges_of(member.text) for size in self._sizes for member in size.maps]
        super().__init__(contestants, request, Extent(MapClass.MAPS, max(edges)))
        self._mine = set(range(len(edges)))
        if isinstance(self.portion, Shard):
            self._mine = set(dealt([m * m for m in edges], self.portion))
        self._rows: list[GrowRow] = []
        self._begun: list[GrowRow] = []
        self._left_out = 0

    @override
    def levels(self) -> Iterator[SweptLevel]:
        number = 0
        for size in self._sizes:
            numbered = enumerate(size.maps.items(), number)
            mine = replace(size, maps=dict(one for n, one in numbered if n in self._mine))
            number += len(size.maps)
            edges = max((m.edge_count for m in mine.maps.values()), default=1)
            runs = sum(unit.runs for unit in self._units(size))
            yield SweptLevel(edges, runs, self._units(mine), mine)

    def _units(self, size: _Size) -> Iterator[UnitOfOne]:
        """A unit for each contestant and world, with the places of the lighthouse that are run."""
        for number, one in enumerate(self.contestants):
            for member, map_ in size.maps.items():
                _, ran = self._chosen(one, member, map_)
                if ran:
                    given = tuple((World(map_, lighthouse, 0), i) for i, lighthouse in ran)
                    unit = GivenWorlds(given, f"{size.family}/{member.name}")
                    yield UnitOfOne(number, unit)

    def _chosen(
        self, one: Contestant, member: Member, map_: CombinatorialMap
    ) -> tuple[int, list[tuple[int, Lighthouse]]]:
        """The number of places of a lighthouse in a world, and those that are run, numbered."""
        places = list(one.rules.kind.places(map_, 0))
        ran = self._choose(member, len(places)) if places else ()
        return len(places), [(i, places[i]) for i in ran]

    @override
    def group(self, level: SweptLevel) -> int:
        """The number of the family to which a level belongs."""
        size: _Size = level.of
        return size.number

    @override
    def finish(self, level: SweptLevel, total: CostsOfAll) -> None:
        self._rows += self._rows_of(level.of, total)
        for one in self.contestants:
            chosen = (self._chosen(one, *member) for member in level.of.maps.items())
            self._left_out += sum(not ran for _, ran in chosen)
        super().leave(level, total)

    @override
    def leave(self, level: SweptLevel, total: CostsOfAll) -> None:
        self._begun += self._rows_of(level.of, total)
        super().leave(level, total)

    @override
    def report(self, ending: Ending) -> Growth:
        return Growth(
            **self.contest(ending),
            families=self._families,
            rows=tuple(sorted(self._rows, key=lambda row: self._families.index(row.family))),
            begun=tuple(self._begun),
            left_out=self._left_out,
        )

    def _rows_of(self, size: _Size, total: CostsOfAll) -> Iterator[GrowRow]:
        """The row of each contestant that was run in every chosen place of one of the members."""
        for number, one in enumerate(self.contestants):
            members = [*self._members(one, size, total.one(number))]
            if members:
                all_run = len(size.maps) == size.drawn_from
                first = next(map_ for m, map_ in size.maps.items() if m.name == members[0].name)
                yield GrowRow(
                    family=size.family,
                    edges=first.edge_count,
                    vertices=first.vertex_count,
                    explorer=one.name,
                    seeds=size.seeds,
                    drawn_from=size.drawn_from,
                    exact=all_run and all(len(m.ran) == m.places for m in members),
                    members=tuple(members),
                )

    def _members(self, one: Contestant, size: _Size, tally: CostTally) -> Iterator[GrownWorld]:
        """The members of a size in which the contestant was run in every chosen place."""
        for member, map_ in size.maps.items():
            places, ran = self._chosen(one, member, map_)
            costs = [tally.costs.get((key_of(map_), i)) for i, _ in ran]
            known = [cost for cost in costs if cost is not None]
            if ran and len(known) == len(ran):
                yield GrownWorld(
                    name=member.name,
                    edges=map_.edge_count,
                    places=places,
                    ran=tuple(i for i, _ in ran),
                    costs=tuple(known),
                    bound=one.rules.the_bound.of(map_, 0),
                )
