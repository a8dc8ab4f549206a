"""The command of a verb that answers one request, and does no more."""

from __future__ import annotations

from collections.abc import Callable

from allworlds.cli.events import answered
from allworlds.cli.files import Files
from allworlds.cli.made_by import MeasuredEffort
from allworlds.cli.options import LongOutputGroup
from allworlds.cli.output import emit
from allworlds.engines import AskedListener
from allworlds.lazy import loaded
from allworlds.verbs import Verb


def plain_command(verb: Verb) -> Callable[..., int]:
    """The function that runs a verb on the command line: it answers, writes files, and prints."""
    function = loaded(verb.function)

    def command(request: AskedListener, *, files: Files, output: LongOutputGroup) -> int:
        report = answered(function, request, output)
        files.write(verb.name, report)
        workers = getattr(request, "workers", None)
        effort = MeasuredEffort() if workers is None else MeasuredEffort(workers=workers)
        return emit(report, verb.name, output, **effort)

    hints = {"request": function.request, "files": Files, "output": LongOutputGroup, "return": int}
    command.__annotations__ = hints
    command.__doc__ = f"Example: allworlds {verb.name} {verb.example}\n\n{verb.help}"
    return command
