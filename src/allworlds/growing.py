"""Cost by size on families of large worlds, with fitted exponents: the verb ``grow``.

Of each family a few members of each size are drawn from seeds.  Every member has a name that gives
it back (``allworlds run greedy --family torus:6x6 --seed 1``), and every run in it is judged.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from math import log
from typing import TYPE_CHECKING, Unpack

from allworlds.checker import ManyRunsOptions, refuse_others, rules_for
from allworlds.findings import Finding, Rules
from allworlds.inputs import InputError, an_integer, show
from allworlds.isolation import Unsettled, confirmed, subject_of, workers_for
from allworlds.maps.classes import Extent, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.families import edges_of
from allworlds.outcome import SCHEMA, Exit, Verdict
from allworlds.progress import Listener, Silent
from allworlds.runs import Costing, CostTally, GivenWorlds, Scope, key_of
from allworlds.subjects import Subject
from allworlds.work import Limits, TimeIsUp, gather
from allworlds.world import World, map_of_family

if TYPE_CHECKING:
    from allworlds import documents

TO, WORLDS, SEED = 400, 3, 1
"""What is taken where nothing is said: the largest number of edges, members of a size, a seed."""

LEAST, SIZES = 12, 6
"""No size has fewer edges, and there are no more sizes."""

HOLES = "10%"
"""Of a dense map, which else would have one member of each size."""


@dataclass(frozen=True, slots=True)
class Growing:
    """A family as it is asked for, and its members by a number that grows with them.

    Attributes:
        form: how it is written; ``:D`` stands for a degree.
        member: the text of a member, from its number and the degree.
        degree: the degree where none is named; None where a name has none.
        holes: the share of edges to be removed.
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
    )
}
"""Every family that grows, by its name."""

FORMS = ", ".join(growing.form for growing in GROWING.values())


@dataclass(frozen=True, slots=True)
class Member:
    """One world of a family: what gives it back on the command line."""

    text: str
    holes: str | None
    seed: int

    @property
    def name(self) -> str:
        """``torus:6x6 --seed 1``."""
        holes = f" --holes {self.holes}" if self.holes else ""
        return f"{self.text}{holes} --seed {self.seed}"

    def map(self) -> CombinatorialMap:
        """Its map; a robot starts at dart 0."""
        return map_of_family(self.text, self.holes, self.seed)


@dataclass(frozen=True, slots=True)
class GrowRow:
    """What an explorer walks in the members of one size.

    Attributes:
        family: as it was asked for.
        edges, vertices: of the members.
        explorer: its name.
        members: the names of these worlds.
        costs: of the runs in them.
        bound: the largest legal cost; None without a bound.
    """

    family: str
    edges: int
    vertices: int
    explorer: str
    members: tuple[str, ...]
    costs: tuple[int, ...]
    bound: int | None

    @property
    def mean(self) -> float:
        """Of the costs."""
        return sum(self.costs) / len(self.costs)

    def to_json(self) -> documents.GrowRow:
        """One row of the document."""
        return {
            "family": self.family,
            "edges": self.edges,
            "vertices": self.vertices,
            "explorer": self.explorer,
            "mean": round(self.mean, 6),
            "least": min(self.costs),
            "worst": max(self.costs),
            "bound": self.bound,
            "members": list(self.members),
            "costs": list(self.costs),
        }


@dataclass(frozen=True, slots=True)
class Exponent:
    """How an explorer's cost grows in a family: like m to this power, fitted to the means."""

    family: str
    explorer: str
    exponent: float
    last: float

    def to_json(self) -> documents.Exponent:
        """One entry of the document."""
        return {
            "family": self.family,
            "explorer": self.explorer,
            "exponent": round(self.exponent, 3),
            "last": round(self.last, 3),
        }


@dataclass(frozen=True, slots=True)
class Growth:
    """The cost by size.

    Attributes:
        explorers: their names.
        families: as they were asked for.
        rows: by family, size and explorer, as they were named.
        findings: the smallest of each explorer in each family.
        left_out: members in which a lighthouse has no place.
        stopped: why there is not more; empty if it is complete.
        interrupted: by the user.
    """

    explorers: tuple[str, ...]
    families: tuple[str, ...]
    rows: tuple[GrowRow, ...]
    findings: tuple[Finding, ...]
    left_out: int = 0
    stopped: str = ""
    interrupted: bool = False

    @property
    def exponents(self) -> list[Exponent]:
        """Where there are two sizes or more."""
        fitted = []
        for family in self.families:
            for name in self.explorers:
                rows = [r for r in self.rows if (r.family, r.explorer) == (family, name)]
                if len(rows) > 1:
                    fitted.append(Exponent(family, name, _slope(rows), _slope(rows[-2:])))
        return fitted

    @property
    def verdict(self) -> Verdict:
        """Whether a run broke a law."""
        if self.findings:
            return Verdict.REFUTED
        if self.stopped or self.interrupted:
            return Verdict.INCONCLUSIVE
        return Verdict.NOT_REFUTED if self.rows else Verdict.VACUOUS

    @property
    def exit_code(self) -> Exit:
        """Of the command."""
        if self.interrupted and not self.findings:
            return Exit.INTERRUPTED
        return self.verdict.exit

    def to_json(self) -> documents.GrowReport:
        """The document of ``grow --json``."""
        return {
            "schema": SCHEMA,
            "verdict": self.verdict.value,
            "exit_code": self.exit_code,
            "complete": not (self.stopped or self.interrupted),
            "explorers": list(self.explorers),
            "families": list(self.families),
            "rows": [row.to_json() for row in self.rows],
            "exponents": [exponent.to_json() for exponent in self.exponents],
            "left_out": self.left_out,
            "stopped": self.stopped or None,
            "findings": [finding.to_json() for finding in self.findings],
        }


