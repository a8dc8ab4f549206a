"""The request of ``fuzz``, and the sweep through a sample of random worlds."""

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Annotated

from typing_extensions import override

from allworlds.documents.document import Text, about
from allworlds.engines import lanes, single
from allworlds.engines.engine_table import ReadyEngine, players_for
from allworlds.engines.kept_units import Identity
from allworlds.engines.limits import Limits, TimeIsUp
from allworlds.engines.listeners import Listener
from allworlds.engines.tally import RunCounter, Tally
from allworlds.engines.units import (
    NumberedRun,
    Sample,
    Scope,
    Shard,
    ShardOptions,
    SweptLevel,
    UnitOfRuns,
)
from allworlds.explorers import loading
from allworlds.inputs.checks import InputError, integer_of, show
from allworlds.inputs.requests import RARE_SCOPE, SCOPE, Converted, Option, Request, answers
from allworlds.judging.findings.finding import Finding
from allworlds.judging.rules import Rules, law_names
from allworlds.maps.classes import Extent
from allworlds.maps.mixture import PARTS, default_mix, mix_named
from allworlds.outcome import Completed, Ending
from allworlds.studies.check.covered import features
from allworlds.studies.check.report import CheckReport
from allworlds.studies.check.tally_sweep import (
    TallySweep,
    rules_known,
    subject_of_record,
)
from allworlds.studies.fuzz.breeding import (
    BRED_PER_BLOCK,
    DRAWS_PER_BLOCK,
    Bred,
    bred,
    bred_of,
    is_bred_for,
)
from allworlds.studies.fuzz.given_maps import MapsRequest
from allworlds.studies.fuzz.sampling import SMALL, SMALL_RUNS, SmallBatch, batches, waves
from allworlds.studies.fuzz.shrinking import smallest_from
from allworlds.studies.options import ClusterOptions, RunDirectoryOptions
from allworlds.studies.user_corpus import CorpusOptions
from allworlds.world import world


class SampleOptions(Request):
    """The part of a request that says how random worlds are drawn: sizes, number, seed."""

    edges: Annotated[int, Option(SCOPE, "M", "At most M edges.", parse=integer_of)]
    mix: Annotated[
        Converted[Iterable[str] | None, tuple[str, ...] | None],
        Option(
            RARE_SCOPE,
            "NAMES",
            f"Draw only from these, with commas: {', '.join(PARTS)} [default: those of the class].",
            parse=law_names,
            document_type=Annotated[
                tuple[Text, ...], about("the distributions of the drawn worlds, in turn")
            ],
        ),
    ] = Converted(mix_named, None)
    min_edges: Annotated[
        int,
        Option(
            SCOPE,
            "L",
            "At least L edges; choose more than an exhaustive check has tried.",
            parse=integer_of,
        ),
    ] = 1
    runs: Annotated[int, Option(SCOPE, "R", "The number of worlds.", parse=integer_of)] = 1024
    seed: Annotated[int, Option(SCOPE, "S", "Which sample.", parse=integer_of)] = 0


class FuzzRequest(
    CorpusOptions, RunDirectoryOptions, ClusterOptions, ShardOptions, MapsRequest, SampleOptions
):
    """Request of ``fuzz``: an explorer, the sample, the rules of its runs, and the limits."""


