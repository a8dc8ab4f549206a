"""The import of users' programs, and calls of their functions; their errors become InputError."""

from __future__ import annotations

import importlib
import importlib.util
import inspect
import linecache
import os
import re
import sys
import warnings
from collections.abc import Callable, Mapping
from contextlib import redirect_stdout
from shlex import quote
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

from msgspec import Struct

from allworlds.inputs.checks import (
    SHOWN,
    InputError,
    existing_file,
    exit_code_kept,
    let_users_interrupt,
    no_file,
    read_text,
    show,
)

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint


T = TypeVar("T")


class SourceText(Struct, frozen=True):
    """The text of a user's file.

    The file is read only once, so later changes of the file do no harm.

    Attributes:
        path: the given path, made absolute.
        text: the text of the file.
    """

    path: str
    text: str

    @property
    def digest(self) -> str:
        """SHA-256 of the text, in hexadecimal."""
        import hashlib  # which players do not need

        return hashlib.sha256(self.text.encode(errors="surrogateescape")).hexdigest()


def text_of(where: str) -> SourceText | None:
    """The text of the file ``where``; None if ``where`` is no ``.py`` file, but a module's name.

    Raises:
        InputError: if there is no such file, or it cannot be read.
    """
    if not where.endswith(".py"):
        return None
    file = existing_file("file", where)
    if file is None:
        raise InputError(no_file(where))
    return SourceText(str(file), read_text(str(file)))


def points_of(group: str) -> dict[str, EntryPoint]:
    """The entry points that installed packages offer in a group, by their names."""
    from importlib.metadata import entry_points

    return {point.name: point for point in entry_points(group=group)}


def module_named(name: str) -> Any:
    """The imported module of that name; the current directory is searched last."""
    _look_last(os.getcwd())  # noqa: PTH109  # pathlib is not loaded in players
    return imported(name, lambda: importlib.import_module(name))


def _look_last(folder: str) -> None:
    """Append a user's folder to the import path, so that its modules hide no other module."""
    if folder not in sys.path:
        sys.path.append(folder)


def module_of_text(where: str, source: SourceText, name: str = "") -> Any:
    """A new module that is made from the text of a file.

    ``where`` names the module in errors.  ``name`` is the module's name; the default comes from the
    name of the file.
    """
    folder, _, file = source.path.rpartition(os.sep)
    _look_last(folder or os.sep)
    # A file may have the name of a loaded module, which it must not replace.
    stem = file.removesuffix(".py")
    name = name or (stem if stem not in sys.modules else f"{stem} in {folder}")
    module = ModuleType(name)
    module.__file__ = source.path
    module.__spec__ = importlib.util.spec_from_file_location(name, source.path)
    sys.modules[name] = module
    # A traceback shows the lines that ran, even if the file has changed.
    lines = source.text.splitlines(keepends=True)
    linecache.cache[source.path] = (len(source.text), None, lines, source.path)

    def execute() -> Any:
        with warnings.catch_warnings():
            # Each player would repeat the same warning about the text.
            warnings.simplefilter("ignore")
            code = compile(source.text, source.path, "exec")
        exec(code, module.__dict__)  # noqa: S102  # the user's
        return module

    try:
        return imported(where, execute)
    except InputError as error:
        if "attempted relative import" not in str(error):
            raise
        raise InputError(f"{error}; {_as_module(source.path)}") from None


def _as_module(path: str) -> str:
    """A sentence that tells users how to name the file ``path``, which has relative imports.

    The sentence has the name of the file as a module, with the packages that contain the module,
    and the folder that PYTHONPATH must have.
    """
    from pathlib import Path  # not loaded in players otherwise

    file = Path(path)
    folder, name = file.parent.parent, f"{file.parent.name}.{file.stem}"
    while (folder / "__init__.py").exists():
        folder, name = folder.parent, f"{folder.name}.{name}"
    return f"it is part of a package: name {name}:FUNCTION, with PYTHONPATH={quote(str(folder))}"


def imported(name: str, importing: Callable[[], Any]) -> Any:
    """The result of ``importing``, a function that imports the program ``name``.

    Raises:
        InputError: naming the program that cannot be imported, in one line.
    """
    return _tried(f"{show(name)} does not import:", importing, InputError)


AT_WORK: list[str] = []
"""The names of users' code that this process is importing or calling."""


