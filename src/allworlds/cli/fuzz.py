"""The verb ``fuzz``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.files import Files
from allworlds.cli.output import emit


def fuzz(
    explorer: opt.Explorer = None,
    *,
    edges: Annotated[int, opt.number(opt.SCOPE, "M", "At most M edges.")],
    min_edges: Annotated[
        int, opt.number(opt.SCOPE, "L", "At least L edges: more than were tried exhaustively.")
    ] = 1,
    runs: Annotated[int, opt.number(opt.SCOPE, "R", "How many worlds.")],
    seed: Annotated[int, opt.number(opt.SCOPE, "S", "Which sample.")] = 0,
    command: opt.Exec = None,
    native: opt.Native = None,
    map_class: opt.MapClassName = "maps",
    lighthouse: opt.LighthouseName = None,
    rules: opt.RulesGroup,
    effort: opt.EffortGroup,
    files: Files,
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds fuzz my_explorer.py:explore --edges 20 --min-edges 6 --runs 1000

    Run an explorer in random worlds beyond the exhaustive bound, and shrink what refutes it.
    Exit code 0: not refuted by the sample, 1: refuted.
    """
    import allworlds

    files.ensure_writable()
    with listening(output) as listener:
        report = allworlds.fuzz(
            opt.explorer_name(explorer, command, native),
            edges=edges,
            min_edges=min_edges,
            runs=runs,
            seed=seed,
            listener=listener,
            **opt.many_runs(map_class, lighthouse, rules, effort),
        )
        listener.verdict(report)
    files.write(report)
    return emit(report, "fuzz", output, workers=effort.count)
