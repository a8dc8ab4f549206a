"""What ``replay`` is asked for, as a value."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

from allworlds.engines import AskedPatience
from allworlds.explorers import ProgramWords
from allworlds.inputs import SCOPE, Argument, Named, Option, Request, read_text
from allworlds.judging import Finding


class AnotherExplorer(Request):
    """An explorer in place of the recorded one, as the command line names it."""

    explorer: Annotated[str | None, Option(SCOPE, "E", "In place of the recorded explorer.")] = None
    command: Annotated[
        str | None,
        Option(
            SCOPE,
            "COMMAND",
            "In place of the recorded explorer: a program that speaks JSON lines.",
            "exec",
        ),
    ] = None
    native: Annotated[
        str | None,
        Option(
            SCOPE,
            "PATH",
            "In place of the recorded explorer: a shared library with the functions of "
            "allworlds.h.",
        ),
    ] = None

    def value(self) -> str | None:
        """Its name, if one is given."""
        return ProgramWords(command=self.command, native=self.native).named(self.explorer)


def finding_in(path: str) -> Finding:
    """The finding in a file; in stdin for ``-``."""
    return Finding.from_json(read_text(path))


class AskedFinding(Request, kw_only=False):
    """Which finding is meant."""

    finding: Annotated[
        Finding,
        Argument(
            "",
            "FILE",
            "A finding, or a check's report; - for stdin.",
            parse=finding_in,
        ),
    ]


class ReplayRequest(AskedPatience, AskedFinding, kw_only=False):
    """What ``replay`` is asked for."""

    explore: Annotated[
        str | Callable[..., Any] | None,
        Named(AnotherExplorer, "an explorer in place of the recorded one"),
    ] = None
