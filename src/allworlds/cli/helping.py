"""Layout of ``--help``: complete at any width, without a type where an option takes no value."""

from __future__ import annotations

import shutil
from typing import Any

from allworlds.cli.output import say

NARROW = 80
"""Columns below which the help is plain text: in the columns of its tables names would be cut."""


def made_helpful(command: Any) -> Any:
    """The command and all its subcommands with this layout of the help."""
    for below in getattr(command, "commands", {}).values():
        made_helpful(below)
    if shutil.get_terminal_size().columns < NARROW:
        command.rich_markup_mode = None
    for param in command.params:
        if param.param_type_name == "argument":
            _show_as_written(param)
        elif param.is_flag:
            param.metavar = ""
    own = command.get_help_option

    def help_option(context: Any) -> Any:
        option = own(context)
        if option is not None:
            option.metavar = ""
            option.callback = _help
        return option

    command.get_help_option = help_option
    return command


def _help(context: Any, _option: object, wanted: bool) -> None:
    if wanted and not context.resilient_parsing:
        say(context.get_help)
        context.exit()


def _show_as_written(argument: Any) -> None:
    """Show the argument in the usage line by its metavar, without further brackets."""
    metavar = argument.metavar
    argument.make_metavar = lambda *_, **__: metavar
    argument.get_usage_pieces = lambda *_, **__: [metavar]
