"""What ``--help`` looks like: complete at any width, and no type where there is no value."""

from __future__ import annotations

import shutil
from typing import Any

NARROW = 80
"""Columns below which the help is plain text: in the columns of its tables names would be cut."""


def made_helpful(command: Any) -> Any:
    """The command, and all commands below it, with a help as it is to be."""
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
        return option

    command.get_help_option = help_option
    return command


def _show_as_written(argument: Any) -> None:
    """A usage line that shows the argument by its metavar, without more brackets round it."""
    metavar = argument.metavar
    argument.make_metavar = lambda *_: metavar
    argument.get_usage_pieces = lambda *_: [metavar]
