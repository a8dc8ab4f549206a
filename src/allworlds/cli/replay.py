"""The verb ``replay`` on the command line."""

import allworlds
from allworlds.cli.output import OutputGroup, complain, emit
from allworlds.inputs.requests import answer
from allworlds.studies.run import ReplayRequest


def replay(request: ReplayRequest, *, output: OutputGroup) -> int:
    """Example: allworlds replay finding.json --explorer mended.py:explore

    Run a recorded finding again.  Exit code 0: reproduced, 5: fixed, 3: a nondeterministic
    explorer did the same each time.  The recorded explorer repeats the recorded choices as far as
    they fit.
    """
    replayed = answer(allworlds.replay, request)
    if replayed.notice:
        complain(replayed.notice)
    return emit(replayed, output)
