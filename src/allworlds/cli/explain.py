"""The verb ``explain``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.output import emit
from allworlds.inputs import read_text


def explain(
    file: Annotated[str, typer.Argument(metavar="FINDING", help="A finding, or a check's report.")],
    *,
    as_json: opt.Json = False,
) -> int:
    """Example: allworlds explain finding.json

    Tell in words what the robot believed, what was true, and the first step where they part.
    """
    from allworlds.explaining import explain as run_explain
    from allworlds.findings import Finding

    explanation = run_explain(Finding.from_json(read_text(file)))
    emit(explanation, "explain", as_json=as_json)
    return explanation.exit_code
