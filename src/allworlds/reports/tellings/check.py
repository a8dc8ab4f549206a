"""The telling of a check."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from allworlds.engines.scope import Given, Sample
from allworlds.engines.single import SingleRun
from allworlds.engines.swept_report import tried_places
from allworlds.engines.tally import Row
from allworlds.engines.units import Shard
from allworlds.judging.findings.finding import Finding
from allworlds.maps.count_source import source_of
from allworlds.outcome import Disagreed, Verdict
from allworlds.reports.rows import CsvRows
from allworlds.reports.telling import (
    Block,
    Costs,
    Headline,
    Section,
    Shown,
    SizeCost,
    Suite,
    ToldCase,
    ToldFacts,
    ToldResult,
    ToldTable,
    Words,
    fact,
)
from allworlds.reports.tellings.finding import finding_section, nothing_checked
from allworlds.reports.tellings.scope import (
    SAID,
    of_the_class,
    options_told,
    places_told,
    trust_told,
)
from allworlds.studies.check.exhaustive import Guess, TimeEstimate
from allworlds.studies.check.report import CheckReport, most_expensive_runs
from allworlds.studies.check.tally_sweep import UserCorpus
from allworlds.version import __version__
from allworlds.words import about, counted, duration, listed, number, plural, size


def most_expensive_sections(
    cells: Sequence[SizeCost], runs: Iterable[SingleRun]
) -> Iterator[Section]:
    """Cost against bound, then the runs; empty if there are no cells."""
    if not cells:
        return
    from allworlds.reports.tellings.single_run import cost_words, run_section  # for files alone

    yield Section("costs", "Cost against bound", [Costs(cells)])
    sections = []
    for count, run in enumerate(runs, 1):
        map_ = run.world.map
        title = f"{size(map_.edge_count, map_.vertex_count)}: {cost_words(run)}"
        sections.append(run_section(run, f"most-expensive-{count}", title))
    if sections:
        yield Section("most-expensive", "The most expensive run of each size", [], sections)


def estimate_telling(guess: TimeEstimate) -> ToldResult:
    """Estimated duration of the check, and of those with more edges if it is known."""
    if guess.seconds is None or guess.rate is None:
        head = Headline("estimate", _TOO_LONG, "inconclusive")
        return ToldResult("allworlds check", guess.explorer, guess, head, [])
    most = "" if guess.counted else "at most "
    worlds = f"{most}{about(guess.worlds)} world{'' if guess.worlds == 1 else 's'}"
    text = f"{most}{duration(guess.seconds)} for {worlds}: a guess"
    of = f"{plural(guess.sampled, 'world')} of the last level, {number(round(guess.rate))} a second"
    blocks: list[Block] = [fact("sample", of), *([_larger(guess)] if guess.larger else [])]
    head = Headline("estimate", text, "inconclusive")
    return ToldResult(
        "allworlds check", guess.explorer, guess, head, [Section("sample", "", blocks)]
    )


_TOO_LONG = "no world of the last level was finished in time: this takes very long"


def _larger(estimate: TimeEstimate) -> ToldTable:
    """Estimated duration with more edges."""
    guesses: list[TimeEstimate | Guess] = [estimate, *estimate.larger]
    worlds, takes = ("worlds", "takes") if estimate.counted else ("worlds <=", "takes <=")
    header = ("edges", worlds, "engine", "sampled", "a second", takes)
    rows = [
        (
            guess.edges,
            Shown(guess.worlds, about(guess.worlds)),
            guess.engine,
            guess.sampled or Shown(0, "none"),
            round(guess.rate),
            Shown(guess.seconds, duration(guess.seconds)),
        )
        for guess in guesses
        if guess.rate is not None and guess.seconds is not None
    ]
    return ToldTable(header, rows)


def check_suite(report: CheckReport, verb: str) -> Suite:
    """The cases of a check, or of a sample."""
    return Suite(verb, report.explorer, _properties(report), [*_cases(report)])


def numbered_finding(report: CheckReport, number: int) -> Section:
    """One of the findings, with its origin."""
    finding = report.findings[number]
    past = report.past and report.past.holds(finding)
    return finding_section(finding, number + 1, "from the corpus" if past else "")


def reason_if_vacuous(report: CheckReport) -> str:
    """The reason why a complete check says nothing."""
    if not report.runs:
        return "the scope holds no run"
    if not report.checked_laws:
        return nothing_checked(report.asked.rules)
    return "a witness is missing"


def _properties(report: CheckReport) -> dict[str, object]:
    """Verdict and scope, which belong to every result."""
    document: Mapping[str, Any] = report.to_json()
    named = ("verdict", "exit_code", "engine", "worlds", "runs", "traversals")
    told = {"version": __version__, **{name: document[name] for name in named}}
    return told | {f"scope.{name}": value for name, value in document["scope"].items()}


def _cases(report: CheckReport) -> Iterator[ToldCase]:
    """A case for each number of edges, of past findings before and of witnesses after; or one.

    A level is passed; failed, with its findings; an error where the count gate or two engines
    disagree; skipped, with the reason, where it was not finished.  A sample is one case.
    """
    if isinstance(report.asked.coverage, Sample):
        yield _sample(report, report.asked.coverage)
        return
    yield from _past(report)
    yield from _levels(report)
    yield from _whole(report)


def _past(report: CheckReport) -> Iterator[ToldCase]:
    """One case for a user's corpus, if there is one."""
    if report.past:
        standing = [finding for finding in report.findings if report.past.holds(finding)]
        yield _failure(report, "past findings", standing) if standing else ToldCase("past findings")


