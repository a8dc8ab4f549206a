"""Code of the user's: how it is named, found and loaded, and by what it is known.

A name is ``path/to/file.py:attribute``, ``module:attribute``, or an entry point, and may end in
``?key=value,...``: what it stands for is then called with these arguments, and what that returns
is meant.  Explorers, lighthouses, tasks and predicates are all found so.
"""

from __future__ import annotations

import hashlib
import importlib
import importlib.metadata
import importlib.util
import linecache
import re
import sys
import warnings
from collections.abc import Callable, Iterable, Mapping
from contextlib import redirect_stdout
from dataclasses import dataclass
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path
from types import ModuleType
from typing import Any, TypeAlias

from allworlds.inputs import (
    SHOWN,
    InputError,
    did_you_mean,
    existing_file,
    let_users_interrupt,
    read_text,
    show,
)

Argument: TypeAlias = int | bool | str
"""The value of an argument in a name."""


@dataclass(frozen=True, slots=True)
class SourceText:
    """The text of a file of the user's, read once: what happens to the file then does no harm.

    Attributes:
        path: as it was named, made absolute.
        text: of the file.
    """

    path: str
    text: str

    @property
    def digest(self) -> str:
        """SHA-256 of the text, in hexadecimal."""
        return hashlib.sha256(self.text.encode(errors="surrogateescape")).hexdigest()


@dataclass(frozen=True, slots=True)
class UserCode:
    """The code of a name, wherever it is loaded: equal text in every process.

    Attributes:
        name: as it is written.
        source: the text of its file; None for a module that is imported.
        digest: SHA-256 of the text; another one at loading is bad input.
    """

    name: str
    source: SourceText | None
    digest: str

    @property
    def arguments(self) -> dict[str, Argument]:
        """Those that the name ends in."""
        return arguments_of(self.name)[1]

    @property
    def plain(self) -> str:
        """The name without its arguments."""
        return arguments_of(self.name)[0]

    def file(self, entry_points: str) -> Path:
        """The file in which it stands."""
        if self.source is not None:
            return Path(self.source.path)
        return _file_of(self.plain, points_of(entry_points)).resolve()

    def load(self, entry_points: str) -> Any:
        """The object that the name stands for, before any argument is given to it.

        Raises:
            InputError: if it cannot be imported, or has another text here.
        """
        name = self.plain
        points = points_of(entry_points)
        if name in points:
            found = imported(name, points[name].load)
        else:
            place, _, attribute = name.rpartition(":")
            found = attribute_of(self._module(place), attribute, place)
        if self.source is None and digest_of_file(_file_of(name, points)) != self.digest:
            raise InputError(f"{show(name)} has another text here")
        return found

    def _module(self, place: str) -> Any:
        if self.source is None:
            return module_named(place)
        # The user's own import of the file must find another module: this one is ours to change.
        name = f"{Path(self.source.path).stem} of {self.digest[:12]}"
        return module_of_text(place, self.source, name)


def find_code(what: str, name: str, entry_points: str, known: tuple[str, ...] = ()) -> UserCode:
    """The code of that name, with its text, which is not run.

    Args:
        what: the noun of the message.
        name: as it is written.
        entry_points: the group in which other packages offer some.
        known: the built-in names, for the message.

    Raises:
        InputError: if the name is incomplete, or there is no such file.
    """
    plain, _ = arguments_of(name)
    points = points_of(entry_points)
    if plain in points:
        return UserCode(name, None, digest_of_file(_file_of(plain, points)))
    place, colon, attribute = plain.rpartition(":")
    if not colon or not re.fullmatch(r"[^\W\d][\w.]*", attribute) or not place:
        legal = ", ".join(sorted({*known, *points}))
        raise InputError(
            f"{what} {show(name)} is not one of {legal}, path/to/file.py:attribute or "
            f"module:attribute{did_you_mean(name, {*known, *points})}"
        )
    source = text_of(place)
    if source is not None:
        return UserCode(name, source, source.digest)
    return UserCode(name, None, digest_of_file(module_file(place)))


def ensure_same_content(codes: Iterable[UserCode], recorded: Mapping[str, str]) -> None:
    """Raise InputError unless each code is the one whose digest is recorded by its name."""
    for code in codes:
        if recorded.get(code.name) != code.digest:
            raise InputError(f"{show(code.name)} has another text now than is recorded")


def text_of(place: str) -> SourceText | None:
    """The text of the file that the place of a name is; None where it is a module.

    Raises:
        InputError: if there is no such file, or it cannot be read.
    """
    if not place.endswith(".py"):
        return None
    file = existing_file("file", place)
    if file is None:
        raise InputError(f"there is no file {show(place)}")
    return SourceText(str(file), read_text(str(file)))


def arguments_of(name: str) -> tuple[str, dict[str, Argument]]:
    """A name without its arguments, and these: integers, true, false, or else texts.

    Raises:
        InputError: if one is not of the form ``key=value``, or is named twice.
    """
    plain, question, rest = name.partition("?")
    arguments: dict[str, Argument] = {}
    for part in rest.split(",") if question else ():
        key, equals, value = part.partition("=")
        if not equals or not key.isidentifier():
            raise InputError(f"{show(part)} in {show(name)} is not of the form key=value")
        if key in arguments:
            raise InputError(f"{show(name)} names {show(key)} twice")
        arguments[key] = _value(value)
    return plain, arguments


