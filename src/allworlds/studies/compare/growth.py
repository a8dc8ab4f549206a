"""Explorers in worlds that grow: the families, the runs in some members, and the cost by size."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache
from math import fsum
from random import Random
from statistics import fmean, geometric_mean
from typing import Annotated, ClassVar, TypeAlias

from msgspec import Struct
from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.engines.units import GivenWorlds, SweptLevel, dealt
from allworlds.inputs.checks import InputError, an_integer, not_one_of, show
from allworlds.maps import classes, families
from allworlds.maps.combinatorial import Code, CombinatorialMap, rooted_code
from allworlds.studies.compare import entrants, intervals
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.named import map_of_family
from allworlds.world.world import World

WORLDS, PLACES, SEED = 30, 8, 1
"""The default number of seeds for each size and of places in each world, and the first seed."""

LEAST, SIZES = 12, 6
"""The least number of edges of a size, and the largest number of sizes."""

HOLES = "10%"
"""The share of edges that is removed from dense maps, so that a size has several members."""


class Growing(Struct, frozen=True):
    """A family of worlds that grow; its members are numbered by size.

    Attributes:
        form: the form of the family's name on the command line; ``:D`` stands for a degree.
        member: a function that makes the name of a member from its number and the degree.
        degree: the default degree; None if the name has no degree.
        holes: the share of edges that is removed, for example ``10%``; None: no edge is removed.
    """

    form: str
    member: Callable[[int, int], str]
    degree: int | None = None
    holes: str | None = None


GROWING = {
    growing.form.partition(":")[0]: growing
    for growing in (
        Growing("lattice", lambda p, _: f"lattice:{p + 1}x{p + 1}"),
        Growing("torus", lambda p, _: f"torus:{p}x{p}"),
        Growing("strip", lambda p, _: f"strip:{p}"),
        Growing("dense", lambda p, _: f"dense:{p + 1}", holes=HOLES),
        Growing("cubic", lambda p, _: f"cubic:{2 * p}"),
        Growing("regular:D", lambda p, d: f"regular:{d}x{p if d % 2 == 0 else 2 * p}", 6),
        Growing("random", lambda p, _: f"random:{p}x{2 * p}"),
        Growing("bouquet", lambda p, _: f"bouquet:{p}"),
        Growing("lollipop:D", lambda p, d: f"lollipop:{d}x{p}", 4),
        Growing("prism", lambda p, _: f"prism:{p + 2}"),
        Growing("thick:D", lambda p, d: f"thick:{d}x{p}", 6),
        Growing("cover", lambda p, _: f"cover:{p}"),
        Growing("corridor", lambda p, _: f"corridor:{p}"),
    )
}
"""Every family that grows, by its name."""

FORMS = ", ".join(growing.form for growing in GROWING.values())


class Member(Struct, frozen=True):
    """One world of a family.

    ``text`` is the family with a size, for example ``torus:6x6``; ``holes`` is the share of edges
    that is removed, for example ``10%``, or None; ``seed`` is the seed of random choices.
    """

    text: str
    holes: str | None
    seed: int

    @property
    def name(self) -> str:
        """The name of the world on the command line, for example ``torus:6x6 --seed 1``."""
        holes = f" --holes {self.holes}" if self.holes else ""
        return f"{self.text}{holes} --seed {self.seed}"

    def map(self) -> CombinatorialMap:
        """The map; a robot starts at dart 0."""
        return map_of_family(self.text, self.holes, self.seed)


def member_named(name: str) -> Member:
    """The member with this name; the name has the form of :attr:`Member.name`."""
    words, _, seed = name.partition(" --seed ")
    text, _, holes = words.partition(" --holes ")
    return Member(text, holes or None, int(seed))


def distinct(members: Iterable[Member]) -> dict[Member, CombinatorialMap]:
    """The different members, each with its map.

    Of several members with isomorphic rooted maps, only the first is returned.
    """
    seen: dict[Code, Member] = {}
    maps = {member: member.map() for member in members}
    for member, map_ in maps.items():
        seen.setdefault(rooted_code(map_.sigma, map_.alpha, 0), member)
    return {member: maps[member] for member in seen.values()}


def form_of(family: str) -> tuple[Growing, int] | None:
    """The growing family that a text such as ``regular:6`` names, and the degree.

    The degree is 0 in a family without a degree.  If the text names no growing family, None is
    returned.
    """
    name, colon, degree = family.partition(":")
    growing = GROWING.get(name)
    if growing is None or (colon and growing.degree is None):
        return None
    if not colon:
        return growing, growing.degree or 0
    return (growing, int(degree)) if re.fullmatch(r"\d{1,4}", degree, re.ASCII) else None


def members_of(family: str, to: int, worlds: int, seed: int) -> list[list[Member]]:
    """The members of a family: a list for each size, the sizes ascending.

    The sizes are those of the largest members with at most ``to``, ``to / 2``, ``to / 4``, ...
    edges.  The members of one size have the seeds ``seed``, ``seed + 1``, and so on; there are
    ``worlds`` seeds.

    Raises:
        InputError: for a text that names no growing family, and for a family without a member of at
            most ``to`` edges.
    """
    known = form_of(family)
    if known is None:
        raise not_one_of("family", family, FORMS.split(", "), also=families.OTHER_WORDS)
    growing, number = known
    largest = dict.fromkeys(_largest(growing, number, to >> k) for k in reversed(range(SIZES)))
    sizes = [
        [Member(text, growing.holes, seed + i) for i in range(worlds)] for text in largest if text
    ]
    for first, *_ in sizes:
        first.map()  # a degree that no member can have is refused before anything is walked
    if not sizes:
        raise InputError(f"family {family} has no world with at most {to} edges")
    return sizes


def _largest(growing: Growing, degree: int, edges: int) -> str:
    """The name of the largest member of the family ``growing`` with at most ``edges`` edges.

    Some families remove a share of the edges when they make a member.  Here the number of edges
    before the removal counts, because it follows from the member's name alone.

    The name is empty if the largest member has fewer than :data:`LEAST` edges, or if all members
    have more than ``edges`` edges.  ``degree`` is the degree in the family's name, or 0.
    """
    number = 1
    while families.edges_of(growing.member(number + 1, degree)) <= edges:
        number += 1
    text = growing.member(number, degree)
    return text if LEAST <= families.edges_of(text) <= edges else ""


Range: TypeAlias = Annotated[
    doc.Pair[doc.Figure] | None,
    doc.about(
        f"at {intervals.LEVEL:.0%}, by Student's t on logarithms; null: exact, fewer than "
        f"{intervals.LEAST_WORLDS} worlds, or no scipy"
    ),
]
"""The type of a confidence interval in a row: its two ends, or null."""


class GrownWorld(doc.Document):
    """One world of a family, and an explorer's runs in it."""

    name: Annotated[doc.Text, doc.about("as `run --family` takes it")]
    edges: Annotated[doc.Positive, doc.about("of the map")]
    places: Annotated[doc.Positive, doc.about("places that the lighthouse has in this world")]
    ran: Annotated[doc.Some[doc.Natural], doc.about("the numbers of the places that were run")]
    costs: Annotated[doc.Some[doc.Natural], doc.about("costs of these runs, in traversals")]
    bound: Annotated[int | None, doc.about("the largest bound of a run; null without a bound")]

    @property
    def mean(self) -> float:
        """The mean cost of the runs."""
        return sum(self.costs) / len(self.costs)

    def map(self) -> CombinatorialMap:
        """The map; the robot starts at dart 0."""
        return member_named(self.name).map()


