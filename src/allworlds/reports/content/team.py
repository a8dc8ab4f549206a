"""Content of reports of ``team``: the verdict, the counts, and diagrams of runs.

A space-time diagram of a run has a column for each robot and a row for each event.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from shlex import join
from typing import Any

from allworlds.explorers.loading import named_on_command_line
from allworlds.inputs.requests import given_again
from allworlds.maps.count_source import source_of
from allworlds.outcome import Verdict
from allworlds.protocol.actions import Percept
from allworlds.reports import parts
from allworlds.reports.content.scope import SAID, each_of, miscount, of_the_class, option_facts
from allworlds.robots.team import TeamRow
from allworlds.robots.team_finding import LAWS, EventRow, TeamFinding, Turned, places_of
from allworlds.studies.team.finding_reports import TeamExplanation, TeamReplay
from allworlds.studies.team.team_report import TeamReport
from allworlds.words import counted, number, plural, size

COLUMNS, LEAST, OF_ACTION = 62, 7, 12
"""In a diagram: the columns of text for all robots together, the fewest columns for a percept, and
the columns for an action."""

SHOWN_EVENTS = 15
"""The number of events that the diagram of a long run shows at either end."""

TEAM_SAID = (
    *(*SAID, "model", "robots", "scheduler", "budget", "within", "lead", "start_delay"),
    *("max_findings", "world", "starts"),
)
"""The fields of the request that the facts of :func:`scope_words` describe."""


def team_content(report: TeamReport) -> parts.ReportContent:
    """The content for a search of a team's runs: verdict, findings, scope and counts."""
    findings = [finding_section(found, i) for i, found in enumerate(report.findings, 1)]
    if report.unfinished and not findings:
        findings.append(unfinished_section(report.unfinished))
    seen = parts.Section(
        "seen", "What was searched", [parts.FactList(scope_words(report)), size_table(report)]
    )
    return parts.ReportContent(
        "allworlds team",
        report.asked.team.name,
        report,
        verdict_of(report),
        [*findings, seen],
        rows=lambda: parts.CsvRows.of(
            report.rows, edges=int, vertices=int, **dict.fromkeys(TeamRow.__slots__, int)
        ),
        cases=lambda: [*_cases(report)],
        command=_command(report),
        apart=frozenset({"findings", "unfinished"}),
        short=[(name, said) for name, said in scope_words(report) if said],
        laws=LAWS,
    )


def _command(report: TeamReport) -> str:
    names = dict.fromkeys(report.explorers) if len({*report.explorers}) == 1 else report.explorers
    named = [word for name in names for word in named_on_command_line(name)]
    return join([*named, *given_again(type(report.request), report.request)])


def verdict_of(report: TeamReport) -> parts.Headline:
    """The verdict in a word, with its explanation."""
    total, timing = report.total, report.asked.timing
    done = (
        f"{plural(total.worlds, 'world')} with starts, {plural(len(report.explorers), 'robot')}, "
        f"every {timing.scheduler} schedule"
    )
    searched = plural(total.configurations, "configuration")
    match report.verdict:
        case Verdict.HOLDS:
            most = f"; at most {plural(total.longest, 'activation')} of a robot in a run that ends"
            text = f"{done}; {searched}{most if total.longest else ''}"
        case Verdict.REFUTED:
            first = report.findings[0]
            text = f"law {first.law} is broken: {first.seen}; {searched}"
        case Verdict.INCONCLUSIVE if total.cut_off and not report.ending.stopped:
            text = (
                f"no law is broken, but {plural(total.cut_off, 'run')} went on after "
                f"{plural(timing.budget, 'activation')} of each robot; {done}; {searched}"
            )
        case Verdict.INCONCLUSIVE if total.full and not report.ending.stopped:
            text = (
                f"no law is broken, but {plural(total.full, 'world')} had more than "
                f"{number(timing.configurations)} configurations, the limit of a search; "
                f"{done}; {searched}"
            )
        case Verdict.VACUOUS:
            text = "the model yields no state in which a run can begin"
            if not total.worlds:
                text = "the scope holds no map in which the robots can start"
        case _:
            text = f"{report.ending.reason}; {done}; {searched}"
    return parts.Headline(report.verdict.value.upper(), text, report.verdict.value)


