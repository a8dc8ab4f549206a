"""The common part of studies of one explorer in many worlds.

This module writes the name and digest of the explorer for a run directory, confirms findings, and
tries the findings of earlier checks again.
"""

import hashlib
import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from functools import partial
from typing import Any, TypeVar

from msgspec import Struct
from typing_extensions import override

from allworlds import outcome
from allworlds.documents.document import replace
from allworlds.engines import lanes, single, sweep, tally, units
from allworlds.engines.engine_table import Job
from allworlds.engines.kept_units import KeptUnits, canonical, from_kept
from allworlds.engines.limits import Limits, deadline_after
from allworlds.explorers import loading, sources
from allworlds.inputs import requests
from allworlds.judging.differences import nondeterministic
from allworlds.judging.findings.finding import Finding, labelled
from allworlds.judging.laws.law_table import LAWS
from allworlds.judging.referee import LOST
from allworlds.judging.rules import Among, RuleOptions, Rules
from allworlds.maps.classes import Extent, MapClass
from allworlds.studies.check import hints
from allworlds.studies.user_corpus import corpus_of
from allworlds.words import size

# ---------------------------------------------------------------- confirmed findings

LOCATED = 10
"""The number of findings, the smallest ones, that are shown with lines of the explorer's code."""

UNREPEATED = "what happened to the explorer was not repeated by a fresh process"


class Confirmation(Struct, frozen=True):
    """The confirmation of a job's findings: each finding is played again in a fresh process.

    Attributes:
        subject, limits, scope: the explorer, the limits and the scope of the job.
        deadline: the time, on the monotonic clock, after which findings are no longer played again;
            None: there is no such time.
        kept: the records in the run directory.  A confirmation that is recorded there is not
            repeated, so all reports of a job agree.
    """

    subject: loading.Subject
    limits: Limits
    scope: units.Scope
    deadline: float | None
    kept: KeptUnits

    def confirmed(self, findings: Iterable[Finding]) -> list[Finding]:
        """The findings, each played again in a fresh process."""
        return [
            self.replaced("confirmed", found, partial(self._again, number=number))
            for number, found in enumerate(findings)
        ]

    def settle(self, tally: tally.Tally, known: Callable[[Finding], bool] | None = None) -> bool:
        """Confirm the findings of a tally; return whether remarks have replaced some of them.

        If a fresh process does not repeat a crash or a time-out, and the machine may be its cause,
        the finding becomes a remark, which refutes nothing.  If the machine cannot be the cause,
        the finding becomes one of the law ``nondeterministic``.

        A finding for which the function ``known`` returns true stays in the tally as it is, and is
        not played again.  If ``known`` is None, every finding is played again.
        """
        kept, remarks = list[Finding](), list[str]()
        for found in tally.findings:
            settled: Finding | str = found
            if not (known and known(found)):
                settle = partial(self._settled, number=len(kept))
                settled = self._recorded("confirmed", found, settle)
            if isinstance(settled, str):
                remarks.append(settled)
            else:
                kept.append(settled)
        tally.findings = kept
        for remark in remarks:
            tally.remark(remark)
        return bool(remarks)

    def replaced(self, name: str, found: Finding, by: Callable[[Finding], Finding]) -> Finding:
        """The finding that the function ``by`` makes from the finding ``found``.

        The new finding is recorded in the run directory under ``name``.  If it is recorded there
        already, the recorded finding is returned, and ``by`` is not called.

        In two other cases ``by`` is not called, and ``found`` itself is returned.  First: nothing
        is recorded, and the deadline is past.  Second: there is a record, but it is a remark, which
        :meth:`settle` has recorded for ``found``; a remark is no finding, so it cannot be returned.
        """
        settled = self._recorded(name, found, by)
        return found if isinstance(settled, str) else settled

    @property
    def is_late(self) -> bool:
        """Whether the deadline is past."""
        return self.deadline is not None and time.monotonic() > self.deadline

    def _again(self, found: Finding, *, number: int) -> Finding:
        """The finding, played again, with hints.

        ``number`` is the number of findings before ``found``.  The first finding, number 0, gets
        all hints.  The next findings get only lines of code as hints.  From number :data:`LOCATED`
        on, findings get no hint.
        """
        again = single.played_again(found, self.subject, self.limits)
        if number == 0:
            return hints.hinted(again, self.subject, self.limits, self.scope)
        return hints.located(again, self.subject, self.limits) if number < LOCATED else again

    def _settled(self, found: Finding, *, number: int) -> Finding | str:
        """The finding, played again in a fresh process; or a remark that replaces it.

        If a crash or a time-out is not repeated, and the machine may be its cause, a remark
        replaces the finding.  If the machine cannot be the cause, the explorer is nondeterministic:
        then a finding of the law ``nondeterministic`` is returned.  ``number`` is the number of
        findings before ``found``.
        """
        again = self._again(found, number=number)
        if again.law not in LOST or not self.subject.importable or again.confirmed:
            return again
        if not again.machine:
            broken = nondeterministic(f"{again.law} here, but not in a fresh process: {again.seen}")
            return replace(
                again, law=broken.law, expected=broken.expected, seen=broken.seen, confirmed=True
            )
        where = f"a world with {size(*found.key[:2])}"
        return f"a {found.law} in {where} ({found.seen}) that a fresh process did not repeat"

    def _recorded(
        self, name: str, found: Finding, settle: Callable[[Finding], Finding | str]
    ) -> Finding | str:
        """The finding or remark that is recorded for ``found``; else the one that ``settle`` makes.

        What ``settle`` makes is recorded under ``name`` and a digest of ``found``.  If nothing is
        recorded and the deadline is past, ``found`` is returned, and ``settle`` is not called.
        """
        plain = replace(found, minimal=False)
        digest = hashlib.sha256(canonical(tally.finding_to_record(plain)).encode()).hexdigest()
        record: Any = self.kept.recall(f"{name} {digest}")
        if record is None:
            if self.is_late:
                return found
            settled = settle(plain)
            if isinstance(settled, str):
                record = {"remark": settled}
            else:
                record = {"finding": tally.finding_to_record(settled)}
            if not self.is_late:  # else it may have been given up
                self.kept.note(f"{name} {digest}", record)
        if "remark" in record:
            return str(record["remark"])
        again = tally.finding_from_record(record["finding"])
        return replace(again, under=self.scope.rules, minimal=found.minimal)


