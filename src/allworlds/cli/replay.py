"""The verb ``replay``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.files import PageFile
from allworlds.cli.output import complain, emit
from allworlds.inputs import read_text


def replay(
    file: opt.FindingFile,
    *,
    explorer: Annotated[
        str | None, opt.option(opt.SCOPE, "E", "In place of the recorded explorer.")
    ] = None,
    command: Annotated[
        str | None,
        opt.option(
            opt.SCOPE,
            "COMMAND",
            "In place of the recorded explorer: a program that speaks JSON lines.",
            "--exec",
        ),
    ] = None,
    native: Annotated[
        str | None,
        opt.option(
            opt.SCOPE,
            "PATH",
            "In place of the recorded explorer: a shared library with the functions of "
            "allworlds.h.",
            "--native",
        ),
    ] = None,
    answer_timeout: opt.AnswerTimeout = opt.ANSWER_TIMEOUT,
    page: PageFile,
    output: opt.OutputGroup,
) -> int:
    """Example: allworlds replay finding.json --explorer mended.py:explore

    Run a recorded finding again.  Exit code 0: reproduced, 5: fixed.  The recorded explorer
    repeats the recorded choices as far as they fit.
    """
    import allworlds

    page.ensure_writable()

    another = None
    if any(given is not None for given in (explorer, command, native)):
        another = opt.explorer_name(explorer, command, native)
    finding = allworlds.Finding.from_json(read_text(file))
    replayed = allworlds.replay(finding, another, answer_timeout=answer_timeout)
    if replayed.notice:
        complain(replayed.notice)
    page.write("replay", replayed)
    return emit(replayed, "replay", output)
