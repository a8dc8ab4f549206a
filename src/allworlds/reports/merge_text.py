"""The texts of ``merge`` and ``status``."""

from __future__ import annotations

from allworlds.engines import WHOLE
from allworlds.reports.rendering import brief, text
from allworlds.reports.text_layout import entry
from allworlds.studies.merge import MergedReport
from allworlds.studies.status import Standing
from allworlds.words import duration, number, plural, size


def merge_text(merged: MergedReport, width: int) -> str:
    """What the verb itself would say."""
    return text(merged.verb, merged.report, width)


def merge_line(merged: MergedReport, width: int) -> str:
    """What it would say with ``--quiet``."""
    return brief(merged.verb, merged.report, width)


def status_text(standing: Standing, width: int) -> str:
    """How far it is, how fast, and what has been met."""
    units, worlds, told = standing.units, standing.worlds, standing.parameters
    lines = entry("state", standing.state, width)
    what = f"{standing.verb} {standing.explorer}".strip()
    bounds = ", ".join(
        plural(told[name], one, many)
        for name, one, many in (("edges", "edge", ""), ("vertices", "vertex", "vertices"))
        if told.get(name) is not None
    )
    whole = standing.shard == str(WHOLE)
    shard = "" if whole else f"; shard {standing.shard}"
    lines += entry("job", f"{what}: class {told['class']}, at most {bounds}{shard}", width)
    lines += entry("units", f"{number(units.done)} of {number(units.all)}", width)
    about = "" if whole else "about "
    lines += entry("worlds", f"{number(worlds.done)} of {about}{number(worlds.all)}", width)
    if standing.rate is not None:
        lines += entry("rate", f"{number(round(standing.rate))} worlds a second", width)
    if standing.left_s:
        lines += entry("left", f"{duration(standing.left_s)}, at this rate: a guess", width)
    if standing.worst:
        worst = standing.worst
        where = size(worst.edges, worst.vertices)
        lines += entry("worst", f"{number(worst.cost)} traversals so far, with {where}", width)
    if standing.findings:
        lines += entry("findings", f"{number(standing.findings)} so far", width)
    return "\n".join(lines)
