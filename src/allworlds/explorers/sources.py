"""The files of an explorer's code: their digest, and the line of the explorer."""

from __future__ import annotations

import ast
import hashlib
import os
import shlex
import shutil
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.loading import Subject
from allworlds.explorers.names import (
    command_of,
    entry_point,
    innermost,
    is_library,
    is_program,
    path_of,
)
from allworlds.explorers.program import Program
from allworlds.inputs.checks import InputError, read_text, show
from allworlds.protocol.importing import SourceText
from allworlds.protocol.user_code import bytes_of, module_file

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
    if name in BUILT_IN:
        return []
    try:
        if is_program(name):
            files = [Path(word) for word in shlex.split(command_of(name))]
        else:
            files = [Path(path_of(name)) if is_library(name) else _file_and_attributes(name)[0]]
    except (InputError, ValueError):
        return []
    return [file for file in files if file.is_file()]


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
            files = files_of_explorer(name)[::-1]
        elif is_library(name):
            files = _library_and_sources(Path(path_of(name)))
        else:
            file, attributes = _file_and_attributes(name)
            tree = ast.parse(file.read_text(encoding="utf-8"))
            return SourceLine(file, _line(tree, attributes))
        return next((SourceLine(file.resolve()) for file in files if file.is_file()), None)
    except (InputError, OSError, ValueError, SyntaxError):
        return None


def _library_and_sources(library: Path) -> list[Path]:
    stems = sorted({library.stem, library.stem.removeprefix("lib")})
    return [*(library.with_name(stem + end) for end in SOURCES for stem in stems), library]


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


OURS = "built-in"
"""The digest of an explorer that comes with this program, and changes with its version alone."""


def content_digest(subject: Subject) -> str:
    """SHA-256 of the explorer's text, in hexadecimal; of a program, with the files that it names.

    A shield comes with this package, and changes with its version alone: the digest is that of the
    explorer inside.
    For a module it is the module's own file: imported modules are not included.

    Raises:
        InputError: if it exists in this process alone, or its file cannot be found.
    """
    name = innermost(subject.name)
    if name in BUILT_IN:
        return OURS
    if subject.source:
        return subject.source.digest
    if subject.from_user and not subject.importable:
        raise InputError(
            f"explorer {show(subject.name)} lives in this process alone, so that no other can go "
            "on with it; put it into a file of its own"
        )
    if subject.is_program:
        files = _files_of(command_of(subject.name))
    elif is_library(name):
        files = [Path(path_of(name))]
    else:
        files = [_file_and_attributes(name)[0]]
    digest = hashlib.sha256()
    for file in files:
        text = bytes_of(file)
        digest.update(b"%d\n" % len(text) + text)
    return digest.hexdigest()


def with_content(subject: Subject) -> Subject:
    """The subject with the text that other machines need, if its code is one file.

    For a module inside a package the text is not enough: the package must be there.
    """
    place, _, _ = innermost(subject.name).partition("?")[0].rpartition(":")
    if (
        subject.own
        or subject.source
        or not place
        or "." in place
        or subject.is_program
        or is_library(subject.name)
    ):
        return subject
    file = module_file(place)
    if file.suffix != ".py" or file.name == "__init__.py":
        return subject
    return replace(subject, source=SourceText(str(file), read_text(str(file))))


def not_alike(subject: Subject, digest: str, answer_timeout: float) -> str:
    """The reason why the explorer is not the one of that digest here; empty if it is."""
    try:
        if subject.is_program:
            Program(command_of(subject.name), answer_timeout)
        same = content_digest(subject) == digest
    except InputError as error:
        return str(error)
    return "" if same else f"the explorer {show(subject.name)} has another text here"


def _files_of(command: str) -> list[Path]:
    """The program, and those of its arguments that are files."""
    program, *arguments = shlex.split(command)
    found = shutil.which(program)
    named = [Path(found)] if found else []
    return named + [Path(word) for word in arguments if Path(word).is_file()]
