"""The common part of studies of one explorer in many worlds.

How run directories know it, its findings confirmed, and findings of earlier checks.
"""

import hashlib
import re
import time
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import fields
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Any, TypeVar

from msgspec import Struct, field
from typing_extensions import override

from allworlds import outcome
from allworlds.documents.document import Document, IfAny, Text, about, replace
from allworlds.engines import lanes, single, sweep, tally, units
from allworlds.engines.engine_table import Job
from allworlds.engines.job_records import Records, canonical, from_kept
from allworlds.engines.limits import Limits, deadline_after
from allworlds.explorers import loading, sources
from allworlds.inputs import checks, requests
from allworlds.judging.differences import nondeterministic
from allworlds.judging.findings.finding import DIGITS, Finding, digest_of, labelled
from allworlds.judging.laws.law_table import LAWS
from allworlds.judging.referee import LOST
from allworlds.judging.rules import Among, RuleOptions, Rules
from allworlds.maps.classes import Extent, MapClass
from allworlds.protocol.user_code import OtherText
from allworlds.studies.check import hints

# ---------------------------------------------------------------- confirmed findings

LOCATED = 10
"""The number of findings, smallest first, of which lines of code are told."""

UNREPEATED = "what happened to the explorer was not repeated by a fresh process"


class Confirmation(Struct, frozen=True):
    """How the findings of a job are confirmed: each is played again in a fresh process.

    Attributes:
        subject, limits, scope: of the job.
        deadline: past it findings are left as they are.
        records: what is on record is believed, so that a finding is the same whoever reports it.
    """

    subject: loading.Subject
    limits: Limits
    scope: units.Scope
    deadline: float | None
    records: Records

    def confirmed(self, findings: Iterable[Finding]) -> list[Finding]:
        """The findings, each played again in a fresh process."""
        return [
            self.replaced("confirmed", found, partial(self._again, number=number))
            for number, found in enumerate(findings)
        ]

    def settle(self, tally: tally.Tally, known: Callable[[Finding], bool] | None = None) -> bool:
        """Confirm the findings of a tally. Return whether there is more to report than they say.

        A crash or a time-out that a fresh process does not repeat refutes nothing: it becomes a
        remark.  Those that are known already stay as they are.
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
        """The finding that replaces this one, recorded under the name."""
        settled = self._recorded(name, found, by)
        return found if isinstance(settled, str) else settled

    @property
    def is_late(self) -> bool:
        """Whether the deadline is past."""
        return self.deadline is not None and time.monotonic() > self.deadline

    def _again(self, found: Finding, *, number: int) -> Finding:
        """Confirm in a fresh process; find the lines of the first findings, and more of one."""
        again = single.played_again(found, self.subject, self.limits)
        if number == 0:
            return hints.hinted(again, self.subject, self.limits, self.scope)
        return hints.located(again, self.subject, self.limits) if number < LOCATED else again

    def _settled(self, found: Finding, *, number: int) -> Finding | str:
        """Confirm in a fresh process. A crash that is not repeated becomes a remark."""
        again = self._again(found, number=number)
        if again.law not in LOST or not self.subject.importable or again.confirmed:
            return again
        if not again.machine:
            broken = nondeterministic(f"{again.law}, and not in a fresh process: {again.seen}")
            return replace(
                again, law=broken.law, expected=broken.expected, seen=broken.seen, confirmed=True
            )
        size = f"{found.key[0]} edges and {found.key[1]} vertices"
        return (
            f"a {found.law} in a world with {size} ({found.seen}) that a fresh process did "
            "not repeat"
        )

    def _recorded(
        self, name: str, found: Finding, settle: Callable[[Finding], Finding | str]
    ) -> Finding | str:
        """The finding or remark on record, or a new one, which is then recorded.

        After the deadline nothing new is made.
        """
        plain = replace(found, minimal=False)
        digest = hashlib.sha256(canonical(tally.finding_to_record(plain)).encode()).hexdigest()
        record: Any = self.records.recall(f"{name} {digest}")
        if record is None:
            if self.is_late:
                return found
            settled = settle(plain)
            if isinstance(settled, str):
                record = {"remark": settled}
            else:
                record = {"finding": tally.finding_to_record(settled)}
            if not self.is_late:  # else it may have been given up
                self.records.note(f"{name} {digest}", record)
        if "remark" in record:
            return str(record["remark"])
        again = tally.finding_from_record(record["finding"])
        return replace(again, under=self.scope.rules, minimal=found.minimal)


# ---------------------------------------------------------------- findings of earlier checks


class CorpusOptions(requests.Request):
    """The part of a request that names the corpus."""

    corpus: Annotated[
        str | Path | None,
        requests.Option(
            requests.RARE_EFFORT,
            "DIR",
            "A directory of findings, which are tried first; new ones are added to it.",
            apart=True,
        ),
    ] = None


class UserCorpus(Struct):
    """A directory of findings in the course of one check.

    Attributes:
        directory: need not exist yet.
        files: their names, by the keys of :class:`CorpusReport`.
    """

    directory: Path
    files: dict[str, list[str]] = field(default_factory=lambda: defaultdict(list))
    _standing: list[Finding] = field(default_factory=list)

    def retry(self, subject: loading.Subject, limits: Limits, scope: units.Scope) -> list[Finding]:
        """Run the explorer in every recorded world. Return the findings within the scope.

        Each finding is tried by itself, so that one that is lost does no harm to others.
        """
        for name, finding in self._past():
            found = _retry(finding, subject, limits)
            if found is None:
                self.files["fixed"].append(name)
            elif is_inside(found, scope):
                self.files["reproduced"].append(name)
                self._standing.append(found)
            else:
                self.files["beyond_scope"].append(name)
        return self._standing

    def _past(self) -> list[tuple[str, Finding]]:
        """The findings of the directory with the names of their files, smallest first.

        Raises:
            InputError: naming the file that cannot be read, is no finding, or has been changed
                since it was written.
        """
        past = list[tuple[str, Finding]]()
        for file in sorted(self.directory.glob("*.json")):
            said = f"corpus file {checks.show(file.name)}"
            if not file.is_file():
                raise checks.InputError(f"{said} is no regular file; legal are findings")
            try:
                text = file.read_text(encoding="utf-8-sig")
            except (OSError, UnicodeDecodeError) as error:
                reason = error.strerror if isinstance(error, OSError) else "it is no text"
                raise checks.InputError(f"{said} cannot be read: {reason}") from None
            written = re.search(rf"-([0-9a-f]{{{DIGITS}}})\.json$", file.name)
            if written and written[1] != digest_of(text):
                raise checks.InputError(f"{said} has been changed since it was written")
            try:
                past.append((file.name, Finding.from_json(text)))
            except OtherText:
                self.files["stale"].append(file.name)
            except ValueError as error:
                raise checks.InputError(f"{said}: {error}") from None
        return sorted(past, key=lambda each: each[1].key)

    @property
    def report(self) -> "CorpusReport":
        """The part of the check's report about past findings."""
        keys = ("reproduced", "beyond_scope", "fixed", "stale", "written")
        files = {key: tuple(self.files[key]) for key in keys}
        return CorpusReport(directory=str(self.directory), **files)

    def holds(self, finding: Finding) -> bool:
        """Whether this is a past finding that was reproduced and confirmed."""
        return finding in self._standing

    def write(self, findings: Iterable[Finding]) -> Iterator[str]:
        """Write the new findings, and yield a line for each that could not be written."""
        for finding in findings:
            if not self.holds(finding):
                try:
                    self._write(finding)
                except OSError as error:
                    yield f"the corpus could not take {finding.file_name}: {error.strerror}"
                else:
                    self.files["written"].append(finding.file_name)

    def _write(self, finding: Finding) -> None:
        """Write a finding, unless it is there already: whole or not at all."""
        self.directory.mkdir(parents=True, exist_ok=True)
        path = self.directory / finding.file_name
        if path.exists():
            return
        with TemporaryDirectory(prefix=".allworlds-", dir=self.directory) as beside:
            draft = Path(beside) / path.name
            draft.write_text(finding.text, encoding="utf-8")
            draft.replace(path)


