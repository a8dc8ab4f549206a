"""The loading of an explorer by its name, in a process that may run users' code."""

from __future__ import annotations

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.functions import function_named
from allworlds.explorers.names import (
    SHIELD,
    command_of,
    entry_point,
    entry_points,
    has_shield,
    innermost,
    is_library,
    is_program,
    path_of,
)
from allworlds.explorers.program import Program
from allworlds.explorers.shared_library.library import Library, library_path
from allworlds.explorers.shared_library.native import NativeExplorer
from allworlds.explorers.spelling import no_explorer
from allworlds.explorers.subject import (
    Subject,
    built_in,
    subject_of,
    with_shield,
)
from allworlds.inputs.checks import InputError, show
from allworlds.protocol.faults import ANSWER_TIMEOUT
from allworlds.protocol.importing import SourceText, arguments_of, called, imported, text_of


def source_of(name: str) -> SourceText | None:
    """The text of the file in an explorer's name; None if the name has no file.

    Raises:
        InputError: if the name is that of no explorer, or the file cannot be read.
    """
    name = innermost(name)
    if is_program(name):
        return None
    if is_library(name):
        library_path(path_of(name))
        return None
    plain, arguments = arguments_of(name)
    if plain in BUILT_IN and arguments:
        raise InputError(f"the built-in explorer {plain} takes no arguments, not {show(name)}")
    if plain in BUILT_IN or entry_point(plain):
        return None
    place, colon, attribute = plain.rpartition(":")
    if not colon:
        raise InputError(no_explorer(name, plain, sorted({*BUILT_IN, *entry_points()})))
    if not place or not attribute:
        raise InputError(
            f"explorer {show(name)} is incomplete; legal are module:attribute and "
            "path/to/file.py:attribute"
        )
    return text_of(place)


def load(
    name: str, answer_timeout: float = ANSWER_TIMEOUT, source: SourceText | None = None
) -> Subject:
    """The explorer of that name, ready to be played here.

    Args:
        name: see :class:`Subject`.
        answer_timeout: seconds after which a silent program is given up.
        source: the text of its file, if it has been read before.

    Raises:
        InputError: if there is none, it does not import, or it is no generator function.
    """
    if has_shield(name):
        return with_shield(load(name.removeprefix(SHIELD), answer_timeout, source))
    if name in BUILT_IN:
        return built_in(name)
    if is_program(name):
        program = Program(command_of(name), answer_timeout)
        return Subject(name, frozenset({"told"}), program.explore, program=program)
    if is_library(name):
        native = NativeExplorer(Library(path_of(name)))
        return Subject(name, native.keywords, native.explore, native=native)
    plain, arguments = arguments_of(name)
    if point := entry_point(plain):
        return subject_of(name, called(name, imported(plain, point.load), arguments))
    source = source or source_of(name)
    return subject_of(name, function_named(name, source), source)
