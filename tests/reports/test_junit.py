"""JUnit XML, held to the rules of the common schemas."""

import re
from collections import Counter
from itertools import combinations_with_replacement
from xml.etree import ElementTree as ET

import pytest

from allworlds import ledger
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.documents.document import replace
from allworlds.engines.units import shard_numbers
from allworlds.explorers.loading import built_in
from allworlds.inputs.checks import InputError
from allworlds.judging.rules import law_names
from allworlds.outcome import Completed, Disagreed, Interrupted, Stopped
from allworlds.reports.formats import content_of, file_of
from allworlds.reports.plain_text import finding_in_words as finding_text
from allworlds.studies.check.exhaustive import check
from allworlds.studies.check.report import CheckRequest, GateCell
from allworlds.studies.fuzz.sample_sweep import fuzz


def junit(report):
    return file_of("junit", report)


MUTANTS = {mutant.name: mutant for mutant in WRONG_EXPLORERS}

TEXT, SECONDS = "(?s).*", r"[0-9]+\.[0-9]{3}"
COUNTS = {"tests": TEXT, "failures": TEXT, "errors": TEXT}
RESULT = {"type": TEXT, "message": TEXT}
JENKINS = {
    "testsuites": ({"testsuite"}, {}, {"name": TEXT, "time": SECONDS, **COUNTS}),
    "testsuite": (
        {"testsuite", "properties", "testcase", "system-out", "system-err"},
        {"name": TEXT, **COUNTS},
        {
            **dict.fromkeys(("group", "skipped", "timestamp", "hostname", "id", "package"), TEXT),
            **dict.fromkeys(("file", "log", "url", "version"), TEXT),
            "time": SECONDS,
        },
    ),
    "testcase": (
        {"skipped", "error", "failure", "system-out", "system-err"},
        {"name": TEXT},
        {"time": SECONDS, "classname": TEXT, "group": TEXT},
    ),
    **dict.fromkeys(("failure", "error", "skipped"), (set(), {}, RESULT)),
}
"""What Jenkins takes (junit-10.xsd of its xUnit plugin): children, required attributes, others."""


def broken_rules(element):
    """The rules of Jenkins that an element and those below it break."""
    children, required, others = JENKINS[element.tag]
    for name in required:
        if name not in element.attrib:
            yield f"{element.tag} has no {name}"
    for name, value in element.attrib.items():
        if not re.fullmatch({**required, **others}.get(name, "(?!)"), value):
            yield f"{element.tag} has {name}={value!r}"
    for child in element:
        if child.tag in children:
            yield from broken_rules(child)
        else:
            yield f"{child.tag} stands in {element.tag}"


def suite_of(report):
    """The suite of a document that keeps the rules."""
    text = junit(report)
    assert text.startswith('<?xml version="1.0" encoding="UTF-8"?>\n')
    root = ET.fromstring(text.encode())
    assert root.tag == "testsuites"
    assert [child.tag for child in root] == ["testsuite"]
    suite = root[0]
    assert [*broken_rules(root)] == []
    assert root.get("time") == suite.get("time")
    cases = [*suite]
    assert {case.tag for case in cases} == {"testcase"}
    results = Counter()
    for case in cases:
        assert set(case.attrib) == {"classname", "name", "time"}
        assert all(case.attrib.values())
        assert len(case) <= 1
        for result in case:
            results[result.tag] += 1
            assert result.tag in ("failure", "error", "skipped")
            wanted = {"message"} if result.tag == "skipped" else {"message", "type"}
            assert set(result.attrib) == wanted
            assert all(result.attrib.values())
    names = [case.get("name") for case in cases]
    assert len(set(names)) == len(names)
    for counted in (root, suite):
        assert counted.get("tests") == str(len(cases))
        assert counted.get("failures") == str(results["failure"])
        assert counted.get("errors") == str(results["error"])
    assert suite.get("skipped") == str(results["skipped"])
    return suite


def outcomes(report):
    return [
        (case.get("name").rpartition(": ")[2], case[0].tag if len(case) else "passed")
        for case in suite_of(report).iter("testcase")
    ]


def levels(*results):
    names = ["every world with 1 edge", *(f"every world with {m} edges" for m in (2, 3, 4))]
    return list(zip(names, results, strict=False))


@pytest.fixture
def holds():
    return check(edges=2)


@pytest.fixture
def refuted():
    return check(MUTANTS["pose-lost"].explorer(), edges=4)


def test_every_case_tells_its_seconds_and_the_suite_their_sum(holds, refuted):
    def seconds(report):
        suite = suite_of(report)
        return [each.get("time") for each in (suite, *suite)]

    assert len(holds.seconds) == 2
    timed = replace(holds, seconds=(0.25, 1234.5))
    assert seconds(timed) == ["1234.750", "0.250", "1234.500", "0.000"]
    assert timed.seconds_by_part == {"level_seconds": [0.25, 1234.5]}
    timed = replace(refuted, seconds=(0.25, 2))
    assert seconds(timed) == ["2.250", "0.250", "2.000", "0.000", "0.000"]