class CorpusReport(Document):
    """Findings of a corpus after a check: reproduced, fixed or written."""

    directory: Annotated[Text, about("the path of the corpus")]
    reproduced: Annotated[tuple[Text, ...], about("the files whose findings still stand")]
    beyond_scope: Annotated[
        tuple[Text, ...],
        about("findings that still stand but lie outside this check's scope; they refute nothing"),
    ]
    fixed: Annotated[
        tuple[Text, ...], about("the files whose worlds no longer refute; they are kept")
    ]
    stale: Annotated[
        IfAny[tuple[Text, ...]],
        about("the files that were not tried: their lighthouse or judge has another text now"),
    ]
    written: Annotated[tuple[Text, ...], about("the files that this check has added")]


def is_inside(finding: Finding, scope: units.Scope) -> bool:
    """Whether a check of that scope could have found this itself."""
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
    """Record of those rules that may come from the explorer."""
    names = ("lighthouse", "step_budget", "promised", "own_bound", "shared_file")
    return {name: requests.as_json(getattr(rules, name)) for name in names}


def rules_known(request: Any, record: Mapping[str, Any]) -> Rules:
    """The rules of a request of many worlds, under a condition, with this record."""
    names = [each.name for each in fields(RuleOptions)]
    asked = {name: getattr(request, name) for name in names}
    asked["step_budget"] = record["step_budget"]
    kept = {name: record[name] for name in ("promised", "own_bound", "shared_file")}
    among = Among.of(request.where)
    return Rules(record["lighthouse"], among=among, **kept, **asked)


