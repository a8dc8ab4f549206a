"""Finding an explorer by its name, and looking once at what it takes."""

from __future__ import annotations

import importlib
import importlib.metadata
import importlib.util
import inspect
import re
import sys
from collections.abc import Callable, Generator, Mapping
from contextlib import AbstractContextManager, closing, nullcontext, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from allworlds.episode import Player
from allworlds.explorers import BUILT_IN, BuiltIn, Size, nobody
from allworlds.inputs import InputError
from allworlds.protocol import Choices, Percept
from allworlds.subjects.program import Program

ENTRY_POINTS = "allworlds.explorers"
EXEC = "exec:"

LIGHTHOUSE = "directional"
"""What foreign explorers are run under unless another lighthouse is named."""


@dataclass(frozen=True, slots=True)
class Subject:
    """An explorer under test.

    Attributes:
        name: what finds it again: a built-in name, ``module:attribute``,
            ``path/to/file.py:attribute``, an entry point, or ``exec:COMMAND``.
        explore: the generator function.
        keywords: those of ``choices``, ``told`` and ``notice`` that it takes.
        foreign: not one of ours: its runs are executed twice.
        importable: another process can find it by its name.
        own: its entry among the built-in explorers, if it is one.
        program: the foreign program behind it, if it is one.
    """

    name: str
    explore: Callable[..., Generator[Any, Any, Any]]
    keywords: frozenset[str]
    foreign: bool = True
    importable: bool = True
    own: BuiltIn | None = None
    program: Program | None = None

    @property
    def lighthouse(self) -> str:
        """The lighthouse under which it is run unless another is named."""
        return self.own.lighthouse if self.own else LIGHTHOUSE

    @property
    def witnesses(self) -> Mapping[str, tuple[Size, Size | None]]:
        """The events that a complete check must have seen (see ``BuiltIn``)."""
        return self.own.witnesses if self.own else {}

    def bound_under(self, lighthouse: str) -> str | None:
        """The bound that it brings under this lighthouse, if it does."""
        return own_bound(self.name, lighthouse)

    @property
    def takes_choices(self) -> bool:
        """The explorer asks where it is free, so its schedules can be enumerated."""
        return "choices" in self.keywords

    def player(self, notice: Callable[[str], None] = nobody) -> Player:
        """The explorer with its keywords bound."""
        explore, keywords = self.explore, self.keywords

        def play(first: Percept, choices: Choices, told: int | None) -> Generator[Any, Any, Any]:
            offered = {"choices": choices, "told": told, "notice": notice}
            return explore(first, **{key: offered[key] for key in keywords})

        return play

    def running(self) -> AbstractContextManager[object]:
        """A context at whose end the program behind the explorer, if any, is stopped."""
        return closing(self.program) if self.program else nullcontext()


def load(name: str, answer_timeout: float = 10.0) -> Subject:
    """The explorer of that name.

    Args:
        name: see :class:`Subject`.
        answer_timeout: seconds after which a silent foreign program is given up.

    Raises:
        InputError: if there is none, it does not import, or it is no generator function.
    """
    if name in BUILT_IN:
        return _built_in(name)
    if name.startswith(EXEC):
        program = Program(name.removeprefix(EXEC), answer_timeout)
        return Subject(name, program.explore, frozenset({"told"}), program=program)
    if ":" in name:
        place, _, attribute = name.rpartition(":")
        if not place or not attribute:
            raise InputError(
                f"explorer {name!r} is incomplete; legal are module:attribute and "
                "path/to/file.py:attribute"
            )
        module = _file(place) if place.endswith(".py") else _module(place)
        return _subject(name, _attribute(module, attribute, place))
    points = importlib.metadata.entry_points(group=ENTRY_POINTS)
    if name in points.names:
        return _subject(name, _imported(name, points[name].load))
    known = ", ".join(sorted({*BUILT_IN, *points.names}))
    raise InputError(
        f"explorer {name!r} is none of {known}, module:attribute or path/to/file.py:attribute"
    )


def own_bound(name: str, lighthouse: str) -> str | None:
    """The bound that the explorer of that name brings under this lighthouse, if it does.

    Lighthouses are written ``KIND[:key=value,...]``; it does under all of the kind it is
    written for.
    """
    kinds = {str(text).partition(":")[0] for text in (lighthouse, own_lighthouse(name))}
    return BUILT_IN[name].bound if name in BUILT_IN and len(kinds) == 1 else None


