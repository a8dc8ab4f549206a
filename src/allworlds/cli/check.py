"""The verb ``check``."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.files import Files, ensure_directory
from allworlds.cli.output import emit
from allworlds.cli.values import shard_numbers
from allworlds.cli.watch import kept_in, watched
from allworlds.inputs import InputError, show

if TYPE_CHECKING:
    from allworlds.studies.check import CheckOptions


def check(
    explorer: opt.Explorer = None,
    *,
    command: opt.Exec = None,
    native: opt.Native = None,
    bounds: opt.ExtentGroup,
    lighthouse: opt.LighthouseName = None,
    shard: opt.ShardText = "0/1",
    schedules: Annotated[
        str,
        opt.option(
            opt.RULES,
            "one|all",
            "all: every sequence of choices, for an explorer that takes choices.",
        ),
    ] = "one",
    rules: opt.RulesGroup,
    engine: Annotated[str, opt.option(opt.EFFORT, "auto|python|kernel", "Which engine.")] = "auto",
    max_findings: Annotated[
        int,
        opt.number(
            opt.EFFORT,
            "K",
            "Stop after whole levels with K findings, the smallest of each law and map.",
        ),
    ] = 1,
    effort: opt.EffortGroup,
    corpus: Annotated[
        str | None,
        opt.option(
            opt.EFFORT,
            "DIR",
            "A directory of findings: tried first, and new ones are written to it.",
            show_default=False,
        ),
    ] = None,
    run: opt.RunDirectory = None,
    dask: opt.DaskAddress = None,
    watch: Annotated[
        bool,
        opt.flag(opt.EFFORT, "Check again whenever the explorer is saved, what was found first."),
    ] = False,
    estimate: Annotated[
        bool,
        typer.Option(
            "--estimate",
            help="Only say how long it would take, from a sample of some seconds.",
            rich_help_panel=opt.EFFORT,
        ),
    ] = False,
    files: Files,
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds check my_explorer.py:explore --edges 4

    Run an explorer (default: Algorithm 1 of the paper) on every start and every marker
    orientation of every map of a class.  Exit code 0: holds, 1: refuted, 3: inconclusive,
    4: vacuous.
    """
    import allworlds
    from allworlds.studies.check import estimate as estimated

    if estimate:
        _refuse_beside_estimate({**files.named(), "corpus": corpus, "run": run, "watch": watch})
    files.ensure_writable()
    explore = opt.explorer_name(explorer, command, native)
    asked: CheckOptions = {
        **opt.many_runs(bounds.map_class, lighthouse, rules, effort),
        "edges": bounds.edges,
        "vertices": bounds.vertices,
        "schedules": schedules,
        "shard": shard_numbers(shard),
        "engine": engine,
        "dask": dask,
    }
    if estimate:
        with listening(output) as listener:
            guess = estimated(explore, listener=listener, **asked)
            listener.verdict(guess)
        return emit(guess, "check", output, workers=effort.count)
    ensure_directory(corpus)

    def once(corpus: str | None) -> int:
        with listening(output) as listener:
            report = allworlds.check(
                explore,
                max_findings=max_findings,
                corpus=corpus,
                run=run,
                listener=listener,
                **asked,
            )
            listener.verdict(report)
        files.write(report)
        return emit(report, "check", output, workers=effort.count)

    if not watch:
        return once(corpus)
    if run is not None:
        raise InputError(
            f"watch cannot be given with run {show(run)}, which is about one text of the explorer"
        )
    with kept_in(corpus) as past:
        return watched(explore, lambda: once(past))


def _refuse_beside_estimate(given: Mapping[str, str | bool | None]) -> None:
    """Nothing, if none of these options of a whole check is given.

    Raises:
        InputError: naming the first.
    """
    for name, value in given.items():
        if value is not None and value is not False:
            raise InputError(
                f"{name} {'' if value is True else show(value) + ' '}has no effect beside "
                "--estimate, which checks nothing; leave one of them out"
            )
