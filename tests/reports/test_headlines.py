"""What reports say in their rarer cases, of reports that are made by hand."""

from types import SimpleNamespace

import pytest

from allworlds import compare, run
from allworlds.documents.document import replace
from allworlds.maps import named_map
from allworlds.maps.classes import Extent, MapClass
from allworlds.reports.content import ambiguity, ledger, scope, sizes
from allworlds.reports.content.compare import _exponents
from allworlds.reports.content.scope import explorer_facts, gate_facts
from allworlds.reports.content.single_run import (
    LONGEST_LIST,
    MOST_LINES,
    _belief,
    _lines,
    _remarks,
    run_content,
    wrong_line,
)
from allworlds.reports.formats import text as text_of
from allworlds.reports.parts import Headline, so_far
from allworlds.world import Directional, World


def said(headline):
    return headline.word, headline.text, headline.verdict


MET = (
    "the enumeration found 1 rooted map with 2 edges, but the independent count (Tutte) is 9; "
    "the enumeration found 2 rooted maps with 2 edges, but the independent count (Tutte) is 9"
)


def row(**given):
    return SimpleNamespace(edges=2, marked_worlds=3, ambiguous_worlds=None, **given)


def test_a_census_that_differs_from_its_source_names_each_row():
    rows = [
        row(rooted=number, counted=9, agrees=lambda *, whole, number=number: number == 9)
        for number in (1, 9, 2)
    ]
    census = SimpleNamespace(agrees=False, rows=rows, source="Tutte", whole=True)
    assert said(ambiguity._counted(census)) == ("MISMATCH", MET, "error")


@pytest.mark.parametrize(
    ("given", "ambiguous", "word"),
    [
        ({"whole": False, "empty": False}, (0, 4), "SHARD"),
        ({"whole": True, "empty": True}, (0, None), "VACUOUS"),
        ({"whole": True, "empty": False}, (None, 4), "AMBIGUOUS"),
        ({"whole": True, "empty": False}, (0, None), "TOLD APART"),
    ],
)
def test_the_first_line_of_a_census(given, ambiguous, word, monkeypatch):
    monkeypatch.setattr(ambiguity.parts, "so_far", lambda _, done: done)
    monkeypatch.setattr(ambiguity, "finished", lambda *_: "of two edges")
    rows = [SimpleNamespace(edges=2, marked_worlds=3, ambiguous_worlds=each) for each in ambiguous]
    census = SimpleNamespace(agrees=True, rows=rows, places="one place", portion="1/2", **given)
    done = ambiguity._counted(census)
    assert done.word == word
    assert "of two edges (one place)" in done.text
    if word != "VACUOUS":
        assert "6 marked worlds" in done.text
    if word == "AMBIGUOUS":
        assert done.text.startswith("4 of 6 marked worlds")
    if word == "SHARD":
        assert done.text.endswith("in the shard 1/2")


def test_a_tour_goes_the_nearest_way_to_what_is_left():
    cube = named_map("cube")
    for dart in cube.darts:
        way = ambiguity._nearest(cube, 0, {dart}) if dart else []
        at = 0
        for k in way:
            at = cube.move(at, k)
        assert at == dart
        assert len(way) <= 6
    assert ambiguity._nearest(cube, 0, {cube.move(0, 1), cube.move(0, 2)}) == [1]


MISCOUNTED = (
    "the enumeration found 1 map with 2 edges and 1 vertex, but the independent count (T) is 3; "
    "the enumeration found 2 maps with 2 edges and 3 vertices, but the independent count (T) is 1"
)


@pytest.mark.parametrize(
    ("given", "what"),
    [
        ({"agrees": False}, ("MISMATCH", MISCOUNTED)),
        ({"agrees": True}, ("VACUOUS", "there is no map of the class 'maps' with at most 3 edges")),
    ],
)
def test_the_first_line_of_a_count(given, what):
    rows = [
        SimpleNamespace(edges=2, miscounts=[(1, 1, 3), (3, 2, 1)]),
        SimpleNamespace(edges=3, miscounts=[]),
    ]
    done = {"complete": True, "whole": True, "empty": True, "extent": Extent(MapClass.MAPS, 3)}
    census = SimpleNamespace(rows=rows, source="T", **done, **given)
    found = sizes._counted(census)
    assert (found.word, found.text) == what


