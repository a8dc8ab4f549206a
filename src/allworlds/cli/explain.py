"""The verb ``explain``."""

from __future__ import annotations

import allworlds
from allworlds.cli.files import PageFile
from allworlds.cli.options import OutputGroup
from allworlds.cli.output import emit
from allworlds.studies.replay import AskedFinding


def explain(request: AskedFinding, *, page: PageFile, output: OutputGroup) -> int:
    """Example: allworlds explain finding.json

    Tell in words what the robot believed, what was true, and the first step where they part.
    """
    page.ensure_writable()
    explained = allworlds.explain(request.finding)
    page.write("explain", explained)
    return emit(explained, "explain", output)