def _levels(report: CheckReport) -> Iterator[ToldCase]:
    """One case for each level."""
    past = report.past
    new = [finding for finding in report.findings if not (past and past.holds(finding))]
    every = "every given world" if isinstance(report.asked.coverage, Given) else "every world"
    for edges in report.asked.sizes:
        name = f"{every} with {plural(edges, 'edge')}"
        found = [finding for finding in new if finding.key[0] == edges]
        wrong = [cell for cell in report.cells if cell.edges == edges and not cell.agrees]
        if wrong:
            text = "\n".join(
                f"of maps with {size(cell.edges, cell.vertices)} {cell.enumerated} were "
                f"enumerated, but {cell.source} counts {cell.counted}"
                for cell in wrong
            )
            told = [Section("gate", "", [Words(text)]), *_sections(report, found)]
            yield ToldCase(name, "error", "count-gate", text.splitlines()[0], told)
        elif found:
            yield _failure(report, name, found)
        elif edges in report.levels:
            yield ToldCase(name)
        else:
            yield ToldCase(
                name, "skipped", message=report.ending.reason or "the level was not finished"
            )


def _whole(report: CheckReport) -> Iterator[ToldCase]:
    """Judgements about the scope as a whole."""
    gate = all(cell.agrees for cell in report.cells)
    if isinstance(report.ending, Disagreed) and gate:
        told = [Section("engines", "", [Words(report.ending.reason)])]
        yield ToldCase("engines", "error", "engines-disagree", "two engines disagree", told)
    if not report.complete or not report.asked.whole:
        return
    if not report.checked_laws:
        yield ToldCase("witnesses", "failure", "vacuous", reason_if_vacuous(report))
    elif report.missing_witnesses:
        missing = f"never seen: {', '.join(report.missing_witnesses)}"
        yield ToldCase("witnesses", "failure", "vacuous", missing)
    else:
        yield ToldCase("witnesses")


def _sample(report: CheckReport, sample: Sample) -> ToldCase:
    edges = plural(report.asked.extent.levels[-1], "edge")
    least = "up to" if sample.min_edges == 1 else f"{sample.min_edges} to"
    name = f"{plural(sample.runs, 'random world')} with {least} {edges}"
    if report.findings:
        return _failure(report, name, report.findings)
    if report.verdict is Verdict.NOT_REFUTED:
        return ToldCase(name)
    return ToldCase(name, "skipped", message=report.ending.reason or "no world was tried")


