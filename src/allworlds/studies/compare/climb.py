"""Runs of explorers in larger and larger worlds."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from random import Random

from typing_extensions import override

from allworlds.engines import (
    CostTally,
    GivenWorlds,
    Shard,
    SweptLevel,
    dealt,
    key_of,
)
from allworlds.inputs import InputError, an_integer, show
from allworlds.maps import CombinatorialMap, Extent, MapClass, edges_of
from allworlds.outcome import Ending
from allworlds.studies.compare.compare_request import CompareRequest
from allworlds.studies.compare.contestants import Contest, Contestant
from allworlds.studies.compare.growing_families import FORMS, LEAST, Member, distinct, members_of
from allworlds.studies.compare.growth import GrownWorld, GrowRow, Growth
from allworlds.studies.compare.side_by_side import CostsOfAll, UnitOfOne
from allworlds.world import Lighthouse, World

WORLDS, PLACES, SEED = 10, 8, 1
"""Defaults: seeds of a size, places in a world, and the first seed."""


def growing(contestants: Sequence[Contestant], request: CompareRequest, to: int) -> GrowingWorlds:
    """Run explorers in larger and larger worlds: of each family some members of each size.

    Every run is judged, and how the cost grows is fitted.

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


def first_place(_: Member, __: int) -> Sequence[int]:
    """The number of the first place alone."""
    return (0,)


@dataclass(frozen=True, slots=True)
class _Size:
    """The members of a family of one size.

    Attributes:
        number: of the family.
        family: its name.
        seeds: the number of members that were drawn.
        maps: those of the different members that are walked in.
    """

    number: int
    family: str
    seeds: int
    maps: Mapping[Member, CombinatorialMap]


class GrowingWorlds(Contest[Growth]):
    """The sweep of explorers through growing worlds, family by family and size by size.

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
        self._sizes = [
            _Size(number, family, len(members), distinct(members))
            for number, (family, ladder) in enumerate(ladders.items())
            for members in ladder
        ]
        edges = [edges_of(member.text) for size in self._sizes for member in size.maps]
        super().__init__(contestants, request, Extent(MapClass.MAPS, max(edges)))
        self._mine = set(range(len(edges)))
        if isinstance(self.portion, Shard):
            self._mine = set(dealt([m * m for m in edges], self.portion))
        self._rows: list[GrowRow] = []
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
        for number, one in enumerate(self.contestants):
            self._rows += self._row(one, level.of, total.one(number))
        self.leave(level, total)

    @override
    def report(self, ending: Ending) -> Growth:
        return Growth(
            **self.contest(ending),
            families=self._families,
            rows=tuple(self._rows),
            left_out=self._left_out,
        )

    def _row(self, one: Contestant, size: _Size, tally: CostTally) -> Iterator[GrowRow]:
        """The row of a size, if the lighthouse has a place in one of its members."""
        members = []
        for member, map_ in size.maps.items():
            places, ran = self._chosen(one, member, map_)
            if not ran:
                self._left_out += 1
                continue
            costs = [tally.costs[key_of(map_), i].most_expensive for i, _ in ran]
            bound = one.rules.the_bound.of(map_, 0)
            members.append(
                GrownWorld(
                    name=member.name,
                    edges=map_.edge_count,
                    places=places,
                    ran=tuple(i for i, _ in ran),
                    costs=tuple(costs),
                    bound=bound,
                )
            )
        if members:
            first = next(map_ for m, map_ in size.maps.items() if m.name == members[0].name)
            yield GrowRow(
                family=size.family,
                edges=first.edge_count,
                vertices=first.vertex_count,
                explorer=one.name,
                seeds=size.seeds,
                members=tuple(members),
            )
