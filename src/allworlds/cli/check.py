"""The verb ``check`` on the command line."""

from typing import Annotated

import allworlds
from allworlds.cli.output import OutputGroup, respond
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import EFFORT, Option, Request
from allworlds.studies.check.report import CheckRequest


class CheckWords(Request):
    """The options of ``check`` on the command line that :func:`allworlds.check` does not have."""

    estimate: Annotated[
        bool, Option(EFFORT, "", "Only estimate the duration, from a sample of some seconds.")
    ] = False


def check(request: CheckRequest, *, words: CheckWords, output: OutputGroup) -> int:
    """Example: allworlds check my_explorer.py:explore --edges 4

    Run an explorer (default: Algorithm 1 of the paper) on every start and every marker
    orientation of every map of a class.  Exit code 0: holds, 1: refuted, 3: inconclusive,
    4: vacuous.
    """
    if words.estimate:
        written = next(iter(output.files or ()), None)
        kept = {"-o": written, "corpus": request.corpus, "run": request.run}
        for name, value in kept.items():
            if value is not None:
                raise InputError(
                    f"{name} {show(value)} has no effect beside --estimate; leave one of them out"
                )
        from allworlds.studies.check.time_estimate import estimate as estimated

        return respond(estimated, request, output)
    return respond(allworlds.check, request, output)
