"""The place of an explorer's code, for reports: a file and a line, found by reading."""

from __future__ import annotations

import ast
import os
import shlex
from pathlib import Path

from msgspec import Struct

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.names import (
    command_of,
    entry_point,
    innermost,
    is_library,
    is_program,
    path_of,
)
from allworlds.inputs.checks import InputError
from allworlds.protocol.user_code import module_file

SOURCES = (".c", ".cc", ".cpp", ".cxx", ".rs", ".zig", ".go")
"""The endings of the source of a shared library, looked for beside it."""


class SourceLine(Struct, frozen=True):
    """A place in a file.

    Attributes:
        file: absolute.
        line: from 1.
    """

    file: Path
    line: int = 1

    def named_from(self, folder: Path) -> str:
        """The file relative to a folder, with ``/``; absolute if it is outside the folder."""
        if self.file.is_relative_to(folder):
            return self.file.relative_to(folder).as_posix()
        return self.file.as_posix()


def files_of_explorer(name: str) -> list[Path]:
    """The files of an explorer's code; none for a built-in explorer, or if they are unknown.

    For a program they are the files that its command names.
    """
    name = innermost(name)
    if is_program(name):
        try:
            words = shlex.split(command_of(name))
        except ValueError:
            return []
        return [Path(word) for word in words if Path(word).is_file()]
    if is_library(name):
        library = Path(path_of(name))
        return [library] if library.is_file() else []
    if name in BUILT_IN:
        return []
    try:
        file, _ = _file_and_attributes(name)
    except InputError:
        return []
    return [file] if file.is_file() else []


def place_of_explorer(name: str) -> SourceLine | None:
    """The place of an explorer's code; None for a built-in explorer, or if it is unknown.

    The explorer's code is not run.  For a Python explorer the place is the line of its function,
    for a program the first line of the last file that its command names, for a shared library
    the source of the same name beside it, or else the library.
    """
    name = innermost(name)
    if name in BUILT_IN:
        return None
    try:
        if is_program(name):
            return _of_program(name)
        if is_library(name):
            return _of_library(Path(path_of(name)))
        return _of_python(name)
    except (InputError, OSError, ValueError, SyntaxError):
        return None


def _of_program(name: str) -> SourceLine | None:
    files = files_of_explorer(name)
    return SourceLine(files[-1].resolve()) if files else None


def _of_library(library: Path) -> SourceLine | None:
    stems = {library.stem, library.stem.removeprefix("lib")}
    beside = [library.with_name(stem + ending) for ending in SOURCES for stem in sorted(stems)]
    found = next((file for file in [*beside, library] if file.is_file()), None)
    return SourceLine(found.resolve()) if found else None


def _of_python(name: str) -> SourceLine | None:
    file, attributes = _file_and_attributes(name)
    if not file.is_file():
        return None
    return SourceLine(file, _line(ast.parse(file.read_text(encoding="utf-8")), attributes))


def _file_and_attributes(name: str) -> tuple[Path, list[str]]:
    """The file of a Python explorer, which may be missing, and the dotted name in it."""
    plain = name.partition("?")[0]
    point = entry_point(plain)
    whole = point.value if point else plain
    place, colon, attribute = whole.rpartition(":")
    if not colon:  # of a file with one explorer its name will do
        place, attribute = whole, ""
    file = Path(place) if place.endswith(".py") else module_file(place)
    return Path(os.path.realpath(file)), attribute.split(".") if attribute else []


def _line(tree: ast.Module, names: list[str]) -> int:
    """The line where a dotted name is defined; 1 if it is not found."""
    body, line = tree.body, 1
    for name in names:
        for node in body:
            if name in _defined(node):
                line = node.lineno
                body = getattr(node, "body", [])
                break
        else:
            return line
    return line


def _defined(node: ast.stmt) -> set[str]:
    match node:
        case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
            return {name}
        case ast.Assign(targets=targets):
            return {target.id for target in targets if isinstance(target, ast.Name)}
        case ast.ImportFrom(names=names):
            return {alias.asname or alias.name for alias in names}
        case _:
            return set()
