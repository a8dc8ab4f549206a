"""Content of the reports of ``check`` and ``fuzz``."""

from collections.abc import Iterable, Iterator, Sequence
from shlex import join
from typing import Any

from allworlds.documents.document import replace
from allworlds.engines import single, tally, units
from allworlds.inputs.requests import given_again
from allworlds.maps.count_source import source_of
from allworlds.outcome import Disagreed, Verdict
from allworlds.reports import parts
from allworlds.reports.content import single_run
from allworlds.reports.content.scope import (
    SAID,
    each_of,
    left_out,
    miscount,
    of_the_class,
    option_facts,
    trust,
)
from allworlds.studies.check import time_estimate
from allworlds.studies.check.report import CheckReport, GateCell, most_expensive_runs
from allworlds.studies.scopes import tried_places
from allworlds.words import about, counted, duration, listed, number, plural, size


def check_content(report: CheckReport | time_estimate.TimeEstimate) -> parts.ReportContent:
    """The content for a check: verdict, findings, scope and counts; or its estimated duration.

    The page of a check without findings also has the most expensive run.
    """
    if isinstance(report, time_estimate.TimeEstimate):
        return _estimate(report)
    verb = "fuzz" if report.asked.coverage.drawn else "check"
    findings = _findings(report, range(len(report.findings)))
    tables = [size_table(report), *([covered_table(report)] if report.covered else [])]
    seen = parts.Section("seen", "What was checked", [parts.FactList(scope_words(report)), *tables])
    return parts.ReportContent(
        f"allworlds {verb}",
        report.explorer,
        report,
        verdict_of(report),
        [*findings, seen],
        more=lambda: () if findings else most_expensive(most_expensive_runs(report)),
        rows=lambda: _rows(report),
        cases=lambda: [*_cases(report)],
        command=_command(report),
        apart=frozenset({"findings"}),
        short=_in_short(report),
    )


def _command(report: CheckReport) -> str:
    """The explorer, and the given options on which the outcome depends, as on the command line."""
    options = given_again(type(report.request), report.request)
    shard = [] if report.whole else ["--shard", str(report.portion)]
    return join([report.explorer, *options, *shard])


def _in_short(report: CheckReport) -> list[tuple[str, str]]:
    """The scope of the verdict, as facts of one line each."""
    scope, cells = report.asked, report.cells
    extent = of_the_class(scope.extent).removeprefix("of the ")
    if scope.extent.given is not None:
        extent = f"{scope.extent.given.words}, {extent}"
    short = {
        "scope": f"{extent}, lighthouse '{scope.rules.lighthouse}', {_which(report)}",
        "witnesses": f"events of {plural(len(report.tally.witnesses), 'kind')} seen",
        "chance": f"one more draw refutes with p < {3 / max(report.runs, 1):.4g} (confidence 95 %)",
    }
    if cells and all(cell.agrees for cell in cells):
        sizes = plural(len(cells), "finished size")
        if report.complete:
            sizes = f"all {plural(len(cells), 'size')}"
        short["gate"] = f"independent count agrees for {sizes}{_listed(cells)}"
    words = [(name, short.get(name, said)) for name, said in scope_words(report) if said]
    if report.tally.rows and not report.findings:
        rows = sorted(report.tally.rows.items())
        (edges, vertices), most = max(rows, key=lambda row: row[1].max_cost)
        bound = "" if most.bound is None else f" of at most {number(most.bound)}"
        cost = f"{plural(most.max_cost, 'traversal')}{bound}, with {size(edges, vertices)}"
        words.append(("worst cost", cost))
    return words


def _rows(report: CheckReport) -> parts.CsvRows:
    """The rows of the CSV file: one for each pair of numbers of edges and vertices.

    The CSV file of a sample has these rows, too, but the table of a sample (:func:`size_table`) has
    one row for each number of edges.
    """
    played = {"worlds": int, "runs": int, "episodes": int}
    costs = {"traversals": int, "traversals_rooted": int, "max_cost": int, "bound": int}
    if report.asked.schedules == "all":
        costs["best_cost"] = int
    return parts.CsvRows.of(report.rows, edges=int, vertices=int, **played, **costs)


