"""The verb ``compare`` on the command line."""

from __future__ import annotations

from allworlds.cli.output import OutputGroup, answered, emit
from allworlds.inputs.checks import InputError, show
from allworlds.studies.compare.compare_request import CompareRequest


def compare(request: CompareRequest, *, output: OutputGroup) -> int:
    """Example: allworlds compare algorithm1 dudek91 --edges 4

    Explorers side by side on the same worlds, each under its own lighthouse; the first is
    compared with each other one, in each rooted map by the mean over the lighthouse's places.
    With --to one or more explorers in worlds that grow: cost by size, with fitted exponents, as in
    allworlds compare algorithm1 dudek91 --family lattice,torus --to 100.
    Every run is judged.  Exit code 0: no law is broken, 1: one is.
    """
    from allworlds.studies.compare.contest import compared

    curves = dict(output.named).get("svg")
    if curves and request.to is None:
        raise InputError(f"-o {show(curves)} draws curves, and has no effect without --to")
    return emit(answered(compared, request, output), output, request.workers)