def test_the_first_line_where_no_schedule_was_worked_on(monkeypatch):
    report = SimpleNamespace(agrees=True, complete=True, rows=[])
    assert said(sizes._worst(report)) == ("VACUOUS", "there is no run", "vacuous")
    report = SimpleNamespace(agrees=False, disagreement="they differ")
    assert said(sizes._worst(report)) == ("MISMATCH", "they differ", "error")


@pytest.mark.parametrize(
    ("given", "rows", "gate"),
    [
        ({}, True, "no map was forgotten: the number equals an independent count (T)"),
        ({}, False, "no level was finished, so nothing was compared"),
        ({"whole": False}, True, "not for a shard: the merge of all shards compares the counts"),
        ({"source": ""}, True, "absent: no formula counts the maps that are cubic"),
    ],
)
def test_the_gate_says_what_was_compared(given, rows, gate):
    extent = SimpleNamespace(given=None, where="cubic")
    made = {"extent": extent, "source": "T", "whole": True, "portion": "1/2", **given}
    assert gate_facts(SimpleNamespace(**made), "map", is_compared=rows) == [("gate", gate)]
    extent.given = SimpleNamespace(gate="the given ones")
    assert gate_facts(SimpleNamespace(**made), "map", is_compared=rows) == [
        ("gate", "the given ones")
    ]


@pytest.mark.parametrize(
    ("section", "heading"),
    [
        *[("IV", "Section IV"), ("3.1", "Section 3.1"), ("A", "Section A")],
        *[("Proofs", "Proofs"), ("AB", "AB"), ("IV a", "IV a")],
    ],
)
def test_a_section_with_a_number_is_called_one(section, heading):
    assert ledger._heading(section) == heading


CLAIM = {
    "section": "IV",
    "id": "all",
    "statement": "All is well.",
    "method": "exhaustive",
    "expected": "holds",
    "verdict": "holds",
    "told": "too long",
}


@pytest.mark.parametrize(
    ("standing", "required", "result"),
    [
        ("as-expected", True, ("passed", "", "")),
        ("not-as-expected", False, ("failure", "not-as-expected", "one; two")),
        ("not-checked", True, ("failure", "required", "too long")),
        ("not-checked", False, ("skipped", "", "too long")),
    ],
)
def test_each_claim_is_a_case(standing, required, result, monkeypatch):
    monkeypatch.setattr(ledger, "_details", lambda _: [("a", "b")])
    claim = SimpleNamespace(**CLAIM, standing=standing, differences=["one", "two"])
    case = ledger._case(claim, required=required)
    assert case.name == "Section IV: all: All is well."
    assert (case.result, case.kind, case.message) == result
    assert bool(case.sections) == (case.result == "failure")


def test_each_claim_is_a_row():
    rows = ledger._rows(SimpleNamespace(claims=[SimpleNamespace(**CLAIM, standing="as-expected")]))
    told = ["IV", "all", "All is well.", "exhaustive", "holds", "holds", "as-expected"]
    assert rows.rows == [told]
    assert len(rows.columns) == len(told)


def test_lines_that_run_in_a_refuting_run_alone_are_told_up_to_a_number():
    code = SimpleNamespace(source=str, alone=["a:1", "a:2", "a:3"], right=1, steps=(), busy=())
    finding = SimpleNamespace(code=code, believed=None, law="crash", detail="")
    told = dict(_lines(finding, None))
    only = "a:1; a:2; a:3 (not run in 1 run that broke no law)"
    assert told["only here"] == only
    code.alone.append("a:4")
    assert len(code.alone) == MOST_LINES + 1
    said = dict(_lines(finding, None))["only here"]
    assert "a:3; 1 other line: --json lists them (not run in 1 run" in said
    assert [*_lines(SimpleNamespace(code=None), None)] == []


YES = "yes: a new process got the same percepts, and no world, and did the same"
NOT = "no: no new process has repeated the run"