def size_table(report: CheckReport) -> parts.Table:
    """A table of the counts for each number of edges and vertices.

    A sample has few worlds of many sizes, so its counts are for each number of edges alone.
    """
    every = report.asked.schedules == "all"
    header = ["edges", "vertices", "worlds", "runs", "traversals", "max cost", "bound"]
    if every:
        header[4:4], header[6:6] = ["schedules"], ["max cheapest"]
    sampled = report.asked.coverage.drawn
    groups: dict[tuple[int, int], tuple[list[int], tally.Row]] = {}
    for (edges, vertices), row in sorted(report.tally.rows.items()):
        met, total = groups.setdefault((edges, 0 if sampled else vertices), ([], tally.Row()))
        met.append(vertices)
        total.add(row)
    rows: list[list[parts.Cell]] = []
    for (edges, _), (met, row) in groups.items():
        between: parts.Cell = met[0] if len(met) == 1 else parts.RightText(f"{met[0]}-{met[-1]}")
        played = [row.worlds, row.runs, *([row.episodes] if every else []), row.traversals]
        best = [row.best_cost] if every else []
        rows.append([edges, between, *played, *best, row.max_cost, row.bound])
    return parts.Table(header, rows, report.asked.coverage.finished.capitalize(), keys=2)


def covered_table(report: CheckReport) -> parts.Table:
    """A table of the worlds of a sample: for each feature the least, median and largest value.

    A feature is a number that a map has, such as its genus or its largest degree.
    """
    rows: list[list[parts.Cell]] = [
        [row.feature, row.least, row.median, row.most] for row in report.covered
    ]
    return parts.Table(["feature", "least", "median", "most"], rows, "What was covered", keys=1)


def verdict_of(report: CheckReport) -> parts.Headline:
    """The verdict in a word, with its explanation."""
    done = (
        f"{plural(report.worlds, 'world')}, {plural(report.runs, 'run')}, "
        f"{plural(report.tally.traversals, 'traversal')}"
    )
    where = report.asked.coverage.finished
    if report.verdict in (Verdict.HOLDS, Verdict.NOT_REFUTED) and not report.runs:
        said = f"{done}: this shard is finished and has nothing to check"
        return parts.Headline("EMPTY", said, "vacuous")
    match report.verdict:
        case Verdict.HOLDS | Verdict.NOT_REFUTED:
            text = f"{done}: no law is broken"
            if (shard := report.asked.portion) != units.WHOLE:
                whole = "the verdict on the whole needs the merge of all shards"
                text = f"{text} in shard {shard}; {whole}"
        case Verdict.REFUTED:
            first = report.findings[0]
            text = f"law {first.law} is broken; {done} in {where}"
        case Verdict.INCONCLUSIVE:
            text = f"{report.ending.reason}; in {where} no law is broken ({done})"
        case Verdict.VACUOUS:
            text = _why_vacuous(report)
        case Verdict.ERROR:
            text = report.ending.reason
    return parts.Headline(report.verdict.value.upper(), text, report.verdict.value)


