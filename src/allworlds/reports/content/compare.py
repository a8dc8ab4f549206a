"""Content of reports of ``compare``."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from shlex import quote
from typing import Any, TypeAlias

from allworlds.engines.sweep import By
from allworlds.explorers.sources import short_names
from allworlds.reports import parts
from allworlds.reports.content.scope import (
    SAID,
    explorer_facts,
    left_out,
    maps_in_words,
    option_facts,
)
from allworlds.reports.content.single_run import finding_section, run_section
from allworlds.studies.compare import comparison, entrants, growth, intervals
from allworlds.words import number, plural
from allworlds.world.named import code_of


def compare_content(report: comparison.Comparison | growth.Growth) -> parts.ReportContent:
    """The content for a comparison: the verdict, the findings, and the costs.

    The page of a :class:`comparison.Comparison` also has each explorer's walk in the world in which
    the costs differ most.  The page of a :class:`growth.Growth`, a comparison in families of worlds
    of growing size, has no walks.
    """
    return _growth(report) if isinstance(report, growth.Growth) else _comparison(report)


def _comparison(report: comparison.Comparison) -> parts.ReportContent:
    """The content for explorers in the same worlds, with walks where the costs differ most."""
    cells = _by_size(report, _short_names(report))
    less = f"less: worlds where '{_short_names(report)[0]}' walks less than this explorer"
    table = parts.Table([*SIZES], cells, f"Compared worlds ({less})", keys=4)
    curve = _curve(_lines_of_levels(report))
    blocks = [_side_by_side(report), *curve, table, parts.FactList(_facts(report))]
    return _content(report, blocks, lambda: _rows(report), lambda: _walks(report))


def _growth(report: growth.Growth) -> parts.ReportContent:
    """The content for explorers in worlds of families, by the size of these worlds."""
    ratios = [_ratios(report)] if report.ratios else []
    facts = parts.FactList(_growth_facts(report))
    tables = [_growth_table(report), *ratios, *_exponents(report)]
    blocks = [*_curve(_lines_of_families(report)), *tables, facts]
    return _content(report, blocks, lambda: _growth_rows(report), lambda: ())


def _content(
    report: comparison.Comparison | growth.Growth,
    blocks: Iterable[Any],
    rows: Callable[[], parts.CsvRows],
    more: Callable[[], Iterable[parts.Section]],
) -> parts.ReportContent:
    """The content of both kinds of comparison: the verdict, the findings, and then ``blocks``.

    Args:
        report: the report.
        blocks: the blocks of the section about the costs.
        rows: a function that makes the rows of a CSV file.
        more: a function that makes further sections, which only pages show.
    """
    findings = [finding_section(found, i) for i, found in enumerate(report.findings, 1)]
    verdict = report.verdict.value
    seen = parts.Section("seen", "What was compared", [*blocks])
    return parts.ReportContent(
        "allworlds compare",
        ", ".join(report.names),
        report,
        parts.Headline(verdict.upper(), _verdict(report), verdict),
        [*findings, seen],
        more=more,
        rows=rows,
        apart=frozenset({"findings"}),
    )


Lines: TypeAlias = dict[str, list[tuple[float, float, float, float]]]
"""The points of each line of a curve, by the line's name: edges, mean, and the lower and the upper
end of the interval."""


def _lines_of_levels(report: comparison.Comparison) -> Lines:
    """The lines of mean cost by number of edges: one for each explorer."""
    lines: Lines = {}
    shown = dict(zip(report.names, _short_names(report), strict=True))
    for edges in sorted({row.edges for row in report.rows}):
        level = [row for row in report.rows if row.edges == edges]
        worlds = sum(row.worlds for row in level)
        for name in report.names:
            mean = sum(row.mean[name] * row.worlds for row in level) / worlds
            lines.setdefault(shown[name], []).append((edges, mean, mean, mean))
    return lines


def _lines_of_families(report: growth.Growth) -> Lines:
    """The lines of mean cost by number of edges: one for each explorer and family.

    An explorer may have a bound of its cost, which depends on the world.  Then there is a second
    line for the explorer and family: at each number of edges it shows the largest bound in these
    worlds.
    """
    lines: Lines = {}
    shown = dict(zip(report.names, _short_names(report), strict=True))
    for row in report.rows:
        low, high = row.interval or (row.mean, row.mean)
        points = lines.setdefault(f"{shown[row.explorer]}, {row.family}", [])
        points.append((row.edges, row.mean, low, high))
        if row.bound is not None:
            bounds = lines.setdefault(f"bound of {shown[row.explorer]}, {row.family}", [])
            bounds.append((row.edges, row.bound, row.bound, row.bound))
    return lines


def _curve(lines: Lines) -> Iterator[parts.Curve]:
    """Yield the curve of the mean cost by size, which has one or more lines; or yield nothing.

    Nothing is yielded if one of the lines has points of a single size, which do not make a line, or
    if it has a point with a value of 0, since the axes are logarithmic.
    """
    if all(
        len({x for x, *_ in line}) > 1 and all(min(p) > 0 for p in line) for line in lines.values()
    ):
        yield parts.Curve("Mean cost, in traversals", "edges", [*lines.items()])


def _short_names(report: entrants.ContestReport) -> list[str]:
    """The heads of columns: a short name for each explorer.

    If the user has written ``EXPLORER@LIGHTHOUSE``, the short name ends in ``@LIGHTHOUSE``, too.
    """
    names = [*dict.fromkeys(one.subject.name for one in report.entrants)]
    short = dict(zip(names, short_names(names), strict=True))
    return [one.named(short[one.subject.name]) for one in report.entrants]


COLUMNS = (
    {"family": str, "edges": int, "vertices": int, "explorer": str}
    | dict.fromkeys(("seeds", "drawn_from", "worlds", "places", "runs"), int)
    | {"exact": bool, "mean": float, "least": int, "worst": int, "bound": int}
)
ENDS = {"low": float, "high": float, "ratio": float, "ratio_low": float, "ratio_high": float}


def _growth_rows(report: growth.Growth) -> parts.CsvRows:
    """A row for each run; or for each world, or each size of a family, if the request asks so.

    Each row is about one explorer.
    """
    if report.by != "size":
        return rows_of_worlds(report.in_worlds(), report.names[0], report.by or "run")
    ratios = {(one.family, one.edges, one.explorer): one for one in report.ratios}
    rows = []
    for row in report.rows:
        ratio = ratios.get((row.family, row.edges, row.explorer))
        ends = row.interval or (None, None)
        beside = ratio.interval or (None, None) if ratio else (None, None)
        own = [getattr(row, name) for name in COLUMNS]
        rows.append([*own, *ends, ratio.ratio if ratio else None, *beside])
    return parts.CsvRows(COLUMNS | ENDS, rows)


def _growth_table(report: growth.Growth) -> parts.Table:
    header = ["family", "edges", "vertices", "explorer", "worlds", "runs", "mean", "interval"]
    rows = [
        [
            *(row.family, row.edges, row.vertices, row.explorer, row.worlds),
            parts.RightText(f"{number(row.runs)} of {number(row.places)}"),
            parts.RightText(f"{row.mean:,.1f}"),
            *(_interval(row, ",.1f"), row.worst, row.bound),
        ]
        for row in report.rows
    ]
    return parts.Table([*header, "worst", "bound"], rows, "Costs, in traversals", keys=4)


def _ratios(report: growth.Growth) -> parts.Table:
    (first, *_) = _short_names(report)
    rows: list[list[parts.Cell]] = [
        [
            *(one.family, one.edges, one.explorer, one.worlds),
            *(parts.RightText(f"{one.ratio:.3f}"), _interval(one, ".3f")),
        ]
        for one in report.ratios
    ]
    header = ["family", "edges", "explorer", "worlds", f"cost / {first}", "interval"]
    return parts.Table(header, rows, "Ratios of costs in the same worlds", keys=3)


def _exponents(report: growth.Growth) -> Iterator[parts.Table]:
    """The table of the exponents e if costs grow like (number of edges)^e, by family and explorer.

    No table is yielded if no exponent was found; each row without an exponent has the reason.
    """
    rows: list[list[parts.Cell]] = [
        [
            *(one.family, one.explorer, one.sizes),
            None if one.exponent is None else parts.RightText(f"{one.exponent:.2f}"),
            _ends(one.interval, ".2f") or one.lack,
        ]
        for one in report.exponents
    ]
    if any(one.exponent is not None for one in report.exponents):
        header = ["family", "explorer", "sizes", "exponent", "interval"]
        yield parts.Table(header, rows, "Cost as a power of the number of edges", keys=2)


def _interval(found: growth.GrowRow | growth.CostRatio, form: str) -> parts.Cell:
    return "exact" if found.exact else _ends(found.interval, form)


def _ends(interval: Sequence[float] | None, form: str) -> parts.Cell:
    if interval is None:
        return None
    low, high = (format(end, form) for end in interval)
    return parts.RightText(f"{low}..{high}")


def _growth_facts(report: growth.Growth) -> list[tuple[str, str]]:
    shard = "" if report.whole else f", shard {report.portion}"
    asked = report.request
    scope = (
        f"families {', '.join(report.families)} up to {plural(asked.to, 'edge')}, "
        f"{plural(asked.draws, 'seed')} of each size from seed {asked.seed} on, at most "
        f"{plural(asked.places, 'place')} of the lighthouse in each world{shard}"
    )
    words = [*explorer_facts(report), ("scope", scope), *option_facts(report, GROWTH_SAID)]
    if report.rows:
        drawn = max(row.seeds for row in report.rows)
        level = f"{intervals.LEVEL:.0%} confidence in mean or ratio, by Student's t on logarithms"
        few = f"the sign -: fewer than {intervals.LEAST_WORLDS} worlds, or a cost of 0"
        words += [
            ("worlds", f"drawn with {plural(drawn, 'seed')}; isomorphic rooted maps count once"),
            ("runs", "places of the lighthouse tried, of all places; worst: the largest cost"),
            ("mean", "over the runs in a world, then over worlds; of ratios the geometric mean"),
            ("interval", intervals.lack() or f"{level}; {few}"),
        ]
        if any(row.exact for row in report.rows):
            words.append(("exact", "every world that a seed can draw was run, in every place"))
        member = report.rows[-1].members[-1].name
        one = report.entrants[0]
        own = f" --lighthouse {quote(one.at)}" if one.at else ""
        words.append(("example", f"allworlds run {one.subject.name}{own} --family {member}"))
    return [*words, ("left out", left_out(report.left_out))]


GROWTH_SAID = (*SAID, "to", "draws", "places")
"""The fields of the request that the facts about growing worlds describe."""


def _walks(report: comparison.Comparison) -> Iterator[parts.Section]:
    """Yield a section for each explorer: its walk in the world where the costs differ most."""
    for i, run in enumerate(report.walks(), 1):
        cost = plural(run.outcome.cost, "traversal")
        title = f"Where the costs differ most: '{run.explorer}' makes {cost}"
        yield run_section(run, f"walk-{i}", title)


SIZES = (
    {"edges": int, "vertices": int, "worlds": int, "explorer": str}
    | {"mean": float, "worst": int, "ratio": float}
    | dict.fromkeys(("less", "equal", "more"), int)
)


def _rows(report: comparison.Comparison) -> parts.CsvRows:
    """A row for each explorer and size; or for each world or run, if the request asks for these."""
    if report.by in ("world", "run"):
        return rows_of_worlds(report.in_worlds, report.names[0], report.by)
    return parts.CsvRows(SIZES, _by_size(report, report.names))


def _by_size(report: comparison.Comparison, names: Sequence[str]) -> list[list[parts.CellValue]]:
    """A row for each size and explorer; ``names`` has the names to show for the explorers.

    The column of ratios compares each explorer with the first one.
    """
    return [
        [
            *(row.edges, row.vertices, row.worlds, shown),
            *(row.mean[name], row.worst[name], row.ratio[name]),
            *(which.get(name) for which in (row.less, row.equal, row.more)),
        ]
        for row in report.rows
        for name, shown in zip(report.names, names, strict=True)
    ]


def _side_by_side(report: comparison.Comparison) -> parts.Table:
    """A table with a row for each size, and a column with mean and worst cost for each explorer."""
    rows: list[list[parts.Cell]] = [
        [
            *(row.edges, row.vertices, row.worlds),
            *(parts.RightText(f"{row.mean[n]:,.2f} ({row.worst[n]:,})") for n in report.names),
        ]
        for row in report.rows
    ]
    header = ["edges", "vertices", "worlds", *_short_names(report)]
    return parts.Table(header, rows, "Mean and worst cost of each explorer", keys=3)


def _facts(report: comparison.Comparison) -> list[tuple[str, str]]:
    """Named sentences about a comparison, which stand below its tables.

    They tell the lighthouse, policy and bound of each explorer, the compared worlds, the meaning of
    the costs and ratios, and the world in which the costs differ most.
    """
    scope = f"one world: {report.member.name}" if report.member else maps_in_words(report)
    words = [*explorer_facts(report), ("scope", scope), *option_facts(report, SAID)]
    meant = "in traversals; means are over the places of the lighthouse, then over the rooted maps"
    words.append(("costs", meant))
    first = _short_names(report)[0]
    exact = "; exact, as the maps are no sample" if report.whole else ""
    ratio = f"mean cost divided by that of '{first}', in each map; their geometric mean{exact}"
    words.append(("ratio", ratio))
    if report.rows:
        words += [("in all", _in_all(report, name)) for name in report.names[1:]]
    most = report.differ_most
    if most is not None:
        costs = ", ".join(f"{name} {cost:,.2f}" for name, cost in most.costs.items())
        said = f"the mean costs differ most in {most.world.in_words} (--json has it): {costs}"
        words.append(("difference", said))
    return words


def _verdict(report: comparison.Comparison | growth.Growth) -> str:
    said = f"no law is broken in {plural(sum(row.runs for row in report.rows), 'run')}"
    if report.findings:
        return "a run has broken a law"
    if not report.agrees:
        return "the enumeration and its count disagree"
    if not report.complete:
        return f"{report.stopped or 'interrupted'}; {said} of finished {report.steps}"
    if not report.rows:
        return "there is no world in which every explorer's lighthouse has a place"
    return said


def _in_all(report: comparison.Comparison, name: str) -> str:
    first = report.names[0]
    less, equal, more = (
        sum(getattr(row, which)[name] for row in report.rows) for which in ("less", "equal", "more")
    )
    return (
        f"'{first}' walks less than '{name}' in {plural(less, 'world')}, as much in "
        f"{number(equal)}, more in {number(more)}"
    )


NAMES = {"code": str, "family": str, "holes": str, "seed": int, "edges": int, "vertices": int}
RUN = {**NAMES, "explorer": str, "place": int, "cost": int, "bound": int}
WORLD = {**NAMES, "drawn_from": int, "explorer": str, "runs": int, "places": int}
WORLD |= {"mean": float, "worst": int, "bound": int, "ratio": float}


def _names(one: entrants.InWorld) -> list[parts.CellValue]:
    """The cells of the columns :data:`NAMES`, for the world of ``one``.

    The cells are: the code of the world's map; for a world of a family, the family, the fraction of
    edges that were removed (``holes``), and the seed; the numbers of edges and of vertices.  With
    the code, or with family, holes and seed, ``allworlds run`` makes the world again.
    """
    member = growth.member_named(one.member) if one.member else None
    words = [member.text, member.holes, member.seed] if member else [None] * 3
    return [code_of(one.map), *words, one.map.edge_count, one.map.vertex_count]


def rows_of_worlds(worlds: Iterable[entrants.InWorld], first: str, by: By) -> parts.CsvRows:
    """A row for each world and explorer, or for each run.

    Args:
        worlds: the runs in each world, in the order of the rows.
        first: the explorer with which the other explorers are compared.
        by: ``world`` or ``run``.
    """
    if by == "run":
        runs = [
            [*_names(one), one.explorer, place, cost, one.bound]
            for one in worlds
            for place, cost in one.costs.items()
        ]
        return parts.CsvRows(RUN, runs)
    every, rows = [*worlds], []
    beside = {(one.map, one.member): one.mean for one in every if one.explorer == first}
    for one in every:
        with_this = beside.get((one.map, one.member))
        ratio = round(one.mean / with_this, 6) if with_this else None
        played = [one.drawn_from, one.explorer, len(one.costs), one.places]
        costs = [round(one.mean, 6), max(one.costs.values()), one.bound]
        rows.append([*_names(one), *played, *costs, ratio])
    return parts.CsvRows(WORLD, rows)