def _value(text: str) -> Argument:
    if re.fullmatch(r"-?[0-9]{1,18}", text):
        return int(text)
    return {"true": True, "false": False}.get(text, text)


def called(name: str, factory: Any, arguments: Mapping[str, Argument]) -> Any:
    """The result of a factory for the arguments of a name; the object itself if there are none.

    Raises:
        InputError: if it cannot be called so, or raises.
    """
    if not arguments:
        return factory
    if not callable(factory):
        raise InputError(f"{show(name)}: what takes arguments is a function that returns the rest")
    return imported(name, lambda: factory(**arguments))


def function_of(what: str, code: UserCode, entry_points: str, shape: str) -> Any:
    """The function that a name stands for.

    Args:
        what: the noun of the message.
        code: of the name.
        entry_points: the group in which other packages offer some.
        shape: a definition of such a function, and what it returns, for the message.

    Raises:
        InputError: if it cannot be loaded, or is no function.
    """
    function = called(code.name, code.load(entry_points), code.arguments)
    if not callable(function):
        raise InputError(
            f"{what} {show(code.name)} is no function, but {show(function)}; one is {shape}"
        )
    return function


# ---------------------------------------------------------------- loading


def points_of(group: str) -> dict[str, importlib.metadata.EntryPoint]:
    """The entry points of a group that other packages offer, by their names."""
    return {point.name: point for point in importlib.metadata.entry_points(group=group)}


def module_named(name: str) -> Any:
    """The module of that name, imported; one in the current directory is found last."""
    _look_last(str(Path.cwd()))
    return imported(name, lambda: importlib.import_module(name))


def _look_last(folder: str) -> None:
    """Make modules in a folder of the user's importable, after all others, so none is hidden."""
    if folder not in sys.path:
        sys.path.append(folder)


def module_of_text(place: str, source: SourceText, name: str = "") -> Any:
    """A fresh module of that text, with that name; by default with that of the file."""
    file = Path(source.path)
    _look_last(str(file.parent))
    # A file may be called as a module that is already there, and must not take its place.
    free = file.stem not in sys.modules
    name = name or (file.stem if free else f"{file.stem} in {file.parent}")
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
        exec(code, module.__dict__)  # noqa: S102  # the user's
        return module

    return imported(place, execute)


def imported(name: str, importing: Callable[[], Any]) -> Any:
    """The result of an import, or an error in one line.

    Raises:
        InputError: naming what does not import.
    """
    try:
        # What a module prints must not get into a document on stdout.
        with redirect_stdout(sys.stderr):
            return importing()
    except BaseException as error:  # noqa: BLE001  # a module may raise anything
        let_users_interrupt(error)
        raise InputError(f"{show(name)} does not import: {said(error)}") from None


def said(error: BaseException) -> str:
    """The first line of what an exception says, if it can be shown."""
    name = type(error).__name__
    try:
        text = str.__str__(str(error)).split("\n", 1)[0]
    except BaseException as another:  # noqa: BLE001  # an exception may not even be printable
        let_users_interrupt(another)
        return f"{name}, which cannot be shown"
    return f"{name}: {text[:SHOWN]}" if text else name


def attribute_of(module: Any, attribute: str, place: str) -> Any:
    """The attribute of a module, which may be one of an attribute.

    Raises:
        InputError: if there is none.
    """
    value = module
    for part in attribute.split("."):
        try:
            value = getattr(value, part)
        except AttributeError:
            raise InputError(f"{show(place)} has no {show(attribute)}") from None
    return value


# ---------------------------------------------------------------- what it is known by


def module_file(module: str) -> Path:
    """The file of a module, found without importing anything.

    Raises:
        InputError: if there is none.
    """
    spec: ModuleSpec | None = None
    places: list[str] | None = [*sys.path, str(Path.cwd())]
    names = module.split(".")
    for depth in range(1, len(names) + 1):
        spec = PathFinder.find_spec(".".join(names[:depth]), places)
        if spec is None:
            break
        places = spec.submodule_search_locations
    if spec is None or spec.origin is None:
        raise InputError(f"the file of the module {show(module)} is not found")
    return Path(spec.origin)


def digest_of_file(file: Path) -> str:
    """SHA-256 of a file, in hexadecimal."""
    return hashlib.sha256(bytes_of(file)).hexdigest()


def bytes_of(file: Path) -> bytes:
    """The content of a file.

    Raises:
        InputError: if it cannot be read.
    """
    try:
        return file.read_bytes()
    except OSError as error:
        raise InputError(f"file {show(str(file))} cannot be read: {error.strerror}") from None


def _file_of(name: str, points: Mapping[str, importlib.metadata.EntryPoint]) -> Path:
    return module_file(points[name].module if name in points else name.rpartition(":")[0])