def scope_words(report: TeamReport) -> list[tuple[str, str]]:
    """The scope of the verdict as named texts."""
    scope, timing, extent = report.asked, report.asked.timing, report.extent
    maps = each_of(extent.given) if extent.given is not None else "every map"
    starts = "the given starts" if scope.starts else "every start that the model allows"
    shard = "" if report.whole else f", shard {report.portion}"
    bounds = [f"every {timing.scheduler} schedule"]
    if timing.within:
        bounds.append(f"within {plural(timing.budget, 'activation')} of each robot")
    if timing.lead is not None:
        bounds.append(f"no robot more than {plural(timing.lead, 'activation')} ahead of another")
    if timing.start_delay:
        bounds.append(f"robot 1 begins up to {plural(timing.start_delay, 'round')} later")
    total = report.total
    past = report.corpus
    paths = "infinitely many, or not known" if total.schedules is None else number(total.schedules)
    return [
        ("programs", ", ".join(report.explorers)),
        ("model", scope.model.name),
        ("scope", f"{starts} in {maps} {of_the_class(extent)}{shard}; {', '.join(bounds)}"),
        *option_facts(report, TEAM_SAID),  # type: ignore[arg-type]  # about worlds, too
        ("gate", _gate(report)),
        ("schedules", paths if report.verdict is Verdict.HOLDS else ""),
        ("numbers", _of_numbers(report)),
        ("corpus", f"{past.directory}: {past.summary}" if past else ""),
        *(("remark", remark) for remark in report.remarks),
    ]


def _of_numbers(report: TeamReport) -> str:
    alike = len(report.asked.team.subjects) == 1 and len(report.explorers) > 1
    said = "starts that are equal but for the numbers of the robots are searched separately"
    return said if alike and not report.asked.starts else ""


def _gate(report: TeamReport) -> str:
    if (given := report.extent.given) is not None:
        return given.gate
    if not report.whole:
        return "not for a shard: the merge of all shards compares the counts"
    if not report.cells:
        empty = "no finished level has a map"
        return empty if source_of(report.extent) else "absent: no formula counts these maps"
    wrong = [cell for cell in report.cells if not cell.agrees]
    if wrong:
        cell = wrong[0]
        said = miscount(cell.edges, cell.vertices, cell.enumerated, cell.source, cell.counted)
        return f"MISMATCH: {said}"
    return f"no map was forgotten: {counted(report.cells[0].source)}"


def size_table(report: TeamReport) -> parts.Table:
    """A table of the counts for each number of edges and vertices."""
    header = ["edges", "vertices", "maps", "worlds", "configurations", "in a world", "longest run"]
    rows = [
        [r.edges, r.vertices, r.maps, r.worlds, r.configurations, r.most, r.longest]
        for r in report.rows
    ]
    return parts.Table(header, rows, "Finished levels", keys=2)


def team_replay_content(replay: TeamReplay) -> parts.ReportContent:
    """The content for a replay: the outcome of the new search, and its findings."""
    names, outcome = ", ".join(dict.fromkeys(replay.again.explorers)), replay.outcome
    now = replay.law_now or replay.law
    text = f"law '{now}' is broken" + (" again" if now == replay.law else f", not '{replay.law}'")
    said = parts.Headline("REPRODUCED", text, "refuted")
    if outcome == "fixed":
        said = parts.Headline("FIXED", f"{names}: no law is broken in the recorded world", "holds")
    elif outcome == "not-reproduced":
        text = f"{names}: the budget is too small to tell if the recorded world breaks a law"
        said = parts.Headline("NOT REPRODUCED", text, "inconclusive")
    sections = [finding_section(found, i) for i, found in enumerate(replay.again.findings, 1)]
    return parts.ReportContent(
        "allworlds replay", names, replay, said, sections, apart=frozenset({"search"})
    )


