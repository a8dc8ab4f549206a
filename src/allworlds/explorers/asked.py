"""How requests ask for explorers: by a name or a function in Python, by words elsewhere."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

from allworlds.explorers.subject import EXEC, NATIVE
from allworlds.inputs import SCOPE, Argument, InputError, Named, Option, Request, show

DEFAULT_EXPLORER = "algorithm1"


class ProgramWords(Request):
    """An explorer that is no Python, as the command line names it."""

    command: Annotated[
        str | None,
        Option(SCOPE, "COMMAND", "In place of EXPLORER: a program that speaks JSON lines.", "exec"),
    ] = None
    native: Annotated[
        str | None,
        Option(
            SCOPE,
            "PATH",
            "In place of EXPLORER: a shared library with the functions of allworlds.h.",
        ),
    ] = None

    def named(self, explorer: str | None) -> str | None:
        """The name of the one explorer that is given, if one is, by an argument or in these words.

        Raises:
            InputError: if several are.
        """
        given = {
            f"EXPLORER {show(explorer)}": explorer,
            f"--exec {show(self.command)}": None if self.command is None else EXEC + self.command,
            f"--native {show(self.native)}": None if self.native is None else NATIVE + self.native,
        }
        named = {option: name for option, name in given.items() if name is not None}
        if len(named) > 1:
            raise InputError(f"give {' or '.join(named)}, not both")
        return next(iter(named.values()), None)


class ExplorerWords(ProgramWords):
    """An explorer as the command line names it."""

    explorer: Annotated[
        str | None,
        Argument(
            "",
            "[EXPLORER]",
            "A built-in name, module:attribute, path/to/file.py:attribute or an entry point "
            "(default: algorithm1). Of a file with one generator function its name will do.",
        ),
    ] = None

    def value(self) -> str:
        """Its name; the default where none is given."""
        return self.named(self.explorer) or DEFAULT_EXPLORER


class ExplorersWords(Request):
    """Several explorers as the command line names them."""

    explorers: Annotated[
        list[str] | None,
        Argument(
            "",
            "[EXPLORER...]",
            "Built-in names, module:attribute, path/to/file.py:attribute or entry points; those "
            "of --exec and --native come after them.",
            repeated=True,
        ),
    ] = None
    command: Annotated[
        list[str] | None,
        Option(
            SCOPE,
            "COMMAND",
            "An explorer too: a program that speaks JSON lines; repeatable.",
            "exec",
            repeated=True,
        ),
    ] = None
    native: Annotated[
        list[str] | None,
        Option(
            SCOPE,
            "PATH",
            "An explorer too: a shared library with the functions of allworlds.h; repeatable.",
            repeated=True,
        ),
    ] = None

    def value(self) -> tuple[str, ...]:
        """The names of all of them."""
        return (
            *(self.explorers or ()),
            *(EXEC + command for command in self.command or ()),
            *(NATIVE + path for path in self.native or ()),
        )


class AskedExplorer(Request, kw_only=False):
    """Which explorer is run."""

    explore: Annotated[
        str | Callable[..., Any],
        Named(
            ExplorerWords,
            "a name, as on the command line, or a generator function (see "
            ":func:`allworlds.explorers.loading.load`)",
        ),
    ] = DEFAULT_EXPLORER
