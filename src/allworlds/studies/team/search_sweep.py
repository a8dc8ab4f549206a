"""The sweep that searches every schedule of a team in many worlds, and its count gate.

Each search is under a *model*, which says how a world changes: what the robots sense, and what can
follow their actions.  A model is built in, or a user's Python class.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.engines import lanes, sweep, units
from allworlds.engines.engine_table import ReadyEngine
from allworlds.engines.kept_units import Identity
from allworlds.engines.limits import Limits, TimeoutOptions
from allworlds.engines.listeners import Listener
from allworlds.inputs.checks import parse_json, show
from allworlds.inputs.requests import takes_fields, values_of
from allworlds.maps import count_source
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap, rooted_code
from allworlds.protocol.user_code import OtherText
from allworlds.robots.model import ModelInMap
from allworlds.robots.models.table import NamedModel, named_model
from allworlds.robots.search_lane import SearchLane
from allworlds.robots.team import Team, TeamScope, TeamTally
from allworlds.robots.team_finding import TeamFinding, TimeDocument
from allworlds.studies.check.tally_sweep import record_of, subject_of_record
from allworlds.studies.team.request import TeamRequest, renamed
from allworlds.studies.team.team_report import TeamCell, TeamReport
from allworlds.studies.user_corpus import LeftOpen, corpus_of
from allworlds.words import plural
from allworlds.world.named import world_named


def searched(request: TeamRequest) -> TeamReport:
    """Do the searches that a request of ``team`` asks for, and return the report."""
    return TeamSweep(request, request.team()).answer(request.run)


@takes_fields(TeamRequest, several="explorers", answered=searched)
def team(*explorers: str | Callable[..., Any], **options: Any) -> TeamReport:
    """Search every schedule of several robots in every world of a class.

    ``explorers`` are the programs of the robots: one for all robots, or one for each.  ``options``
    are the other fields of :class:`TeamRequest`, such as ``robots``, ``model`` and ``edges``.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    return searched(TeamRequest(explorers=explorers, **options))


class TeamSweep(sweep.Sweep[TeamTally, TeamReport]):
    """The sweep that searches every schedule of a team in many worlds.

    Args:
        request: the request.
        team: the programs of the robots.
    """

    verb, request_type, result = "team", TeamRequest, TeamTally
    finer = 1
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
            request.timing,
            request.max_findings,
            starts,
        )
        self._tally = self.scope.tally()
        self.corpus = corpus_of(request.corpus, request.run, _read)
        self._levels: list[int] = []
        self._gate: list[TeamCell] = []

    @override
    @classmethod
    def known(cls, identity: Identity, portion: units.Shard, listener: Listener) -> TeamSweep:
        subjects = tuple(subject_of_record(each) for each in identity.explorer["explorers"])
        of = tuple(identity.explorer["of"])
        return cls(cls.request_of(identity, portion, listener), Team(subjects, of))

    @override
    def explorer(self) -> dict[str, Any]:
        team = self.scope.team
        explorers = [record_of(subject) for subject in team.subjects]
        return {"name": team.name, "explorers": explorers, "of": [*team.program_of]}

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
    def begin(self) -> outcome.Ending | None:
        """Try again the findings in the user's corpus, a directory of earlier findings.

        Return an ending if at least as many findings are reproduced as the option ``max_findings``
        says: then the job ends before its first level.  Else return None.
        """
        if self.corpus is None:
            return None
        for found in self.corpus.retry(self._again, partial(is_inside, scope=self.scope)):
            self._tally.find(found)
        if len(self._tally.findings) >= self.scope.keep:
            return outcome.Stopped("past findings stand")
        return None

    def _again(self, finding: TeamFinding) -> TeamFinding | None:
        """Search the world of an earlier finding again, with the programs as they are now.

        Return the new finding, or None if no law is broken.

        Raises:
            OtherText: if the text of the finding's model is not the recorded one, or if there are
                several programs, but not one for each robot of the finding.
            LeftOpen: if the search ends without an answer, for example at a limit.
        """
        programs = tuple(self.request.explorers)
        if len(programs) not in (1, len(finding.starts)):
            raise OtherText(f"{len(programs)} programs for {len(finding.starts)} robots")
        asked = request_again(finding, programs, self.request, self.scope.model)
        limits = values_of(Limits, self.request)
        within = doc.replace(asked, configurations=self.request.configurations, **limits)
        report = searched(within).uninterrupted()
        if report.findings:
            return doc.replace(report.findings[0], minimal=False)
        if report.verdict is not outcome.Verdict.HOLDS:
            raise LeftOpen(report.ending.reason)
        return None

    @override
    def conclude(self, ending: outcome.Ending) -> outcome.Ending | None:
        """Write the new findings into the user's corpus; return None, which keeps the ending.

        For each file that cannot be written, the report gets a remark, and the listener is told.
        """
        if self.corpus is not None:
            for lost in self.corpus.write(self._tally.findings):
                self._tally.remarks[lost] += 1
                self.listener.notice(lost)
        return None

    @override
    def finish(self, level: units.SweptLevel, total: TeamTally) -> outcome.Ending | None:
        whole = self.portion == units.WHOLE
        total.findings = [doc.replace(found, minimal=whole) for found in total.findings]
        self._tally.add(total)
        self._levels.append(level.edges)
        if whole:
            self._gate += gate_of(self.extent, level.edges, total)
        if not all(cell.agrees for cell in self._gate):
            return outcome.Disagreed("a fault of allworlds: the maps are wrong, as the gate says")
        found = len(self._tally.findings)
        if found >= self.scope.keep and level.edges != self.extent.levels[-1]:
            return outcome.Stopped(f"ended after {plural(found, 'finding')}", final=True)
        return None

    @override
    def leave(self, level: units.SweptLevel, total: TeamTally) -> None:
        """Add the findings of an unfinished level to those of the job; its counts are dropped.

        ``total`` is the tally of the part of the level that was done.
        """
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
            past=self.corpus,
        )


