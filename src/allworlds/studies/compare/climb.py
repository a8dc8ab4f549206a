"""Explorers are run in larger and larger worlds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from allworlds.engines import CostTally, GivenWorlds, Limits, Listener, key_of, workers_for
from allworlds.inputs import InputError, an_integer, show
from allworlds.judging import Finding, Rules
from allworlds.maps import CombinatorialMap, Extent, MapClass
from allworlds.studies.check import Completed, Stopped, ending_of
from allworlds.studies.compare.contestants import Contestant
from allworlds.studies.compare.growing_families import LEAST, Member, members_of
from allworlds.studies.compare.growth import GrowRow, Growth
from allworlds.world import World

WORLDS, SEED = 3, 1
"""What is taken where nothing is said: members of a size, and a seed."""


def growth_of(
    contestants: Sequence[Contestant],
    families: Sequence[str],
    numbers: Mapping[str, int],
    limits: Limits,
    listener: Listener,
) -> Growth:
    """Run explorers in larger and larger worlds, judge every run, and fit how the cost grows.

    Args:
        contestants: the explorers.
        families: names of :data:`~allworlds.studies.compare.growing_families.GROWING`, with a
            degree where they have one: ``regular:6``.
        numbers: ``to``, the largest number of edges; ``worlds``, how many members of each size;
            ``seed``, of the first of them: the others have the next ones.
        limits: of the effort.
        listener: is told of the progress.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: that of the walks, which grow with the square of the edges and more.
    """
    for option, least in (("to", LEAST), ("worlds", 1), ("seed", 0)):
        if an_integer(option, numbers[option]) < least:
            raise InputError(f"{option} = {show(numbers[option])} is less than {least}")
    ladders = {family: members_of(family, **numbers) for family in dict.fromkeys(families)}
    return Climb(contestants, ladders, limits, listener).growth()


@dataclass(slots=True)
class Climb:
    """Explorers on their way through worlds that grow, family by family.

    Attributes:
        contestants: who walks.
        ladders: of each family the worlds of each size, ascending.
        limits: of the effort.
        listener: is told of the progress.
        rows: of finished families.
        findings: the smallest of each explorer in each family.
        left_out: members in which a lighthouse has no place.
    """

    contestants: Sequence[Contestant]
    ladders: Mapping[str, list[list[Member]]]
    limits: Limits
    listener: Listener
    rows: list[GrowRow] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    left_out: int = 0

    def growth(self) -> Growth:
        """What it has cost, as far as it has come."""
        ending = ending_of(self._run, self.limits)
        return Growth(
            complete=isinstance(ending, Completed),
            explorers=tuple(one.name for one in self.contestants),
            families=tuple(self.ladders),
            rows=tuple(self.rows),
            left_out=self.left_out,
            stopped=ending.reason if isinstance(ending, Stopped) else None,
            findings=tuple(self.findings),
        )

    def _run(self) -> None:
        deadline = self.limits.deadline()
        for family, ladder in self.ladders.items():
            maps = {member: member.map() for size in ladder for member in size}
            found: dict[tuple[int, str], GrowRow] = {}
            for one in self.contestants:
                self.listener.level(max(m.edge_count for m in maps.values()), len(maps))
                tally = self._costs(one, maps, deadline)
                for i, size in enumerate(ladder):
                    for row in self._rows(family, one, size, maps, tally):
                        found[i, one.name] = row
            names = [one.name for one in self.contestants]
            self.rows += (
                found[i, name] for i in range(len(ladder)) for name in names if (i, name) in found
            )

    def _costs(
        self, one: Contestant, maps: Mapping[Member, CombinatorialMap], deadline: float | None
    ) -> CostTally:
        extent = Extent(MapClass.MAPS, max(map_.edge_count for map_ in maps.values()))
        with workers_for(one.subject, self.limits, deadline) as transport:
            units = list(_units(one.rules, maps))
            self.left_out += len(maps) - len(units)
            # The largest take the longest: who begins with them waits least for the last.
            tally = one.costs(extent, units[::-1], transport, self.listener)
        self.findings += one.confirmed(tally, self.limits)
        return tally

    @staticmethod
    def _rows(
        family: str,
        one: Contestant,
        size: Sequence[Member],
        maps: Mapping[Member, CombinatorialMap],
        tally: CostTally,
    ) -> Iterator[GrowRow]:
        """The row of a size, if there is a member in which the lighthouse has a place."""
        placed = [member for member in size if (key_of(maps[member]), 0) in tally.costs]
        if placed:
            first = maps[placed[0]]
            bounds = [one.rules.the_bound.of(maps[member], 0) for member in placed]
            costs = (tally.costs[key_of(maps[member]), 0] for member in placed)
            yield GrowRow(
                family=family,
                edges=first.edge_count,
                vertices=first.vertex_count,
                explorer=one.name,
                bound=max((bound for bound in bounds if bound is not None), default=None),
                members=tuple(member.name for member in placed),
                costs=tuple(cost.most_expensive for cost in costs),
            )


def _units(rules: Rules, maps: Mapping[Member, CombinatorialMap]) -> Iterator[GivenWorlds]:
    """A unit for each world, with the first place of the lighthouse."""
    for member, map_ in maps.items():
        lighthouse = next(iter(rules.kind.places(map_, 0)), None)
        if lighthouse is not None:
            yield GivenWorlds(((World(map_, lighthouse, 0), 0),), member.name)
