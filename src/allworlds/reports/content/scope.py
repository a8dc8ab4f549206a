"""Words for the scope of a report: the maps, the places of the lighthouse, the other options."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, TypeAlias

from allworlds import words
from allworlds.documents import document as doc
from allworlds.engines import units
from allworlds.inputs.requests import given_again
from allworlds.maps.classes import Extent, MapSource
from allworlds.studies.check.report import CheckReport
from allworlds.studies.scopes import tried_places
from allworlds.studies.swept import SweptReport

if TYPE_CHECKING:
    from allworlds.studies.compare.entrants import ContestReport

OfWorlds: TypeAlias = SweptReport | CheckReport
"""A report about the worlds of a class of maps of bounded size."""

SAID = (
    *("edges", "vertices", "map_class", "where", "lighthouse", "policy", "bound"),
    *("family", "holes", "seed", "worlds", "graph", "embeddings"),
)
"""The fields of requests that the functions of this module describe in words."""


def of_the_class(extent: Extent, least: int = 1) -> str:
    """The class in words, such as ``of the class 'maps', trees, with at most 3 edges``.

    The condition, in this example ``trees``, follows the class.  ``least`` is the smallest number
    of edges.
    """
    where = f", {extent.where.name}," if extent.where else ""
    most = extent.edges
    if extent.given is not None and most == max(extent.given.starts):
        most = None
    limits = [f"at most {words.plural(most, 'edge')}"] if most else []
    if most and least > 1:
        limits = [f"{least} to {words.plural(most, 'edge')}"]
    if extent.vertices:
        limits.append(f"at most {words.plural(extent.vertices, 'vertex', 'vertices')}")
    bounds = f" with {' and '.join(limits)}" if limits else ""
    return f"of the class '{extent.map_class}'{where}{bounds}"


def each_of(given: MapSource) -> str:
    """The given worlds in words: ``each of 3 maps of plan.json``, ``the map of plan.json``."""
    return f"each of {given.words}" if given.count > 1 else f"the {given.words.removeprefix('1 ')}"


def maps_in_words(report: OfWorlds, every: str = "every rooted map") -> str:
    """The maps of a report in words, with the shard if the report is about a shard.

    If the report is about worlds that the user gave, the result names their origin.  Otherwise the
    report is about a class of maps, and ``every`` is the text that stands before the class.
    """
    shard = f", shard {report.portion}" if report.portion != units.WHOLE else ""
    given = report.extent.given
    maps = every if given is None else f"every start in {each_of(given)}"
    return f"{maps} {of_the_class(report.extent)}{shard}"


def finished(report: SweptReport, last: int) -> str:
    """The maps of the finished levels in words; ``last`` is the last finished level."""
    extent = report.extent
    return of_the_class(extent if report.complete else doc.replace(extent, edges=last))


def explorer_facts(report: ContestReport) -> list[tuple[str, str]]:
    """Facts about each explorer of a comparison; a fact that does not apply has an empty sentence.

    The facts are: the lighthouse, the policy and the bound; the places of the lighthouse, unless
    all are tried; and the warning of :func:`trust`.
    """
    facts = []
    for one in report.entrants:
        rules = one.rules
        how = f"lighthouse {rules.lighthouse}, policy {rules.policy}, bound {rules.the_bound}"
        facts.append(("explorer", f"{one.name}: {how}"))
        facts.append(("places", tried_places(rules.lighthouse, report.extent)))
        facts.append(("trust", trust(rules.shared_file)))
    return facts


def trust(file: str) -> str:
    """A warning that the file ``file`` has both an explorer and code that judges the explorer.

    Code that judges is, for example, a user's task or lighthouse.  If ``file`` is empty, no file
    has both, and the warning is empty, too.
    """
    return file and f"{file} holds the explorer, and code that judges it: see docs/trust.md"


def left_out(worlds: int, among: str = "") -> str:
    """A text about the worlds without a place for the lighthouse; empty if there are none.

    ``worlds`` is the number of these worlds; ``among`` is a text that follows their number, such as
    ``" of 120"`` if there are 120 worlds in all.
    """
    return f"{words.plural(worlds, 'world')}{among}: no place for the lighthouse" if worlds else ""


def option_facts(report: OfWorlds, said: Iterable[str]) -> list[tuple[str, str]]:
    """A fact with the options that were given; no fact if no option is left.

    The options whose fields are named in ``said`` are left out, since other facts describe them.
    """
    given = given_again(type(report.request), report.request, but=said)
    return [("options", " ".join(given))] if given else []


def miscount(edges: int, vertices: int, met: int, source: str, counted: int) -> str:
    """A sentence about maps of one size: the enumeration met ``met`` maps, not ``counted``.

    ``counted`` is the number of these maps by the independent source ``source``.
    """
    maps = f"{words.plural(met, 'map')} with {words.size(edges, vertices)}"
    return f"the enumeration found {maps}, but the independent count ({source}) is {counted}"


def gate_facts(report: Any, what: str, *, is_compared: bool) -> list[tuple[str, str]]:
    """One fact about the count gate: that the counts agree, or the reason why none was compared.

    This function is not called if counts differ; then :func:`miscount` makes the sentence.

    Args:
        report: the report of a job or of a shard, with the source of its counts.
        what: the name of what was counted.
        is_compared: whether the counts of at least one level were compared; the gate compares the
            counts of each finished level.
    """
    if report.extent.given is not None:
        said = report.extent.given.gate
    elif not report.source:
        said = f"absent: no formula counts the maps that are {report.extent.where}"
    elif not report.whole:
        said = "not for a shard: the merge of all shards compares the counts"
    elif is_compared:
        said = f"no {what} was forgotten: {words.counted(report.source)}"
    else:
        said = "no level was finished, so nothing was compared"
    return [("gate", said)]
