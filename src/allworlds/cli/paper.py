"""The verbs ``paper claims`` and ``paper figure``."""

from __future__ import annotations

from typing import Annotated

import allworlds
from allworlds.cli.events import answered, listening
from allworlds.cli.files import ensure_all_writable, write_files
from allworlds.cli.options import LongOutputGroup
from allworlds.cli.output import emit
from allworlds.engines import AskedWorkers
from allworlds.evidence.figures import FigureRequest
from allworlds.inputs import EFFORT, OUTPUT, SCOPE, Option
from allworlds.reports import FORMATS

IDS = "once or several times"


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
            "installed Coq the proofs; without it their claims are not checked.",
        ),
    ] = None,
    budget: Annotated[
        str, Option(EFFORT, "quick|full", "Below a minute, or below half an hour.")
    ] = "quick",
    effort: AskedWorkers,
    junit: Annotated[
        str | None,
        Option(OUTPUT, "FILE", FORMATS["junit"].help),
    ] = None,
    html: Annotated[
        str | None,
        Option(
            OUTPUT,
            "FILE",
            "Write the ledger as a web page too, with pictures of the worlds that it names.",
        ),
    ] = None,
    output: LongOutputGroup,
) -> int:
    """Example: allworlds paper claims --only fig1 --html fig1.html

    The ledger: each sentence of the paper that can be checked, and our own, with the verdict that
    it must get and the one that was found.  Misprints are expected to be refuted.  Exit code 0:
    all that was checked is as expected, 1: something is not, 3: a required claim was not checked,
    4: nothing was met that a claim is about.
    """
    files = {"html": html, "junit": junit}
    ensure_all_writable(files)
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
    write_files("paper claims", report, files)
    seconds = [one.seconds for one in report.claims]
    return emit(report, "paper claims", output, workers=effort.workers, claim_seconds=seconds)


def figure(request: FigureRequest, *, output: LongOutputGroup) -> int:
    """Example: allworlds paper figure 2 --out pass.svg

    A figure of the paper, drawn from runs that were judged or from a proof that was checked, and
    its data as CSV; needs the extra 'figures'.  Exit code 0: what is drawn is so, 1: it is not.
    """
    ensure_all_writable({path.suffix: str(path) for path in request.files})
    report = answered(allworlds.figure, request, output)
    return emit(report, "paper figure", output, workers=request.workers)