def _failure(report: CheckReport, name: str, findings: Sequence[Finding]) -> ToldCase:
    law = findings[0].law
    return ToldCase(name, "failure", law, f"law '{law}' is broken", _sections(report, findings))


def _sections(report: CheckReport, findings: Sequence[Finding]) -> list[Section]:
    """Sections for these findings, as the check shows them."""
    return [numbered_finding(report, report.findings.index(finding)) for finding in findings]


def check_telling(report: CheckReport | TimeEstimate) -> ToldResult:
    """The verdict, the findings, the scope and the counts; or the estimated duration.

    On the page of a check that holds also the most expensive runs.
    """
    if isinstance(report, TimeEstimate):
        return estimate_telling(report)
    verb = "fuzz" if isinstance(report.asked.coverage, Sample) else "check"
    findings = [numbered_finding(report, number) for number in range(len(report.findings))]
    seen = Section("seen", "What was checked", [ToldFacts(scope_words(report)), size_table(report)])
    cells = [
        SizeCost(row.edges, row.vertices, row.max_cost, row.bound)
        for row in report.rows
        if row.episodes
    ]
    return ToldResult(
        f"allworlds {verb}",
        report.explorer,
        report,
        verdict_of(report),
        [*findings, seen],
        more=lambda: (
            [] if findings else most_expensive_sections(cells, most_expensive_runs(report))
        ),
        rows=lambda: _rows(report),
        suite=lambda: check_suite(report, verb),
        apart=frozenset({"findings"}),
        short=_in_short(report),
    )


def _in_short(report: CheckReport) -> list[tuple[str, str]]:
    """The scope of the verdict, in facts of a line each."""
    scope, cells = report.asked, report.cells
    extent = of_the_class(scope.extent).removeprefix("of the ")
    told = {
        "scope": f"{extent}, {scope.rules.lighthouse} lighthouse, {_which(report)}",
        "witnesses": f"{plural(len(report.tally.witnesses), 'kind')} of events seen",
    }
    if cells and all(cell.agrees for cell in cells):
        sizes = f"{plural(len(cells), 'size')} finished"
        if report.complete:
            sizes = f"all {plural(len(cells), 'size')} complete"
        told["gate"] = f"{sizes}; their number equals an independent count"
    words = [(name, told.get(name, said)) for name, said in scope_words(report)]
    if report.tally.rows and not report.findings:
        rows = sorted(report.tally.rows.items())
        (edges, vertices), most = max(rows, key=lambda told: told[1].max_cost)
        bound = "" if most.bound is None else f" of at most {number(most.bound)}"
        cost = f"{plural(most.max_cost, 'traversal')}{bound}, with {size(edges, vertices)}"
        words.append(("worst cost", cost))
    return words


def _rows(report: CheckReport) -> CsvRows:
    """A row for each number of edges and of vertices, of a sample too."""
    played = {"worlds": int, "runs": int, "episodes": int}
    costs = {"traversals": int, "traversals_rooted": int, "max_cost": int, "bound": int}
    if report.asked.schedules == "all":
        costs["best_cost"] = int
    return CsvRows.of(report.rows, edges=int, vertices=int, **played, **costs)


def size_table(report: CheckReport) -> ToldTable:
    """Counts for each number of edges and vertices.

    Of a sample, which has a few worlds of very many sizes, for each number of edges.
    """
    every = report.asked.schedules == "all"
    header = ["edges", "vertices", "worlds", "runs", "traversals", "max cost", "bound"]
    if every:
        header[4:4], header[6:6] = ["schedules"], ["best cost"]
    rows = []
    sampled = isinstance(report.asked.coverage, Sample)
    for (edges, *vertices), row in _by_size(report, sampled).items():
        fewest, most = vertices[0], vertices[-1]
        between = f"{number(most)}" if fewest == most else f"{fewest}-{most}"
        shown = Shown(most if fewest == most else between, between)
        played = [row.worlds, row.runs, *([row.episodes] if every else []), row.traversals]
        best = [row.best_cost] if every else []
        rows.append([edges, shown, *played, *best, row.max_cost, row.bound])
    return ToldTable(header, rows, "Drawn worlds" if sampled else "Finished levels", keys=2)


