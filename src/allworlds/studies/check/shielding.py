"""The ``shield``, which turns any explorer into one that is right."""

from __future__ import annotations

from collections.abc import Callable, Generator
from typing import Any, overload

from allworlds.explorers.builtin.shield import Shield
from allworlds.explorers.loading import SHIELD
from allworlds.inputs.checks import InputError, show


@overload
def shield(explorer: str) -> str: ...
@overload
def shield(explorer: Callable[..., Generator[Any, Any, Any]]) -> Shield: ...
def shield(explorer: str | Callable[..., Generator[Any, Any, Any]]) -> str | Shield:
    """Return an explorer with a shield: right in every world under the directional lighthouse.

    It walks less than nine times what the explorer walks until its log has no open dart, and less
    than nine times the sum of the paper's bounds (1) and (2), whichever is less.  An explorer that
    neither yields nor returns still breaks the law ``timeout``.

    Args:
        explorer: a generator function; or a name, as on the command line, of which
            ``exec:COMMAND`` is a program and ``native:PATH`` a shared library.

    Returns:
        a generator function of a function, a name of a name.

    Raises:
        InputError: if it is neither.
    """
    if isinstance(explorer, str):
        return SHIELD + explorer
    if not callable(explorer):
        raise InputError(f"explorer = {show(explorer)} is neither a name nor a function")
    return Shield(explorer)