class GrowRow(doc.Document):
    """Costs of an explorer in the members of a family that have one size."""

    family: Annotated[doc.Text, doc.about("as it was asked for")]
    edges: Annotated[doc.Positive, doc.about("the edges of the first member")]
    vertices: Annotated[doc.Positive, doc.about("the vertices of the first member")]
    explorer: Annotated[doc.Text, doc.about("the name of the explorer")]
    seeds: Annotated[doc.Positive, doc.about("the number of drawn members")]
    drawn_from: Annotated[
        doc.Positive | None,
        doc.about("how many rooted maps seeds can draw; null: seeds draw more than a start"),
    ]
    exact: Annotated[bool, doc.about("whether all worlds seeds can draw were run in all places")]
    members: Annotated[doc.Some[GrownWorld], doc.about("the worlds, by seed")]

    @doc.computed
    def worlds(self) -> doc.Positive:
        """The number of different rooted maps among the members."""
        return len(self.members)

    @doc.computed
    def places(self) -> doc.Positive:
        """The number of places of the lighthouse in a member, summed over the members."""
        return sum(one.places for one in self.members)

    @doc.computed
    def runs(self) -> doc.Positive:
        """The number of runs: one for each chosen place of the lighthouse in each member."""
        return sum(len(one.costs) for one in self.members)

    @doc.computed
    def mean(self) -> doc.Figure:
        """The mean traversals: first over the places in a world, then over the worlds."""
        return round(fsum(self.means) / len(self.members), 6)

    @doc.computed
    def interval(self) -> Range:
        """The confidence interval of ``mean``, at the level :data:`intervals.LEVEL`.

        The result is None if the mean is exact: all worlds that seeds can draw were run in all
        places.  It is also None if :func:`intervals.mean_interval` finds no interval: for few
        worlds, for a mean cost of 0 in a world, or without scipy.
        """
        return None if self.exact else _rounded(intervals.mean_interval(self.means))

    @doc.computed
    def least(self) -> doc.Natural:
        """The least traversals of a run; if ``runs`` < ``places``, other places may need less."""
        return min(min(one.costs) for one in self.members)

    @doc.computed
    def worst(self) -> doc.Natural:
        """The most traversals of a run; if ``runs`` < ``places``, other places may need more."""
        return max(max(one.costs) for one in self.members)

    @doc.computed
    def bound(self) -> int | None:
        """The largest bound of a run; null without a bound."""
        return max((m.bound for m in self.members if m.bound is not None), default=None)

    @property
    def means(self) -> list[float]:
        """The mean cost in each member, in the order of ``members``."""
        return [one.mean for one in self.members]


