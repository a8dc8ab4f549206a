"""A result of which nobody has written content for is shown by every form all the same."""

from typing import Annotated

import pytest

from allworlds.documents.document import Document, Natural, about
from allworlds.documents.report import Report
from allworlds.outcome import Verdict
from allworlds.reports.content.plain import plain_content
from allworlds.reports.formats import FORMATS
from allworlds.reports.plain_text import _shortened, content_line, content_text, entry
from allworlds.verbs import ROWS


class Row(Document):
    edges: Annotated[Natural, about("their number")]
    leaves: Annotated[Natural | None, about("the most leaves")] = None


class Leaves(Report):
    kind: Annotated[str, about("of maps")]
    rows: Annotated[tuple[Row, ...], about("by edges")] = ()
    share: Annotated[float, about("of all vertices")] = 0.5


class Judged(Leaves):
    verdict: Annotated[Verdict, about("on the leaves")] = Verdict.REFUTED


ROWS_OF_TWO = (Row(edges=1, leaves=2), Row(edges=1200))
TEXT = """\
2 rows
edges  leaves
    1       2
1,200       -

kind       maps
share      0.5
"""


def test_keys_are_facts_and_lists_of_objects_are_tables():
    told = plain_content(Leaves(kind="maps", rows=ROWS_OF_TWO))
    assert content_text(told, 80).strip() == TEXT.strip()
    assert content_line(told, 80) == "2 rows"


def test_a_verdict_stands_first_and_alone_if_asked_for():
    told = plain_content(Judged(kind="maps", rows=ROWS_OF_TWO))
    assert content_text(told, 80).startswith("REFUTED")
    assert content_line(told, 80).strip(": \n") == "REFUTED"


@pytest.mark.parametrize(
    "form", [name for name, form in FORMATS.items() if ROWS in form.shows and name != "parquet"]
)
def test_every_form_of_rows_shows_it(form):
    made = FORMATS[form].of_content(plain_content(Leaves(kind="maps", rows=ROWS_OF_TWO)))
    assert "leaves" in made
    assert "200" in made


def test_an_option_is_not_broken_at_its_hyphens():
    lines = entry("scope", "all were tried with --time-limit", 40)
    assert lines == ["scope      all were tried with", "           --time-limit"]


def test_of_a_long_diagram_the_last_third_of_the_room_is_for_its_end():
    lines = [*map(str, range(20))]
    assert _shortened(lines, 9).split() == [*"01234", "...", "17", "18", "19"]
    assert _shortened(lines, 20).split() == lines
