"""The request of a check; files that hold an explorer, and code that judges it."""

from collections.abc import Iterable
from pathlib import Path
from typing import Annotated, TypeAlias

from allworlds.document import Bounded, IfAny, about, replace
from allworlds.engines.limits import ClusterOptions, Limits, ListenerOptions, RunDirectoryOptions
from allworlds.engines.units import ShardOptions
from allworlds.explorers import loading, sources
from allworlds.inputs import checks, requests
from allworlds.judging.findings.rules import Among, RuleOptions, Rules
from allworlds.maps.classes import DEFAULT_EDGES, ClassOptions, Condition, Extent, ExtentOptions
from allworlds.protocol.choices import Schedule, a_schedule
from allworlds.world import selection, world

SharedFile: TypeAlias = Annotated[
    IfAny[str], about("the explorer's file, where judges load code from it, too: see trust")
]
"""A key of the scope of every verb that judges runs."""


def shared_file(explorer: str, rules: Rules, where: Condition | None) -> str:
    """The name of the explorer's file where code that judges it is loaded from it; else empty.

    Such code runs where verdicts are made, and could make one.
    """
    files = (*rules.files, *selection.files_of_condition(where))
    if not files:
        return ""
    theirs = {file.resolve() for file in sources.files_of_explorer(explorer)}
    return next((file.name for file in files if file in theirs), "")


class ManyWorlds(ListenerOptions, Limits, RuleOptions, selection.LighthouseOptions, ClassOptions):
    """Many worlds of a class, under rules, with an effort."""

    def rules(self, subject: loading.Subject) -> Rules:
        """The rules under which the explorer is run; its own lighthouse, if none is named.

        Raises:
            InputError: naming the offending option and what would be legal.
        """
        lighthouse = self.lighthouse or subject.lighthouse
        where = getattr(self, "where", None)
        rules = self.rules_of(
            subject, lighthouse, promised=self.map_class.planar, among=Among.of(where)
        )
        return replace(rules, shared_file=shared_file(subject.name, rules, where))


def _max_findings(given: object) -> int:
    number = checks.an_integer("max-findings", given)
    if number < 1:
        raise checks.InputError(f"max-findings {checks.show(number)} is not positive and finite")
    return number


class CheckRequest(
    RunDirectoryOptions,
    ClusterOptions,
    ManyWorlds,
    sources.ExplorerOptions,
    ShardOptions,
    selection.WhereOptions,
    ExtentOptions,
):
    """Request of ``check``: an explorer, worlds, rules and limits."""

    edges: Annotated[
        int | None,
        requests.Option(
            requests.SCOPE,
            "M",
            f"At most M edges (default, unless --vertices is given: {DEFAULT_EDGES}).",
            parse=checks.integer_of,
            document_type=Bounded,
        ),
    ] = None
    schedules: Annotated[
        requests.Converted[str, Schedule],
        requests.Option(
            requests.RARE_RULES,
            "one|all",
            "all: every sequence of choices, for an explorer that takes choices.",
            document_type=Annotated[Schedule, about("the policy's, or every sequence of choices")],
        ),
    ] = requests.Converted(a_schedule, "one")
    engine: Annotated[
        str,
        requests.Option(
            requests.RARE_EFFORT,
            "auto|python|kernel",
            "python judges in Python, kernel in compiled code; auto takes the faster one that can.",
        ),
    ] = "auto"

    worlds: Annotated[
        Iterable[world.World] | None,
        "Worlds to be tried, each once with its own lighthouse, in place of every world of the "
        "class; they are counted by no source.",
    ] = None

    max_findings: Annotated[
        requests.Converted[int, int],
        requests.Option(
            requests.RARE_EFFORT,
            "K",
            "Stop after the level with the K-th finding (the smallest of each law and map counts).",
            parse=checks.integer_of,
        ),
    ] = requests.Converted(_max_findings, 1)
    corpus: Annotated[
        str | Path | None,
        requests.Option(
            requests.RARE_EFFORT,
            "DIR",
            "A directory of findings, which are tried first; new ones are added to it.",
            apart=True,
        ),
    ] = None

    @property
    def extent(self) -> Extent:
        """Class and bounds; without a bound a check takes seconds.

        Raises:
            InputError: naming the offending bound and what would be legal.
        """
        unbounded = self.edges is None and self.vertices is None
        edges = DEFAULT_EDGES if unbounded else self.edges
        return Extent(self.map_class, edges, self.vertices, self.where)
