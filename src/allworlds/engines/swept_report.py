"""Reports of studies that go through worlds, with their scope."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any, TypeAlias, TypeVar

from typing_extensions import override

from allworlds.document import (
    Aside,
    Document,
    ExitCode,
    IfAny,
    Text,
    Why,
    about,
    computed,
    one_of,
)
from allworlds.engines.ended_report import RowsReport
from allworlds.engines.units.shards import Portion
from allworlds.inputs import as_json, in_scope
from allworlds.judging import Rules
from allworlds.maps import Extent, source_name
from allworlds.outcome import (
    Exit,
)
from allworlds.world import LighthouseKind

TriedPlaces = Annotated[
    IfAny[Text | None],
    about("the places of the lighthouse that were tried; where it is left out, every one"),
]
"""A key of every scope with a lighthouse."""


def tried_places(kind: LighthouseKind, extent: Extent) -> str:
    """The places of a lighthouse that are tried in an extent, in words; empty: every place."""
    return kind.as_class.tried_in_maps_of(extent.levels[-1])


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
    told = {**asked, **(rules.told if rules else {})}
    return kind(**({name: told[name] for name in told if name in keys} | more))


SweptExit = Annotated[
    ExitCode,
    one_of(
        *(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERNAL),
        Exit.INTERRUPTED,
    ),
]
"""The exit codes of a study that goes through worlds, and judges runs there."""


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
GATE: Any = computed(lambda report: report.compared)
"""The key of a report that holds its count gate."""


STOPPED: Any = computed(lambda report: report.ending.stopped)
"""The key of a report that says why rows are missing."""


class SweptReport(RowsReport):
    """A report about the worlds of an ``extent``; the ``request`` says what was asked."""

    stopped: Why = STOPPED
    request: Aside[Any]
    extent: Aside[Extent]

    @property
    @override
    def portion(self) -> Portion:
        portion: Portion = self.request.shard
        return portion

    @property
    def _lines(self) -> Sequence[Any]:
        """The rows, whose type each report says by itself."""
        rows: Sequence[Any] = getattr(self, "rows", ())
        return rows

    @property
    @override
    def empty(self) -> bool:
        return not self._lines

    @property
    def source(self) -> str:
        """The name of the independent source of the counts; empty if there is none."""
        return source_name(self.extent)

    @property
    def compared(self) -> Gate | None:
        """The count gate, if there is anything to compare."""
        some = self.source and (self._lines or not self.agrees)
        return Gate(source=self.source, agrees=self.agrees) if some else None