def record_of(subject: loading.Subject) -> dict[str, Any]:
    """Record of an explorer, identified by its content.

    Raises:
        InputError: if it cannot be.
    """
    return {
        "name": subject.name,
        "keywords": sorted(subject.keywords),
        "digest": sources.content_digest(subject),
    }


def subject_of_record(record: Mapping[str, Any]) -> loading.Subject:
    """The explorer of such a record. Its code is not loaded, because its results are known."""
    return loading.Subject(record["name"], frozenset(record["keywords"]))


Answer = TypeVar("Answer")


class TallySweep(sweep.Sweep[tally.Tally, Answer]):
    """The sweep of one explorer through many worlds.

    Args:
        request: what was asked for.
        scope: the worlds, the rules and the schedules.
        subject: the explorer.
        keep: how many findings are kept.
        extent: the worlds, where they are all of a class.

    Attributes:
        job: all of that, for an engine.
        corpus: where past findings are and new ones go; None without one.
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
        named = request.corpus
        self.corpus = None if named is None else UserCorpus(checks.a_path("corpus", named))
        if named is not None and request.run is not None:
            raise checks.InputError(
                f"corpus {checks.show(str(named))} cannot be given with run "
                f"{checks.show(str(request.run))}: what is in the one would change what the other "
                "keeps; give one of them"
            )

    def retry_past(self, total: tally.Tally) -> outcome.Ending | None:
        """Try past findings. Those that stand are in the total; enough of them end the job."""
        job = self.job
        if self.corpus is not None:
            past = self.corpus.retry(job.subject, job.limits, self.scope)
            total.findings = past[: job.keep]
            if len(total.findings) >= job.keep:
                return outcome.Stopped("past findings stand")
        return None

    def keep_new(self, total: tally.Tally) -> None:
        """Add new findings to the corpus; a remark tells what it could not take."""
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
        """The confirmation of this sweep's findings."""
        job = self.job
        return Confirmation(job.subject, job.limits, self.scope, self.deadline, self.records)