def _by_size(report: CheckReport, sampled: bool) -> dict[tuple[int, ...], Row]:
    """The rows by their edges and vertices; of a sample added up, by edges and all vertices."""
    rows = dict(sorted(report.tally.rows.items()))
    if not sampled:
        return {(edges, vertices): row for (edges, vertices), row in rows.items()}
    added: dict[int, tuple[list[int], Row]] = {}
    for (edges, vertices), row in rows.items():
        met, total = added.setdefault(edges, ([], Row()))
        met.append(vertices)
        total.add(row)
    return {(edges, *met): total for edges, (met, total) in added.items()}


def verdict_of(report: CheckReport) -> Headline:
    """The verdict and its explanation."""
    done = (
        f"{plural(report.worlds, 'world')}, {plural(report.runs, 'run')}, "
        f"{plural(report.tally.traversals, 'traversal')}"
    )
    where = "drawn worlds" if isinstance(report.asked.coverage, Sample) else "finished levels"
    if report.verdict in (Verdict.HOLDS, Verdict.NOT_REFUTED) and not report.runs:
        said = f"{done} fall to this shard, which is finished and has nothing to check"
        return Headline("EMPTY", said, "vacuous")
    match report.verdict:
        case Verdict.HOLDS | Verdict.NOT_REFUTED:
            text = f"{done}: no law is broken{_in_shard(report)}"
        case Verdict.REFUTED:
            first = report.findings[0]
            text = f"law {first.law} is broken; {done} in {where}"
        case Verdict.INCONCLUSIVE:
            text = f"{report.ending.reason}; in {where} no law is broken ({done})"
        case Verdict.VACUOUS:
            text = reason_if_vacuous(report)
        case Verdict.ERROR:
            text = report.ending.reason
    return Headline(report.verdict.value.upper(), text, report.verdict.value)


def _in_shard(report: CheckReport) -> str:
    """A remark that this is only a shard; empty for a whole check."""
    shard = report.asked.portion
    if not isinstance(shard, Shard):
        return ""
    return f" in shard {shard}; the verdict on the whole needs the merge of all shards"


def scope_words(report: CheckReport) -> list[tuple[str, str]]:
    """The scope of the verdict as named texts. A text without a name continues the one before."""
    scope, rules = report.asked, report.asked.rules
    least = scope.coverage.min_edges if isinstance(scope.coverage, Sample) else 1
    shard = f", shard {scope.portion}" if isinstance(scope.portion, Shard) else ""
    what = (
        f"{_which(report)} of the {rules.lighthouse} lighthouse in {_maps(report)} "
        f"{of_the_class(scope.extent, least)}{shard}; {_schedules(report)}"
    )
    words = [("explorer", f"{report.explorer}, {report.engine} engine"), ("scope", what)]
    words += places_told(tried_places(rules.lighthouse, scope.extent))
    words += options_told(report, CHECK_SAID)
    if not report.complete and not isinstance(scope.coverage, Sample):
        finished = ", ".join(map(str, report.levels)) or "none"
        why = "" if report.ending.final else f"{report.ending.reason}; "
        words.append(("", f"NOT complete: {why}finished levels (edges): {finished}"))
    if not rules.task.is_map:
        words.append(("task", f"{rules.task.name}: {rules.task.asks}"))
    words += trust_told(report.scope.shared_file)
    if report.symmetry:
        words.append(("symmetry", report.symmetry))
    witnesses = report.tally.witnesses
    seen = ", ".join(f"{event} {number(count)}" for event, count in sorted(witnesses.items()))
    met = f"events seen: {seen}" if seen else "no event was seen"
    words += [("laws", _laws(report)), ("gate", _gate(report)), ("witnesses", met)]
    if report.missing_witnesses:
        words.append(("MISSING", f"never met: {', '.join(report.missing_witnesses)}"))
    if report.past:
        past = report.past
        words.append(("corpus", f"{past.directory}: {_corpus(past)}"))
    if report.tally.left_out:
        left = plural(report.tally.left_out, "world")
        words.append(("left out", f"{left} without a place for the lighthouse"))
    words += [("remark", remark) for remark in report.remarks]
    return words