@pytest.mark.parametrize(
    ("confirmed", "minimal", "among", "words"),
    [
        (False, False, None, f"{NOT}; a smaller world may refute the explorer, too"),
        (True, True, None, f"{YES}; no "),
        (False, True, "cubic", f"{NOT}; no smaller world of the scope (--where cubic) refutes the"),
        (False, True, None, f"{NOT}; no smaller world of the scope refutes the explorer"),
    ],
)
def test_a_finding_says_whether_it_is_confirmed_and_the_smallest(confirmed, minimal, among, words):
    rules = SimpleNamespace(among=among and SimpleNamespace(name=among))
    before = SimpleNamespace(to_json=lambda: {"a": 1}, in_words="one edge")
    finding = SimpleNamespace(
        confirmed=confirmed, minimal=minimal, rules=rules, earlier=[before], choices=()
    )
    told = dict(_remarks(finding, "here", checked=True))
    assert told["confirmed"].startswith(words)
    assert (told["ran before"], told["origin"]) == ('in one edge: {"a":1}', "here")
    assert "confirmed" not in dict(_remarks(finding, "here", checked=False))


def wrong(parting, /, **given):
    code = SimpleNamespace(steps=("s1", "s2", "s3"), checkpoints=("c0", "c1"))
    found = {"code": code, "believed": None, "law": "map", "detail": "", "step": None, **given}
    return wrong_line(SimpleNamespace(**found), parting)


def test_the_first_wrong_line_is_that_of_the_checkpoint_or_of_the_step_or_the_last():
    shown = SimpleNamespace(number=1)
    assert wrong(2, step=0, believed=shown) == "c1"
    assert wrong(2, believed=shown) == "s2"
    assert wrong(2, step=0, believed=SimpleNamespace(number=2)) == "s2"
    assert [wrong(step) for step in (0, 1, 3, 4, None)] == ["s1", "s1", "s3", "s3", "s3"]
    assert wrong(4, law="bound") == ""
    assert wrong(1, law="bound") == "s1"
    assert wrong(1, code=None) == ""


def test_the_first_choices_are_told():
    finding = SimpleNamespace(choices=[0] * LONGEST_LIST, earlier=[])
    told = dict(_remarks(finding, "here", checked=False))
    assert told["choices"] == ", ".join("0" * LONGEST_LIST)
    finding.choices.append(1)
    told = dict(_remarks(finding, "here", checked=False))
    assert told["choices"] == ", ".join("0" * LONGEST_LIST) + ", and 1 more"


@pytest.mark.parametrize(
    ("given", "word", "facts"),
    [
        ({"status": "unknown"}, "UNKNOWN", []),
        ({"vacuous": True}, "VACUOUS", []),
        ({"status": "sat", "certificate": "pair.json"}, "FOUND", ["why", "pair"]),
        ({"status": "sat"}, "FOUND", ["why"]),
        ({"certificate": "here"}, "NONE", ["proof"]),
        ({}, "NONE", ["proof"]),
    ],
)
def test_the_first_line_of_a_search_for_twins(given, word, facts):
    asked = {"question": SimpleNamespace(describes="Twins"), "status": "unsat", "vacuous": False}
    found, told = ambiguity._found(SimpleNamespace(**{"certificate": None, **asked, **given}))
    assert found.word == word
    assert found.text.startswith("there are no twins" if word == "NONE" else "Twins")
    assert [name for name, _ in told] == facts
    if word == "NONE":
        assert ("LRAT proof" in told[0][1]) == ("certificate" in given)


def test_each_explorer_of_a_comparison_has_its_rules_its_places_and_its_file(monkeypatch):
    monkeypatch.setattr(scope, "tried_places", lambda kind, extent: f"{kind} of {extent}")
    rules = SimpleNamespace(
        lighthouse="door", policy="fifo", the_bound=SimpleNamespace(name="m"), shared_file=""
    )
    one = SimpleNamespace(name="mine", rules=rules)
    facts = explorer_facts(SimpleNamespace(entrants=[one], extent="all"))
    assert [name for name, _ in facts] == ["explorer", "places", "trust"]
    assert facts[1] == ("places", "door of all")
    assert facts[2] == ("trust", "")
    rules.shared_file = "a.py"
    told = explorer_facts(SimpleNamespace(entrants=[one], extent="all"))[2][1]
    assert told == "a.py holds the explorer, and code that judges it: see docs/trust.md"


