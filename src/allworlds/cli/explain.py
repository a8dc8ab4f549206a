"""The verb ``explain``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.output import emit


def explain(
    file: Annotated[str, typer.Argument(metavar="FINDING", help="A finding, or a check's report.")],
    *,
    as_json: opt.Json = False,
) -> int:
    """Example: allworlds explain finding.json

    Tell in words what the robot believed, what was true, and the first step where they part.
    """
    from allworlds.checker import Finding
    from allworlds.explaining import explain as run_explain
    from allworlds.reports.explain_text import explain_text

    explanation = run_explain(Finding.from_json(opt.read_text(file)))
    emit(explanation, lambda width: explain_text(explanation, width), as_json=as_json)
    return explanation.exit_code