def test_a_failure_tells_the_file_and_line_of_the_explorer(tmp_path, monkeypatch, refuted):
    assert "file" not in suite_of(refuted).attrib  # it is a closure
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.py").write_text("\n\ndef explore(first):\n    yield\n")
    (tmp_path / "deeper").mkdir()
    (tmp_path / ".git").mkdir()
    monkeypatch.chdir(tmp_path / "deeper")
    suite = suite_of(replace(refuted, explorer="../mine.py:explore"))
    assert suite.get("file") == "mine.py"
    text = suite.find(".//failure").text
    assert text == f"mine.py:3\n{finding_text(refuted.findings[0], 100)}"


def test_the_rules_of_jenkins_do_not_take_anything(refuted):
    for spoil in (
        lambda root: root.set("skipped", "0"),
        lambda root: root[0][0].set("file", "mine.py"),
        lambda root: root.set("time", "soon"),
        lambda root: root[0].attrib.pop("tests"),
        lambda root: root.append(root[0][0]),
    ):
        root = ET.fromstring(junit(refuted).encode())
        assert [*broken_rules(root)] == []
        spoil(root)
        assert [*broken_rules(root)]


def test_a_check_that_holds_has_one_case_a_level_and_the_witnesses(holds):
    assert outcomes(holds) == [*levels("passed", "passed"), ("witnesses", "passed")]


def test_a_finding_fails_its_level_and_the_unfinished_ones_are_skipped(refuted):
    assert outcomes(refuted) == levels("passed", "failure", "skipped", "skipped")
    failure = suite_of(refuted).find(".//failure")
    assert failure.get("type") == "pose"
    assert failure.text == finding_text(refuted.findings[0], 100)
    assert suite_of(refuted).find(".//skipped").get("message") == refuted.ending.reason


def test_every_finding_of_a_level_is_told():
    report = check(MUTANTS["pose-lost"].explorer(), edges=3, max_findings=9)
    text = "".join(failure.text for failure in suite_of(report).iter("failure"))
    for i, finding in enumerate(report.findings, 1):
        assert finding_text(finding, 100, i) in text
    assert len(report.findings) > 1


def test_a_mismatch_of_the_count_gate_is_an_error(holds):
    first, *others = holds.cells
    report = replace(holds, cells=(replace(first, counted=99), *others))
    assert outcomes(report)[0][1] == "error"
    assert "is 99" in suite_of(report).find(".//error").get("message")
    assert "the number equals" not in str(dict(content_of(report).short)["gate"])


def test_other_worlds_in_the_same_number_are_an_error(holds):
    first, *others = holds.cells
    report = replace(holds, cells=(replace(first, fingerprint="abc"), *others))
    assert report.exit_code == 70
    assert "but not the maps: their fingerprint is abc, not " in suite_of(report)[0][0].get(
        "message"
    )


def test_a_mismatch_in_a_refuted_level_keeps_the_finding(refuted):
    cell = GateCell(edges=2, vertices=1, enumerated=3, counted=99, source="somebody")
    suite = suite_of(replace(refuted, cells=(*refuted.cells, cell)))
    assert finding_text(refuted.findings[0], 100) in suite.find(".//error").text
    assert suite.find(".//failure") is None


def test_two_engines_that_disagree_are_an_error(holds):
    report = replace(holds, ending=Disagreed("python: 3, kernel: 4"))
    assert ("engines", "error") in outcomes(report)


def test_a_missing_witness_is_a_failure(holds):
    report = replace(holds, ending=Completed(("case-1",)))
    assert outcomes(report)[-1] == ("witnesses", "failure")
    assert "case-1" in suite_of(report).find(".//failure").get("message")


def test_a_scope_without_a_run_does_not_pass(holds):
    empty = replace(holds, tally=replace(holds.tally, rows={}))
    assert empty.exit_code == 4
    assert outcomes(empty)[-1] == ("witnesses", "failure")


def test_a_shard_says_nothing_of_witnesses():
    assert outcomes(check(edges=2, shard=(0, 2))) == levels("passed", "passed")


def test_a_check_that_ran_out_of_time_skips_with_the_reason(holds):
    report = replace(holds, levels=(1,), ending=Stopped("the time limit was reached"))
    assert outcomes(report) == levels("passed", "skipped")
    assert suite_of(report).find(".//skipped").get("message") == "the time limit was reached"


