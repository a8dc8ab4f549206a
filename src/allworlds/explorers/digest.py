"""The digest of an explorer's code: the bytes of its file, or of its program."""

from __future__ import annotations

import hashlib
import shlex
import shutil
from pathlib import Path

from msgspec.structs import replace

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.names import command_of, entry_point, innermost, is_library, path_of
from allworlds.explorers.program import Program
from allworlds.explorers.subject import Subject
from allworlds.inputs.checks import InputError, read_text, show
from allworlds.protocol.importing import SourceText, arguments_of
from allworlds.protocol.user_code import bytes_of, module_file

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
        files = [module_file(_module_of(name))]
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


def _module_of(name: str) -> str:
    plain, _ = arguments_of(name)
    point = entry_point(plain)
    return point.module if point else plain.rpartition(":")[0]


def _files_of(command: str) -> list[Path]:
    """The program, and those of its arguments that are files."""
    program, *arguments = shlex.split(command)
    found = shutil.which(program)
    named = [Path(found)] if found else []
    return named + [Path(word) for word in arguments if Path(word).is_file()]
