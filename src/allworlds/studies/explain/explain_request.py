"""Request of ``explain``: the finding, and how it is explained."""

from __future__ import annotations

from typing import Annotated

from allworlds.engines import AskedPatience
from allworlds.judging import Finding


class AskedExplanation(AskedPatience):
    """Options for the explanation of a finding."""


class ExplainRequest(AskedExplanation, kw_only=False):
    """Request of ``explain``: the finding, and how it is explained."""

    finding: Annotated[Finding, "the finding"]
    number: Annotated[int, "the number of the finding in its report, from 1 on"] = 1
    findings: Annotated[int, "how many findings the report holds"] = 1
