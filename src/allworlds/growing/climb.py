"""Explorers are run in larger and larger worlds."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Unpack

from allworlds.checker import ManyRunsOptions, ending_of, refuse_others
from allworlds.contestants import Contestant, contestants_of
from allworlds.findings import Finding, Rules
from allworlds.growing.growth import GrowRow, Growth
from allworlds.growing.ladder import FORMS, LEAST, Member, members_of
from allworlds.inputs import InputError, an_integer, show
from allworlds.isolation import workers_for
from allworlds.maps.classes import Extent, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.progress import Listener, Silent
from allworlds.runs import CostTally, GivenWorlds, key_of
from allworlds.work import Limits
from allworlds.world import World

TO, WORLDS, SEED = 400, 3, 1
"""What is taken where nothing is said: the largest number of edges, members of a size, a seed."""


def grow(
    *explorers: str | Callable[..., object],
    families: Iterable[str],
    to: int = TO,
    worlds: int = WORLDS,
    seed: int = SEED,
    listener: Listener | None = None,
    **options: Unpack[ManyRunsOptions],
) -> Growth:
    """Run explorers in larger and larger worlds, judge every run, and fit how the cost grows.

    Args:
        explorers: names (see :func:`allworlds.subjects.load`) or generator functions.
        families: names of :data:`GROWING`, with a degree where they have one: ``regular:6``.
        to: the largest number of edges.
        worlds: how many members of each size.
        seed: of the first of them; the others have the next ones.
        listener: is told of the progress.
        options: how runs are judged, and the effort; a class of maps has no meaning here.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: that of the walks, which grow with the square of the edges and more.
    """
    refuse_others("grow", options, ManyRunsOptions)
    limits = Limits.of(options)
    contestants = contestants_of(explorers, limits, options)
    if not contestants:
        raise InputError("grow takes an explorer at least")
    asked = tuple(dict.fromkeys(families))
    if not asked:
        raise InputError(f"grow takes a family at least: {FORMS}")
    numbers = {"to": to, "worlds": worlds, "seed": seed}
    for option, least in (("to", LEAST), ("worlds", 1), ("seed", 0)):
        if an_integer(option, numbers[option]) < least:
            raise InputError(f"{option} = {show(numbers[option])} is less than {least}")
    ladders = {family: members_of(family, to, worlds, seed) for family in asked}
    climb = Climb(contestants, ladders, limits, listener or Silent())
    return climb.growth()


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
            tuple(one.name for one in self.contestants),
            tuple(self.ladders),
            tuple(self.rows),
            tuple(self.findings),
            ending,
            self.left_out,
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
        lit = [member for member in size if (key_of(maps[member]), 0) in tally.costs]
        if lit:
            first = maps[lit[0]]
            yield GrowRow(
                family,
                first.edge_count,
                first.vertex_count,
                one.name,
                tuple(member.name for member in lit),
                tuple(tally.costs[key_of(maps[member]), 0].dearest for member in lit),
                max(
                    (b for b in (one.rules.the_bound.of(maps[m], 0) for m in lit) if b is not None),
                    default=None,
                ),
            )


def _units(rules: Rules, maps: Mapping[Member, CombinatorialMap]) -> Iterator[GivenWorlds]:
    """A unit for each world, with the first place of the lighthouse."""
    for member, map_ in maps.items():
        lighthouse = next(iter(rules.kind.places(map_, 0)), None)
        if lighthouse is not None:
            yield GivenWorlds(((World(map_, lighthouse, 0), 0),), member.name)