# ---------------------------------------------------------------- findings of earlier checks


def is_inside(finding: Finding, scope: units.Scope) -> bool:
    """Whether a check of this scope could make a finding with this world, law, task and policy."""
    rules, own, world = scope.rules, finding.rules, finding.world
    return (
        scope.extent.include(world.map)
        and (scope.extent.given is None or any(True for _ in scope.like(world)))
        and own.task == rules.task
        and world.lighthouse in rules.kind.places(world.map, world.start)
        and (finding.law not in LAWS or finding.law in rules.applying)
        and (finding.law != "bound" or own.the_bound.name == rules.the_bound.name)
        and (finding.law != "budget" or own.step_budget == rules.step_budget)
        and (scope.schedules == "all" or own.policy == rules.policy)
    )


def _retry(finding: Finding, subject: loading.Subject, limits: Limits) -> Finding | None:
    if finding.after:
        seed, earlier, script = finding.hash_seed, finding.earlier, finding.choices
        played = single.single_run(
            subject, finding.world, finding.rules, script, limits, seed, earlier
        )
        return played.finding and single.played_again(played.finding, subject, limits)
    # A recorded schedule other than the policy's own is met when all are tried.
    every = subject.takes_choices and finding.rules.policy == "fifo" and any(finding.choices)
    extent = Extent(MapClass.MAPS, finding.world.map.edge_count)
    scope = units.Scope(extent, finding.rules, "all" if every else "one")

    with lanes.workers_for(subject, limits, deadline_after(limits.time_limit)) as workers:
        world = units.GivenWorlds(((finding.world, finding.place),))
        for part in workers.map(tally.RunCounter(scope, keep=1), [world]):
            for found in part.result.findings:
                again = replace(found, world=labelled(found.world, [finding.world]))
                return hints.located(single.played_again(again, subject, limits), subject, limits)
    return None


# ---------------------------------------------------------------- the sweep


def rules_record(rules: Rules) -> dict[str, Any]:
    """The fields of the rules for which the explorer may be needed, for a run directory.

    With this record, :func:`rules_known` makes the rules without loading the explorer.  Otherwise
    the explorer is needed for these reasons: it can have a default lighthouse and a step budget of
    its own, which apply if the user names none; it can name a bound; and its file can hold code
    that judges.  The field ``promised``, which does not depend on the explorer, is recorded, too.
    """
    names = ("lighthouse", "step_budget", "promised", "own_bound", "shared_file")
    return {name: requests.as_json(getattr(rules, name)) for name in names}