def scope_words(report: CheckReport) -> list[tuple[str, str]]:
    """The scope of the verdict as named texts; a text without a name continues the text before."""
    scope, rules = report.asked, report.asked.rules
    shard = f", shard {scope.portion}" if scope.portion != units.WHOLE else ""
    what = (
        f"{_which(report)} of the lighthouse '{rules.lighthouse}' in {_maps(report)} "
        f"{of_the_class(scope.extent, scope.coverage.min_edges)}{shard}; {_schedules(report)}"
    )
    unfinished = ""
    if not report.complete and not scope.coverage.drawn:
        levels = [plural(edges, "edge") for edges in report.levels] or ["none"]
        why = "" if report.ending.final else f"{report.ending.reason}; "
        unfinished = f"{why}finished levels: {listed(levels)}"
    witnesses, past = report.tally.witnesses, report.corpus
    seen = ", ".join(f"{event} {number(count)}" for event, count in sorted(witnesses.items()))
    missing = ", ".join(report.missing_witnesses)
    return [
        ("explorer", f"{report.explorer}, {report.engine} engine"),
        ("scope", what),
        *_of_sample(report),
        ("places", tried_places(rules.lighthouse, scope.extent)),
        *option_facts(report, CHECK_SAID),
        ("INCOMPLETE", unfinished),
        ("task", "" if rules.task.is_map else f"{rules.task.name}: {rules.task.asks}"),
        ("trust", trust(report.scope.shared_file)),
        ("symmetry", report.symmetry),
        ("laws", _laws(report)),
        ("gate", _gate(report)),
        ("witnesses", f"events seen: {seen}" if seen else "no event was seen"),
        ("MISSING", missing and f"never met: {missing}"),
        ("corpus", f"{past.directory}: {past.summary}" if past else ""),
        ("left out", left_out(report.tally.left_out, f" of {number(report.worlds)}")),
        *(("remark", remark) for remark in report.remarks),
    ]


def _of_sample(report: CheckReport) -> Iterator[tuple[str, str]]:
    """Yield facts about a sample of random worlds; none if all worlds are checked.

    A *draw* is a random world of the sample.  The first fact is the mixture: the ways of drawing,
    which take turns.  The second fact, if there are any such worlds, is the number of the worlds
    that were made from draws by small changes.  The third fact is a bound on the probability that
    one more draw refutes the explorer.  It is yielded only if the verdict is ``not-refuted``, and
    the report is about the whole sample and not about a shard.
    """
    sample = report.asked.coverage
    if not isinstance(sample, units.Sample):
        return
    yield "mixture", f"drawn in these ways in turn: {', '.join(sample.mix)}; seed {sample.seed}"
    if report.bred:
        why = "made by changing drawn worlds, to reach rarely run code; only their findings count"
        yield "bred", f"{plural(report.bred, 'world')} {why}"
    if report.verdict is Verdict.NOT_REFUTED and sample.portion == units.WHOLE:
        chance = (
            f"none of {plural(report.runs, 'random draw')} refutes the explorer; one more draw "
            f"refutes it with a probability below {3 / report.runs:.4g} (at 95 % confidence)"
        )
        yield "chance", chance


CHECK_SAID = (
    *(*SAID, "task", "laws", "schedules", "min_edges", "mix", "runs"),
    *("max_findings", "engine"),
)
"""The fields of the request that the facts of :func:`scope_words` describe."""


def _which(report: CheckReport) -> str:
    given = report.asked.extent.given
    if report.asked.coverage.drawn or (given and given.fixed):
        return "one start and place"
    some = tried_places(report.asked.rules.lighthouse, report.extent)
    return "every start and the places named below" if some else "every start and place"


def _maps(report: CheckReport) -> str:
    sample, given = report.asked.coverage, report.asked.extent.given
    if given is not None:
        return each_of(given)
    if not isinstance(sample, units.Sample):
        return "every map"
    ended = report.refuted and 0 < report.worlds < sample.runs and sample.portion == units.WHOLE
    first = f"the first {number(report.worlds)} of " if ended else ""
    return f"each of {first}a SAMPLE of {plural(sample.runs, 'map')} (seed {sample.seed})"


def _schedules(report: CheckReport) -> str:
    if report.asked.schedules == "all":
        return "every sequence of choices"
    return f"free choices made by policy {report.asked.rules.policy}, one schedule a run"


def _laws(report: CheckReport) -> str:
    rules = report.asked.rules
    published, checked = report.tally.checkpoints, report.checked_laws
    if not report.runs:
        return "no run was made, so no law was checked"
    if not checked:
        return single_run.nothing_checked(rules)
    bound = f"bound ({rules.the_bound.name})"
    laws = ", ".join(bound if law == "bound" else law for law in checked)
    if published:
        return f"{laws}; {plural(published, 'checkpoint')}"
    left = [law for law in rules.applying if law not in checked]
    return laws + (f"; no checkpoint, so unchecked: {listed(left)}" if left else "")


