"""A finding in words."""

from __future__ import annotations

from typing import Annotated

from allworlds.inputs.requests import Request, answers
from allworlds.judging.explanations.explanation import Explanation, explain as explained
from allworlds.judging.findings.finding import Finding


class ExplainRequest(Request, kw_only=False):
    """Request of ``explain``: the finding, and its place in its report."""

    finding: Annotated[Finding, "the finding"]
    number: Annotated[int, "the number of the finding in its report, from 1 on"] = 1
    findings: Annotated[int, "how many findings the report holds"] = 1


@answers(ExplainRequest)
def explain(request: ExplainRequest) -> Explanation:
    """Explain the finding in plain words.

    Raises:
        InputError: if the transcript of the finding is no walk in its world, or its answer is
            none.
    """
    return explained(request.finding, number=request.number, findings=request.findings)
