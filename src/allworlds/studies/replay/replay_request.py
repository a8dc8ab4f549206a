"""Request of ``replay``: a finding, and another explorer if wanted."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

from allworlds.engines import AskedPatience
from allworlds.explorers import ProgramWords
from allworlds.inputs import SCOPE, Named, Option, Request
from allworlds.judging import AskedFinding


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
        """The name of the explorer, if one is given."""
        return ProgramWords(command=self.command, native=self.native).named(self.explorer)


class ReplayRequest(AskedPatience, AskedFinding, kw_only=False):
    """Request of ``replay``: a finding, and another explorer if wanted."""

    explore: Annotated[
        str | Callable[..., Any] | None,
        Named(AnotherExplorer, "an explorer in place of the recorded one"),
    ] = None
