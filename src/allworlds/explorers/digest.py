"""What an explorer is, whatever it is called: the bytes of its file, or of its program."""

from __future__ import annotations

import hashlib
import shlex
import shutil
import sys
from dataclasses import replace
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.moved import present_name
from allworlds.explorers.program import Program
from allworlds.explorers.subject import (
    ExplorerSource,
    Subject,
    command_of,
    entry_points,
    path_of,
)
from allworlds.inputs import InputError, read_text, show

OURS = "built-in"
"""The digest of an explorer that comes with this program, and changes with its version alone."""


def content_digest(subject: Subject) -> str:
    """SHA-256 of the explorer's text, in hexadecimal; of a program, with the files that it names.

    Of a module it is the module's own file: what that imports is not looked at.

    Raises:
        InputError: if it lives in this process alone, or its file cannot be found.
    """
    if subject.name in BUILT_IN:
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
    elif subject.compiled:
        files = [Path(path_of(subject.name))]
    else:
        files = [module_file(_module_of(subject.name))]
    digest = hashlib.sha256()
    for file in files:
        text = _bytes(file)
        digest.update(b"%d\n" % len(text) + text)
    return digest.hexdigest()


def with_content(subject: Subject) -> Subject:
    """The subject with the text that other machines need, where it stands in one file.

    Of a module inside a package it is not enough: the package must be there.
    """
    place, _, _ = subject.name.rpartition(":")
    if (
        subject.own
        or subject.source
        or not place
        or "." in place
        or subject.is_program
        or subject.compiled
    ):
        return subject
    file = module_file(place)
    if file.suffix != ".py" or file.name == "__init__.py":
        return subject
    return replace(subject, source=ExplorerSource(str(file), read_text(str(file))))


def not_alike(subject: Subject, digest: str, answer_timeout: float) -> str:
    """Why the explorer cannot be played on this machine as on the one with that digest."""
    try:
        if subject.is_program:
            Program(command_of(subject.name), answer_timeout)
        same = content_digest(subject) == digest
    except InputError as error:
        return str(error)
    return "" if same else f"the explorer {show(subject.name)} has another text here"


def module_file(module: str) -> Path:
    """The file of a module, found without importing anything.

    Raises:
        InputError: if there is none.
    """
    spec: ModuleSpec | None = None
    places: list[str] | None = [*sys.path, str(Path.cwd())]
    names = present_name(module).split(".")
    for depth in range(1, len(names) + 1):
        spec = PathFinder.find_spec(".".join(names[:depth]), places)
        if spec is None:
            break
        places = spec.submodule_search_locations
    if spec is None or spec.origin is None:
        raise InputError(f"the file of the module {show(module)} is not found")
    return Path(spec.origin)


def _module_of(name: str) -> str:
    points = entry_points()
    return points[name].module if name in points else name.rpartition(":")[0]


def _files_of(command: str) -> list[Path]:
    """The program, and those of its arguments that are files."""
    program, *arguments = shlex.split(command)
    found = shutil.which(program)
    named = [Path(found)] if found else []
    return named + [Path(word) for word in arguments if Path(word).is_file()]


def _bytes(file: Path) -> bytes:
    try:
        return file.read_bytes()
    except OSError as error:
        raise InputError(f"file {show(str(file))} cannot be read: {error.strerror}") from None
