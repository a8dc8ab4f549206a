"""Finding an explorer by its name, in a process that may run foreign code."""

from __future__ import annotations

import importlib
import importlib.util
import inspect
import linecache
import sys
import warnings
from collections.abc import Callable
from contextlib import redirect_stdout
from pathlib import Path
from types import ModuleType
from typing import Any

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.moved import present_name
from allworlds.explorers.program import Program
from allworlds.explorers.shared_library.library import Library, library_path
from allworlds.explorers.shared_library.native import NativeExplorer
from allworlds.explorers.spelling import did_you_mean
from allworlds.explorers.subject import (
    ExplorerSource,
    Subject,
    built_in,
    command_of,
    entry_points,
    is_library,
    is_program,
    keywords_of,
    path_of,
)
from allworlds.inputs import SHOWN, InputError, a_path, let_users_interrupt, read_text, show
from allworlds.protocol import ANSWER_TIMEOUT


def source_of(name: str) -> ExplorerSource | None:
    """The text of the file that a name tells of; None where it tells of none.

    Raises:
        InputError: if the name is that of no explorer, or the file cannot be read.
    """
    if name in BUILT_IN or is_program(name) or name in entry_points():
        return None
    if is_library(name):
        library_path(path_of(name))
        return None
    place, colon, attribute = name.rpartition(":")
    if not colon:
        known = sorted({*BUILT_IN, *entry_points()})
        raise InputError(
            f"explorer {show(name)} is not one of {', '.join(known)}, module:attribute or "
            f"path/to/file.py:attribute{did_you_mean(name, known)}"
        )
    if not place or not attribute:
        raise InputError(
            f"explorer {show(name)} is incomplete; legal are module:attribute and "
            "path/to/file.py:attribute"
        )
    if not place.endswith(".py"):
        return None
    file = a_path("file", place).resolve()
    try:
        found = file.is_file()
    except OSError as error:
        raise InputError(f"file {show(place)} cannot be read: {error.strerror}") from None
    if not found:
        raise InputError(f"there is no file {show(place)}")
    return ExplorerSource(str(file), read_text(str(file)))


def load(
    name: str, answer_timeout: float = ANSWER_TIMEOUT, source: ExplorerSource | None = None
) -> Subject:
    """The explorer of that name, ready to be played here.

    Args:
        name: see :class:`Subject`.
        answer_timeout: seconds after which a silent foreign program is given up.
        source: the text of its file, if it has been read before.

    Raises:
        InputError: if there is none, it does not import, or it is no generator function.
    """
    if name in BUILT_IN:
        return built_in(name)
    if is_program(name):
        program = Program(command_of(name), answer_timeout)
        return Subject(name, frozenset({"told"}), program.explore, program=program)
    if is_library(name):
        native = NativeExplorer(Library(path_of(name)))
        return Subject(name, native.keywords, native.explore, native=native)
    points = entry_points()
    if name in points:
        return _subject(name, _imported(name, points[name].load))
    source = source or source_of(name)
    place, _, attribute = name.rpartition(":")
    module = _file(place, source) if source else _module(place)
    return _subject(name, _attribute(module, attribute, place), source)


def _subject(name: str, explore: Any, source: ExplorerSource | None = None) -> Subject:
    return Subject(name, keywords_of(name, explore), explore, source=source)


def _module(name: str) -> Any:
    _look_last(str(Path.cwd()))
    return _imported(name, lambda: importlib.import_module(present_name(name)))


def _look_last(folder: str) -> None:
    """A folder of the user's: what lies in it must not hide modules that we need."""
    if folder not in sys.path:
        sys.path.append(folder)


def _file(place: str, source: ExplorerSource) -> Any:
    file = Path(source.path)
    _look_last(str(file.parent))
    # A file may be called as a module that is already there, and must not take its place.
    name = f"{file.stem} in {file.parent}" if file.stem in sys.modules else file.stem
    module = ModuleType(name)
    module.__file__ = source.path
    module.__spec__ = importlib.util.spec_from_file_location(name, file)
    sys.modules[name] = module
    # A traceback shows the lines that were run, whatever has become of the file.
    lines = source.text.splitlines(keepends=True)
    linecache.cache[source.path] = (len(source.text), None, lines, source.path)

    def execute() -> Any:
        with warnings.catch_warnings():
            # Every player would say the same of the text.
            warnings.simplefilter("ignore")
            code = compile(source.text, source.path, "exec")
        exec(code, module.__dict__)  # noqa: S102  # the explorer
        return module

    return _imported(place, execute)


def _imported(name: str, importing: Callable[[], Any]) -> Any:
    try:
        # What a module prints must not get into a document on stdout.
        with redirect_stdout(sys.stderr):
            return importing()
    except BaseException as error:  # noqa: BLE001  # a module may raise anything
        let_users_interrupt(error)
        raise InputError(f"{show(name)} does not import: {_said(error)}") from None


def _said(error: BaseException) -> str:
    """The first line of what an exception says, if it can be shown."""
    name = type(error).__name__
    try:
        said = str.__str__(str(error)).split("\n", 1)[0]
    except BaseException as another:  # noqa: BLE001  # an exception may not even be printable
        let_users_interrupt(another)
        return f"{name}, which cannot be shown"
    return f"{name}: {said[:SHOWN]}" if said else name


def _attribute(module: Any, attribute: str, place: str) -> Any:
    value = module
    for part in attribute.split("."):
        try:
            value = getattr(value, part)
        except AttributeError:
            names = [n for n, v in vars(module).items() if inspect.isgeneratorfunction(v)]
            raise InputError(
                f"{show(place)} has no {show(attribute)}; its generator functions are: "
                + (", ".join(names) or "none")
            ) from None
    return value
