"""Every verb's result in every form of a report, and forms that know no verb."""

import ast
import csv
import io
import re
from pathlib import Path

import pytest

from allworlds import reports
from allworlds.documents.document import replace
from allworlds.reports.formats import FORMATS, csv_rows, file_of, formats_of
from allworlds.reports.parts import (
    CsvRows,
    FactList,
    Headline,
    ReportContent,
    RightText,
    Section,
    Table,
)
from allworlds.reports.plain_text import content_line, content_text
from allworlds.studies.count import count
from allworlds.verbs import BY_NAME, ROWS
from html_tree import read
from recorded.record import least

pytestmark = pytest.mark.usefixtures("compiled")  # for worst

HOME = Path(reports.__file__).parent
FORMS = [
    *(HOME / f"{name}.py" for name in ("parts", "plain_text")),
    HOME / "web" / "sections.py",
]
WRONG = f"{Path(__file__).parents[1] / 'recorded' / 'explorers.py'}:first_edge"
SLOW = ("ledger", "ambiguity search")
WITH_ROWS = [verb.name for verb in BY_NAME.values() if ROWS in verb.has and verb.name not in SLOW]


def too_wide(told):
    """The lines of more than 80 columns, but for commands, which are copied as one line."""
    return [line for line in told.splitlines() if len(line) > 80 and line[:12] != "  allworlds "]


@pytest.mark.parametrize("verb", WITH_ROWS)
def test_a_verb_with_rows_writes_every_form_and_fits_80_columns(verb, cli, tmp_path, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    forms = [name for name, form in FORMATS.items() if ROWS in form.shows]
    assert {"html", "markdown", "csv"} <= {*forms}
    forms.remove("parquet")
    options = [word for form in forms for word in ("-o", f"{form}:{tmp_path / form}")]
    _, out, _ = cli(*least(verb, str(tmp_path)), *options)
    assert out
    assert too_wide(out) == []
    made = {form: (tmp_path / form).read_text(encoding="utf-8") for form in forms}
    root = read(made["html"])
    assert root.one("h1").text.startswith("allworlds ")
    assert [*root.all("table"), *root.all("ol")]
    assert made["markdown"].startswith("## allworlds")
    assert made["markdown"].count("<details>") == made["markdown"].count("</details>")
    header, *rows = csv.reader(io.StringIO(made["csv"]))
    assert rows
    assert {len(row) for row in rows} == {len(header)}
    # Names without spaces, each once; no cell is a list.
    assert all(re.fullmatch("[a-z][a-z_]*", name) for name in header)
    assert len({*header}) == len(header)
    assert not any(re.search(r"\d[:-]\d+( |$)", cell) for row in rows for cell in row)


@pytest.mark.parametrize("verb", WITH_ROWS)
def test_each_column_of_a_verbs_rows_has_one_type_whatever_is_missing(verb, cli, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    file, text_file = tmp_path / "rows.parquet", tmp_path / "rows.csv"
    cli(*least(verb, str(tmp_path)), "-o", file)
    if verb != "merge":  # its run directory is used up
        cli(*least(verb, str(tmp_path)), "-o", text_file)
    table = parquet.read_table(file)
    assert {str(column.type) for column in table.schema} <= {"int64", "double", "string", "bool"}
    assert table.num_rows > 0
    if text_file.exists():
        header, *rows = csv.reader(io.StringIO(text_file.read_text(encoding="utf-8")))
        assert header == table.column_names
        assert len(rows) == table.num_rows


@pytest.mark.parametrize(
    "words",
    [
        ["check", WRONG, "--edges", 3, "--max-findings", 3],
        ["compare", WRONG, "algorithm1-cluster", "folding", "--edges", 2],
        ["compare", WRONG, "algorithm1", "--family", "lattice,regular:4", "--to", 20],
        ["run", WRONG, "theta"],
    ],
    ids=["check", "compare", "growth", "run"],
)
def test_a_refuted_explorer_is_told_of_first_and_in_80_columns(words, cli, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    code, out, _ = cli(*words, *["-v"] * (words[0] == "check"))
    if words[0] == "check":  # its verdict is the last line, and is one
        out, _, verdict = out.rpartition("\n\n")
        out = f"{verdict[:80]}\n\n{out}"
    assert (code, too_wide(out)) == (1, [])
    head, finding, *_ = out.split("\n\n")
    assert head.startswith("REFUTED ")
    assert finding.startswith("Finding 1: ")
    assert out.index("The world\n") < f"{out}What was ".index("What was ")


@pytest.mark.parametrize("form", FORMS, ids=lambda path: path.stem)
def test_a_form_knows_no_verb_and_no_verbs_result(form):
    tree = ast.parse(form.read_text(encoding="utf-8"))
    looks = [node.value for node in ast.walk(tree) if isinstance(node, ast.keyword)]
    said = {n.value for n in ast.walk(tree) if isinstance(n, ast.Constant) and n not in looks}
    assert said.isdisjoint(BY_NAME)
    imported = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    inner = [node for node in imported if node not in tree.body]  # for findings
    for node in imported:
        names = {alias.name for alias in node.names}
        assert not node.module.startswith("allworlds.reports.content.") or node in inner
        assert node.module != "allworlds.verbs"
        assert not node.module.startswith("allworlds.studies") or names == {"Hypothesis"}


def test_that_no_form_knows_a_verb_can_fail(tmp_path):
    for source in (
        'x = "check"\n',
        "from allworlds.studies.check.report import CheckReport\n",
        "from allworlds.verbs import BY_NAME\n",
    ):
        form = tmp_path / "form.py"
        form.write_text(source)
        with pytest.raises(AssertionError):
            test_a_form_knows_no_verb_and_no_verbs_result(form)


def content(headline, cells=()):
    table = Table(["name", "costs", "much"], cells, "What it costs")
    sections = [Section("seen", "What was seen", [table, FactList([("by", "nobody")])])]
    return ReportContent("allworlds count", "maps", count(edges=1), headline, sections)


CELLS = [["a|b", 1000, 2.5], ["=1", None, RightText("3 or more")]]


def test_a_cell_has_a_text_for_people():
    told = content(None, CELLS)
    assert content_text(told, 80).splitlines()[2:6] == [
        "What it costs",
        "name  costs       much",
        "a|b   1,000       2.50",
        "=1        -  3 or more",
    ]


def test_rows_are_numbers_and_words_and_a_missing_one_is_an_empty_cell():
    rows = CsvRows(
        {"name": str, "costs": int, "much": float}, [["a|b", 1000, 2.5], ["=1", None, 3.0]]
    )
    told = replace(content(None, CELLS), rows=lambda: rows)
    assert csv_rows(told) == "name,costs,much\na|b,1000,2.5\n=1,,3.0\n"
    assert rows.records[1] == {"name": "=1", "costs": None, "much": 3.0}
    assert csv_rows(content(None, CELLS)) == ""


def test_quiet_leaves_one_line():
    verdict, answer = Headline("HOLDS", "so it is\nand more", "holds"), Headline("COUNTED", "much")
    assert content_line(content(verdict), 80) == "HOLDS: so it is and more"
    assert content_line(content(answer), 80) == "COUNTED: much"
    assert content_line(content(None), 80) == content_text(content(None), 80).splitlines()[0] != ""


def test_a_form_is_offered_where_there_is_what_it_shows():
    assert "sarif" in formats_of("check")
    assert "sarif" not in formats_of("worst")
    assert {*formats_of("status")} == {"json"}
    assert file_of("csv", count(edges=1)) == (
        "edges,vertices,genus,rooted,unrooted\n1,1,0,1,1\n1,2,0,1,1\n"
    )
