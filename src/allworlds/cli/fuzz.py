"""The verb ``fuzz``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.files import Html, Junit, ensure_writable, write_reports
from allworlds.cli.output import Progress, emit


def fuzz(
    explorer: opt.Explorer = None,
    *,
    edges: Annotated[
        int,
        typer.Option(
            parser=opt.integer, metavar="M", help="At most M edges.", rich_help_panel=opt.SCOPE
        ),
    ],
    runs: Annotated[
        int,
        typer.Option(
            parser=opt.integer, metavar="R", help="How many worlds.", rich_help_panel=opt.SCOPE
        ),
    ],
    seed: Annotated[
        int,
        typer.Option(
            parser=opt.integer, metavar="S", help="Which sample.", rich_help_panel=opt.SCOPE
        ),
    ] = 0,
    command: opt.Exec = None,
    map_class: opt.MapClassName = "maps",
    lighthouse: opt.LighthouseName = None,
    policy: opt.PolicyName = "fifo",
    bound: opt.BoundName = None,
    laws: opt.LawNames = None,
    step_budget: opt.StepBudget = None,
    workers: Annotated[
        str, typer.Option(metavar="N|auto", rich_help_panel=opt.EFFORT, help="Processes.")
    ] = "auto",
    answer_timeout: opt.AnswerTimeout = 10.0,
    time_limit: opt.TimeLimit = None,
    memory: opt.Memory = None,
    junit: Junit = None,
    html: Html = None,
    as_json: opt.Json = False,
    quiet: opt.Quiet = False,
) -> int:
    """Example: allworlds fuzz my_explorer.py:explore --edges 20 --runs 1000

    Run an explorer in random worlds beyond the exhaustive bound, and shrink what refutes it.
    Exit code 0: not refuted by the sample, 1: refuted.
    """
    from allworlds.fuzzer import fuzz as run_fuzz

    ensure_writable(junit)
    ensure_writable(html)
    with Progress(quiet=quiet) as progress:
        report = run_fuzz(
            opt.explorer_name(explorer, command),
            edges=edges,
            runs=runs,
            seed=seed,
            map_class=map_class,
            lighthouse=lighthouse,
            policy=policy,
            bound=bound,
            laws=opt.law_names(laws),
            step_budget=step_budget,
            workers=opt.worker_count(workers),
            answer_timeout=answer_timeout,
            time_limit=time_limit,
            memory=memory,
            listener=progress,
        )
    write_reports(report, {"junit": junit, "html": html})
    emit(report, "fuzz", as_json=as_json)
    return report.exit_code
