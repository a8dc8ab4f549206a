"""Curves of costs in pages and pictures; rows as a table of LaTeX."""

import csv
import io
import re
from itertools import pairwise
from xml.etree import ElementTree as ET

import pytest

from allworlds import compare, run
from allworlds.reports.content.compare import compare_content
from allworlds.reports.drawing.plot import BELOW, LEFT, _ticks, plot
from allworlds.reports.formats import file_of, latex_rows
from allworlds.reports.parts import CsvRows, Curve, ReportContent

pytestmark = pytest.mark.usefixtures("without_workers")
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def compared():
    return compare("algorithm1", "dfs", edges=3)


def curves(report):
    sections = compare_content(report).sections
    return [block for each in sections for block in each.blocks if isinstance(block, Curve)]


def test_the_curve_has_the_mean_cost_of_each_explorer_by_size(compared):
    (curve,) = curves(compared)
    assert [name for name, _ in curve.lines] == ["algorithm1", "dfs"]
    for name, line in curve.lines:
        assert [edges for edges, *_ in line] == [1, 2, 3]
        for edges, mean, low, high in line:
            rows = [row for row in compared.rows if row.edges == edges]
            worlds = sum(row.worlds for row in rows)
            assert mean * worlds == pytest.approx(sum(r.mean[name] * r.worlds for r in rows))
            assert low == mean == high


def test_of_worlds_that_grow_a_line_is_of_a_family_with_its_intervals():
    report = compare("dudek91", family="lattice,torus", to=50, draws=3)
    (curve,) = curves(report)
    families = [f"dudek91, {family}" for family in ("lattice", "torus")]
    assert [name for name, _ in curve.lines] == [
        name for each in families for name in (each, f"bound of {each}")
    ]
    for row in report.rows:
        assert (row.edges, *[row.bound] * 3) in dict(curve.lines)[f"bound of dudek91, {row.family}"]
        line = dict(curve.lines)[f"dudek91, {row.family}"]
        assert (row.edges, row.mean, *(row.interval or (row.mean, row.mean))) in line


def test_one_size_is_no_curve():
    assert curves(compare("dfs", "dudek91", edges=1)) == []
    assert ET.fromstring(file_of("svg", compare("dfs", "dudek91", edges=1))).tag == f"{SVG}svg"


def test_a_picture_has_the_points_in_their_order_and_the_names(compared):
    drawn = ET.fromstring(file_of("svg", compared))
    texts = [each.text for each in drawn.iter(f"{SVG}text")]
    assert {"edges", "algorithm1", "dfs", "1", "3"} <= {*texts}
    dots = [(float(c.get("cx")), float(c.get("cy"))) for c in drawn.iter(f"{SVG}circle")]
    assert len(dots) == 6
    for first, then in pairwise(dots[:3]):
        assert first[0] < then[0]  # a larger world is further to the right
        assert first[1] > then[1]  # a larger cost is higher up
    assert dots[0][0] == LEFT
    assert dots[0][1] == BELOW
    assert ET.tostring(plot(curves(compared)[0]), "unicode").split(">")[0] in file_of(
        "html", compared
    )


def test_the_rows_of_a_verb_are_a_table_of_latex(compared):
    for report in (compared, run("algorithm1", "theta")):
        lines = file_of("latex", report).splitlines()
        assert lines[0].startswith(r"\begin{tabular}{")
        assert lines[-1] == r"\end{tabular}"
        rows = [line.removesuffix(r" \\").split(" &") for line in lines if " &" in line]
        plain = [[cell.replace(r"\_", "_").strip() for cell in row] for row in rows]
        assert plain == [*csv.reader(io.StringIO(file_of("csv", report)))]
        sides = re.fullmatch(r"\\begin\{tabular\}\{([lr]+)\}", lines[0])[1]
        assert len(sides) == len(plain[0])


def test_what_means_something_to_latex_is_written_as_it_is():
    rows = CsvRows({"name": str}, [["50% of #1 & ~x^2 \\ {a_b} $\nnext"], [None]])
    content = ReportContent("d", "s", None, None, [], rows=lambda: rows)
    _, _, _, _, first, second, *_ = latex_rows(content).splitlines()
    assert first == (
        r"50\% of \#1 \& \textasciitilde{}x\textasciicircum{}2 \textbackslash{} \{a\_b\} \$ next \\"
    )
    assert second.strip() == r"\\"
    nothing = CsvRows({}, [])
    assert latex_rows(ReportContent("d", "s", None, None, [], rows=lambda: nothing)) == ""


def test_up_to_six_values_are_ticks_and_of_more_round_ones():
    assert _ticks(range(1, 7)) == [1, 2, 3, 4, 5, 6]
    assert _ticks(range(1, 8)) == [1, 2, 5]
    assert _ticks([k * 10**12 for k in range(1, 8)]) == [1e12, 2e12, 5e12]
