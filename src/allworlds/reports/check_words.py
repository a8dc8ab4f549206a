"""What there is to say of a check, for every report that people read."""

from __future__ import annotations

from allworlds.engines import Row, Sample, Shard
from allworlds.judging import Finding
from allworlds.outcome import Verdict
from allworlds.studies.check import CheckReport, UserCorpus
from allworlds.words import number, plural, size


def size_table(report: CheckReport) -> tuple[list[str], list[list[str]]]:
    """The header and the rows of what was counted for each number of edges and vertices.

    Of a sample, which has a few worlds of very many sizes, for each number of edges.
    """
    every = report.asked.schedules == "all"
    header = ["edges", "vertices", "worlds", "runs", "traversals", "max cost", "bound"]
    if every:
        header.insert(4, "schedules")
    rows = []
    sampled = isinstance(report.asked.coverage, Sample)
    for (edges, *vertices), row in _by_size(report, sampled).items():
        fewest, most = vertices[0], vertices[-1]
        cells = [row.worlds, row.runs, *([row.episodes] if every else [])]
        cells += [row.traversals, row.max_cost]
        bound = "-" if row.bound is None else number(row.bound)
        between = number(most) if fewest == most else f"{fewest}-{most}"
        rows.append([number(edges), between, *map(number, cells), bound])
    return header, rows


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


def verdict_words(report: CheckReport) -> tuple[str, str]:
    """The verdict, and what it says."""
    done = (
        f"{plural(report.worlds, 'world')}, {plural(report.runs, 'run')}, "
        f"{plural(report.tally.traversals, 'traversal')}"
    )
    if report.verdict is Verdict.HOLDS and not report.runs:
        return "EMPTY", f"{done} fall to this shard: it is finished, and says nothing"
    match report.verdict:
        case Verdict.HOLDS | Verdict.NOT_REFUTED:
            text = f"{done}: no law is broken"
        case Verdict.REFUTED:
            first = report.findings[0]
            text = f"law {first.law} is broken; {done} in finished levels"
        case Verdict.INCONCLUSIVE:
            text = f"{report.ending.reason}; {done} in finished levels, no law is broken"
        case Verdict.VACUOUS:
            text = "nothing was checked" if not report.runs else "a witness is missing"
        case Verdict.ERROR:
            text = report.ending.reason
    return report.verdict.value.upper(), text


def scope_words(report: CheckReport) -> list[tuple[str, str]]:
    """What the verdict is about, as names and texts; a text without a name goes on."""
    scope, rules = report.asked, report.asked.rules
    bounds = scope.extent
    limits = [f"at most {plural(bounds.edges, 'edge')}"] if bounds.edges else []
    if isinstance(scope.coverage, Sample) and scope.coverage.min_edges > 1:
        limits = [f"{scope.coverage.min_edges} to {plural(scope.extent.levels[-1], 'edge')}"]
    if bounds.vertices:
        limits += [f"at most {plural(bounds.vertices, 'vertex', 'vertices')}"]
    shard = f", shard {scope.coverage}" if isinstance(scope.coverage, Shard) else ""
    what = (
        f"{_which(report)} of the {rules.lighthouse} lighthouse in {_maps(report)} of the class "
        f"{bounds.map_class} with {' and '.join(limits)}{shard}; {_schedules(report)}"
    )
    words = [("explorer", f"{report.explorer}, {report.engine} engine"), ("scope", what)]
    if not report.complete and not isinstance(scope.coverage, Sample):
        finished = ", ".join(map(str, report.levels)) or "none"
        words.append(("", f"NOT complete: finished levels (edges): {finished}"))
    if report.symmetry:
        words.append(("symmetry", report.symmetry))
    witnesses = report.tally.witnesses
    seen = ", ".join(f"{event} {number(count)}" for event, count in sorted(witnesses.items()))
    met = f"what was met, and how often: {seen}" if seen else "none was met"
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


def origin_words(report: CheckReport, finding: Finding) -> str:
    """Where a finding comes from; empty where this check has come upon it by itself."""
    return "from the corpus" if report.past and report.past.holds(finding) else ""


def _which(report: CheckReport) -> str:
    sampled = isinstance(report.asked.coverage, Sample)
    return "one start and marker" if sampled else "every start and marker"


def _maps(report: CheckReport) -> str:
    sample = report.asked.coverage
    if not isinstance(sample, Sample):
        return "every map"
    return f"each of a SAMPLE of {plural(sample.runs, 'map')} (seed {sample.seed})"


def _corpus(past: UserCorpus) -> str:
    return "; ".join(
        f"{len(names)} {what}" + (f" ({', '.join(names)})" if names else "")
        for what, names in (
            ("past findings reproduced", past.reproduced),
            *([("still refuted, but beyond the scope", past.beyond)] if past.beyond else []),
            ("fixed and kept", past.fixed),
            ("written", past.written),
        )
    )


def _schedules(report: CheckReport) -> str:
    if report.asked.schedules == "all":
        return "every sequence of choices"
    return f"free choices as policy {report.asked.rules.policy} takes them, one schedule a run"


def _laws(report: CheckReport) -> str:
    rules = report.asked.rules
    laws = [f"bound ({rules.the_bound.name})" if law == "bound" else law for law in rules.applying]
    published = report.tally.checkpoints
    note = (
        f"; {plural(published, 'checkpoint')}"
        if published
        else "; no checkpoint was published, so nothing is said of what it knew on the way"
    )
    return ", ".join(laws) + note


def _gate(report: CheckReport) -> str:
    if isinstance(report.asked.coverage, Shard):
        return "deferred to the merge of all shards"
    if isinstance(report.asked.coverage, Sample):
        return "absent: a sample is not to be counted"
    if not report.cells:
        return "no level was finished"
    wrong = [cell for cell in report.cells if not cell.agrees]
    if wrong:
        cell = wrong[0]
        return (
            f"MISMATCH: of maps with {size(cell.edges, cell.vertices)} {cell.enumerated} were "
            f"enumerated, but {cell.source} counts {cell.counted}"
        )
    cells = plural(len(report.cells), "cell")
    return f"no world was forgotten: in {cells} (edges, vertices) {counted(report.cells[0].source)}"


def counted(source: str) -> str:
    """That an enumeration met as many as an independent source counts, in plain words."""
    return f"there are as many as are counted without making one ({source})"
