"""The verb ``claims``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.files import ensure_all_writable, write_files
from allworlds.cli.output import emit
from allworlds.cli.values import worker_count
from allworlds.reports import FORMATS

IDS = "once or several times"


def claims(
    *,
    only: Annotated[
        list[str] | None,
        opt.option(opt.SCOPE, "ID", f"Only this claim; {IDS}.", show_default=False),
    ] = None,
    require: Annotated[
        list[str] | None,
        opt.option(
            opt.SCOPE,
            "ID",
            f"A claim that must be checked, else the exit code is 3; {IDS}.",
            show_default=False,
        ),
    ] = None,
    proofs: Annotated[
        str | None,
        opt.option(
            opt.SCOPE,
            "DIR",
            "The folder 'proofs' of the sources: certificates, and with --budget full and an "
            "installed Coq the proofs; without it their claims are not checked.",
            show_default=False,
        ),
    ] = None,
    budget: Annotated[
        str, opt.option(opt.EFFORT, "quick|full", "Below a minute, or below half an hour.")
    ] = "quick",
    workers: opt.Workers = "auto",
    junit: Annotated[
        str | None,
        opt.option(opt.OUTPUT, "FILE", FORMATS["junit"].help, show_default=False),
    ] = None,
    html: Annotated[
        str | None,
        opt.option(
            opt.OUTPUT,
            "FILE",
            "Write the ledger as a web page too, with pictures of the worlds that it names.",
            show_default=False,
        ),
    ] = None,
    output: opt.LongOutput,
) -> int:
    """Example: allworlds claims --only fig1 --html fig1.html

    The ledger: each sentence of the paper that can be checked, and our own, with the verdict that
    it must get and the one that was found.  Misprints are expected to be refuted.  Exit code 0:
    all that was checked is as expected, 1: something is not, 3: a required claim was not checked,
    4: nothing was met that a claim is about.
    """
    import allworlds

    files = {"html": html, "junit": junit}
    ensure_all_writable(files)
    threads = worker_count(workers)
    with listening(output) as listener:
        report = allworlds.claims(
            only=only or (),
            require=require or (),
            proofs=proofs,
            budget=budget,
            workers=threads,
            listener=listener,
        )
        listener.verdict(report)
    write_files("claims", report, files)
    seconds = [entry.seconds for entry in report.entries]
    return emit(report, "claims", output, workers=threads, claim_seconds=seconds)