def own_lighthouse(name: str) -> str:
    """The lighthouse that the explorer of that name is run under unless another is named."""
    return BUILT_IN[name].lighthouse if name in BUILT_IN else LIGHTHOUSE


def subject_of(explore: str | Callable[..., Any], answer_timeout: float = 10.0) -> Subject:
    """The subject for a name or a generator function.

    A function that can be imported by its name runs in worker processes, any other (a
    closure, or one of the running script) in this process.
    """
    if isinstance(explore, str):
        return load(explore, answer_timeout)
    for name, built_in in BUILT_IN.items():
        if explore is built_in.explore:
            return _built_in(name)
    module = getattr(explore, "__module__", None) or "?"
    name = f"{module}:{getattr(explore, '__qualname__', type(explore).__qualname__)}"
    return _subject(name, explore, importable=_is_found_by_name(explore))


def names_explorer(text: str) -> bool:
    """Whether a text has the form of an explorer's name, be there one or not."""
    if text in BUILT_IN or text in importlib.metadata.entry_points(group=ENTRY_POINTS).names:
        return True
    return bool(re.fullmatch(r"(.+\.py|[^\W\d]\w*(\.[^\W\d]\w*)*):[^\W\d][\w.]*", text))


def _built_in(name: str) -> Subject:
    built_in = BUILT_IN[name]
    return Subject(
        name,
        built_in.explore,
        frozenset(inspect.signature(built_in.explore).parameters) - {"first"},
        foreign=False,
        own=built_in,
    )


def _subject(name: str, explore: Any, *, importable: bool = True) -> Subject:
    function = explore if inspect.isroutine(explore) else getattr(explore, "__call__", None)  # noqa: B004
    generates = inspect.isgeneratorfunction(explore) or inspect.isgeneratorfunction(function)
    if not callable(explore) or not generates:
        raise InputError(
            f"{name} is no generator function: an explorer is def explore(first) with yield"
        )
    parameters = inspect.signature(explore).parameters
    takes_all = any(p.kind is p.VAR_KEYWORD for p in parameters.values())
    keywords = frozenset(
        key
        for key in ("choices", "told")
        if takes_all
        or (key in parameters and parameters[key].kind is not inspect.Parameter.POSITIONAL_ONLY)
    )
    try:
        inspect.signature(explore).bind(None, **dict.fromkeys(keywords))
    except TypeError as error:
        raise InputError(
            f"{name} must be callable as explore(first), with choices and told at most: {error}"
        ) from None
    return Subject(name, explore, keywords, importable=importable)


def _module(name: str) -> Any:
    here = str(Path.cwd())
    if here not in sys.path:
        sys.path.insert(0, here)
    return _imported(name, lambda: importlib.import_module(name))


def _file(path: str) -> Any:
    file = Path(path).resolve()
    if not file.is_file():
        raise InputError(f"there is no file {path!r}")
    # Behind all others: what lies beside the file must not hide modules that we need.
    if str(file.parent) not in sys.path:
        sys.path.append(str(file.parent))
    # A file may be called as a module that is already there, and must not take its place.
    name = f"{file.stem} in {file.parent}" if file.stem in sys.modules else file.stem
    spec = importlib.util.spec_from_file_location(name, file)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    loader = spec.loader

    def execute() -> Any:
        loader.exec_module(module)
        return module

    return _imported(path, execute)


def _imported(name: str, importing: Callable[[], Any]) -> Any:
    try:
        # What a module prints must not get into a document on stdout.
        with redirect_stdout(sys.stderr):
            return importing()
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # noqa: BLE001  # a module may raise anything
        what = f"{type(error).__name__}: {error}".splitlines()[0].removesuffix(": ")
        raise InputError(f"{name!r} does not import: {what}") from None


def _attribute(module: Any, attribute: str, place: str) -> Any:
    value = module
    for part in attribute.split("."):
        try:
            value = getattr(value, part)
        except AttributeError:
            names = [n for n, v in vars(module).items() if inspect.isgeneratorfunction(v)]
            raise InputError(
                f"{place!r} has no {attribute!r}; its generator functions are: "
                + (", ".join(names) or "none")
            ) from None
    return value


def _is_found_by_name(explore: Any) -> bool:
    module, name = getattr(explore, "__module__", None), getattr(explore, "__qualname__", "")
    if module in (None, "__main__") or "<" in name:
        return False
    try:
        if importlib.util.find_spec(module) is None:
            return False
        value: Any = sys.modules[module]
        for part in name.split("."):
            value = getattr(value, part)
    except (ImportError, ValueError, KeyError, AttributeError):
        return False
    return value is explore