def team_explain_content(explanation: TeamExplanation) -> parts.ReportContent:
    """The content for an explanation: sentences, and the diagram of the run."""
    found = explanation.finding
    sentences = [parts.Paragraph(sentence) for sentence in explanation.sentences]
    section = parts.Section("run", "The run", [*_run(found)])
    return parts.ReportContent(
        "allworlds explain",
        ", ".join(found.team),
        explanation,
        None,
        [parts.Section("words", "", sentences), section],
        apart=frozenset({"finding"}),
    )


# ---------------------------------------------------------------- a run


def headline_of(found: TeamFinding) -> str:
    """A finding in one line: the programs, the broken law and the world's size."""
    return f"{', '.join(found.team)} breaks the law '{found.law}' with {size(*found.key[:2])}"


def finding_section(found: TeamFinding, index: int) -> parts.Section:
    """A section for a finding: its world, the diagram of its run, and the command to repeat it.

    ``index`` is the number of the finding in the title, from 1 on.
    """
    title = f"Finding {index}: {found.law}, {size(*found.key[:2])}"
    return parts.Section(f"finding-{index}", title, [*_run(found)])


def unfinished_section(found: TeamFinding) -> parts.Section:
    """A section for a run that the budget cuts off, in the smallest world that has such a run."""
    title = f"A run that is cut off, with {size(*found.key[:2])}"
    return parts.Section("unfinished", title, [*_run(found, ("cut off", found.seen))])


def _run(found: TeamFinding, why: tuple[str, str] | None = None) -> Iterator[parts.Block]:
    map_ = found.map
    starts = ", ".join(
        f"robot {robot} at dart {dart} of v{map_.vertex_of[dart]}"
        for robot, dart in enumerate(found.starts)
    )
    yield parts.FactList(
        [
            why or ("broken", f"{found.law}: {found.seen}"),
            ("map", f"sigma {[*map_.sigma]}, alpha {[*map_.alpha]}"),
            ("starts", starts),
            ("model", f"{found.model}, scheduler {found.time.scheduler}"),
        ]
    )
    yield parts.ShownRun("The run", parts.Scene(map_), [*_rows_of(found)], diagram(found))
    if found.detail:
        yield parts.Quote("detail", "Detail", found.detail)
    yield parts.Quote("again", "Again", found.reproduce, command=True)


def _rows_of(found: TeamFinding) -> Iterator[parts.RunRow]:
    """Yield the start and the events of a run, as rows for the page."""
    before: tuple[int | None, ...] = found.starts
    yield parts.RunRow("", (), "", before)
    repeats = len(found.events) - found.loop
    for step, event in enumerate(found.events, 1):
        shown, vertex_of = places_of(event), found.map.vertex_of
        darts = shown.darts or before
        moved = [new for old, new in zip(before, darts, strict=False) if new not in (old, None)]
        yield parts.RunRow(
            event.written,
            [f"robot {turn.robot}: {_cell(event, turn.robot)}" for turn in event.robots],
            "; ".join(filter(None, [event.world, *_moved(before, darts, vertex_of)])),
            darts,
            moved,
            shown.vertices,
            shown.edges,
            step > repeats,
        )
        before = darts


