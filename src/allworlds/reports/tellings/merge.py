"""Tellings of ``merge`` and ``status``."""

from __future__ import annotations

from allworlds.engines import WHOLE
from allworlds.reports.rendering import told
from allworlds.reports.telling import Section, ToldFacts, ToldResult
from allworlds.studies.merge import MergedReport
from allworlds.studies.status import Standing
from allworlds.words import duration, number, plural, size


def merge_telling(merged: MergedReport) -> ToldResult:
    """The telling of the verb whose shards were merged."""
    return told(merged.verb, merged.report)


def status_telling(standing: Standing) -> ToldResult:
    """Progress, rate, and results so far."""
    units, worlds, asked = standing.units, standing.worlds, standing.parameters
    what = f"{standing.verb} {standing.explorer}".strip()
    bounds = ", ".join(
        plural(asked[name], one, many)
        for name, one, many in (("edges", "edge", ""), ("vertices", "vertex", "vertices"))
        if asked.get(name) is not None
    )
    whole = standing.shard == str(WHOLE)
    shard = "" if whole else f"; shard {standing.shard}"
    facts: list[tuple[str, str]] = [("state", standing.state)]
    scope = [f"class {asked['class']}"] if "class" in asked else []
    scope += [f"at most {bounds}"] if bounds else []
    scope += [f"family {asked['family']}"] if asked.get("family") else []
    facts.append(("job", f"{what}: {', '.join(scope)}{shard}"))
    facts.append(("units", f"{number(units.done)} of {number(units.all)}"))
    about = "" if whole else "about "
    facts.append(("worlds", f"{number(worlds.done)} of {about}{number(worlds.all)}"))
    if standing.rate is not None:
        facts.append(("rate", f"{number(round(standing.rate))} worlds a second"))
    if standing.left_s:
        facts.append(("left", f"{duration(standing.left_s)}, at this rate: a guess"))
    if standing.worst:
        worst = standing.worst
        where = size(worst.edges, worst.vertices)
        facts.append(("worst", f"{number(worst.cost)} traversals so far, with {where}"))
    if standing.findings:
        facts.append(("findings", f"{number(standing.findings)} so far"))
    sections = [Section("seen", "", [ToldFacts(facts)])]
    return ToldResult("allworlds status", standing.verb, standing, None, sections)
