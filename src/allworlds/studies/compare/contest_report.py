"""Reports of contests: what those in the same worlds, and in worlds that grow, have in common."""

from __future__ import annotations

from typing import Annotated, Any

from typing_extensions import override

from allworlds.document.struct import (
    EXIT_CODE,
    Aside,
    Document,
    Some,
    Text,
    WhichShard,
    about,
    computed,
    replace,
)
from allworlds.engines.swept_report import (
    By,
    SweptExit,
    SweptReport,
    TriedPlaces,
    by_named,
    told_scope,
    tried_places,
)
from allworlds.judging.findings.finding import Finding
from allworlds.judging.findings.rules import AskedRules
from allworlds.outcome import Verdict
from allworlds.studies.check.requests import SharedFile
from allworlds.studies.compare.compare_request import AskedContestWorlds
from allworlds.studies.compare.contestants import Contestant
from allworlds.world.selection import LighthouseOptions


class ComparedName(Document):
    """An explorer by its name."""

    name: Annotated[Text, about("the explorer's")]


class Compared(ComparedName, of=(LighthouseOptions, AskedRules)):
    """An explorer of a comparison, with the rules of its runs."""

    places: TriedPlaces
    shared_file: SharedFile


class ContestScope(Document, of=AskedContestWorlds):
    """The worlds of a comparison."""

    shard: WhichShard


class ContestReport(SweptReport):
    """The report of explorers that were run in the same worlds.

    ``contestants`` were run; rows for programs are wanted ``by`` world or run.
    """

    verdict: Annotated[Verdict, about("whether a run of any explorer broke a law")] = computed(
        lambda report: report.judged
    )
    exit_code: SweptExit = EXIT_CODE
    explorers: Annotated[Some[Compared], about("in the order in which they were named")] = computed(
        lambda report: tuple(report.compared_one(one) for one in report.contestants)
    )
    scope: Annotated[ContestScope, about("the worlds in which they were run")] = computed(
        lambda report: told_scope(ContestScope, report.request, shard=str(report.portion))
    )
    findings: Annotated[
        tuple[Finding, ...], about("the smallest of each explorer that broke a law")
    ] = ()
    contestants: Aside[tuple[Contestant, ...]]
    by: Aside[By | None] = None

    @property
    def judged(self) -> Verdict:
        """The verdict of these facts."""
        return self.facts.verdict

    @property
    @override
    def refuted(self) -> bool:
        return bool(self.findings)

    @property
    def names(self) -> list[str]:
        """The names of the explorers."""
        return [one.name for one in self.contestants]

    @override
    def records(self, by: str | None = None) -> list[dict[str, Any]]:
        """The rows of ``-o FILE.csv``, by the names of their columns, for ``pandas.DataFrame``.

        Args:
            by: ``size``, ``world`` or ``run``, as in the request; by default as was asked for.

        Raises:
            InputError: for another word, or for rows that were not kept.
        """
        found = self if by is None else replace(self, by=by_named(by))
        return super(ContestReport, found).records()

    def compared_one(self, one: Contestant) -> Compared:
        """The part of the document that tells of an explorer."""
        return Compared(
            name=one.name,
            **one.rules.told,
            places=tried_places(one.rules.lighthouse, self.extent),
            shared_file=one.rules.shared_file,
        )