@answers(FuzzRequest)
def fuzz(request: FuzzRequest) -> CheckReport:
    """Run an explorer in random worlds of up to ``edges`` edges; shrink a world that refutes it.

    The report is about a sample: its verdict is at best ``not-refuted``, and it is never complete.
    The sample depends on the class, ``where``, ``edges``, ``min_edges``, ``mix``, ``runs`` and
    ``seed`` alone.

    A few small worlds are tried first, to find out soon whether the explorer walks for ever.  If it
    breaks the law ``budget`` there, the search ends with this finding.  If it breaks another law
    there, this is ignored, because these worlds are not in the sample.

    Then come the random worlds, in waves.  The waves end after 16, 64, 256, ... runs, and the last
    one after ``runs`` runs.  The search ends after the first wave in which a run refutes the
    explorer.  For an explorer in Python, worlds are also bred from the random worlds, between the
    waves: see :func:`bred`.  A run in a bred world can refute the explorer, too, and then the
    search ends.

    Shrinking starts at the smallest refuting world, and may reach a world with fewer than
    ``min_edges`` edges; it ends at the time limit.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    subject = single.subject_of(request.explore, request.limits)
    scope = scope_of(request, request.rules(subject))
    return FuzzSweep(request, scope, subject).answer(request.run)


def scope_of(request: FuzzRequest, rules: Rules) -> Scope:
    """The scope of a request: the class of the worlds, their sample, and ``rules``.

    Raises:
        InputError: for numbers out of range.
    """
    extent = Extent(request.map_class, request.edges, where=request.where)
    mix = request.mix or default_mix(extent)
    sample = Sample(request.runs, request.seed, request.min_edges, request.shard, mix)
    if sample.min_edges > request.edges:
        least, most = show(sample.min_edges), show(request.edges)
        raise InputError(f"min-edges = {least} is more than edges = {most}")
    return Scope(extent, rules, coverage=sample)


class SampleCounter(RunCounter, frozen=True, kw_only=True):
    """The engine that counts the runs in drawn worlds and in bred worlds.

    A drawn world is a random world of the sample.  A bred world is a drawn world, or another bred
    world, after a few random changes.  The engine also counts the features, such as the genus, of
    the maps of these worlds.

    Attributes:
        subject, limits: the explorer, and the limits of its players; the explorer runs while
            worlds are bred.
    """

    subject: loading.Subject
    limits: Limits

    @override
    def runs(self, unit: UnitOfRuns, start: int = 0) -> Iterator[NumberedRun]:
        if isinstance(unit, Bred):
            return islice(bred(unit, self.scope, self.subject, self.limits), start, None)
        return super().runs(unit, start)

    @override
    def count_run(self, run: NumberedRun, tally: Tally) -> world.World | None:
        tally.covered.update(features(run.map))
        return super().count_run(run, tally)


class FuzzSweep(TallySweep[CheckReport]):
    """The sweep of a sample: it goes through the random worlds, and makes the report.

    In this sweep a *level* is a set of worlds that is finished before the next set begins.  There
    are three kinds of levels.

    - The first level is a few small worlds.  Findings there are kept only if they break the law
      ``budget``, because this level is for explorers that walk for ever.
    - The next levels are *waves* of random worlds.  Each wave is three times as large as all
      earlier waves together; the last one may be smaller.
    - If a wave completes a block of draws, and the lines of the explorer can be traced
      (:func:`is_bred_for`), a level of *bred* worlds follows: random worlds after a few random
      changes.

    A level with a kept finding is the last level.

    The report counts the finished runs of the waves, also those of an unfinished wave.  It does not
    count the runs in bred worlds, although it has the findings there.  It counts the runs in small
    worlds only if there is a kept finding.

    Args:
        request: the request.
        scope: the worlds and the rules.
        subject: the explorer.
    """

    verb, request_type = "fuzz", FuzzRequest

    def __init__(self, request: FuzzRequest, scope: Scope, subject: loading.Subject) -> None:
        super().__init__(request, scope, subject)
        self._tally, self._bred = self.empty(), 0

    @override
    @classmethod
    def known(cls, identity: Identity, portion: Shard, listener: Listener) -> "FuzzSweep":
        request = cls.request_of(identity, portion, listener)
        rules = rules_known(request, identity.parameters)
        subject = subject_of_record(identity.explorer)
        return cls(request, scope_of(request, rules), subject)

    @override
    def levels(self) -> Iterable[SweptLevel]:
        sample, edges = self.scope.coverage, self.request.edges
        assert isinstance(sample, Sample)
        subject, blocks = self.job.subject, 0
        if not sample.portion.index:
            small = [SmallBatch(sample.seed, sample.mix)]
            announced = SMALL_RUNS * sample.portion.count  # a shard tells of its part
            yield SweptLevel(min(SMALL, edges), announced, small, of=0)
        for begin, end in waves(sample.runs):
            yield SweptLevel(edges, end - begin, batches(sample, begin, end))
            until = end // DRAWS_PER_BLOCK
            if until > blocks and is_bred_for(subject):
                begins = range(blocks * DRAWS_PER_BLOCK, until * DRAWS_PER_BLOCK, DRAWS_PER_BLOCK)
                mine = [*bred_of(sample, begins)]
                yield SweptLevel(edges, 0, mine, of=len(mine) * BRED_PER_BLOCK)
                blocks = until

    @override
    def begin(self) -> Ending | None:
        """Try again the findings in the user's corpus, a directory of earlier findings.

        If a finding in the scope is reproduced, return the ending with which the job ends before it
        tries any world; otherwise, or without a corpus, return None.
        """
        return self.retry_past(self._tally)

    @override
    def ready(self) -> ReadyEngine:
        job = self.job
        counter = SampleCounter(self.scope, job.keep, subject=job.subject, limits=job.limits)
        return ReadyEngine(players_for(job), counter)

    @override
    def finish(self, level: SweptLevel, total: Tally) -> Ending | None:
        self.leave(level, total)
        self._bred += level.of or 0
        return Completed() if self._tally.findings else None

    @override
    def leave(self, level: SweptLevel, total: Tally) -> None:
        found = total.findings
        if level.of == 0:  # a finding in small worlds counts only if the explorer walks for ever
            found = total.findings = [one for one in found if one.law == "budget"]
        if level.of or (level.of == 0 and not found):  # bred worlds do not count, nor these
            total = Tally(total.keep, findings=found, remarks=total.remarks)
        self._tally.add(total)

    @override
    def conclude(self, ending: Ending) -> None:
        """Shrink and confirm the findings, and add them to the user's corpus.

        To shrink a finding is to search for findings in smaller worlds; this is done only if the
        job was completed, that is, if ``ending`` is ``Completed``.  To confirm a finding is to play
        its run again in a fresh process.  If the job has reproduced a finding of the corpus,
        nothing is confirmed or added.

        Raises:
            TimeIsUp: if there are findings, and the deadline is past after all this work; then
                perhaps not all findings have been shrunk and confirmed.  The caller catches the
                exception, and reports that the time limit was reached, together with the findings.
        """
        settled = self.confirmation
        if isinstance(ending, Completed):
            self._tally.findings = [
                settled.replaced("shrunk", found, self._shrunk) for found in self._tally.findings
            ]
        past = self.corpus is not None and any(map(self.corpus.holds, self._tally.findings))
        if not past:
            self._tally.findings = settled.confirmed(self._tally.findings)
            self.keep_new(self._tally)
        if self._tally.findings and settled.is_late:
            raise TimeIsUp  # it may have been given up

    def _shrunk(self, found: Finding) -> Finding:
        job = self.job
        with lanes.workers_for(job.subject, job.limits, self.deadline) as workers:
            return smallest_from(found, workers, self.scope)

    @override
    def report(self, ending: Ending) -> CheckReport:
        return CheckReport(
            **self.ended(ending, self.scope.extent),
            explorer=self.job.subject.name,
            engine="python",
            asked=self.scope,
            tally=self._tally,
            levels=(),
            past=self.corpus,
            offspring=self._bred,
            seconds=tuple(self.seconds),
        )
