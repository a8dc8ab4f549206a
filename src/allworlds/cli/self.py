"""The verbs ``self mutants`` and ``self bench``."""

from __future__ import annotations

from typing import Annotated

import allworlds
from allworlds.cli.events import listening
from allworlds.cli.files import Files
from allworlds.cli.options import LongOutputGroup
from allworlds.cli.output import emit
from allworlds.inputs import EFFORT, SCOPE, Option, integer_of


def mutants(
    *,
    edges: Annotated[
        int, Option(SCOPE, "M", "Try worlds with at most M edges (1 to 4).", parse=integer_of)
    ] = 4,
    files: Files,
    output: LongOutputGroup,
) -> int:
    """Example: allworlds self mutants

    Try wrong explorers, weakened judges and broken enumerators, and say which check kills
    which at which smallest world.  Exit code 1: one survived.
    """
    with listening(output) as listener:
        matrix = allworlds.mutants(edges=edges, listener=listener)
        listener.verdict(matrix)
    files.write("self mutants", matrix)
    return emit(matrix, "self mutants", output)


def bench(
    *,
    edges: Annotated[
        int,
        Option(
            SCOPE,
            "M",
            "The number of edges of the worlds for the compiled engines.",
            parse=integer_of,
        ),
    ] = 7,
    rounds: Annotated[
        int,
        Option(
            EFFORT,
            "R",
            "The number of rounds; each contender runs once in a round.",
            parse=integer_of,
        ),
    ] = 3,
    peer: Annotated[
        list[str] | None,
        Option(
            SCOPE,
            "NAME[@M]=COMMAND",
            "Another program that walks every world with M edges (default: those of --edges); "
            "repeatable.",
            repeated=True,
        ),
    ] = None,
    files: Files,
    output: LongOutputGroup,
) -> int:
    """Example: allworlds self bench --edges 7 --peer 'lazy=./lazy 1 7'

    Measure this program's engines and others side by side, in turns; ratios with their
    spread.
    """
    with listening(output) as listener:
        report = allworlds.bench(edges=edges, rounds=rounds, peers=peer or (), listener=listener)
        listener.verdict(report)
    files.write("self bench", report)
    return emit(report, "self bench", output)
