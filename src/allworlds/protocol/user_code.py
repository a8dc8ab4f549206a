"""Users' programs: their names, their files, and the texts by which they are recognised.

A name is ``path/to/file.py:attribute``, ``module:attribute``, or the name of an entry point.  It
may end in ``?key=value,...``; then the named object is called with these arguments, and the name
stands for the result.  All explorers, lighthouses, tasks and predicates are found in this way.  A
lighthouse, task or predicate is a *model*: the judge calls it, and its errors become InputError.
"""

from __future__ import annotations

import hashlib
import re
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from importlib.machinery import PathFinder
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

from msgspec import Struct
from msgspec.structs import replace

from allworlds.inputs.checks import InputError, did_you_mean, exit_code_kept, show
from allworlds.inputs.nesting import loading
from allworlds.protocol import importing

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint


class OtherText(InputError):
    """Raised if the text of a user's program differs from the text that was recorded earlier."""


class Role(Struct, frozen=True):
    """A role that a user's program can have, such as a task or a lighthouse.

    Attributes:
        noun: the name of the role in messages.
        group: the group of entry points in which other packages offer programs for this role.
        shape: words that tell users how to write a function of this role, such as
            ``def predicate(map), which returns True or False``; empty if the role's programs are
            no functions.
        known: the names of the objects for this role that come with this package.
    """

    noun: str
    group: str
    shape: str = ""
    known: tuple[str, ...] = ()

    def find(self, name: str) -> UserCode:
        """The user's program with this name, and its text; the program does not run.

        Raises:
            InputError: if the name is incomplete, or there is no file or module of this name.
        """
        plain, _ = importing.arguments_of(name)
        if (record := _RECORDED.get().get(plain)) is not None:
            return UserCode(name, self, *_as_recorded(plain, record))
        if point := self.offered(plain):
            return UserCode(name, self, None, digest_of_file(module_file(point.module)))
        where, colon, attribute = plain.rpartition(":")
        if not colon or not re.fullmatch(r"[^\W\d][\w.]*", attribute) or not where:
            raise InputError(self._legal(name))
        source = importing.text_of(where)
        if source is not None:
            return UserCode(name, self, source, source.digest)
        try:
            return UserCode(name, self, None, digest_of_file(module_file(where)))
        except InputError as error:
            raise InputError(self._legal(name, f": {error}")) from None

    def offered(self, name: str) -> EntryPoint | None:
        """The entry point with this name, if an installed package offers it, else None.

        The name of an entry point has no colon.
        """
        return None if ":" in name else importing.points_of(self.group).get(name)

    def of(self, given: Any) -> UserCode:
        """The user's program for a function or class that other processes can import.

        Raises:
            InputError: if other processes cannot import it.
        """
        module, name = getattr(given, "__module__", None), getattr(given, "__qualname__", "")
        if module in (None, "__main__") or not name or "<" in name:
            raise InputError(
                f"{self.noun} {show(name or given)} lives in this process alone, and no other "
                "could load it; put it into a file of its own"
            )
        return self.find(f"{module}:{name}")

    def _legal(self, name: str, reason: str = "") -> str:
        known = [*self.known, *sorted(importing.points_of(self.group))]
        return (
            f"{self.noun} {show(name)} is not one of {', '.join(known)}, "
            f"path/to/file.py:attribute or module:attribute{reason}{did_you_mean(name, known)}"
        )


class UserCode(Struct, frozen=True):
    """A user's program, by its name; each process that loads it uses the same text.

    Attributes:
        name: the name, as the user wrote it.
        role: the role of the program.
        source: the text of its file; None for a module that is imported.
        digest: SHA-256 of the text; if the text has another digest at loading, that is an error.
    """

    name: str
    role: Role
    source: importing.SourceText | None
    digest: str

    @property
    def arguments(self) -> dict[str, importing.ArgumentValue]:
        """The arguments at the end of the name, by their keys; empty if there are none."""
        return importing.arguments_of(self.name)[1]

    @property
    def plain(self) -> str:
        """The name without its arguments."""
        return self.name.partition("?")[0]

    @property
    def bare(self) -> UserCode:
        """The program without the arguments in its name."""
        return replace(self, name=self.plain)

    @property
    def recorded(self) -> bool:
        """Whether the present context of :func:`as_recorded` has a record of the program.

        A program's :attr:`record` is kept in a run directory, or sent to another process.  In such
        a context the program is found by its record; its file is not read for this.
        """
        return self.plain in _RECORDED.get()

    @property
    def record(self) -> str:
        """The value that :func:`as_recorded` takes for the program: a text, or a digest.

        If the program is named by a file, the value is the text of the file; a later job can run
        this text, even if the file has changed.  If the program is named by a module, Python itself
        reads the module's text, so only the digest of this text is recorded; a later job refuses a
        changed module.
        """
        return self.source.text if self.source else self.digest

    def ensure_recorded(self, digest: object) -> None:
        """Raise OtherText if ``digest``, which was recorded, differs from the program's digest.

        If ``digest`` is None, no digest was recorded, and every text is legal.
        """
        if digest not in (None, self.digest):
            raise OtherText(
                f"{self.role.noun} {show(self.name)} has another text now: its digest is "
                f"{self.digest[:12]}..., and {show(digest)} is recorded"
            )

    @property
    def file(self) -> Path:
        """The file that contains the program."""
        if self.source is not None:
            return Path(self.source.path)
        point = self.role.offered(self.plain)
        return module_file(point.module if point else self.plain.rpartition(":")[0]).resolve()

    @property
    def files(self) -> frozenset[Path]:
        """The files that run when the program is loaded: its own file and those that it imports."""
        return frozenset({self.file.resolve(), *_loaded(self.bare).brought})

    def load(self) -> Any:
        """The object for which the name without arguments stands; a file runs once in a process.

        Raises:
            InputError: if the object cannot be imported, or if the text of its module has changed.
        """
        return _loaded(self.bare).object

    def made(self) -> Any:
        """The result of :meth:`load`, called with the arguments in the name if there are any.

        Raises:
            InputError: if the object does not take these arguments, or raises.
        """
        return importing.called(self.name, self.load(), self.arguments)

    @property
    def function(self) -> Any:
        """The function for which the name stands; it is made once in a process.

        Raises:
            InputError: if the function cannot be loaded, or the object is no function.
        """
        return _function(self)

    def __call__(self, *values: Any) -> Any:
        """Call the user's function with these values.

        Raises:
            InputError: naming the model, if it raises.
        """
        function = _function(self)
        return importing.attempted(
            f"{self.role.noun} {show(self.name)} raises", lambda: function(*values)
        )