class CostRatio(doc.Document):
    """Costs of an explorer divided by the first explorer's costs in the same worlds."""

    family: Annotated[doc.Text, doc.about("as it was asked for")]
    edges: Annotated[doc.Positive, doc.about("the edges of the first member")]
    explorer: Annotated[doc.Text, doc.about("the name of the explorer")]
    worlds: Annotated[doc.Positive, doc.about("worlds in which both explorers were run")]
    ratio: Annotated[doc.Figure, doc.about("the geometric mean of the ratios in these worlds")]
    exact: Annotated[bool, doc.about("whether all worlds seeds can draw were run in all places")]
    interval: Annotated[Range, doc.about("the interval of the ratio")]


class Exponent(doc.Document):
    """The exponent e with which an explorer's cost grows in a family: like (number of edges)^e."""

    family: Annotated[doc.Text, doc.about("as it was asked for")]
    explorer: Annotated[doc.Text, doc.about("its name")]
    sizes: Annotated[doc.Positive, doc.about("the number of sizes that have a mean cost")]
    exponent: Annotated[
        float | None,
        doc.about(
            "by least squares of the logarithms of mean costs and edges; null: fewer than "
            f"{intervals.LEAST_SIZES} sizes, or a cost of 0"
        ),
    ]
    interval: Annotated[
        doc.Pair[float] | None,
        doc.about(f"the interval of the exponent, at {intervals.LEVEL:.0%}; null: see `lack`"),
    ]
    lack: Annotated[str, doc.about("the reason why there is no interval; empty if there is one")]


class Growth(entrants.ContestReport, kw_only=True):
    """Report of 'compare --to'.

    The costs of explorers in worlds that grow. ``families`` are the families, as they were named.
    """

    steps: ClassVar[str] = "sizes"

    rows: Annotated[tuple[GrowRow, ...], doc.about("one for each family, size and explorer")]
    left_out: Annotated[doc.Natural, doc.about("members in which a lighthouse had no place")] = 0
    families: doc.NotInDocument[tuple[str, ...]]

    @doc.computed
    def ratios(self) -> tuple[CostRatio, ...]:
        """For each family, size and further explorer, its costs divided by the first explorer's."""
        return tuple(_ratios(self))

    @doc.computed
    def exponents(self) -> tuple[Exponent, ...]:
        """For each family and explorer, the exponent with which the cost grows."""
        keys = dict.fromkeys((row.family, row.explorer) for row in self.rows)
        return tuple(_exponent(self, *key) for key in keys)

    def in_worlds(self) -> Iterator[entrants.InWorld]:
        """Yield an explorer's runs in one world, for each world of each row.

        Cost: each world is built once again.
        """
        built = cache(lambda name: member_named(name).map())
        for row in self.rows:
            for one in row.members:
                yield entrants.InWorld(
                    built(one.name),
                    one.name,
                    row.explorer,
                    dict(zip(one.ran, one.costs, strict=True)),
                    one.places,
                    one.bound,
                    row.drawn_from,
                )


