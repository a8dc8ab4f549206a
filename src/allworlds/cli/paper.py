"""The verbs ``paper claims`` and ``paper figure``."""

from __future__ import annotations

from typing import Annotated

import allworlds
from allworlds.cli.events import answered, listening
from allworlds.cli.files import Files, ensure_writable
from allworlds.cli.options import LongOutputGroup
from allworlds.cli.output import emit
from allworlds.engines import AskedWorkers
from allworlds.evidence.figures import FigureRequest
from allworlds.inputs import EFFORT, SCOPE, Option

IDS = "may be repeated"


def claims(
    *,
    only: Annotated[
        list[str] | None,
        Option(SCOPE, "ID", f"Only this claim; {IDS}.", repeated=True),
    ] = None,
    require: Annotated[
        list[str] | None,
        Option(
            SCOPE,
            "ID",
            f"A claim that must be checked, else the exit code is 3; {IDS}.",
            repeated=True,
        ),
    ] = None,
    proofs: Annotated[
        str | None,
        Option(
            SCOPE,
            "DIR",
            "The folder 'proofs' of the sources: certificates, and with --budget full and an "
            "installed Coq the proofs (default: that of the clone of the sources; without one "
            "their claims are not checked).",
        ),
    ] = None,
    budget: Annotated[
        str,
        Option(
            EFFORT,
            "quick|full",
            "How much is checked: quick is less than a minute, full less than half an hour.",
        ),
    ] = "quick",
    effort: AskedWorkers,
    files: Files,
    output: LongOutputGroup,
) -> int:
    """Example: allworlds paper claims --only fig1 --html fig1.html

    The ledger: each sentence of the paper that can be checked, and each sentence that this project
    adds, with the expected verdict and the verdict found. Misprints are expected to be refuted.
    Exit code 0: all that was checked is as expected, 1: something is not, 3: a required claim was
    not checked, 4: no claim was checked, or a claim was checked on no case.
    """
    with listening(output) as listener:
        report = allworlds.claims(
            only=only or (),
            require=require or (),
            proofs=proofs,
            budget=budget,
            workers=effort.workers,
            listener=listener,
        )
        listener.verdict(report)
    files.write("paper claims", report)
    seconds = [one.seconds for one in report.claims]
    return emit(report, "paper claims", output, workers=effort.workers, claim_seconds=seconds)


def figure(request: FigureRequest, *, output: LongOutputGroup) -> int:
    """Example: allworlds paper figure 2 --out pass.svg

    A figure of the paper, drawn from runs that were judged or from a proof that was checked, and
    its data as CSV; needs the extra 'figures'. Exit code 0: the checks of the figure succeed, 1:
    they do not.
    """
    for path in request.files:
        ensure_writable(str(path))
    report = answered(allworlds.figure, request, output)
    return emit(report, "paper figure", output, workers=request.workers)
