"""The base of requests and reports of studies that go through units, and the count gate."""

from collections.abc import Sequence
from typing import Annotated, Any, TypeAlias, get_args

from typing_extensions import override

from allworlds.documents import document as doc
from allworlds.engines import units
from allworlds.engines.limits import TimeLimitOptions
from allworlds.engines.sweep import By
from allworlds.engines.units import ShardOptions
from allworlds.inputs.checks import a_word
from allworlds.inputs.requests import OUTPUT, Converted, Option, Request
from allworlds.maps import classes, count_source
from allworlds.studies.options import ClusterOptions, ListenerOptions, RunDirectoryOptions
from allworlds.studies.reports import EndedReport, RowsReport


class SweptOptions(
    ListenerOptions,
    ClusterOptions,
    RunDirectoryOptions,
    TimeLimitOptions,
    ShardOptions,
):
    """The part of a request with listener, Dask cluster, run directory, time limit and shard."""


_by = a_word("by", get_args(By))


class RowOptions(Request):
    """The part of a request that chooses what one row of a CSV file is about."""

    by: Annotated[
        Converted[str | None, By | None],
        Option(
            OUTPUT,
            "size|world|run",
            "Rows of -o FILE.csv: one for each size, world, or run, and explorer [default: size; "
            "of worlds that grow: run].",
            apart=True,
        ),
    ] = Converted(lambda given: None if given is None else _by(given), None)


class Gate(doc.Document):
    """A count gate: the comparison of every count with an independent source."""

    source: Annotated[doc.Text, doc.about("the independent source of the counts")]
    agrees: Annotated[bool, doc.about("whether each count equals the source's")]


ToldGate: TypeAlias = Annotated[
    Gate | None,
    doc.about(
        "the comparison of the rows with an independent source, of a shard as far as it goes; "
        "null: there is no source, or no row"
    ),
]


class PortionReport(EndedReport):
    """A report of a job that goes through worlds: of the whole job, or of one shard of it.

    ``request`` is the answered request; ``extent`` is the class of maps with its bounds, or the
    given maps.
    """

    request: doc.NotInDocument[Any]
    extent: doc.NotInDocument[classes.Extent]

    @property
    def portion(self) -> units.Shard:
        """The shard that the report is about; ``WHOLE`` stands for the whole job."""
        portion: units.Shard = self.request.shard
        return portion

    @property
    @override
    def whole(self) -> bool:
        return self.portion == units.WHOLE


class SweptReport(PortionReport, RowsReport):
    """A report with rows about worlds, level by level, or about a shard of these worlds."""

    @doc.computed
    def stopped(self) -> doc.Why:
        """The reason why rows are missing; None if none is missing, or the user interrupted."""
        return self.ending.stopped

    @property
    @override
    def empty(self) -> bool:
        return not self.rows

    @property
    def rows(self) -> Sequence[Any]:
        """The rows of the finished levels; each subclass has them as a key of its document."""
        raise NotImplementedError

    @property
    def source(self) -> str:
        """The name of the independent source of the counts; empty if there is none."""
        source = count_source.source_of(self.extent)
        return source.name if source else ""

    @property
    def compared(self) -> Gate | None:
        """The count gate; None if no source counts the worlds, or there are no rows to compare."""
        some = self.source and (self.rows or not self.agrees)
        return Gate(source=self.source, agrees=self.agrees) if some else None
