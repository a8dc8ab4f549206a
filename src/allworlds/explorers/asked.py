"""Explorers in requests: a name or a function in Python, options on the command line."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

from allworlds.explorers.loading import EXEC, NATIVE
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import RARE_SCOPE, SCOPE, Argument, Option, OptionGroup, Request

DEFAULT_EXPLORER = "algorithm1"


class ProgramWords(Request):
    """The options of the command line that name an explorer outside Python."""

    command: Annotated[
        str | None,
        Option(SCOPE, "COMMAND", "The explorer: a program that speaks JSON lines.", "exec"),
    ] = None
    native: Annotated[
        str | None,
        Option(
            RARE_SCOPE,
            "PATH",
            "The explorer: a shared library with the functions of allworlds.h.",
        ),
    ] = None

    def named(self, explorer: str | None) -> str | None:
        """The name of the explorer that the argument or these options give; None if there is none.

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

    def named_or_default(self, explorer: str | None) -> str:
        """The name of the explorer, as :meth:`named`; the default if none is given."""
        name = self.named(explorer)
        return DEFAULT_EXPLORER if name is None else name


class ExplorerWords(ProgramWords):
    """The argument and options of the command line that name an explorer."""

    explorer: Annotated[
        str | None,
        Argument(
            "",
            "[EXPLORER]",
            "A built-in name, module:attribute, path/to/file.py:attribute or an entry point "
            "(default: algorithm1); shield:EXPLORER makes any of them right under the directional "
            "lighthouse. If the file has one generator function, path/to/file.py is enough.",
        ),
    ] = None

    def value(self) -> str:
        """The explorer's name; the default if none is given."""
        return self.named_or_default(self.explorer)


class ExplorersWords(Request):
    """The arguments and options of the command line that name several explorers."""

    explorers: Annotated[
        list[str] | None,
        Argument(
            "",
            "[EXPLORER...]",
            "Built-in names, module:attribute, path/to/file.py:attribute or entry points, each "
            "also as shield:EXPLORER; those of --exec and --native come after them.",
            repeated=True,
        ),
    ] = None
    command: Annotated[
        list[str] | None,
        Option(
            RARE_SCOPE,
            "COMMAND",
            "An explorer too: a program that speaks JSON lines; repeatable.",
            "exec",
            repeated=True,
        ),
    ] = None
    native: Annotated[
        list[str] | None,
        Option(
            RARE_SCOPE,
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


class ExplorerOptions(Request, kw_only=False):
    """The part of a request that names the explorer."""

    explore: Annotated[
        str | Callable[..., Any],
        OptionGroup(
            ExplorerWords,
            "a name, as on the command line, or a generator function (see "
            ":func:`allworlds.explorers.loading.load`)",
        ),
    ] = DEFAULT_EXPLORER
