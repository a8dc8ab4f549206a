"""Explorers as a check speaks of them: a name, what it takes, and where it is played."""

from __future__ import annotations

import hashlib
import importlib.metadata
import importlib.util
import inspect
import re
import sys
from collections.abc import Callable, Generator, Iterable, Mapping
from contextlib import AbstractContextManager, closing, nullcontext
from dataclasses import dataclass
from typing import Any

from allworlds.explorers.builtin.algorithm1 import nobody
from allworlds.explorers.builtin.explorer_table import BUILT_IN, BuiltIn, Size
from allworlds.explorers.program import Program
from allworlds.explorers.shared_library.native import NativeExplorer
from allworlds.inputs import InputError
from allworlds.protocol import Choices, Percept, Player

ENTRY_POINTS = "allworlds.explorers"
EXEC = "exec:"
NATIVE = "native:"
"""The beginnings of the names of programs and of shared libraries."""

LIGHTHOUSE = "directional"
"""What foreign explorers are run under unless another lighthouse is named."""


@dataclass(frozen=True, slots=True)
class ExplorerSource:
    """The text of an explorer's file, read once: what happens to the file then does no harm.

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
class Subject:
    """An explorer under test.

    Attributes:
        name: what finds it again: a built-in name, ``module:attribute``,
            ``path/to/file.py:attribute``, an entry point, ``exec:COMMAND`` or ``native:PATH``.
        keywords: those of ``choices``, ``told`` and ``notice`` that it takes.
        explore: the generator function; None where another process finds it by its name, so
            that its code never gets into this one.
        own: its entry among the built-in explorers, if it is one.
        source: the text of its file, if it stands in a file.
        program: the foreign program behind it, if it is one, and is to be run here.
        native: the same for a shared library.
    """

    name: str
    keywords: frozenset[str]
    explore: Callable[..., Generator[Any, Any, Any]] | None = None
    own: BuiltIn | None = None
    source: ExplorerSource | None = None
    program: Program | None = None
    native: NativeExplorer | None = None

    @property
    def from_user(self) -> bool:
        """It is not one of ours: its runs are executed twice."""
        return self.own is None

    @property
    def is_program(self) -> bool:
        """It is a program behind a pipe; its name tells, here and where it is started."""
        return is_program(self.name)

    @property
    def compiled(self) -> bool:
        """It is a shared library; its name tells, here and where it is loaded."""
        return is_library(self.name)

    @property
    def importable(self) -> bool:
        """It is played in other processes."""
        return self.explore is None

    @property
    def lighthouse(self) -> str:
        """The lighthouse under which it is run unless another is named."""
        return self.own.lighthouse if self.own else LIGHTHOUSE

    @property
    def witnesses(self) -> Mapping[str, tuple[Size, Size | None]]:
        """The events that a complete check must have seen (see ``BuiltIn``)."""
        return self.own.witnesses if self.own else {}

    @property
    def step_budget(self) -> int | None:
        """The step budget that it brings, if it needs one of its own."""
        return self.own.step_budget if self.own else None

    def bound_under(self, lighthouse: str) -> str | None:
        """The bound that it brings under this lighthouse, if it does."""
        return own_bound(self.name, lighthouse)

    @property
    def takes_choices(self) -> bool:
        """The explorer asks where it is free, so its schedules can be enumerated."""
        return "choices" in self.keywords

    def player(self, notice: Callable[[str], None] = nobody) -> Player:
        """The explorer with its keywords bound; it must be here."""
        explore, keywords = self.explore, self.keywords
        assert explore is not None

        def play(first: Percept, choices: Choices, told: int | None) -> Generator[Any, Any, Any]:
            offered = {"choices": choices, "told": told, "notice": notice}
            return explore(first, **{key: offered[key] for key in keywords})

        return play

    def running(self) -> AbstractContextManager[object]:
        """A context at whose end what is behind the explorer, if anything, is stopped."""
        behind = self.program or self.native
        return closing(behind) if behind else nullcontext()


def is_program(name: str) -> bool:
    """Whether that is the name of a program behind a pipe, as ``exec:COMMAND``."""
    return name.startswith(EXEC)


def is_library(name: str) -> bool:
    """Whether that is the name of a shared library, as ``native:PATH``."""
    return name.startswith(NATIVE)


def command_of(name: str) -> str:
    """The command of a program of that name."""
    return name.removeprefix(EXEC)


def path_of(name: str) -> str:
    """The path of a shared library of that name."""
    return name.removeprefix(NATIVE)


def named_on_command_line(name: str) -> list[str]:
    """The words by which the command line names that explorer."""
    if is_program(name):
        return ["--exec", command_of(name)]
    if is_library(name):
        return ["--native", path_of(name)]
    return [name]


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


def built_in(name: str) -> Subject:
    """The built-in explorer of that name."""
    own = BUILT_IN[name]
    keywords = frozenset(inspect.signature(own.explore).parameters) - {"first"}
    return Subject(name, keywords, own.explore, own)


def subject_known(name: str, keywords: Iterable[str]) -> Subject:
    """The subject of that name where all is known of what it does: its code is not looked for."""
    return built_in(name) if name in BUILT_IN else Subject(name, frozenset(keywords))


def in_process_subject(explore: Callable[..., Any]) -> Subject:
    """The subject for a function of this process.

    One that can be imported by its name is played in processes of its own, any other (a closure,
    or one of the running script) in this process.

    Raises:
        InputError: if it is no generator function.
    """
    for name, own in BUILT_IN.items():
        if explore is own.explore:
            return built_in(name)
    module = getattr(explore, "__module__", None) or "?"
    name = f"{module}:{getattr(explore, '__qualname__', type(explore).__qualname__)}"
    keywords = keywords_of(name, explore)
    return Subject(name, keywords, None if _is_found_by_name(explore) else explore)


def keywords_of(name: str, explore: Any) -> frozenset[str]:
    """Those of ``choices`` and ``told`` that a generator function takes.

    Raises:
        InputError: if it is none, or must be called in another way.
    """
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
    return keywords


def entry_points() -> dict[str, importlib.metadata.EntryPoint]:
    """The explorers that other packages offer, by their names."""
    return {point.name: point for point in importlib.metadata.entry_points(group=ENTRY_POINTS)}


def names_explorer(text: str) -> bool:
    """Whether a text has the form of an explorer's name, be there one or not."""
    if text in BUILT_IN or text in entry_points():
        return True
    return bool(re.fullmatch(r"(.+\.py|[^\W\d]\w*(\.[^\W\d]\w*)*):[^\W\d][\w.]*", text))


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
