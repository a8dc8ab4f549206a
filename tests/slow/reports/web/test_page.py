"""The page: complete, self-contained, and the same every time."""

import json
import os
import subprocess
import sys

import pytest

from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.judging.findings.finding import Finding
from allworlds.studies.check.exhaustive import check
from allworlds.studies.explain import explain
from html_tree import read
from reports.web import test_page as quick
from reports.web.test_page import mutant, page

refuted = quick.refuted
root = quick.root


@pytest.mark.parametrize("name", [m.name for m in WRONG_EXPLORERS])
def test_there_is_a_page_of_every_wrong_explorer(name):
    report = check(mutant(name), edges=2)
    root = read(page(report))
    assert len([*root.all("section", class_="finding")]) == len(report.findings)
    for finding, walk in zip(report.findings, root.all("ol"), strict=True):
        assert len([*walk.all("li")]) == len(finding.transcript.steps) + 1


@pytest.mark.parametrize("kind", ["none", "position", "compass"])
def test_under_every_lighthouse_there_is_a_page(kind):
    report = check(edges=2, lighthouse=kind, laws=("map", "pose"))
    assert report.findings
    assert read(page(report)).one(id="finding-1-world")


SAME = """
import sys
from allworlds import check
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.reports.formats import file_of
from html_tree import read
wrong = next(m for m in WRONG_EXPLORERS if m.name == "wrong-entry-label")
report = check(wrong.explorer(), edges=3)
sys.stdout.buffer.write(file_of("html", report).encode())
"""


@pytest.mark.slowest
def test_the_bytes_are_the_same_whatever_the_hash_seed():
    paths = os.pathsep.join(filter(None, sys.path))
    pages = {
        subprocess.run(
            [sys.executable, "-c", SAME],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": paths},
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("0", "1", "2")
    }
    assert len(pages) == 1
    assert b"finding-1-answer" in pages.pop()


@pytest.mark.slowest
def test_the_page_shows_the_verdict_and_everything_that_check_prints(refuted, root):
    (verdict,) = root.all(class_="verdict refuted")
    assert "REFUTED" in verdict.text
    assert "law map is broken" in verdict.text
    cells = [[cell.text for cell in row.all("td")] for row in root.one("tbody").all("tr")]
    assert [row[:3] for row in cells] == [
        [str(row.edges), str(row.vertices), str(row.worlds)] for row in refuted.rows
    ]
    terms = [term.text for term in root.one(class_="scope").all("dt")]
    assert terms == ["explorer", "scope", "laws", "gate", "witnesses"]


def test_a_finding_reads_back_from_the_page_and_is_equal(refuted, root):
    records = [json.loads(block.text) for block in root.all("script", class_="finding")]
    assert len(records) > 1
    assert records == [finding.to_json() for finding in refuted.findings]
    assert Finding.from_json(records[0]).key == refuted.findings[0].key
    summary = json.loads(root.one(id="report-json").text)
    assert {**summary, "findings": records} == refuted.to_json()


def test_the_list_of_the_walk_has_one_item_a_step(refuted, root):
    for finding, walk in zip(refuted.findings, root.all("ol"), strict=True):
        items = list(walk.all("li"))
        assert len(items) == len(finding.transcript.steps) + 1
        assert ["data-moved" in item.attributes for item in items] == [
            i > 0 for i in range(len(items))
        ]
        sensed = [finding.transcript.first, *(p for _, p in finding.transcript.steps)]
        for item, percept in zip(items, sensed, strict=True):
            assert item.one(class_="sensed").text == f"sensed: {percept}"
            signs = {c.attributes["class"] for c in item.all("span")} & {"fits", "misfits"}
            assert len(signs) == (1 if finding.law in ("map", "pose") else 0)
        marked = [i for i, item in enumerate(items) if item.attributes.get("class") == "parting"]
        parting = explain(finding).step
        assert marked == ([] if parting is None else [parting])