def attempted(what: str, act: Callable[[], T], kind: type[InputError] = InputError) -> T:
    """The result of a call of a model: a user's lighthouse, task or predicate.

    Text that the model prints goes to stderr, and the model cannot end the process.

    Args:
        what: the first words of the error's message.
        act: the function without arguments that calls the model.
        kind: the class of the error, InputError or a subclass.

    Raises:
        InputError: beginning with ``what``, if the model raises.
    """
    with exit_code_kept():
        return _tried(what, act, kind)


def _tried(what: str, act: Callable[[], T], kind: type[InputError]) -> T:
    AT_WORK.append(what.removesuffix(" raises").removesuffix(" does not import:"))
    try:
        # Its prints must not get into a document on stdout.
        with redirect_stdout(sys.stderr):
            return act()
    except BaseException as error:  # noqa: BLE001  # a module may raise anything
        let_users_interrupt(error)
        raise kind(f"{what} {said(error)}") from None
    finally:
        AT_WORK.pop()


def said(error: BaseException) -> str:
    """The name of an exception's class, and the first line of the exception's message if any.

    If the exception's own code raises while the message is made, the text says in place of the
    message that the exception cannot be shown.
    """
    name = type(error).__name__
    try:
        text = str.__str__(str(error)).split("\n", 1)[0]
    except BaseException as another:  # noqa: BLE001  # an exception may not even be printable
        let_users_interrupt(another)
        return f"{name}, which cannot be shown"
    return f"{name}: {text[:SHOWN]}" if text else name


def attribute_of(module: Any, attribute: str, where: str) -> Any:
    """The attribute of a module; for a name ``a.b`` the attribute ``b`` of the attribute ``a``.

    Raises:
        InputError: if there is no such attribute; the message has ``where`` as the module's name.
    """
    value = module
    for part in attribute.split("."):
        try:
            value = getattr(value, part)
        except AttributeError:
            raise InputError(f"{show(where)} has no {show(attribute)}") from None
    return value


# ---------------------------------------------------------------- arguments in a name


ArgumentValue: TypeAlias = int | bool | str
"""The value of an argument in a name."""


def arguments_of(name: str) -> tuple[str, dict[str, ArgumentValue]]:
    """The two parts of a name ``NAME?key=value,...``: NAME, and the arguments by their keys.

    The values of the arguments are integers, booleans, or texts.

    Raises:
        InputError: if an argument has not the form ``key=value``, or is named twice.
    """
    plain, question, rest = name.partition("?")
    pairs = pairs_in(name, rest) if question else []
    return plain, {key: _value(value) for key, value in pairs}


def pairs_in(name: str, text: str) -> list[tuple[str, str]]:
    """The keys and values in a text ``key=value,...``.

    ``name`` is the whole name that contains the text; errors show it.

    Raises:
        InputError: if a pair has another form, or a key is named twice.
    """
    pairs: dict[str, str] = {}
    for part in text.split(","):
        key, equals, value = part.partition("=")
        if not equals or not key.isidentifier():
            raise InputError(f"{show(part)} in {show(name)} is not of the form key=value")
        if key in pairs:
            raise InputError(f"{show(name)} names {show(key)} twice")
        pairs[key] = value
    return [*pairs.items()]


def _value(text: str) -> ArgumentValue:
    if re.fullmatch(r"-?[0-9]{1,18}", text):
        return int(text)
    return {"true": True, "false": False}.get(text, text)


def _percept_alone(first: object) -> None:
    """Do nothing; only the signature of this function is used: a percept and nothing else."""


def signature_of(explore: Callable[..., Any]) -> inspect.Signature:
    """The signature of an explorer; if Python does not know it, that of ``explore(first)``."""
    try:
        return inspect.signature(explore)
    except (TypeError, ValueError):
        return inspect.signature(_percept_alone)


def called(name: str, factory: Any, arguments: Mapping[str, ArgumentValue]) -> Any:
    """The result of ``factory``, called with ``arguments``, which stand in the name ``name``.

    Without arguments ``factory`` is not called; it is the result itself.

    Raises:
        InputError: if the factory does not take these arguments, or raises.
    """
    if not arguments:
        return factory
    if not callable(factory):
        raise InputError(f"{show(name)}: what takes arguments is a function that returns the rest")
    try:
        inspect.signature(factory).bind_partial(**arguments)
    except TypeError as error:
        legal = inspect.signature(factory)
        raise InputError(f"{show(name)} {error}; legal is {legal}") from None
    except ValueError:  # there is no signature to ask
        pass
    return attempted(f"{show(name)} raises", lambda: factory(**arguments))