def _slope(rows: Sequence[GrowRow]) -> float:
    """Of the straight line through log mean over log edges, by least squares."""
    from numpy import polyfit

    points = [(log(row.edges), log(row.mean)) for row in rows]
    slope, _ = polyfit([x for x, _ in points], [y for _, y in points], 1)
    return float(slope)


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
    contestants = [_Contestant.of(explore, limits, options) for explore in explorers]
    names = tuple(one.subject.name for one in contestants)
    if not names:
        raise InputError("grow takes an explorer at least")
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"explorer {show(name)} is named twice")
    asked = tuple(dict.fromkeys(families))
    if not asked:
        raise InputError(f"grow takes a family at least: {FORMS}")
    numbers = {"to": to, "worlds": worlds, "seed": seed}
    for option, least in (("to", LEAST), ("worlds", 1), ("seed", 0)):
        if an_integer(option, numbers[option]) < least:
            raise InputError(f"{option} = {show(numbers[option])} is less than {least}")
    ladders = {family: members_of(family, to, worlds, seed) for family in asked}
    growth = _Growth(contestants, ladders, limits, listener or Silent())
    stopped, interrupted = "", False
    try:
        growth.run()
    except TimeIsUp:
        stopped = f"the time limit of {limits.time_limit:g} s was reached"
    except Unsettled as error:
        stopped = str(error)
    except KeyboardInterrupt:
        interrupted = True
    return Growth(
        names,
        asked,
        tuple(growth.rows),
        tuple(growth.findings),
        growth.left_out,
        stopped,
        interrupted,
    )


def members_of(family: str, to: int, worlds: int, seed: int) -> list[list[Member]]:
    """The members of a family, ascending; those of one size together.

    The sizes are the largest members with at most ``to``, ``to / 2``, ``to / 4``, ... edges.

    Raises:
        InputError: for a text that is none of the families.
    """
    name, _, degree = family.partition(":")
    growing = GROWING.get(name)
    legal = growing is not None and (
        not degree or (growing.degree is not None and re.fullmatch(r"\d{1,4}", degree, re.ASCII))
    )
    if growing is None or not legal or (":" in family and not degree):
        raise InputError(f"family {show(family)} is none of {FORMS}")
    number = int(degree) if degree else growing.degree or 0
    ladder = []
    for text in dict.fromkeys(_largest(growing, number, to >> k) for k in reversed(range(SIZES))):
        if text:
            ladder.append([Member(text, growing.holes, seed + i) for i in range(worlds)])
            # A degree that no member can have is told before anything is walked.
            ladder[-1][0].map()
    return ladder


def _largest(growing: Growing, degree: int, edges: int) -> str:
    """The largest member with at most so many edges, counted without holes; empty if too small."""
    number = 1
    while edges_of(growing.member(number + 1, degree)) <= edges:
        number += 1
    text = growing.member(number, degree)
    return text if LEAST <= edges_of(text) <= edges else ""


@dataclass(frozen=True, slots=True)
class _Contestant:
    subject: Subject
    rules: Rules

    @classmethod
    def of(
        cls, explore: str | Callable[..., object], limits: Limits, options: ManyRunsOptions
    ) -> _Contestant:
        subject = subject_of(explore, limits)
        return cls(subject, rules_for(subject, options)[1])


@dataclass(slots=True)
class _Growth:
    """On its way."""

    contestants: Sequence[_Contestant]
    ladders: Mapping[str, list[list[Member]]]
    limits: Limits
    listener: Listener
    rows: list[GrowRow] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    left_out: int = 0

    def run(self) -> None:
        deadline = self.limits.deadline()
        for family, ladder in self.ladders.items():
            maps = {member: member.map() for size in ladder for member in size}
            found: dict[tuple[int, str], GrowRow] = {}
            for one in self.contestants:
                self.listener.level(max(m.edge_count for m in maps.values()), len(maps))
                tally = self._costs(one, maps, deadline)
                for i, size in enumerate(ladder):
                    for row in self._rows(family, one, size, maps, tally):
                        found[i, one.subject.name] = row
            names = [one.subject.name for one in self.contestants]
            self.rows += (
                found[i, name] for i in range(len(ladder)) for name in names if (i, name) in found
            )

    def _costs(
        self, one: _Contestant, maps: Mapping[Member, CombinatorialMap], deadline: float | None
    ) -> CostTally:
        extent = Extent(MapClass.MAPS, max(map_.edge_count for map_ in maps.values()))
        scope = Scope(extent, one.rules)
        tally = CostTally(keep=1)
        with workers_for(one.subject, self.limits, deadline) as transport:
            units = list(_units(one.rules, maps))
            self.left_out += len(maps) - len(units)
            # The largest take the longest: who begins with them waits least for the last.
            gather(transport, Costing(scope, tally.keep), units[::-1], tally, self.listener)
        self.findings += [
            confirmed(finding, one.subject, self.limits, "one") for finding in tally.findings
        ]
        return tally

    @staticmethod
    def _rows(
        family: str,
        one: _Contestant,
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
                one.subject.name,
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