def _gate(report: CheckReport) -> str:
    if (given := report.asked.extent.given) is not None:
        return given.gate
    if report.asked.coverage.drawn:
        return "absent: a sample has no independent count"
    if report.asked.coverage != units.WHOLE:
        return "not for a shard: the merge of all shards compares the counts"
    extent = report.asked.extent
    if extent.where is not None and source_of(extent) is None:
        return f"absent: no formula counts the maps that are {extent.where.name}"
    if not report.cells:
        return "the scope holds no world" if report.levels else "no level was finished"
    wrong = [_mismatch(cell) for cell in report.cells if not cell.agrees]
    if wrong:
        return f"MISMATCH: {wrong[0]}"
    sizes = f"{plural(len(report.cells), 'size')} (edges and vertices)"
    said = f"no world was forgotten: for {sizes} {counted(report.cells[0].source)}"
    return said + _listed(report.cells)


def _listed(cells: Sequence[GateCell]) -> str:
    """Words that say up to which number of edges a second enumeration found the same maps.

    The check enumerates all maps of a level, and the count gate compares their number with an
    independent count.  For few edges, other code enumerates the maps a second time; then the gate
    also compares the fingerprints of both enumerations.

    ``cells`` holds the comparisons of the gate, all of which agree.  In a comparison, ``listed`` is
    the fingerprint of the second enumeration; if it is empty in all of them, so is the result.
    """
    most = max((cell.edges for cell in cells if cell.listed), default=0)
    return f"; up to {plural(most, 'edge')} a second enumeration agrees" if most else ""


def _why_vacuous(report: CheckReport) -> str:
    """The reason why a complete check is vacuous."""
    if not report.runs:
        return "the scope holds no run"
    if not report.checked_laws:
        return single_run.nothing_checked(report.asked.rules)
    return "a witness is missing"


def _cases(report: CheckReport) -> Iterator[parts.SuiteCase]:
    """Yield test cases: for past findings, for each number of edges, and for the witnesses.

    The case of a number of edges has one of four results: passed; failed, with its findings; an
    error, if the count gate disagrees; or skipped, with the reason, if this level was not finished.
    A disagreement of two engines is a case of its own.  A sample is one case.
    """
    if isinstance(report.asked.coverage, units.Sample):
        yield replace(_sample(report, report.asked.coverage), seconds=sum(report.seconds))
        return
    past, new = list[int](), list[int]()
    for i, finding in enumerate(report.findings):
        (past if report.past and report.past.holds(finding) else new).append(i)
    if report.past:
        yield _failure(report, "past findings", past) if past else parts.SuiteCase("past findings")
    seconds = dict(zip(report.levels, report.seconds, strict=False))
    every = "every world" if report.asked.extent.given is None else "every given world"
    for edges in report.asked.extent.levels:
        name = f"{every} with {plural(edges, 'edge')}"
        found = [i for i in new if report.findings[i].key[0] == edges]
        wrong = [
            _mismatch(cell) for cell in report.cells if cell.edges == edges and not cell.agrees
        ]
        if wrong:
            said = [
                parts.Section("gate", "", [parts.Paragraph("\n".join(wrong))]),
                *_findings(report, found),
            ]
            case = parts.SuiteCase(name, "error", "count-gate", wrong[0], said)
        elif found:
            case = _failure(report, name, found)
        elif edges in report.levels:
            case = parts.SuiteCase(name)
        else:
            why = report.ending.reason or "the level was not finished"
            case = parts.SuiteCase(name, "skipped", message=why)
        yield replace(case, seconds=seconds.get(edges, 0))
    if isinstance(report.ending, Disagreed) and all(cell.agrees for cell in report.cells):
        said = [parts.Section("engines", "", [parts.Paragraph(report.ending.reason)])]
        yield parts.SuiteCase("engines", "error", "engines-disagree", "two engines disagree", said)
    if report.complete and report.asked.whole:
        missing = ""
        if not report.checked_laws:
            missing = _why_vacuous(report)
        elif report.missing_witnesses:
            missing = f"never seen: {', '.join(report.missing_witnesses)}"
        result: Any = ("failure", "vacuous", missing) if missing else ()
        yield parts.SuiteCase("witnesses", *result)