INTERVAL = (
    "95% confidence in mean or ratio, by Student's t on logarithms; the sign -: fewer than 5 "
    "worlds, or a cost of 0"
)


@pytest.mark.parametrize("lack", ["", "scipy is not installed"])
def test_an_interval_that_is_missing_has_its_reason(lack, monkeypatch):
    monkeypatch.setattr("allworlds.studies.compare.intervals.lack", lambda: lack)
    told = compare("algorithm1", family="prism", to=12, draws=1, places=1)
    said = [line for line in text_of(told, 200).splitlines() if line.startswith("interval")]
    assert [line.split(maxsplit=1)[1] for line in said] == [lack or INTERVAL]


def test_in_the_map_of_a_checkpoint_the_vertices_that_are_not_explored_have_no_name():
    shown = SimpleNamespace(sigma=(1, 0), alpha=(0, 1), here=0, step=0)
    story = SimpleNamespace(
        finding=SimpleNamespace(step=0, seen="", believed=shown),
        world=World(named_map("theta"), Directional(0)),
        walk=SimpleNamespace(actions=()),
    )
    (block,) = _belief(story)
    _, (title, scene) = block.entries
    assert [*scene.vertices] == ["s0", "?", "?"]
    assert "in the explorer's numbers (darts at '?' lead to unknown vertices)" in title
    story.finding.step = None
    assert _belief(story)
    shown.here = 9
    (block,) = _belief(story)
    assert "sigma [1, 0], alpha [0, 1], here 9. This map has no such dart 'here'" in str(block)


def grown(exponent, lack=""):
    interval = None if lack else (1.2, 1.8)
    return SimpleNamespace(
        family="cubic", explorer="mine", sizes=6, exponent=exponent, interval=interval, lack=lack
    )


def test_exponents_are_a_table_if_one_of_them_is_known():
    few = grown(None, "fewer than 5 sizes")
    assert [*_exponents(SimpleNamespace(exponents=[few]))] == []
    (table,) = _exponents(SimpleNamespace(exponents=[few, grown(1.5)]))
    assert table.header == ["family", "explorer", "sizes", "exponent", "interval"]
    assert [row[0] for row in table.texts] == ["cubic", "cubic"]
    few, known = (row[3:] for row in table.texts)
    assert (few, known) == (["-", "fewer than 5 sizes"], ["1.50", "1.20..1.80"])


@pytest.mark.parametrize(
    ("complete", "done", "told"),
    [
        (True, Headline("HOLDS", "2 worlds", "holds"), ("HOLDS", "2 worlds", "holds")),
        (True, None, None),
        (False, None, ("INCONCLUSIVE", "late; before that nothing was finished", "")),
        (
            False,
            Headline("HOLDS", "", "holds"),
            ("INCONCLUSIVE", "late; before that nothing was finished", ""),
        ),
        (
            False,
            Headline("HOLDS", "2 worlds", "holds"),
            ("INCONCLUSIVE", "late; before that: 2 worlds", ""),
        ),
        (
            False,
            Headline("REFUTED", "1 world", "refuted"),
            ("REFUTED", "1 world; late, and the rest was not tried", "refuted"),
        ),
        (
            False,
            Headline("MISMATCH", "1 row", "error"),
            ("MISMATCH", "1 row; late, and the rest was not tried", "error"),
        ),
    ],
)
def test_the_first_line_of_a_job_that_ended_early_has_the_reason(complete, done, told):
    report = SimpleNamespace(complete=complete, ending=SimpleNamespace(reason="late"))
    found = so_far(report, done)
    assert (found and said(found)) == told


def test_a_run_without_its_walk_has_the_laws_and_its_rows():
    ran = run("algorithm1", "dipole-2")
    (whole,) = run_content(ran).sections
    content = run_content(replace(ran, shows_walk=False))
    (shown,) = content.sections
    assert [*shown.blocks] == [*whole.blocks][1:]
    assert len(content.rows().rows) == len(ran.walk.darts)