def rules_known(request: Any, record: Mapping[str, Any]) -> Rules:
    """The rules of a request, made without loading its explorer.

    ``record``, made by :func:`rules_record`, has the options that may depend on the explorer.
    """
    names = [each.name for each in fields(RuleOptions)]
    asked = {name: getattr(request, name) for name in names}
    asked["step_budget"] = record["step_budget"]
    kept = {name: record[name] for name in ("promised", "own_bound", "shared_file")}
    among = Among.of(request.where)
    return Rules(record["lighthouse"], among=among, **kept, **asked)


def record_of(subject: loading.Subject) -> dict[str, Any]:
    """The name, the keywords and the digest of an explorer, which identify it in run directories.

    The keywords are the names of the arguments that the explorer's function takes besides the first
    percept; they are among ``choices``, ``told`` and ``notice``.  The digest is made from the
    explorer's code.

    Raises:
        InputError: if the code cannot be identified: the explorer exists only in this process, or
            its file cannot be found.
    """
    return {
        "name": subject.name,
        "keywords": sorted(subject.keywords),
        "digest": sources.content_digest(subject),
    }


def subject_of_record(record: Mapping[str, Any]) -> loading.Subject:
    """An explorer with the name and the keywords in a record, but without code, so it cannot run.

    A job whose runs are all done, such as a merge of shards, only names the explorer in its report.
    ``record`` is made by :func:`record_of`.
    """
    return loading.Subject(record["name"], frozenset(record["keywords"]))


Answer = TypeVar("Answer")


class TallySweep(sweep.Sweep[tally.Tally, Answer]):
    """The sweep of one explorer through many worlds.

    Args:
        request: the request.
        scope: the worlds, the rules and the schedules.
        subject: the explorer.
        keep: the number of findings to keep.
        extent: the class of maps with its bounds, or the given maps; None for a sample.

    Attributes:
        job: the job for an engine.
        corpus: the user's corpus of past and new findings; None without one.
    """

    def __init__(
        self,
        request: Any,
        scope: units.Scope,
        subject: loading.Subject,
        keep: int = 1,
        extent: Extent | None = None,
    ) -> None:
        super().__init__(request, extent)
        self.scope = scope
        self.narrowed = scope.extent
        notice = self.listener.notice
        self.job = Job(scope, subject, request.limits, keep, self.deadline, notice, request.dask)
        self.corpus = corpus_of(request.corpus, request.run, Finding.from_json)

    def retry_past(self, total: tally.Tally) -> outcome.Ending | None:
        """Try the user's earlier findings again; put those that are reproduced into ``total``.

        ``total`` gets at most ``job.keep`` findings, the largest number that the job keeps.  If it
        gets so many, return an ending, with which the job ends before it tries any world; otherwise
        return None.
        """
        job = self.job
        if self.corpus is not None:
            again = partial(_retry, subject=job.subject, limits=job.limits)
            past = self.corpus.retry(again, partial(is_inside, scope=self.scope))
            total.findings = past[: job.keep]
            if len(total.findings) >= job.keep:
                return outcome.Stopped("past findings stand")
        return None

    def keep_new(self, total: tally.Tally) -> None:
        """Write the new findings of ``total`` into the user's corpus, a directory of findings.

        For each finding that cannot be written, a remark is added to ``total``.
        """
        if self.corpus is not None:
            for lost in self.corpus.write(total.findings):
                total.remark(lost)
                self.listener.notice(lost)

    @override
    def parameters(self) -> dict[str, Any]:
        return {**requests.meant(self.request), **rules_record(self.scope.rules)}

    @override
    def explorer(self) -> dict[str, Any]:
        return record_of(self.job.subject)

    @override
    def empty(self) -> tally.Tally:
        return tally.Tally(self.job.keep)

    @override
    def read(self, kept: Any) -> tally.Tally:
        return from_kept(kept, tally.Tally).under(self.scope.rules)

    @override
    def costs(self, total: tally.Tally) -> Iterable[tuple[int, int, int]]:
        return total.costs_by_size

    @property
    def confirmation(self) -> Confirmation:
        """The object that confirms this sweep's findings."""
        job = self.job
        return Confirmation(job.subject, job.limits, self.scope, self.deadline, self.kept)