def diagram(found: TeamFinding) -> list[str]:
    """The space-time diagram of a run: a column for each robot, a row for each event."""
    most = max(LEAST, COLUMNS // len(found.starts) - OF_ACTION)
    rows = [["", *(f"robot {robot}" for robot in range(len(found.starts))), "world"]]
    vertex_of, before = found.map.vertex_of, tuple[int | None, ...](found.starts)
    repeats = len(found.events) - found.loop
    for step, event in enumerate(found.events, 1):
        cells = [_cell(event, robot, most) for robot in range(len(found.starts))]
        where = [*_moved(before, event.darts, vertex_of)]
        world = "; ".join(filter(None, [event.world, ", ".join(where)]))
        mark = "*" if step > repeats else ""
        rows.append([f"{step}{mark}", *cells, world])
        before = event.darts
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    lines = ["  ".join(_fitted(row, widths)).rstrip() for row in rows]
    if len(lines) > 2 * SHOWN_EVENTS + 2:
        hidden = len(lines) - 2 * SHOWN_EVENTS - 1
        between = f"... {plural(hidden, 'more event')}: --json has all of them"
        lines = [*lines[: SHOWN_EVENTS + 1], between, *lines[-SHOWN_EVENTS:]]
    if found.loop:
        lines.append("(the events with * repeat for ever)")
    return lines


def sequence_of(found: TeamFinding) -> str:
    """The run as a sequence diagram of PlantUML: a lifeline for each robot, one for the world."""
    robots = range(len(found.starts))
    lines = ["@startuml", f"title {found.law}: {found.seen}"]
    lines += [f'participant "robot {robot}" as r{robot}' for robot in robots]
    lines.append('participant "world" as w')
    repeats = len(found.events) - found.loop
    for step, event in enumerate(found.events):
        if step == repeats:
            lines.append("loop for ever")
        for turn in event.robots:
            arrow = "->" if turn.phase != "look" else "-->"
            lines.append(f"r{turn.robot} {arrow} w : {_cell(event, turn.robot)}")
        if event.world:
            lines.append(f"note over w : {event.world}")
    lines += ["end"] if found.loop else []
    return "\n".join([*lines, "@enduml", ""])


def _fitted(row: Sequence[str], widths: Sequence[int]) -> Iterator[str]:
    for text, width in zip(row, widths, strict=True):
        yield text.ljust(width)


def _cell(event: EventRow, robot: int, most: int = COLUMNS) -> str:
    turn = next((each for each in event.robots if each.robot == robot), None)
    if turn is None:
        return "|"
    if turn.phase == "move":
        return f"'-> {turn.did}"
    later = " ..." if turn.phase == "look" else ""
    return f"{sensed_in_words(turn, most)}: {turn.did}{later}"


def sensed_in_words(turn: Turned, most: int) -> str:
    """The percept of a robot's turn, as text.

    A percept other than degree, marks and bearing is cut to ``most`` characters.
    """
    sensed: Any = turn.sensed
    if isinstance(sensed, dict) and {*sensed} == {"degree", "marks", "bearing"}:
        return str(Percept(**sensed))
    text = json.dumps(sensed, separators=(",", ":"))
    return text if len(text) <= most else f"{text[: most - 2]}.."


def _moved(
    before: Sequence[int | None], after: Sequence[int | None], vertex_of: Sequence[int]
) -> Iterator[str]:
    if len(before) != len(after):
        return
    for robot, (old, new) in enumerate(zip(before, after, strict=True)):
        if old != new:
            yield f"{robot} at v{vertex_of[new]}" if new is not None else f"{robot} is gone"


def _cases(report: TeamReport) -> Iterable[parts.SuiteCase]:
    """Yield a test case for each number of edges."""
    for edges in report.extent.levels:
        name = f"every world with {plural(edges, 'edge')}"
        found = [i for i, each in enumerate(report.findings, 1) if each.key[0] == edges]
        if found:
            first = report.findings[found[0] - 1]
            sections = [finding_section(report.findings[i - 1], i) for i in found]
            yield parts.SuiteCase(name, "failure", first.law, first.seen, sections)
        elif edges in report.levels and not report.undecided:
            yield parts.SuiteCase(name)
        else:
            limit = "budget" if report.total.cut_off else "limit --configurations"
            why = report.ending.reason or f"the {limit} is too small for a verdict"
            yield parts.SuiteCase(name, "skipped", message=why)