def _ratios(report: Growth) -> Iterator[CostRatio]:
    first = {(r.family, r.edges): r for r in report.rows if r.explorer == report.names[0]}
    for row in report.rows:
        beside = first.get((row.family, row.edges))
        if beside is None or beside is row:
            continue
        costs = {one.name: one.mean for one in beside.members}
        ratios = [one.mean / costs[one.name] for one in row.members if costs.get(one.name)]
        if ratios and min(ratios) > 0:
            exact = row.exact and beside.exact and len(ratios) == len(row.members) == len(costs)
            yield CostRatio(
                family=row.family,
                edges=row.edges,
                explorer=row.explorer,
                worlds=len(ratios),
                ratio=round(geometric_mean(ratios), 6),
                exact=exact,
                interval=None if exact else _rounded(intervals.ratio_interval(ratios)),
            )


def _exponent(report: Growth, family: str, explorer: str) -> Exponent:
    rows = [row for row in report.rows if (row.family, row.explorer) == (family, explorer)]
    found = intervals.power({row.edges: fmean(row.means) for row in rows})
    return Exponent(
        family=family,
        explorer=explorer,
        sizes=len(rows),
        exponent=None if found.exponent is None else round(found.exponent, 3),
        interval=_rounded(found.interval, 3),
        lack=found.lack,
    )


def _rounded(interval: intervals.Interval | None, digits: int = 6) -> intervals.Interval | None:
    return interval and (round(interval[0], digits), round(interval[1], digits))


class _Size(Struct, frozen=True):
    """The members of a family that have one size.

    Attributes:
        number: the family's index among the families of the request.
        family: the name of the family in the request.
        edges: the number of edges of a member before edges are removed.
        seeds: the number of members that were drawn.
        maps: the maps of the different members in which explorers run.
        drawn_from: the number of different members that seeds can draw; None: unknown.
    """

    number: int
    family: str
    edges: int
    seeds: int
    maps: Mapping[Member, CombinatorialMap]
    drawn_from: int | None


