"""Names of explorers: what is known by a name alone, and those that are nearly one."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterable, Iterator, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.inputs.checks import (
    InputError,
    did_you_mean,
    is_loop_of_links,
    no_file,
    read_text,
    show,
)
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
    for option, kind in (("--exec", EXEC), ("--native", NATIVE)):
        if name.startswith(kind):
            return [option, name.removeprefix(kind)]
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


MOST_OF_A_COMMAND = 20
"""The number of characters that stand for a command, if they tell it from others."""


def whole_name(name: str) -> str:
    """The name; the function is added to the name of a file that has only one.

    The file is read, and not run.  If it defines none, it may import one named ``explore``.

    Raises:
        InputError: if the file has several, is not there, or is no Python.
    """
    if has_shield(name):
        return SHIELD + whole_name(name.removeprefix(SHIELD))
    if not name.endswith(".py") or ":" in name:
        return name
    if not Path(name).exists():
        raise InputError(no_file(name, _like_file(name)))
    text = read_text(name)
    try:
        compile(text, name, "exec", dont_inherit=True)
    except (SyntaxError, ValueError, RecursionError) as error:
        line = getattr(error, "lineno", None)
        where = f", line {line}" if line else ""
        said = getattr(error, "msg", None) or error
        kind = type(error).__name__
        raise InputError(f"{show(name)}{where} is no Python: {kind}: {said}") from None
    explorers = [*explorers_in(text)]
    if len(explorers) == 1:
        return f"{name}:{explorers[0]}"
    if not explorers:
        return f"{name}:explore"
    legal = ", ".join(f"{name}:{explorer}" for explorer in explorers)
    raise InputError(f"{show(name)} has several explorers; legal are {legal}")


def no_explorer(name: str, plain: str, known: Sequence[str]) -> str:
    """The reason why a name without a function is none of an explorer, and what would be legal.

    Without its arguments it is ``plain``; ``known`` are the explorers that stand alone.
    """
    if os.path.isdir(plain):  # noqa: PTH112  # takes any text, as below
        return f"{show(plain)} is a directory; an explorer in it is {Path(plain)}/FILE.py:FUNCTION"
    if os.path.isfile(plain):  # noqa: PTH113
        if plain.endswith(".py"):
            arguments = name.removeprefix(plain)
            return f"{show(name)} names no function; legal is {plain}:FUNCTION{arguments}"
        return (
            f"{show(plain)} is a file, but no file.py with a function; a program runs with --exec, "
            f"a shared library with --native{_like_file(plain)}"
        )
    if os.sep in plain or is_loop_of_links(plain):
        return no_file(plain, _like_file(plain))
    return (
        f"explorer {show(name)} is not one of {', '.join(known)}, module:attribute or "
        f"path/to/file.py:attribute{_like_file(plain) or did_you_mean(name, known)}"
    )


def _like_file(name: str) -> str:
    """A hint at a Python file whose name is similar, in the same folder; empty if there is none."""
    given = Path(name)
    try:
        files = sorted(file.name for file in given.parent.glob("*.py"))
    except (OSError, ValueError):
        return ""
    if f"{given.name}.py" in files:
        return f"; did you mean {show(f'{name}.py')}?"
    close = get_close_matches(given.name, files, n=1)
    return f"; did you mean {show(name.removesuffix(given.name) + close[0])}?" if close else ""


def explorers_in(text: str) -> Iterator[str]:
    """The names of a module's generator functions, in their order; none if it is no Python."""
    try:
        module = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError):
        return
    for statement in module.body:
        if isinstance(statement, ast.FunctionDef) and _yields(statement.body):
            yield statement.name


def _yields(body: Iterable[ast.AST]) -> bool:
    """Whether the function has a yield of its own, not only of a nested function."""
    for node in body:
        if isinstance(node, ast.Yield | ast.YieldFrom):
            return True
        inner = isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda | ast.ClassDef)
        if not inner and _yields(ast.iter_child_nodes(node)):
            return True
    return False


def short_names(names: Sequence[str]) -> list[str]:
    """The shortest ends of these names that tell them apart, as the heads of columns."""
    ends = [[*_ends(name)] for name in names]
    taken = [0] * len(names)
    while True:
        short = [end[i] for end, i in zip(ends, taken, strict=True)]
        alike = [
            i
            for i, name in enumerate(short)
            if short.count(name) > 1 and taken[i] + 1 < len(ends[i])
        ]
        if not alike:
            return short
        for i in alike:
            taken[i] += 1


def _ends(name: str) -> Iterator[str]:
    """The ends of a name, from the shortest one to the name itself."""
    if is_program(name):
        yield name[:MOST_OF_A_COMMAND]
    elif ":" in name:
        place, _, attribute = name.rpartition(":")
        yield attribute
        folders = place.split("/")
        yield from (f"{'/'.join(folders[-i:])}:{attribute}" for i in range(1, len(folders)))
    yield name
