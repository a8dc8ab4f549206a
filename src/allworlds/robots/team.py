"""A team of robots under test: its programs, and the scope and the counts of its searches."""

from __future__ import annotations

from bisect import insort
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Annotated, Any

from msgspec import Struct

from allworlds.engines.kept_units import Form
from allworlds.engines.units import LevelUnit
from allworlds.explorers.loading import Subject
from allworlds.explorers.sources import content_digest, not_alike, with_content
from allworlds.inputs.checks import InputError, show
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.robots.configurations import Search
from allworlds.robots.minds import Minds
from allworlds.robots.model import ModelInMap
from allworlds.robots.models.table import NamedModel
from allworlds.robots.schedulers import Timing
from allworlds.robots.team_finding import TeamFinding


class Team(Struct, frozen=True, weakref=True):
    """The programs of a team.

    Attributes:
        subjects: the programs, each once.
        program_of: for each robot the number of its program.
    """

    subjects: tuple[Subject, ...]
    program_of: tuple[int, ...]

    from_user = True
    compiled = False

    @property
    def names(self) -> tuple[str, ...]:
        """The name of each robot's program."""
        return tuple(self.subjects[program].name for program in self.program_of)

    @property
    def name(self) -> str:
        """The names of the programs, each once, in one text with commas."""
        return ", ".join(self.subjects[program].name for program in dict.fromkeys(self.program_of))

    @property
    def digests(self) -> tuple[str, ...]:
        """The digest of each program's source, which must be the same on all machines."""
        return tuple(map(content_digest, self.subjects))

    @property
    def with_content(self) -> Team:
        """The team with the source texts that other machines need.

        Raises:
            InputError: for a program that exists in this process alone.
        """
        for subject in self.subjects:
            if subject.from_user and not subject.importable:
                raise InputError(
                    f"program {show(subject.name)} lives in this process alone and cannot be sent "
                    "to others; put it into a file of its own"
                )
        return Team(tuple(map(with_content, self.subjects)), self.program_of)

    def not_alike(self, digests: tuple[str, ...], answer_timeout: float) -> str:
        """The reason why a program on this machine does not have the expected digest.

        ``digests`` has the expected digest of each program; ``answer_timeout`` is the number of
        seconds in which a program in another language must answer.  The reason is empty if all
        programs have the expected digests.
        """
        pairs = zip(self.subjects, digests, strict=True)
        found = (not_alike(subject, digest, answer_timeout) for subject, digest in pairs)
        return next(filter(None, found), "")

    @property
    def importable(self) -> bool:
        """Whether other processes can play all programs."""
        return all(subject.importable or not subject.from_user for subject in self.subjects)


@dataclass(slots=True)
class TeamRow:
    """The counts of the worlds with one number of edges and one number of vertices.

    Attributes:
        maps: the number of rooted maps.
        worlds: the number of searches: one for each map and each choice of the robots' start darts.
        configurations: the number of configurations of all searches.
        most: the largest number of configurations of a search.
        ends: the number of configurations in which a run ends.
        cut_off: the number of configurations in which a run is cut off: by the budget (see
            :class:`Timing`), or at the end of the given schedule.
        full: the number of searches that stopped because they reached too many configurations.
        longest: the largest number of activations of a robot in a run that ends.
        schedules: the number of complete runs: those that cannot be continued; None if the number
            is infinite or not known.
    """

    maps: int = 0
    worlds: int = 0
    configurations: int = 0
    most: int = 0
    ends: int = 0
    cut_off: int = 0
    full: int = 0
    longest: int = 0
    schedules: int | None = 0

    def add(self, other: TeamRow) -> None:
        """Add the counts of other searches."""
        self.maps += other.maps
        self.worlds += other.worlds
        self.configurations += other.configurations
        self.most = max(self.most, other.most)
        self.ends += other.ends
        self.cut_off += other.cut_off
        self.full += other.full
        self.longest = max(self.longest, other.longest)
        known = self.schedules is not None and other.schedules is not None
        self.schedules = (self.schedules or 0) + (other.schedules or 0) if known else None

    def count(self, search: Search) -> None:
        """Add the counts of a search."""
        unknown = search.broken or search.ends.cut_off or search.full
        self.add(
            TeamRow(
                worlds=1,
                configurations=len(search),
                most=len(search),
                ends=search.ends.count,
                cut_off=search.ends.cut_off,
                full=int(search.full),
                longest=search.ends.longest,
                schedules=None if unknown else search.schedules(),
            )
        )


