"""Code of users', imported and called."""

from __future__ import annotations

import ast
import hashlib
import importlib
import importlib.util
import linecache
import sys
import sysconfig
import warnings
from collections.abc import Callable, Iterator
from contextlib import redirect_stdout
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeVar

from msgspec import Struct

from allworlds.inputs.checks import (
    SHOWN,
    InputError,
    existing_file,
    let_users_interrupt,
    no_file,
    read_text,
    show,
)
from allworlds.inputs.exit_code import exit_code_kept

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint


T = TypeVar("T")


class SourceText(Struct, frozen=True):
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


def text_of(place: str) -> SourceText | None:
    """The text of the file that the place of a name is; None where it is a module.

    Raises:
        InputError: if there is no such file, or it cannot be read.
    """
    if not place.endswith(".py"):
        return None
    file = existing_file("file", place)
    if file is None:
        raise InputError(no_file(place))
    return SourceText(str(file), read_text(str(file)))


def points_of(group: str) -> dict[str, EntryPoint]:
    """The entry points of a group that other packages offer, by their names."""
    from importlib.metadata import entry_points

    return {point.name: point for point in entry_points(group=group)}


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
    return attempted(f"{show(name)} does not import:", importing)


def attempted(what: str, act: Callable[[], T], kind: type[InputError] = InputError) -> T:
    """The result of an action of the user's code; its prints go to stderr.

    Args:
        what: the first words of the message.
        act: the action.
        kind: of the error.

    Raises:
        InputError: beginning with these words, if it raises.
    """
    try:
        # What it prints must not get into a document on stdout.
        with redirect_stdout(sys.stderr), exit_code_kept():
            return act()
    except BaseException as error:  # noqa: BLE001  # a module may raise anything
        let_users_interrupt(error)
        raise kind(f"{what} {said(error)}") from None


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


def module_file(module: str) -> Path:
    """The file of a module, found without importing anything.

    Raises:
        InputError: if there is none.
    """
    spec = _spec_of(module, [*sys.path, str(Path.cwd())])
    if spec is None or spec.origin is None:
        raise InputError(f"the file of the module {show(module)} is not found")
    return Path(spec.origin)


def _spec_of(module: str, places: list[str]) -> ModuleSpec | None:
    """The specification of a module that is found at one of these places; None if there is none."""
    spec: ModuleSpec | None = None
    inside: list[str] | None = places
    names = module.split(".")
    for depth in range(1, len(names) + 1):
        spec = PathFinder.find_spec(".".join(names[:depth]), inside)
        if spec is None:
            return None
        inside = spec.submodule_search_locations
    return spec


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


# ---------------------------------------------------------------- what it brings in


def files_imported(text: str, folder: Path) -> set[Path]:
    """The files of all modules that a text imports anywhere in it, and that these import.

    The standard library and this package are left out, and so is what installed packages import.
    The modules are found, and not run.
    """
    found: set[Path] = set()
    texts = [(text, folder)]
    for each, beside in texts:
        for file in _files_named(each, beside):
            installed = any(file.is_relative_to(place) for place in _INSTALLED)
            if file in found or _is_known(file, installed):
                continue
            found.add(file)
            if file.suffix == ".py" and not installed:
                texts.append((bytes_of(file).decode(errors="replace"), file.parent))
    return found


_STANDARD = Path(sysconfig.get_path("stdlib")).resolve()
_INSTALLED = tuple({Path(sysconfig.get_path(kind)).resolve() for kind in ("purelib", "platlib")})
_OURS = Path(__file__).resolve().parents[1]


def _is_known(file: Path, installed: bool) -> bool:
    return file.is_relative_to(_OURS) or (file.is_relative_to(_STANDARD) and not installed)


def _files_named(text: str, folder: Path) -> Iterator[Path]:
    """The files of the modules that a text names in its imports."""
    try:
        statements = [*ast.walk(ast.parse(text))]
    except (SyntaxError, ValueError, RecursionError):
        return
    everywhere = [*sys.path, str(Path.cwd()), str(folder)]
    for statement in statements:
        modules, places = list[str](), everywhere
        match statement:
            case ast.Import(names=names):
                modules = [name.name for name in names]
            case ast.ImportFrom(module=root, names=names, level=level):
                inside = [f"{root}.{name.name}" if root else name.name for name in names]
                modules = [root, *inside] if root else inside
                if level:
                    places = [str([folder, *folder.parents][level - 1])]
        for module in modules:
            spec = _spec_of(module, places)
            if spec is not None and spec.origin is not None:
                yield Path(spec.origin).resolve()
