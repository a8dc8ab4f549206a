"""The text of ``check``."""

from __future__ import annotations

from textwrap import wrap

from allworlds.checker.past import Past
from allworlds.checker.report import Report, Verdict
from allworlds.reports.layout import entry, number, plural, table
from allworlds.reports.run_text import finding_text


def check_text(report: Report, width: int) -> str:
    """What was seen, the verdict with its scope, and the findings."""
    blocks = [_rows(report), _verdict(report, width), _scope(report, width)]
    blocks += [[finding_text(finding, width)] for finding in report.findings]
    return "\n\n".join("\n".join(block) for block in blocks if block)


def _rows(report: Report) -> list[str]:
    every = report.scope.schedules == "all"
    header = ["edges", "vertices", "worlds", "runs", "traversals", "max cost", "bound"]
    if every:
        header.insert(4, "schedules")
    rows = []
    for row in report.rows():
        cells = [row["edges"], row["vertices"], row["worlds"], row["runs"]]
        cells += [row["episodes"]] if every else []
        cells += [row["traversals"], row["max_cost"]]
        checked = "bound" in report.scope.rules.applying and row["bound"] is not None
        bound = number(row["bound"]) if checked else "-"
        rows.append([*map(number, cells), bound])
    return table(header, rows, "r" * len(header))


def _verdict(report: Report, width: int) -> list[str]:
    word = report.verdict.value.upper()
    done = (
        f"{plural(report.worlds, 'world')}, {plural(report.runs, 'run')}, "
        f"{plural(report.tally.traversals, 'traversal')}"
    )
    match report.verdict:
        case Verdict.HOLDS | Verdict.NOT_REFUTED:
            text = f"{done}: no law is broken"
        case Verdict.REFUTED:
            first = report.findings[0]
            text = f"law {first.law} is broken; {done} in finished levels"
        case Verdict.INCONCLUSIVE:
            text = f"{report.stopped}; {done} in finished levels, no law is broken"
        case Verdict.VACUOUS:
            text = "nothing was checked" if not report.runs else "a witness is missing"
        case Verdict.ERROR:
            text = report.stopped
    return entry(word, text, width) if len(word) < 11 else wrap(f"{word}: {text}", width)


def _scope(report: Report, width: int) -> list[str]:
    scope, rules = report.scope, report.scope.rules
    bounds = scope.bounds
    limits = [f"at most {plural(bounds.edges, 'edge')}"] if bounds.edges else []
    limits += [f"at most {bounds.vertices} vertices"] if bounds.vertices else []
    shard = "" if scope.shard == (0, 1) else f", shard {scope.shard[0]}/{scope.shard[1]}"
    lines = entry("explorer", f"{report.explorer}, {report.engine} engine", width)
    lines += entry(
        "scope",
        f"{_which(report)} of the {rules.lighthouse} lighthouse in {_maps(report)} of the class "
        f"{bounds.map_class} with {' and '.join(limits)}{shard}; "
        f"{_schedules(report)}",
        width,
    )
    if not report.complete and not scope.sample:
        finished = ", ".join(map(str, report.levels)) or "none"
        lines += entry("", f"NOT complete: finished levels (edges): {finished}", width)
    if report.symmetry:
        lines += entry("symmetry", report.symmetry, width)
    lines += entry("laws", _laws(report), width)
    lines += entry("gate", _gate(report), width)
    witnesses = report.tally.witnesses
    seen = ", ".join(f"{event} {number(count)}" for event, count in sorted(witnesses.items()))
    lines += entry("witnesses", seen or "none", width)
    if report.missing:
        lines += entry("MISSING", ", ".join(report.missing), width)
    if report.corpus:
        past = report.corpus
        lines += entry("corpus", f"{past.directory}: {_corpus(past)}", width)
    if report.tally.left_out:
        left = plural(report.tally.left_out, "world")
        lines += entry("left out", f"{left} without a place for the lighthouse", width)
    return lines


def _which(report: Report) -> str:
    return "one start and marker" if report.scope.sample else "every start and marker"


def _maps(report: Report) -> str:
    sample = report.scope.sample
    if sample is None:
        return "every map"
    return f"each of a SAMPLE of {number(sample['runs'])} maps (seed {sample['seed']})"


def _corpus(past: Past) -> str:
    return "; ".join(
        f"{len(names)} {what}" + (f" ({', '.join(names)})" if names else "")
        for what, names in (
            ("past findings reproduced", past.reproduced),
            ("fixed and kept", past.fixed),
            ("written", past.written),
        )
    )


def _schedules(report: Report) -> str:
    if report.scope.schedules == "all":
        return "every sequence of choices"
    return f"policy {report.scope.rules.policy}, one schedule a run"


def _laws(report: Report) -> str:
    rules = report.scope.rules
    laws = [f"bound ({rules.the_bound.name})" if law == "bound" else law for law in rules.applying]
    published = report.tally.checkpoints
    note = (
        f"; {plural(published, 'checkpoint')}"
        if published
        else "; no checkpoint was published, so nothing is said of the invariants"
    )
    return ", ".join(laws) + note


def _gate(report: Report) -> str:
    if report.scope.shard != (0, 1):
        return "deferred to the merge of all shards"
    if report.scope.sample:
        return "absent: a sample is not to be counted"
    if not report.gate:
        return "no level was finished"
    wrong = [cell for cell in report.gate if not cell.agrees]
    if wrong:
        cell = wrong[0]
        return (
            f"MISMATCH: {cell.enumerated} maps with {cell.edges} edges and {cell.vertices} "
            f"vertices were enumerated, but {cell.source} counts {cell.counted}"
        )
    cells = plural(len(report.gate), "cell")
    return f"in {cells} (edges, vertices) the worlds number as in: {report.gate[0].source}"
