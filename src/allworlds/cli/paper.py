"""The verbs ``paper claims`` and ``paper figure``."""

from __future__ import annotations

from typing import Annotated

import typer

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
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds paper claims --only fig1 --html fig1.html

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
    write_files("paper claims", report, files)
    seconds = [one.seconds for one in report.claims]
    return emit(report, "paper claims", output, workers=threads, claim_seconds=seconds)


def figure(
    name: Annotated[
        str,
        typer.Argument(
            metavar="1|2|3|bounds",
            help="Twins, one pass of Algorithm 1, the cost in graphs with holes; or the exact "
            "worst cases beside the bound.",
        ),
    ],
    *,
    out: Annotated[
        str | None,
        opt.option(
            opt.OUTPUT,
            "FILE",
            "The picture: .svg, .png or .pdf; the data go beside it as .csv "
            "[default: figure-NAME.svg].",
            show_default=False,
        ),
    ] = None,
    worlds: Annotated[
        int | None,
        opt.number(opt.SCOPE, "K", "Graphs of each size, for 3 [default: 30].", show_default=False),
    ] = None,
    seed: Annotated[
        int | None,
        opt.number(
            opt.SCOPE, "S", "Of the first graph of a size, for 3 [default: 1].", show_default=False
        ),
    ] = None,
    edges: Annotated[
        int | None,
        opt.number(opt.SCOPE, "M", "At most M edges, for bounds [default: 6].", show_default=False),
    ] = None,
    effort: opt.EffortGroup,
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds paper figure 2 --out pass.svg

    A figure of the paper, drawn from runs that were judged or from a proof that was checked, and
    its data as CSV; needs the extra 'figures'.  Exit code 0: what is drawn is so, 1: it is not.
    """
    import allworlds
    from allworlds.evidence.figures import files_of

    ensure_all_writable({str(i): str(path) for i, path in enumerate(files_of(name, out))})
    with listening(output) as listener:
        report = allworlds.figure(
            name,
            out=out,
            worlds=worlds,
            seed=seed,
            edges=edges,
            workers=effort.count,
            time_limit=effort.time_limit,
            memory=effort.memory,
            listener=listener,
        )
        listener.verdict(report)
    return emit(report, "paper figure", output, workers=effort.count)
