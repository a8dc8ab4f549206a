"""The texts of ``merge`` and ``status``."""

from __future__ import annotations

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
    identity = standing.identity
    done, all_ = standing.units
    worlds, of = standing.worlds
    lines = entry("state", standing.state, width)
    what = f"{identity.verb} {identity.explorer['name']}".strip()
    bounds = ", ".join(
        plural(identity.parameters[name], one, many)
        for name, one, many in (("edges", "edge", ""), ("vertices", "vertex", "vertices"))
        if identity.parameters.get(name) is not None
    )
    shard = f"; shard {identity.shard}" if identity.shards > 1 else ""
    lines += entry(
        "job", f"{what}: class {identity.parameters['class']}, at most {bounds}{shard}", width
    )
    lines += entry("units", f"{number(done)} of {number(all_)}", width)
    about = "about " if identity.shards > 1 else ""
    lines += entry("worlds", f"{number(worlds)} of {about}{number(of)}", width)
    if standing.rate is not None:
        lines += entry("rate", f"{number(round(standing.rate))} worlds a second", width)
    if standing.left:
        lines += entry("left", f"{duration(standing.left)}, at this rate: a guess", width)
    if standing.worst:
        worst = standing.worst
        where = size(worst.edges, worst.vertices)
        lines += entry("worst", f"{number(worst.cost)} traversals so far, with {where}", width)
    if standing.findings:
        lines += entry("findings", f"{number(standing.findings)} so far", width)
    return "\n".join(lines)