def _sample(report: CheckReport, sample: units.Sample) -> parts.SuiteCase:
    edges = plural(report.asked.extent.levels[-1], "edge")
    least = "up to" if sample.min_edges == 1 else f"{sample.min_edges} to"
    name = f"{plural(sample.runs, 'random world')} with {least} {edges}"
    if report.findings:
        return _failure(report, name, range(len(report.findings)))
    if report.verdict is Verdict.NOT_REFUTED:
        return parts.SuiteCase(name)
    return parts.SuiteCase(name, "skipped", message=report.ending.reason or "no world was tried")


def _failure(report: CheckReport, name: str, found: Sequence[int]) -> parts.SuiteCase:
    law = report.findings[found[0]].law
    return parts.SuiteCase(name, "failure", law, f"law '{law}' is broken", _findings(report, found))


def _findings(report: CheckReport, found: Iterable[int]) -> list[parts.Section]:
    """A section for each finding whose index is in ``found``.

    The section says so if the finding comes from the user's corpus.
    """
    sections = []
    for i in found:
        past = report.past and report.past.holds(report.findings[i])
        origin = "from the corpus" if past else ""
        sections.append(single_run.finding_section(report.findings[i], i + 1, origin))
    return sections


def _mismatch(cell: GateCell) -> str:
    if cell.enumerated == cell.counted:
        said = f"but not the maps: their fingerprint is {cell.fingerprint}, not {cell.listed}"
        return f"the number of maps with {size(cell.edges, cell.vertices)} is right, {said}"
    return miscount(cell.edges, cell.vertices, cell.enumerated, cell.source, cell.counted)


def _estimate(guess: time_estimate.TimeEstimate) -> parts.ReportContent:
    """The content for the estimated duration of a check, and of checks with more edges if known."""
    if guess.seconds is None or guess.rate is None:
        text = "no world of the last level was finished in a few seconds: the check takes very long"
        head = parts.Headline("estimate", text, "inconclusive")
        return parts.ReportContent("allworlds check", guess.explorer, guess, head, [])
    most = "" if guess.counted else "at most "
    worlds = f"{most}{about(guess.worlds)} world{'' if guess.worlds == 1 else 's'}"
    text = f"{most}{duration(guess.seconds)} for {worlds}: a guess"
    of = f"{plural(guess.sampled, 'world')} of the last level, {number(round(guess.rate))} a second"
    blocks: list[parts.Block] = [parts.fact("sample", of)]
    if guess.larger:
        names = ("worlds", "duration") if guess.counted else ("worlds <=", "duration <=")
        header = ("edges", names[0], "engine", "sampled", "worlds/s", names[1])
        every: list[time_estimate.TimeEstimate | time_estimate.Guess] = [guess, *guess.larger]
        rows = [
            (
                one.edges,
                parts.RightText(about(one.worlds)),
                one.engine,
                one.sampled or parts.RightText("none"),
                round(one.rate),
                parts.RightText(duration(one.seconds)),
            )
            for one in every
            if one.rate is not None and one.seconds is not None
        ]
        blocks.append(parts.Table(header, rows))
    head = parts.Headline("estimate", text, "inconclusive")
    seen = parts.Section("sample", "", blocks)
    return parts.ReportContent("allworlds check", guess.explorer, guess, head, [seen])


def most_expensive(runs: Iterable[single.SingleRun]) -> Iterator[parts.Section]:
    """A section about the run that costs most; no section without runs."""
    if most := max(runs, key=lambda run: run.outcome.cost, default=None):
        map_ = most.world.map
        where = size(map_.edge_count, map_.vertex_count)
        title = f"The most expensive run: {where}, {single_run.cost_words(most)}"
        yield single_run.run_section(most, "most-expensive", title)