def gate_of(extent: Extent, edges: int, tally: TeamTally) -> Iterator[TeamCell]:
    """Compare the numbers of a level's maps with those of an independent source.

    The level has the maps of ``extent`` with ``edges`` edges, and ``tally`` its counts.  Yield a
    comparison for each number of vertices; yield none if no source counts the maps of ``extent``.
    """
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


# ---------------------------------------------------------------- findings of earlier searches


def _read(text: str) -> TeamFinding:
    return TeamFinding.from_json(parse_json(text))


def request_again(
    finding: TeamFinding,
    programs: Sequence[str | Callable[..., Any]],
    limits: TimeoutOptions,
    here: NamedModel | None = None,
) -> TeamRequest:
    """The request that searches the world of a finding again, with these programs.

    The finding names its model.  If the model ``here`` of the present job has this name, ``here``
    is used, because a model that the user gave as an object cannot be loaded by its name.
    Otherwise the model is loaded by its name.

    Args:
        finding: the finding.
        programs: one program for all robots, or one for each.
        limits: the time-outs of the programs.
        here: the model of the present job; None if there is no job.

    Raises:
        InputError: if the model cannot be found, or its text is not the recorded one.
    """
    time = finding.time
    known = here is not None and here.name == finding.model
    model = here if here is not None and known else named_model(finding.model)
    if model.digest != finding.model_digest:
        raise OtherText(f"the model {show(finding.model)} has another text than the recorded one")
    return TeamRequest(
        explorers=programs,
        model=model,
        robots=len(finding.starts),
        scheduler=time.scheduler,
        budget=time.budget,
        within=time.budget if time.within else None,
        lead=time.lead,
        start_delay=time.start_delay,
        world=json.dumps({"sigma": finding.sigma, "alpha": finding.alpha}),
        starts=finding.starts,
        **values_of(TimeoutOptions, limits),
    )


def is_inside(finding: TeamFinding, scope: TeamScope) -> bool:
    """Whether the searches of a scope include the search that made a finding.

    They do if the model, the number of robots and the schedules of the scope are those of the
    finding, and if the scope tries the finding's map with the robots at the finding's starts.
    """
    own = scope.model.name, scope.model.digest, len(scope.team.names), TimeDocument.of(scope.timing)
    starts = finding.starts
    if own != (finding.model, finding.model_digest, len(starts), finding.time):
        return False
    there = _place(finding.map, starts)
    for map_ in _rooted_like(finding.map, scope.extent):
        world = ModelInMap(scope.model.model, map_, scope.model.name)
        if any(_place(map_, each) == there for each in scope.starts_in(world)):
            return True
    return False


def _place(map_: CombinatorialMap, starts: Sequence[int]) -> Any:
    """A value that says where the robots start in a map, whatever the names of the darts are.

    ``starts`` has the dart of each robot at the start.  Two such values are equal if and only if an
    isomorphism of the two maps takes the start of each robot to the start of the same robot.
    """
    return rooted_code(map_.sigma, map_.alpha, starts[0]), renamed(map_, starts)


def _rooted_like(map_: CombinatorialMap, extent: Extent) -> Iterator[CombinatorialMap]:
    """Yield all rooted maps of an extent that are ``map_`` with a root, and perhaps other maps.

    First: the extent is a class of maps.  If ``map_`` is in the extent, it is yielded with each of
    its darts as the root, once for each class of isomorphic rooted maps; otherwise nothing is
    yielded.  Second: the extent consists of given maps.  All given maps with as many edges as
    ``map_`` are yielded, without a comparison with ``map_``; so the caller must compare them.
    """
    if extent.given is not None:
        for unit in units.units_of_level(extent, map_.edge_count, units.WHOLE):
            yield from unit.maps(extent)
    elif extent.include(map_):
        codes = {rooted_code(map_.sigma, map_.alpha, dart): None for dart in map_.darts}
        yield from (CombinatorialMap(*code) for code in codes)