def to_record(finding: TeamFinding) -> dict[str, Any]:
    """The finding, as a run directory keeps it."""
    return finding.to_json()


KeptFinding = Annotated[TeamFinding, Form(to_record, TeamFinding.from_json)]


@dataclass(slots=True)
class TeamTally:
    """The results of all searches of a part of a job, added up.

    A run is cut off by the budget, or at the end of the given schedule.

    Attributes:
        keep: the largest number of findings that are kept.  Of findings with the same law and map
            only the smallest is kept.
        rows: the counts by (edges, vertices).
        findings: the smallest findings, ascending.
        unfinished: a list with the smallest run that is cut off, or an empty list.
        remarks: texts about processes that were lost, each with its number of occurrences; they
            refute nothing.
    """

    keep: int = 1
    rows: dict[tuple[int, int], TeamRow] = field(default_factory=dict)
    findings: list[KeptFinding] = field(default_factory=list)
    unfinished: list[KeptFinding] = field(default_factory=list)
    remarks: Counter[str] = field(default_factory=Counter)

    @property
    def worlds(self) -> int:
        """The number of rooted maps, which is the sum of ``maps`` over all rows.

        The progress of a job is counted in rooted maps, so this property has the name that other
        tallies use for them.  ``TeamRow.worlds`` counts maps with starts.
        """
        return sum(row.maps for row in self.rows.values())

    def row(self, map_: CombinatorialMap) -> TeamRow:
        """The row with the counts of worlds of the size of this map; a missing row is added."""
        return self.rows.setdefault((map_.edge_count, map_.vertex_count), TeamRow())

    def find(self, finding: TeamFinding, *, unfinished: bool = False) -> None:
        """Keep a finding if it is among the smallest; for each law and map only one is kept.

        If ``unfinished`` is set, the finding is a run that is cut off.
        """
        held, most = (self.unfinished, 1) if unfinished else (self.findings, self.keep)
        for index, kept in enumerate(held):
            if kept.kind == finding.kind:
                if kept.rank <= finding.rank:
                    return
                del held[index]
                break
        insort(held, finding, key=lambda each: each.rank)
        del held[most:]

    def wants(self, map_: CombinatorialMap, *, unfinished: bool = False) -> bool:
        """Whether a finding in a map of this size could be among the smallest findings.

        If ``unfinished`` is set, the finding is a run that is cut off.
        """
        held, most = (self.unfinished, 1) if unfinished else (self.findings, self.keep)
        size = map_.edge_count, map_.vertex_count
        return len(held) < most or size <= held[-1].key[:2]

    def add(self, other: TeamTally) -> None:
        """Add the tally of another part of the job."""
        for size, row in other.rows.items():
            self.rows.setdefault(size, TeamRow()).add(row)
        for finding in other.findings:
            self.find(finding)
        for finding in other.unfinished:
            self.find(finding, unfinished=True)
        self.remarks.update(other.remarks)


class TeamScope(Struct, frozen=True):
    """The scope of a verdict about a team: which maps, model, programs and schedules are searched.

    Its methods make the searches of a unit, and an empty tally for the results of these searches.

    Attributes:
        extent: the class of the maps, with bounds on their size.
        model: the model of the worlds.
        team: the programs.
        timing: the schedules that are tried.
        keep: the largest number of findings to keep.
        starts: a dart for each robot, if only this start is tried; None if all starts that the
            model yields are tried.
    """

    extent: Extent
    model: NamedModel
    team: Team
    timing: Timing
    keep: int
    starts: tuple[int, ...] | None = None

    def tally(self) -> TeamTally:
        """An empty tally."""
        return TeamTally(self.keep)

    def starts_in(self, world: ModelInMap) -> Iterable[tuple[int, ...]]:
        """The starts that are tried in a map, each with a dart for each robot."""
        return [self.starts] if self.starts else world.starts(len(self.team.program_of))

    def searches(self, unit: LevelUnit, minds: Minds) -> Iterator[tuple[bool, Search | ModelInMap]]:
        """The searches of a unit, in a fixed order.

        Each item is a pair.  The first value says whether the item is the first of its map.  The
        second value is the search.  If the model allows no start in a map, nothing is searched
        there; the map still has one item, so that it is counted, and its second value is the model
        in this map.
        """
        for map_ in unit.maps(self.extent):
            world, first = ModelInMap(self.model.model, map_, self.model.name), True
            for start in self.starts_in(world):
                yield first, Search(world, start, self.team.program_of, minds, self.timing)
                first = False
            if first:
                yield True, world
