"""Names of explorers, and what is known by a name alone."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.inputs.checks import InputError, show
from allworlds.protocol.importing import points_of

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

ENTRY_POINTS = "allworlds.explorers"
EXEC = "exec:"
NATIVE = "native:"
SHIELD = "shield:"
"""The beginnings of the names of programs, of shared libraries, and of explorers with a shield."""

SHIELD_BOUND = "9*paper"
"""The bound that every explorer with a shield keeps."""

LIGHTHOUSE = "directional"
"""The lighthouse of users' explorers unless another is named."""


def is_program(name: str) -> bool:
    """Whether that is the name of a program behind a pipe, as ``exec:COMMAND``."""
    return innermost(name).startswith(EXEC)


def is_library(name: str) -> bool:
    """Whether that is the name of a shared library, as ``native:PATH``."""
    return innermost(name).startswith(NATIVE)


def has_shield(name: str) -> bool:
    """Whether that is the name of an explorer with a shield, as ``shield:NAME``."""
    return name.startswith(SHIELD)


def innermost(name: str) -> str:
    """The name without shields."""
    while has_shield(name):
        name = name.removeprefix(SHIELD)
    return name


def command_of(name: str) -> str:
    """The command of a program of that name."""
    return innermost(name).removeprefix(EXEC)


def path_of(name: str) -> str:
    """The path of a shared library of that name."""
    return innermost(name).removeprefix(NATIVE)


def named_on_command_line(name: str) -> list[str]:
    """The arguments of the command line that name an explorer."""
    if has_shield(name):
        return [name]
    if is_program(name):
        return ["--exec", command_of(name)]
    if is_library(name):
        return ["--native", path_of(name)]
    return [name]


def names_explorer(text: str) -> bool:
    """Whether a text has the form of an explorer's name; whether there is one is not checked."""
    plain = text.partition("?")[0]
    if has_shield(text) or plain in BUILT_IN or entry_point(plain):
        return True
    return bool(re.fullmatch(r"(.+\.py|[^\W\d]\w*(\.[^\W\d]\w*)*):[^\W\d][\w.]*", plain))


def entry_points() -> dict[str, EntryPoint]:
    """The explorers that other packages offer, by their names."""
    return points_of(ENTRY_POINTS)


def entry_point(plain: str) -> EntryPoint | None:
    """The explorer that another package offers by a name; None if there is none.

    A name with a colon is that of a function: packages are not asked, which takes some time.
    """
    return None if ":" in plain else entry_points().get(plain)


def own_lighthouse(name: str) -> str:
    """The lighthouse of the explorer of that name unless another is named."""
    return BUILT_IN[name].lighthouse if name in BUILT_IN else LIGHTHOUSE


def own_bound(name: str, lighthouse: str) -> str | None:
    """The own bound of the explorer of that name under this lighthouse; None if it has none.

    Lighthouses are written ``KIND[:key=value,...]``; the bound holds under all options of the kind
    that the explorer is written for.

    Raises:
        InputError: if it has a shield, which helps under the directional lighthouse alone.
    """
    kinds = {str(text).partition(":")[0] for text in (lighthouse, own_lighthouse(name))}
    if has_shield(name):
        if len(kinds) > 1:
            raise InputError(
                f"a shield needs the directional lighthouse, not {show(str(lighthouse))}"
            )
        return SHIELD_BOUND
    return BUILT_IN[name].bound if name in BUILT_IN and len(kinds) == 1 else None