class LocalCode(Struct, frozen=True):
    """A user's function that exists only in this process.

    Attributes:
        role: what the function is for the user, such as an explorer or a lighthouse.
        function: the function itself.
    """

    role: Role
    function: Any

    @property
    def name(self) -> str:
        """The name of the function."""
        return str(getattr(self.function, "__name__", show(self.function)))

    def __call__(self, *values: Any) -> Any:
        """Call the user's function with these values.

        Raises:
            InputError: naming the model, if it raises.
        """
        return importing.attempted(
            f"{self.role.noun} {show(self.name)} raises", lambda: self.function(*values)
        )


# ---------------------------------------------------------------- what is loaded


class _Loaded(NamedTuple):
    """A user's object, and the files of the modules that its loading imported."""

    object: Any
    brought: frozenset[Path]


@cache
def _loaded(code: UserCode) -> _Loaded:
    if code.source is None and digest_of_file(code.file) != code.digest:
        raise InputError(f"{show(code.name)} has another text here")
    before = {*sys.modules}
    with exit_code_kept(), loading():
        found = _found(code)
    files = (getattr(sys.modules[name], "__file__", "") for name in {*sys.modules} - before)
    return _Loaded(found, frozenset(Path(file).resolve() for file in files if file))


def _found(code: UserCode) -> Any:
    if point := code.role.offered(code.name):
        return importing.imported(code.name, point.load)
    where, _, attribute = code.name.rpartition(":")
    module = importing.module_named(where) if code.source is None else _module(where, code.source)
    return importing.attribute_of(module, attribute, where)


@cache
def _module(where: str, source: importing.SourceText) -> Any:
    # If the user imports the file, too, this must be another module, since this one is changed.
    name = f"{Path(source.path).stem} of {source.digest[:12]}"
    return importing.module_of_text(where, source, name)


@cache
def _function(code: UserCode) -> Any:
    function = code.made()
    if not callable(function):
        raise InputError(
            f"{code.role.noun} {show(code.name)} is no function, but {show(function)}; one is "
            f"{code.role.shape}"
        )
    return function


# ---------------------------------------------------------------- what a record says


_RECORDED: ContextVar[Mapping[str, str]] = ContextVar("recorded", default=MappingProxyType({}))


@contextmanager
def as_recorded(texts: Mapping[str, str]) -> Iterator[None]:
    """A context in which names stand for recorded programs, even if their files have changed.

    Args:
        texts: for the name of each program, without arguments, its :attr:`UserCode.record`.
    """
    token = _RECORDED.set(texts)
    try:
        yield
    finally:
        _RECORDED.reset(token)


def recorded(plain: str) -> str | None:
    """The recorded text of the program ``plain``; None outside of :func:`as_recorded`.

    ``plain`` is a name without arguments.  For a module the result is the digest of its text.
    """
    return _RECORDED.get().get(plain)


def _as_recorded(plain: str, record: str) -> tuple[importing.SourceText | None, str]:
    where = plain.rpartition(":")[0]
    if not where.endswith(".py"):
        return None, record
    source = importing.SourceText(str(Path(where).absolute()), record)
    return source, source.digest


# ---------------------------------------------------------------- files


def module_file(module: str) -> Path:
    """The file of a module; the module is not imported.

    Raises:
        InputError: if there is no such file.
    """
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
    """SHA-256 of a file, in hexadecimal.

    Raises:
        InputError: if the file cannot be read.
    """
    try:
        with file.open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError as error:
        raise InputError(f"file {show(str(file))} cannot be read: {error.strerror}") from None