def test_past_findings_are_a_case_of_their_own(tmp_path):
    explorer = MUTANTS["pose-lost"].explorer()
    check(explorer, edges=2, corpus=tmp_path)
    standing = check(explorer, edges=2, corpus=tmp_path)
    assert outcomes(standing)[0] == ("past findings", "failure")
    # What was found beyond the scope says nothing of it.
    assert outcomes(check(explorer, edges=1, corpus=tmp_path))[0] == ("past findings", "passed")
    fixed = check(edges=1, corpus=tmp_path)
    # The corpus has named the mutant, but another explorer has been tried.
    assert outcomes(fixed)[0] == ("past findings", "passed")


JUDGES = """
def one(world, transcript, answer):
    return None

def two(world, transcript, answer):
    return "wrong"
"""

OPTIONS = {
    "explore": ("folding", "algorithm1-cluster"),
    "edges": (1, 2, 3),
    "vertices": (1, 2),
    "map_class": ("simple", "planar"),
    "where": ("bipartite", "cubic"),
    "lighthouse": ("position", "cluster", "told:n", "told:m", "told:n,m"),
    "task": ("count:n", "count:m", "judges.py:one", "judges.py:two"),
    "bound": ("none", "2*m", "2 * m + n"),
    "laws": ("map", "map,pose"),
    "policy": ("last", "random:1"),
    "step_budget": (1000, 1001),
    "max_findings": (2,),
    "shard": ("0/2", "1/2"),
    "worlds": ("a.json", "b.json"),
}
"""Values of options, each of which makes another check."""


def checks():
    """Checks of algorithm1 with one other value, or with two."""
    singles = [{name: value} for name, values in OPTIONS.items() for value in values]
    for one, other in combinations_with_replacement(singles, 2):
        if one == other or not {*one} & {*other}:
            yield one | other


def test_no_name_of_a_case_occurs_twice_in_the_reports_of_a_pipeline(tmp_path, monkeypatch):
    """Services keep one of two cases with one class and one name, and a failure would vanish."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "judges.py").write_text(JUDGES)
    names = Counter()
    done = check("algorithm1", edges=1)
    tried = 0
    for options in checks():
        explore = options.pop("explore", "algorithm1")
        asked = {"laws": law_names, "shard": shard_numbers}
        given = {key: asked.get(key, lambda each: each)(each) for key, each in options.items()}
        try:
            request = CheckRequest(explore, **given)
            request.rules(built_in(explore))
        except InputError:
            continue
        tried += 1
        report = replace(done, explorer=explore, request=request)
        names.update(case_names(report))
    assert tried > 150
    assert {name: count for name, count in names.items() if count > 1} == {}


def case_names(report):
    return [(case.get("classname"), case.get("name")) for case in suite_of(report)]


def test_the_name_of_a_case_holds_the_command():
    report = check("folding", edges=1, lighthouse="cluster", vertices=1)
    command = "folding --vertices 1 --edges 1 --lighthouse cluster"
    first, *_ = [name for _, name in case_names(report)]
    assert {*first.partition(": ")[0].split()} == {*command.split()}
    assert first.endswith(": every world with 1 edge")


def test_samples_checks_and_ledgers_share_no_name(tmp_path):
    one, other = (fuzz(edges=6, runs=2, seed=seed) for seed in (1, 2))
    claims = "from allworlds.claims import NotChecked\ndef a(means):\n    return NotChecked('no')"
    table = '[a]\nsection = "1"\nstatement = "s"\nmethod = "m"\nscope = "s"\nexpected = "holds"'
    ledgers = []
    for name in ("this", "that"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "claims.py").write_text(claims)
        text = f'{table}\nsource = "x"\nquick = {{ witnesses = {{ n = 1 }} }}\n'
        (tmp_path / name / "ledger.toml").write_text(text)
        ledgers += [ledger(tmp_path / name, budget=budget) for budget in ("quick", "full")]
    names = [
        name for report in (one, other, check(edges=1), *ledgers) for name in case_names(report)
    ]
    assert len(names) == len({*names}) == 2 + 2 + 4


def test_a_sample_is_one_case():
    assert [result for _, result in outcomes(fuzz(edges=6, runs=5))] == ["passed"]
    refuted = fuzz(MUTANTS["pose-lost"].explorer(), edges=6, runs=5)
    assert [result for _, result in outcomes(refuted)] == ["failure"]
    refuted.tally.findings = []
    interrupted = replace(refuted, ending=Interrupted())
    assert [result for _, result in outcomes(interrupted)] == ["skipped"]


def test_what_xml_forbids_is_replaced():
    def explore(first):
        raise ValueError("\x1b[31m \0 \ufffe \ud800 \N{GRINNING FACE} <&>\t")
        yield

    report = check(explore, edges=1)
    suite = suite_of(report)
    told = suite.find(".//failure").text
    assert "\N{GRINNING FACE} <&>" in told
    assert "[31m" in told
    assert not re.search("[\0-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]", told)
    assert r"\x1b[31m \x00 " in told
    assert told.count("\N{REPLACEMENT CHARACTER}") >= 2
