"""The sweep of the searches of a team, and the gate of their counts."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.engines import lanes, sweep, units
from allworlds.engines.engine_table import ReadyEngine
from allworlds.engines.job_records import Identity
from allworlds.engines.listeners import Listener
from allworlds.inputs.requests import (
    takes_fields,
)
from allworlds.maps import count_source
from allworlds.maps.classes import Extent
from allworlds.robots.lane import SearchLane
from allworlds.robots.team import Team, TeamScope, TeamTally
from allworlds.studies.check.tally_sweep import record_of, subject_of_record
from allworlds.studies.team.request import TeamRequest, renamed
from allworlds.studies.team.team_report import TeamCell, TeamReport
from allworlds.world.named import world_named


def searched(request: TeamRequest) -> TeamReport:
    """Answer a request of ``team``."""
    return TeamSweep(request, request.team()).answer(request.run)


@takes_fields(TeamRequest, several="explorers", answered=searched)
def team(*explorers: str | Callable[..., Any], **options: Any) -> TeamReport:
    """Search every schedule of several robots in every world of a class.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    return searched(TeamRequest(explorers=explorers, **options))


class TeamSweep(sweep.Sweep[TeamTally, TeamReport]):
    """The sweep of the searches of a team.

    Args:
        request: what was asked for.
        team: the programs.
    """

    verb, asked, result = "team", TeamRequest, TeamTally
    extent: Extent

    def __init__(self, request: TeamRequest, team: Team) -> None:
        super().__init__(request, request.extent)
        starts = None
        if request.starts and request.world:
            starts = renamed(world_named(request.world).map, request.starts)
        self.scope = TeamScope(
            self.extent,
            request.model,
            team,
            request.time,
            request.max_findings,
            starts,
        )
        self._tally = self.scope.tally()
        self._levels: list[int] = []
        self._gate: list[TeamCell] = []

    @override
    @classmethod
    def known(cls, identity: Identity, portion: units.Shard, listener: Listener) -> TeamSweep:
        subjects = tuple(subject_of_record(each) for each in identity.explorer["explorers"])
        of = tuple(identity.explorer["of"])
        return cls(cls.asked_then(identity, portion, listener), Team(subjects, of))

    @override
    def explorer(self) -> dict[str, Any]:
        records = [record_of(subject) for subject in self.scope.team.subjects]
        return {"name": self.scope.team.name, "explorers": records, "of": [*self.scope.team.of]}

    @override
    def parameters(self) -> dict[str, Any]:
        return {**super().parameters(), "edges": self.extent.edges}

    @override
    def ready(self) -> ReadyEngine:
        where = self.extent.where
        models = bool(self.request.model.codes or getattr(where, "codes", ()))
        made: Any = partial(lanes.workers_for, models=models, make=SearchLane)
        limits, team = self.request.limits, self.scope.team
        if self.request.dask is None:
            return ReadyEngine(made(team, limits, self.deadline), self.scope)
        from allworlds.engines.dask import Dask

        alone = doc.replace(limits, workers=1, time_limit=None)
        there = Dask(
            self.request.dask,
            limits.workers,
            self.deadline,
            inside=partial(made, team.with_content, alone),
            probe=partial(team.not_alike, team.digests, limits.answer_timeout),
        )
        return ReadyEngine(there, self.scope)

    @override
    def empty(self) -> TeamTally:
        return self.scope.tally()

    @override
    def finish(self, level: units.SweptLevel, total: TeamTally) -> outcome.Ending | None:
        whole = self.portion == units.WHOLE
        total.findings = [doc.replace(found, minimal=whole) for found in total.findings]
        self._tally.add(total)
        self._levels.append(level.edges)
        if whole:
            self._gate += gate_of(self.extent, level.edges, total)
        if not all(cell.agrees for cell in self._gate):
            return outcome.Disagreed("the count gate: the enumeration and its source disagree")
        found = len(self._tally.findings)
        if found >= self.scope.keep and level.edges != self.extent.levels[-1]:
            return outcome.Stopped(f"{found} findings in finished levels", final=True)
        return None

    @override
    def leave(self, level: units.SweptLevel, total: TeamTally) -> None:
        """Store the findings. Counts enter the report only if their level is finished."""
        for found in total.findings:
            self._tally.find(doc.replace(found, minimal=False))

    @override
    def report(self, ending: outcome.Ending) -> TeamReport:
        return TeamReport(
            **self.ended(ending),
            explorers=self.scope.team.names,
            asked=self.scope,
            tally=self._tally,
            cells=tuple(self._gate),
            seconds=tuple(self.seconds),
            levels=tuple(self._levels),
        )


def gate_of(extent: Extent, edges: int, tally: TeamTally) -> Iterator[TeamCell]:
    """Counts of the maps of a level, beside those of an independent source, if there is one."""
    source = count_source.source_of(extent)
    if source is None:
        return
    for vertices, counted in units.cells_of_level(extent, edges).items():
        row = tally.rows.get((edges, vertices))
        maps = row.maps if row else 0
        if maps or counted:
            yield TeamCell(
                edges=edges,
                vertices=vertices,
                enumerated=maps,
                counted=counted,
                source=source.name,
            )
