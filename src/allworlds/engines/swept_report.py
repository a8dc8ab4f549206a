"""Reports of jobs that may end early, and of those that go through worlds."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, Literal, Self, TypeAlias, TypeVar

from typing_extensions import override

from allworlds.document.report import Report
from allworlds.document.struct import (
    AllRows,
    Document,
    IfAny,
    NotInDocument,
    Positive,
    Text,
    Why,
    about,
    computed,
)
from allworlds.engines.units import WHOLE, Portion
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import OUTPUT, Converted, Option, Request, as_json, in_scope
from allworlds.maps.classes import Extent
from allworlds.maps.count_source import source_of
from allworlds.outcome import Completed, Disagreed, Ending, Facts, Interrupted, Stopped

if TYPE_CHECKING:
    from allworlds.judging.findings.rules import Rules
    from allworlds.world.lighthouses.kinds import LighthouseKind


class EndedReport(Report):
    """A report of what was finished when a job came to its ``ending``."""

    ending: NotInDocument[Ending]

    @property
    def portion(self) -> Portion:
        """The part of the job that was to be done."""
        return WHOLE

    @property
    def whole(self) -> bool:
        """Whether it is about all of the job, and not a shard of it."""
        return self.portion == WHOLE

    @property
    def agrees(self) -> bool:
        """Whether the numbers agree with what they were compared with."""
        return True

    @property
    def refuted(self) -> bool:
        """Whether a law is broken, or something is not as it should be."""
        return False

    @property
    def undecided(self) -> bool:
        """Whether something was left undone by which the answer could be another one."""
        return isinstance(self.ending, Stopped)

    @property
    def empty(self) -> bool:
        """Whether there was nothing to be answered."""
        return False

    @property
    def interrupted(self) -> bool:
        """Whether the user interrupted the job."""
        return isinstance(self.ending, Interrupted)

    def uninterrupted(self) -> Self:
        """Return this report, for callers that can do nothing with a part of it.

        Raises:
            KeyboardInterrupt: if it was interrupted; who made it has kept that to itself.
        """
        if self.interrupted:
            raise KeyboardInterrupt
        return self

    @property
    @override
    def facts(self) -> Facts:
        return Facts(
            disagrees=not self.agrees or isinstance(self.ending, Disagreed),
            interrupted=self.interrupted,
            refuted=self.refuted,
            undecided=self.undecided,
            vacuous=self.whole and self.empty,
        )


class RowsReport(EndedReport):
    """A report with rows of all that was finished."""

    @computed
    def complete(self) -> AllRows:
        """Whether every row is there."""
        return isinstance(self.ending, Completed | Disagreed)


By: TypeAlias = Literal["size", "world", "run"]
"""Rows for programs: one for each size, each world, or each run, and explorer."""


def by_named(given: str | None) -> By | None:
    """The word, or None.

    Raises:
        InputError: naming another word.
    """
    if given in (None, "size", "world", "run"):
        return given  # type: ignore[return-value]  # one of these
    raise InputError(f"by {show(given)} is not one of size, world, run")


class RowOptions(Request):
    """The part of a request that says for what there are rows."""

    by: Annotated[
        Converted[str | None, By | None],
        Option(
            OUTPUT,
            "size|world|run",
            "Rows of -o FILE.csv: one for each size, world, or run, and explorer [default: size; "
            "of worlds that grow: run].",
            apart=True,
        ),
    ] = Converted(by_named, None)


TriedPlaces = Annotated[
    IfAny[Text | None],
    about("the places of the lighthouse that were tried; where it is left out, every one"),
]
"""A key of every scope with a lighthouse."""


def tried_places(kind: LighthouseKind, extent: Extent) -> str:
    """The places of a lighthouse that are tried in an extent, in words; empty: every place."""
    return kind.as_class.tried_in_maps_of(extent.levels[-1])


FileDigests: TypeAlias = Annotated[
    IfAny[dict[str, Text] | None], about("the SHA-256 of each file of given worlds")
]
GivenCount: TypeAlias = Annotated[
    IfAny[Positive | None], about("how many worlds were given; where it is left out, none")
]


def given_of(request: object) -> dict[str, Any]:
    """The keys of a scope that tell of given worlds."""
    given = getattr(request, "given", None)
    return given.described if given else {"sha256": None, "given": None}


Scope_ = TypeVar("Scope_", bound=Document)


def told_scope(
    kind: type[Scope_], request: object, rules: Rules | None = None, **more: Any
) -> Scope_:
    """The scope of a document: what was asked, as it took effect.

    Args:
        kind: the class of the scope.
        request: whose options stand there by their names.
        rules: in place of options of rules, if runs were judged.
        more: further keys, or other values.
    """
    keys = {*kind.__struct_fields__}
    asked = {one.name: as_json(getattr(request, one.name)) for one in in_scope(type(request))}
    told = {**asked, **(rules.in_effect if rules else {}), **given_of(request)}
    return kind(**({name: told[name] for name in told if name in keys} | more))


class Gate(Document):
    """A count gate: the comparison of every count with an independent source."""

    source: Annotated[Text, about("the independent source of the counts")]
    agrees: Annotated[bool, about("whether each count equals the source's")]


ToldGate: TypeAlias = Annotated[
    Gate | None,
    about(
        "the comparison of the rows with an independent source, of a shard as far as it goes; "
        "null: there is no source, or no row"
    ),
]


class SweptReport(RowsReport):
    """A report about the worlds of an ``extent``; the ``request`` says what was asked."""

    request: NotInDocument[Any]
    extent: NotInDocument[Extent]

    @computed
    def stopped(self) -> Why:
        """Reason why rows are missing."""
        return self.ending.stopped

    @property
    @override
    def portion(self) -> Portion:
        portion: Portion = self.request.shard
        return portion

    @property
    @override
    def empty(self) -> bool:
        return not getattr(self, "rows", ())

    @property
    def source(self) -> str:
        """The name of the independent source of the counts; empty if there is none."""
        source = source_of(self.extent)
        return source.name if source else ""

    @property
    def compared(self) -> Gate | None:
        """The count gate, if there is anything to compare."""
        rows: Any = getattr(self, "rows", ())
        some = self.source and (rows or not self.agrees)
        return Gate(source=self.source, agrees=self.agrees) if some else None