CHECK_SAID = (*SAID, "task", "laws", "schedules", "min_edges", "runs", "max_findings", "engine")
"""The fields of the request of which the scope, and other facts, tell."""


def _which(report: CheckReport) -> str:
    if isinstance(report.asked.coverage, Sample | Given):
        return "one start and marker"
    some = tried_places(report.asked.rules.lighthouse, report.extent)
    return "every start and the places told below" if some else "every start and marker"


def _maps(report: CheckReport) -> str:
    sample = report.asked.coverage
    if isinstance(sample, Given):
        return f"each of {plural(len(sample.worlds), 'given world')}"
    if not isinstance(sample, Sample):
        return "every map"
    return f"each of a SAMPLE of {plural(sample.runs, 'map')} (seed {sample.seed})"


def _corpus(past: UserCorpus) -> str:
    return "; ".join(
        told + (f" ({', '.join(names)})" if names else "")
        for told, names in (
            (f"{plural(len(past.reproduced), 'past finding')} reproduced", past.reproduced),
            (f"{len(past.beyond)} still refuted, but beyond the scope", past.beyond),
            (f"{len(past.fixed)} fixed and kept", past.fixed),
            (f"{len(past.stale)} stale and not tried", past.stale),
            (f"{len(past.written)} written", past.written),
        )
        if names or (names is not past.beyond and names is not past.stale)
    )


def _schedules(report: CheckReport) -> str:
    if report.asked.schedules == "all":
        return "every sequence of choices"
    return f"free choices as policy {report.asked.rules.policy} takes them, one schedule a run"


def _laws(report: CheckReport) -> str:
    rules = report.asked.rules
    published, checked = report.tally.checkpoints, report.checked_laws
    if not report.runs:
        return "no run was made, so no law was checked"
    if not checked:
        return nothing_checked(rules)
    bound = f"bound ({rules.the_bound.name})"
    laws = ", ".join(bound if law == "bound" else law for law in checked)
    if published:
        return f"{laws}; {plural(published, 'checkpoint')}"
    left = [law for law in rules.applying if law not in checked]
    return laws + (
        f"; not checked, because the explorer shows no checkpoint: {listed(left)}" if left else ""
    )


def _gate(report: CheckReport) -> str:
    if isinstance(report.asked.coverage, Shard):
        return "deferred to the merge of all shards"
    if isinstance(report.asked.coverage, Sample):
        return "absent: a sample is not to be counted"
    if isinstance(report.asked.coverage, Given):
        return "absent: the worlds were given"
    extent = report.asked.extent
    if extent.where is not None and source_of(extent) is None:
        return f"absent: no source counts the maps that are {extent.where.name}"
    if not report.cells:
        return "the scope holds no world" if report.levels else "no level was finished"
    wrong = [cell for cell in report.cells if not cell.agrees]
    if wrong:
        cell = wrong[0]
        return (
            f"MISMATCH: of maps with {size(cell.edges, cell.vertices)} {cell.enumerated} were "
            f"enumerated, but {cell.source} counts {cell.counted}"
        )
    cells = plural(len(report.cells), "cell")
    return f"no world was forgotten: in {cells} (edges, vertices) {counted(report.cells[0].source)}"
