"""The command of a verb that answers one request, and does no more."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from allworlds.cli.files import Files
from allworlds.cli.output import OutputGroup, answered, emit
from allworlds.lazy import loaded
from allworlds.verbs import Verb


def plain_command(verb: Verb) -> Callable[..., int]:
    """The function that runs a verb on the command line: it answers, writes files, and prints."""
    function = loaded(verb.function)

    def command(request: Any, *, files: Files, output: OutputGroup) -> int:
        files.expect(request)
        report = answered(function, request, output)
        files.write(verb.name, report)
        return emit(report, verb.name, output, getattr(request, "workers", None))

    hints = {"request": function.request, "files": Files, "output": OutputGroup, "return": int}
    command.__annotations__ = hints
    command.__doc__ = f"Example: allworlds {verb.name} {verb.example}".rstrip() + f"\n\n{verb.help}"
    return command
