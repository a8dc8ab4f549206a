"""The verbs ``self mutants`` and ``self bench``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.output import emit


def mutants(
    *,
    edges: Annotated[
        int, opt.number(opt.SCOPE, "M", "Try worlds with at most M edges (1 to 4).")
    ] = 4,
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds self mutants

    Try wrong explorers, weakened judges and broken enumerators, and say which check kills
    which at which smallest world.  Exit code 1: one survived.
    """
    import allworlds

    with listening(output) as listener:
        matrix = allworlds.mutants(edges=edges, listener=listener)
        listener.verdict(matrix)
    return emit(matrix, "self mutants", output)


def bench(
    *,
    edges: Annotated[
        int, opt.number(opt.SCOPE, "M", "The level that the compiled engines do.")
    ] = 7,
    rounds: Annotated[
        int, opt.number(opt.EFFORT, "R", "How often each contender takes its turn.")
    ] = 3,
    peer: Annotated[
        list[str] | None,
        opt.option(
            opt.SCOPE,
            "NAME[@M]=COMMAND",
            "Another program that walks every world with M edges (default: those of --edges); "
            "repeatable.",
            show_default=False,
        ),
    ] = None,
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds self bench --edges 7 --peer 'lazy=./lazy 1 7'

    Measure this program's engines and others side by side, in turns; ratios with their
    spread.
    """
    import allworlds

    with listening(output) as listener:
        report = allworlds.bench(edges=edges, rounds=rounds, peers=peer or (), listener=listener)
        listener.verdict(report)
    return emit(report, "self bench", output)
