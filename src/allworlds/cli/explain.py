"""The verb ``explain``."""

from __future__ import annotations

from allworlds.cli import options as opt
from allworlds.cli.files import PageFile
from allworlds.cli.output import emit
from allworlds.inputs import read_text


def explain(file: opt.FindingFile, *, page: PageFile, output: opt.OutputGroup) -> int:
    """Example: allworlds explain finding.json

    Tell in words what the robot believed, what was true, and the first step where they part.
    """
    import allworlds

    page.ensure_writable()
    explained = allworlds.explain(allworlds.Finding.from_json(read_text(file)))
    page.write("explain", explained)
    return emit(explained, "explain", output)
