"""Notebooks and ``print``: drawings with their own style, and texts of the command line."""

from xml.etree import ElementTree as ET

import allworlds
from reports import test_notebook as quick

world = quick.world


def test_runs_transcripts_and_findings_are_shown(world):
    run = allworlds.run("folding", world)
    assert "srcdoc=" in run._repr_html_()
    rows = ET.fromstring(run.transcript._repr_html_()).find("tbody")
    assert len(rows) == len(run.transcript.steps) + 1
    (finding,) = allworlds.check("dudek91", edges=2).findings
    assert finding.law in finding._repr_html_()
