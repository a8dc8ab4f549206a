"""The command check."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated

import allworlds
from allworlds.cli.files import Files, ensure_directory
from allworlds.cli.output import OutputGroup, answered, emit
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import EFFORT, Option
from allworlds.studies.check.requests import CheckRequest


def check(
    request: CheckRequest,
    *,
    estimate: Annotated[
        bool,
        Option(
            EFFORT,
            "",
            "Only estimate the duration, from a sample of some seconds.",
            "estimate",
        ),
    ] = False,
    files: Files,
    output: OutputGroup,
) -> int:
    """Example: allworlds check my_explorer.py:explore --edges 4

    Run an explorer (default: Algorithm 1 of the paper) on every start and every marker
    orientation of every map of a class.  Exit code 0: holds, 1: refuted, 3: inconclusive,
    4: vacuous.
    """
    if estimate:
        kept = {"corpus": request.corpus, "run": request.run}
        _refuse_beside_estimate({**files.named(), **kept})
        return _estimate(request, output)
    ensure_directory(request.corpus)
    report = answered(allworlds.check, request, output)
    files.write("check", report)
    return emit(report, "check", output, request.workers)


def _estimate(request: CheckRequest, output: OutputGroup) -> int:
    from allworlds.studies.check.exhaustive import estimate

    guess = answered(estimate, request, output)
    return emit(guess, "check", output, request.workers)


def _refuse_beside_estimate(given: Mapping[str, object]) -> None:
    """Raise InputError if an option is given that has no effect on an estimate.

    Raises:
        InputError: naming the first.
    """
    for name, value in given.items():
        if value is not None:
            raise InputError(
                f"{name} {show(value)} has no effect beside --estimate, which checks nothing; "
                "leave one of them out"
            )
