"""One function a verb."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.files import Html, Junit, ensure_writable, write_reports
from allworlds.cli.output import Progress, complain, emit
from allworlds.inputs import InputError, read_text


def check(
    explorer: opt.Explorer = None,
    *,
    command: opt.Exec = None,
    edges: opt.Edges = None,
    vertices: opt.Vertices = None,
    map_class: opt.MapClassName = "maps",
    lighthouse: opt.LighthouseName = None,
    shard: Annotated[
        str,
        typer.Option(
            metavar="K/N", help="Only every N-th part, from the K-th.", rich_help_panel=opt.SCOPE
        ),
    ] = "0/1",
    policy: opt.PolicyName = "fifo",
    schedules: Annotated[
        str,
        typer.Option(
            metavar="one|all",
            help="all: every sequence of choices, for an explorer that takes choices.",
            rich_help_panel=opt.RULES,
        ),
    ] = "one",
    bound: opt.BoundName = None,
    laws: opt.LawNames = None,
    step_budget: opt.StepBudget = None,
    engine: Annotated[
        str,
        typer.Option(
            metavar="auto|python|kernel", rich_help_panel=opt.EFFORT, help="Which engine."
        ),
    ] = "auto",
    workers: Annotated[
        str,
        typer.Option(metavar="N|auto", rich_help_panel=opt.EFFORT, help="Processes, or threads."),
    ] = "auto",
    max_findings: Annotated[
        int,
        typer.Option(
            parser=opt.integer,
            metavar="K",
            rich_help_panel=opt.EFFORT,
            help="Stop after K findings of whole levels.",
        ),
    ] = 1,
    answer_timeout: opt.AnswerTimeout = 10.0,
    time_limit: opt.TimeLimit = None,
    memory: opt.Memory = None,
    corpus: opt.CorpusDirectory = None,
    junit: Junit = None,
    html: Html = None,
    as_json: opt.Json = False,
    quiet: opt.Quiet = False,
) -> int:
    """Example: allworlds check my_explorer.py:explore --edges 4

    Run an explorer (default: Algorithm 1 of the paper) on every start and every marker
    orientation of every map of a class.  Exit code 0: holds, 1: refuted, 3: inconclusive,
    4: vacuous.
    """
    from allworlds.checker import check as run_check

    ensure_writable(junit)
    ensure_writable(html)
    opt.ensure_directory(corpus)
    with Progress(quiet=quiet) as progress:
        report = run_check(
            opt.explorer_name(explorer, command),
            edges=edges,
            vertices=vertices,
            map_class=map_class,
            lighthouse=lighthouse,
            policy=policy,
            schedules=schedules,
            bound=bound,
            laws=opt.law_names(laws),
            step_budget=step_budget,
            shard=opt.shard_numbers(shard),
            workers=opt.worker_count(workers),
            answer_timeout=answer_timeout,
            time_limit=time_limit,
            memory=memory,
            max_findings=max_findings,
            engine=engine,
            corpus=corpus,
            listener=progress,
        )
    write_reports(report, {"junit": junit, "html": html})
    emit(report, "check", as_json=as_json)
    return report.exit_code


def count(
    *,
    edges: opt.Edges = None,
    vertices: opt.Vertices = None,
    map_class: opt.MapClassName = "maps",
    as_json: opt.Json = False,
) -> int:
    """Example: allworlds count --edges 6

    Enumerate every rooted map of a class, count, and compare the counts with an independent
    source.
    """
    from allworlds.counter import count as run_count

    census = run_count(edges=edges, vertices=vertices, map_class=map_class)
    emit(census, "count", as_json=as_json)
    return census.exit_code


def run(
    arguments: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[EXPLORER] WORLD",
            help="WORLD: inline JSON, @file, or a name such as k4, wheel-4, theta-torus; "
            "left out with --family.",
            show_default=False,
        ),
    ] = None,
    *,
    command: opt.Exec = None,
    family: Annotated[
        str | None,
        typer.Option(
            metavar="F",
            help="In place of WORLD: lattice:RxC, dense:N, cycle:N or random:M.",
            rich_help_panel=opt.SCOPE,
        ),
    ] = None,
    holes: Annotated[
        str | None,
        typer.Option(
            metavar="P%",
            help="Share of a family's edges to remove [default: none].",
            rich_help_panel=opt.SCOPE,
            show_default=False,
        ),
    ] = None,
    seed: Annotated[
        int,
        typer.Option(
            parser=opt.integer,
            metavar="S",
            help="For a random family, or for the holes.",
            rich_help_panel=opt.SCOPE,
        ),
    ] = 0,
    policy: opt.PolicyName = "fifo",
    choices: Annotated[
        str | None,
        typer.Option(
            metavar="I,I,...",
            help="Answers to the first choices, by index; then the policy goes on.",
            rich_help_panel=opt.RULES,
        ),
    ] = None,
    bound: opt.BoundName = None,
    laws: opt.LawNames = None,
    step_budget: opt.StepBudget = None,
    answer_timeout: opt.AnswerTimeout = 10.0,
    as_json: opt.Json = False,
) -> int:
    """Example: allworlds run algorithm1 theta

    Run an explorer once in one world, tell it step by step, and judge it.
    """
    from allworlds.checker import refuse_unused
    from allworlds.checker import run as run_single
    from allworlds.subjects import own_lighthouse
    from allworlds.world import World, world_of_family

    explorer, place = opt.explorer_and_world(
        list(arguments or []), family=family is not None, program=command is not None
    )
    name = opt.explorer_name(explorer, command)
    world: World | str = place
    if family is not None:
        world = world_of_family(family, holes, seed, own_lighthouse(name))
    elif holes is not None:
        raise InputError(f"holes {holes} has no effect without --family")
    told = run_single(
        name,
        world,
        policy=policy,
        choices=opt.index_list(choices),
        bound=bound,
        laws=opt.law_names(laws),
        step_budget=step_budget,
        answer_timeout=answer_timeout,
    )
    refuse_unused(opt.index_list(choices), told)
    emit(told, "run", as_json=as_json)
    return told.exit_code


def replay(
    file: Annotated[str, typer.Argument(metavar="FILE", help="A finding, or a check's report.")],
    *,
    explorer: Annotated[
        str | None,
        typer.Option(metavar="E", help="In place of the recorded explorer."),
    ] = None,
    answer_timeout: opt.AnswerTimeout = 10.0,
    as_json: opt.Json = False,
) -> int:
    """Example: allworlds replay finding.json --explorer mended.py:explore

    Run a recorded finding again.  Exit code 0: reproduced, 5: fixed.  The recorded explorer
    repeats the recorded choices as far as they fit.
    """
    from allworlds.checker import replay as run_replay
    from allworlds.findings import Finding

    finding = Finding.from_json(read_text(file))
    replayed = run_replay(finding, explorer, answer_timeout=answer_timeout)
    if replayed.notice:
        complain(replayed.notice)
    emit(replayed, "replay", as_json=as_json)
    return replayed.exit_code
