"""Files that hold an explorer, and code that judges it."""

from __future__ import annotations

from typing import Annotated, TypeAlias

from allworlds.document import IfAny, about
from allworlds.explorers import files_of_explorer
from allworlds.judging import Rules
from allworlds.maps import Condition
from allworlds.world import files_of_condition

SharedFile: TypeAlias = Annotated[
    IfAny[str], about("the explorer's file, where judges load code from it, too: see trust")
]
"""A key of the scope of every verb that judges runs."""


def shared_file(explorer: str, rules: Rules, where: Condition | None) -> str:
    """The name of the explorer's file where code that judges it is loaded from it; else empty.

    Such code runs where verdicts are made, and could make one.
    """
    files = (*rules.files, *files_of_condition(where))
    if not files:
        return ""
    theirs = {file.resolve() for file in files_of_explorer(explorer)}
    return next((file.name for file in files if file in theirs), "")
