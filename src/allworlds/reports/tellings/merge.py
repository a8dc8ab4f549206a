"""Tellings of ``merge`` and ``status``."""

from __future__ import annotations

from allworlds.document.report import Report
from allworlds.engines.units import WHOLE
from allworlds.judging.tasks import MAP
from allworlds.reports.rendering import told, verb_of
from allworlds.reports.telling import Section, ToldFacts, ToldResult
from allworlds.studies.status import Standing
from allworlds.words import duration, number, plural, size


def merge_telling(merged: Report) -> ToldResult:
    """The telling of the verb whose shards were merged."""
    return told(verb_of(type(merged)), merged)


def status_telling(standing: Standing) -> ToldResult:
    """Progress, rate, and results so far."""
    units, worlds = standing.units, standing.worlds
    finished = standing.state == "finished"
    so_far = "" if finished else " so far"
    facts: list[tuple[str, str]] = [("state", standing.state), ("job", _job(standing))]
    if standing.options:
        facts.append(("options", " ".join(standing.options)))
    facts.append(("units", f"{number(units.done)} of {number(units.all)}"))
    whole = standing.shard == str(WHOLE)
    some = "" if whole else "about "
    some = some if standing.counted else f"at most {some}"
    facts.append(("worlds", f"{number(worlds.done)} of {some}{number(worlds.all)}"))
    if standing.rate is not None:
        facts.append(("rate", f"{plural(round(standing.rate), 'world')} a second"))
    if standing.left_s:
        most = "" if standing.counted else "at most "
        facts.append(("left", f"{most}{duration(standing.left_s)}, at this rate: a guess"))
    if standing.worst:
        worst = standing.worst
        where = size(worst.edges, worst.vertices)
        facts.append(("worst", f"{plural(worst.cost, 'traversal')}{so_far}, with {where}"))
    if standing.findings:
        facts.append(("findings", f"{number(standing.findings)}{so_far}"))
    sections = [Section("seen", "", [ToldFacts(facts)])]
    return ToldResult("allworlds status", standing.verb, standing, None, sections)


def _job(standing: Standing) -> str:
    """The verb, the explorer and the worlds."""
    asked = standing.parameters
    scope = [f"class {asked['class']}"] if asked.get("class") and not asked.get("family") else []
    scope += [str(asked["where"])] if asked.get("where") else []
    bounds = [
        plural(asked[name], one, many)
        for name, one, many in (("edges", "edge", ""), ("vertices", "vertex", "vertices"))
        if asked.get(name) is not None
    ]
    scope += [f"at most {' and '.join(bounds)}"] if bounds else []
    scope += [f"family {', '.join(asked['family'])}"] if asked.get("family") else []
    scope += [f"up to {plural(asked['to'], 'edge')}"] if asked.get("to") else []
    scope += [f"lighthouse {asked['lighthouse']}"] if asked.get("lighthouse") else []
    scope += [f"task {asked['task']}"] if asked.get("task", MAP) != MAP else []
    shard = "" if standing.shard == str(WHOLE) else f"; shard {standing.shard}"
    return f"{f'{standing.verb} {standing.explorer}'.strip()}: {', '.join(scope)}{shard}"
