"""Findings of earlier checks, tried again before anything else."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Annotated

from msgspec import Struct, field

from allworlds.document.struct import Document, IfAny, Text, about
from allworlds.engines.effort import Limits
from allworlds.engines.lanes import workers_for
from allworlds.engines.scope import GivenWorlds, Scope
from allworlds.engines.single import played_again
from allworlds.engines.tally import RunCounter
from allworlds.explorers.loading import Subject
from allworlds.inputs.checks import InputError, show
from allworlds.judging.findings.finding import DIGITS, Finding, digest_of
from allworlds.judging.laws.law_table import LAWS
from allworlds.maps.classes import Extent, MapClass
from allworlds.protocol.user_code import OtherText


class UserCorpus(Struct):
    """A directory of findings in the course of one check.

    Attributes:
        directory: need not exist yet.
        reproduced: the files whose findings still stand, within the scope of the check.
        beyond: those that stand beyond it; they say nothing about the scope.
        fixed: the files whose worlds are no longer refuting; they are kept.
        stale: the files that were not tried, since their lighthouse or judge has another text now.
        written: the files that this check has added.
    """

    directory: Path
    reproduced: list[str] = field(default_factory=list)
    beyond: list[str] = field(default_factory=list)
    fixed: list[str] = field(default_factory=list)
    stale: list[str] = field(default_factory=list)
    written: list[str] = field(default_factory=list)
    _standing: list[Finding] = field(default_factory=list)

    def retry(self, subject: Subject, limits: Limits, scope: Scope) -> list[Finding]:
        """Run the explorer in every recorded world. Return the findings within the scope.

        Each finding is tried by itself, so that one that is lost does no harm to others.
        """
        for name, finding in self._past():
            found = _retry(finding, subject, limits)
            if found is None:
                self.fixed.append(name)
            elif is_inside(found, scope):
                self.reproduced.append(name)
                self._standing.append(found)
            else:
                self.beyond.append(name)
        return self._standing

    def _past(self) -> list[tuple[str, Finding]]:
        """The findings of the directory with the names of their files, smallest first.

        Raises:
            InputError: naming the file that cannot be read, is no finding, or has been changed
                since it was written.
        """
        past = list[tuple[str, Finding]]()
        for file in sorted(self.directory.glob("*.json")):
            said = f"corpus file {show(file.name)}"
            try:
                text = file.read_text(encoding="utf-8")
            except (OSError, UnicodeDecodeError) as error:
                reason = error.strerror if isinstance(error, OSError) else "it is no text"
                raise InputError(f"{said} cannot be read: {reason}") from None
            written = re.search(rf"-([0-9a-f]{{{DIGITS}}})\.json$", file.name)
            if written and written[1] != digest_of(text):
                raise InputError(f"{said} has been changed since it was written")
            try:
                past.append((file.name, Finding.from_json(text)))
            except OtherText:
                self.stale.append(file.name)
            except ValueError as error:
                raise InputError(f"{said}: {error}") from None
        return sorted(past, key=lambda each: (each[1].key, each[0]))

    @property
    def report(self) -> CorpusReport:
        """The part of the check's report about past findings."""
        return CorpusReport(
            directory=str(self.directory),
            reproduced=tuple(self.reproduced),
            beyond_scope=tuple(self.beyond),
            fixed=tuple(self.fixed),
            stale=tuple(self.stale),
            written=tuple(self.written),
        )

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
                    self.written.append(finding.file_name)

    def _write(self, finding: Finding) -> None:
        """Write a finding, unless it is there already: whole or not at all."""
        self.directory.mkdir(parents=True, exist_ok=True)
        path = self.directory / finding.file_name
        if path.exists():
            return
        draft = path.with_suffix(".tmp")
        try:
            draft.write_text(finding.text, encoding="utf-8")
            draft.replace(path)
        except OSError:
            draft.unlink(missing_ok=True)
            raise


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


def is_inside(finding: Finding, scope: Scope) -> bool:
    """Whether a check of that scope could have found this itself."""
    rules, own, world = scope.rules, finding.rules, finding.world
    return (
        scope.extent.include(world.map)
        and own.task == rules.task
        and world.lighthouse in rules.kind.places(world.map, world.start)
        and (finding.law not in LAWS or finding.law in rules.applying)
        and (finding.law != "bound" or own.the_bound.name == rules.the_bound.name)
        and (finding.law != "budget" or own.step_budget == rules.step_budget)
        and (scope.schedules == "all" or own.policy == rules.policy)
    )


def _retry(finding: Finding, subject: Subject, limits: Limits) -> Finding | None:
    # A recorded schedule other than the policy's own is met when all are tried.
    every = subject.takes_choices and finding.rules.policy == "fifo" and any(finding.choices)
    extent = Extent(MapClass.MAPS, finding.world.map.edge_count)
    scope = Scope(extent, finding.rules, "all" if every else "one")

    with workers_for(subject, limits, limits.deadline()) as workers:
        world = GivenWorlds(((finding.world, finding.place),))
        for part in workers.map(RunCounter(scope, keep=1), [world]):
            for found in part.result.findings:
                return played_again(found, subject, limits)
    return None
