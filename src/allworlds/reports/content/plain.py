"""Content with named facts and tables, for results that have no module of their own here."""

from collections.abc import Sequence
from typing import Any

from allworlds import words
from allworlds.documents.report import Report
from allworlds.engines.units import WHOLE
from allworlds.inputs.checks import show
from allworlds.judging.tasks import MAP
from allworlds.reports import parts
from allworlds.studies import init, merge

NOT_IN_DOCUMENT = ("schema", "made_by", "verdict", "exit_code")
"""The keys that are not shown as facts: they are in the headline, or are of no use to people."""


def plain_content(report: Report) -> parts.ReportContent:
    """The content for any report: a fact for each key, and a table for each list of objects."""
    facts: list[tuple[str, str]] = []
    tables: list[parts.Block] = []
    rows = parts.CsvRows({}, [])
    for key, value in report.to_json().items():
        if key in NOT_IN_DOCUMENT or value is None:
            continue
        if isinstance(value, list) and value and all(isinstance(row, dict) for row in value):
            header = [*value[0]]
            cells = [[_cell(row.get(name)) for name in header] for row in value]
            tables.append(
                parts.Table(header, cells, words.plural(len(value), key.removesuffix("s")))
            )
            rows = rows if rows.columns else _rows(header, value)
        else:
            facts.append((key, str(_cell(value))))
    verdict = str(getattr(report, "verdict", ""))
    headline = parts.Headline(verdict.upper(), "", verdict) if verdict else None
    section = parts.Section("seen", "", [*tables, *([parts.FactList(facts)] if facts else [])])
    verb = f"allworlds {type(report).__name__.lower()}"
    return parts.ReportContent(verb, "", report, headline, [section], rows=lambda: rows)


def _rows(names: Sequence[str], objects: Sequence[dict[str, Any]]) -> parts.CsvRows:
    """A row for each object, with a column for each of the keys ``names``.

    A column of integers alone, or of floats alone, is a column of numbers; any other one is of
    texts.
    """
    columns = {}
    for name in names:
        kinds = {type(one.get(name)) for one in objects} - {type(None)}
        columns[name] = kinds.pop() if kinds in ({int}, {float}) else str
    rows = [
        [
            value if value is None or isinstance(value, kind) else show(value)
            for value, kind in ((one.get(name), kind) for name, kind in columns.items())
        ]
        for one in objects
    ]
    return parts.CsvRows(columns, rows)


def _cell(value: Any) -> parts.Cell:
    return value if value is None or type(value) in (int, str) else show(value)


def status_content(standing: merge.Standing) -> parts.ReportContent:
    """The content for a job: its progress, its rate, and its results so far."""
    units, worlds = standing.units, standing.worlds
    so_far = "" if standing.state == "finished" else " so far"
    most = "" if standing.counted else "at most "
    about = "" if standing.shard == str(WHOLE) else "about "
    some = f" of {most}{about}{words.number(worlds.all)}"
    facts = [
        ("state", standing.state),
        ("job", _job(standing)),
        ("options", " ".join(standing.options or ())),
        ("units", f"{words.number(units.done)} of {words.number(units.all)}"),
        ("worlds", f"{words.number(worlds.done)}{some if so_far or not about else ''}"),
    ]
    if standing.rate is not None:
        facts.append(("rate", f"{words.plural(round(standing.rate), 'world')} a second"))
    if standing.left_s:
        facts.append(("left", f"{most}{words.duration(standing.left_s)}, at this rate: a guess"))
    if worst := standing.worst:
        where = words.size(worst.edges, worst.vertices)
        facts.append(("worst", f"{words.plural(worst.cost, 'traversal')}{so_far}, with {where}"))
    if standing.findings:
        facts.append(("findings", f"{words.number(standing.findings)}{so_far}"))
    seen = parts.Section("seen", "", [parts.FactList(facts)])
    return parts.ReportContent("allworlds status", standing.verb, standing, None, [seen])


def _job(standing: merge.Standing) -> str:
    """The verb, the explorer and the worlds of a job, in words."""
    asked = standing.parameters
    names = ("class", "where", "edges", "vertices", "family", "to", "lighthouse", "task")
    given = {name: asked[name] for name in names if asked.get(name)}
    if given.get("task") == MAP:
        del given["task"]
    scope = [
        f"{name} {', '.join(value) if isinstance(value, list | tuple) else value}"
        for name, value in given.items()
    ]
    shard = "" if standing.shard == str(WHOLE) else f"; shard {standing.shard}"
    return f"{f'{standing.verb} {standing.explorer}'.strip()}: {', '.join(scope)}{shard}"


def init_content(begun: init.Skeleton | init.LedgerSkeleton | init.Header) -> parts.ReportContent:
    """The content for ``init``: the written files and the next command, or the text of a C header.

    The header is the one that explorers in C include.
    """
    if isinstance(begun, init.Header):
        subject, name = "header", "header"
        blocks: list[parts.Block] = [parts.Quote("header", "", begun.header.rstrip("\n"))]
    else:
        facts = [("written", ", ".join(begun.files))]
        subject, name, last = "ledger", "next", list[parts.Block]()
        if isinstance(begun, init.Skeleton):
            subject = begun.explorer
            facts.append(("needs", ", ".join(begun.language.needs)))
            wrong = "is wrong so far: the check draws the smallest world that refutes it."
            last = [parts.Paragraph(f"{begun.explorer} {wrong}")]
        blocks = [
            parts.FactList(facts),
            parts.Quote("next", "next", begun.check, command=True),
            *last,
        ]
    return parts.ReportContent(
        "allworlds init", subject, begun, None, [parts.Section(name, "", blocks)]
    )
