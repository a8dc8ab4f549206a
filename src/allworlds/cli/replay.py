"""The verb ``replay``."""

from __future__ import annotations

import allworlds
from allworlds.cli.files import PageFile
from allworlds.cli.options import OutputGroup
from allworlds.cli.output import complain, emit
from allworlds.inputs import answer
from allworlds.studies.replay import ReplayRequest


def replay(request: ReplayRequest, *, page: PageFile, output: OutputGroup) -> int:
    """Example: allworlds replay finding.json --explorer mended.py:explore

    Run a recorded finding again.  Exit code 0: reproduced, 5: fixed.  The recorded explorer
    repeats the recorded choices as far as they fit.
    """
    page.ensure_writable()
    replayed = answer(allworlds.replay, request)
    if replayed.notice:
        complain(replayed.notice)
    page.write("replay", replayed)
    return emit(replayed, "replay", output)