class GrowingWorlds(entrants.Contest[Growth]):
    """The sweep of explorers through growing worlds, from the smallest size to the largest.

    The sizes of all families are sorted together by the number of edges.  So, when the time is up,
    the smaller sizes of every family are finished.

    Args:
        entrants: the explorers.
        request: the request; its families are in :data:`GROWING`, perhaps with a degree, as in
            ``regular:6``.
        to: the largest number of edges.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: that of the explorers' runs, which grows at least with the square of the number of edges.
    """

    def __init__(
        self, entrants: Sequence[entrants.Entrant], request: entrants.CompareRequest, to: int
    ) -> None:
        _ensure_grows(entrants, request)
        defaults = {"draws": WORLDS, "places": PLACES, "seed": SEED}
        numbers = {"to": to}
        for name, default in defaults.items():
            given = getattr(request, name)
            numbers[name] = default if given is None else given
        for option, least in (("to", LEAST), ("draws", 1), ("places", 1), ("seed", 0)):
            if an_integer(option, numbers[option]) < least:
                raise InputError(f"{option} = {show(numbers[option])} is less than {least}")
        self._places, self._families = numbers["places"], request.family or ()
        sizes = [
            _size(number, family, members)
            for number, family in enumerate(self._families)
            for members in members_of(family, to, numbers["draws"], numbers["seed"])
        ]
        self._sizes = sorted(sizes, key=lambda size: size.edges)
        edges = [families.edges_of(member.text) for size in self._sizes for member in size.maps]
        extent = classes.Extent(classes.MapClass.MAPS, max(edges))
        super().__init__(entrants, doc.replace(request, **numbers), extent)
        self._mine = {*dealt([m * m for m in edges], self.portion)}
        self._rows: list[GrowRow] = []
        self._left_out = 0

    @override
    def levels(self) -> Iterator[SweptLevel]:
        number = 0
        for size in self._sizes:
            numbered = enumerate(size.maps.items(), number)
            mine = doc.replace(size, maps=dict(one for n, one in numbered if n in self._mine))
            number += len(size.maps)
            edges = max((m.edge_count for m in mine.maps.values()), default=1)
            chosen = (self._chosen(one, *m) for one in self.entrants for m in size.maps.items())
            runs = sum(len(ran) for _, ran in chosen)
            yield SweptLevel(edges, runs, self._units(mine), mine)

    def _units(self, size: _Size) -> Iterator[entrants.UnitOfOne]:
        """Yield a unit of runs for each explorer and world, at the chosen lighthouse places."""
        for number, one in enumerate(self.entrants):
            for member, map_ in size.maps.items():
                _, ran = self._chosen(one, member, map_)
                if ran:
                    given = tuple((World(map_, lighthouse, 0), i) for i, lighthouse in ran.items())
                    unit = GivenWorlds(given, f"{size.family}/{member.name}")
                    yield entrants.UnitOfOne(number, unit)

    def _chosen(
        self, one: entrants.Entrant, member: Member, map_: CombinatorialMap
    ) -> tuple[int, dict[int, Lighthouse]]:
        """The number of places of an explorer's lighthouse in a world, and the chosen places.

        A chosen place is given as its number and the lighthouse at this place.  If the request
        allows fewer places than there are, places are drawn at random; the seed of this choice is
        the world's name.
        """
        places = [*one.rules.kind.places(map_, 0)]
        drawn: Sequence[int] = range(len(places))
        if len(places) > self._places:
            chance = Random(f"places/{member.name}")  # noqa: S311  # reproducible, not secret
            drawn = sorted(chance.sample(drawn, self._places))
        return len(places), {i: places[i] for i in drawn}

    @override
    def finish(self, level: SweptLevel, total: entrants.CostsOfAll) -> None:
        self._rows += self._rows_of(level.of, total)
        for one in self.entrants:
            chosen = (self._chosen(one, *member) for member in level.of.maps.items())
            self._left_out += sum(not ran for _, ran in chosen)
        self.leave(level, total)

    @override
    def report(self, ending: outcome.Ending) -> Growth:
        return Growth(
            **self.contest(ending),
            families=self._families,
            rows=tuple(sorted(self._rows, key=lambda row: self._families.index(row.family))),
            left_out=self._left_out,
        )

    def _rows_of(self, size: _Size, total: entrants.CostsOfAll) -> Iterator[GrowRow]:
        """Yield a row for each explorer, about the members whose runs are all done.

        ``size`` has the members of one size, and ``total`` the costs of the runs that are done.  In
        a member there is one run for each chosen place of the explorer's lighthouse.
        """
        for number, one in enumerate(self.entrants):
            costs, members = total.one(number).costs, dict[CombinatorialMap, GrownWorld]()
            for member, map_ in size.maps.items():
                places, ran = self._chosen(one, member, map_)
                known = costs.get(entrants.key_of(map_), {})
                if ran and ran.keys() <= known.keys():
                    members[map_] = GrownWorld(
                        name=member.name,
                        edges=map_.edge_count,
                        places=places,
                        ran=tuple(ran),
                        costs=tuple(known[i] for i in ran),
                        bound=one.rules.the_bound.of(map_, 0),
                    )
            if members:
                all_run = len(size.maps) == size.drawn_from
                first = next(iter(members))
                yield GrowRow(
                    family=size.family,
                    edges=first.edge_count,
                    vertices=first.vertex_count,
                    explorer=one.name,
                    seeds=size.seeds,
                    drawn_from=size.drawn_from,
                    exact=all_run and all(len(m.ran) == m.places for m in members.values()),
                    members=tuple(members.values()),
                )


def _ensure_grows(who: Sequence[entrants.Entrant], request: entrants.CompareRequest) -> None:
    """Raise InputError if an explorer or a family is missing, or an option would have no effect."""
    names = ("edges", "vertices", "holes", "worlds", "graph", "where")
    entrants.ensure_unnamed(request, names, "worlds that grow")
    if request.map_class is not classes.MapClass.MAPS:
        raise InputError(f"class {show(request.map_class.value)} has no effect on worlds that grow")
    if not who:
        raise InputError("compare with to takes an explorer at least, not none")
    if not request.family:
        raise InputError(f"compare with to takes a family at least: {FORMS}")


def _size(number: int, family: str, members: Sequence[Member]) -> _Size:
    """The members of a family that have one size; isomorphic members count once.

    ``number`` is the index of the family among the families of the request, ``family`` its name;
    ``members`` are the members that were drawn.
    """
    maps = distinct(members)
    member, map_ = next(iter(maps.items()))
    drawn_from = families.rootings(member.text, map_, member.holes)
    return _Size(number, family, families.edges_of(member.text), len(members), maps, drawn_from)
