"""Explorers under test: found by their names, loaded, and played."""

from __future__ import annotations

import importlib.util
import inspect
import sys
from collections.abc import Callable, Generator, Iterable, Mapping
from contextlib import AbstractContextManager, closing, nullcontext
from typing import Any, overload

from msgspec import Struct
from msgspec.structs import replace

from allworlds.explorers.builtin.algorithm1 import nobody
from allworlds.explorers.builtin.explorer_table import BUILT_IN, BuiltIn, Size
from allworlds.explorers.builtin.shield import Shield
from allworlds.explorers.functions import bound, function_named, keywords_of
from allworlds.explorers.names import (
    LIGHTHOUSE,
    NATIVE,
    SHIELD,
    command_of,
    entry_point,
    entry_points,
    has_shield,
    innermost,
    is_library,
    is_program,
    no_explorer,
    path_of,
)
from allworlds.explorers.program import Program
from allworlds.explorers.shared_library.library import Library, NativeExplorer, library_path
from allworlds.inputs.checks import InputError, show
from allworlds.protocol.faults import ANSWER_TIMEOUT
from allworlds.protocol.importing import SourceText, arguments_of, called, imported, text_of
from allworlds.protocol.player import Player

HASH_SEED = "PYTHONHASHSEED"
"""The variable of the environment from which an interpreter takes its hash seed."""


class Subject(Struct, frozen=True, weakref=True):
    """An explorer under test.

    Attributes:
        name: by which it is found again: a built-in name, ``module:attribute``,
            ``path/to/file.py:attribute``, an entry point, each of which may end in ``?key=value``,
            ``exec:COMMAND`` or ``native:PATH``;
            any of them with a shield as ``shield:NAME``.
        keywords: the ones of ``choices``, ``told`` and ``notice`` that it takes.
        explore: the generator function; None where another process finds it by its name, so
            that its code never gets into this one.
        own: its entry among the built-in explorers, if it is built in.
        source: the text of its file, if it stands in a file.
        program: the user's program behind it, if there is one that is run here.
        native: the shared library behind it, if there is one that is run here.
        inside: the explorer inside a shield, if it is run here.
    """

    name: str
    keywords: frozenset[str]
    explore: Callable[..., Generator[Any, Any, Any]] | None = None
    own: BuiltIn | None = None
    source: SourceText | None = None
    program: Program | None = None
    native: NativeExplorer | None = None
    inside: Subject | None = None

    @property
    def from_user(self) -> bool:
        """Whether it is a user's explorer, whose runs are executed twice."""
        return self.own is None

    @property
    def is_program(self) -> bool:
        """Whether it is a program behind a pipe, here and in other processes; also in a shield."""
        return is_program(self.name)

    @property
    def compiled(self) -> bool:
        """Whether it is a shared library; in a shield Python calls it, as any other explorer."""
        return self.name.startswith(NATIVE)

    @property
    def innermost(self) -> Subject:
        """The explorer without a shield, if it is run here; else itself."""
        return self.inside or self

    @property
    def importable(self) -> bool:
        """Whether it can be played in other processes."""
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
        """The explorer's own step budget; None if the usual one is large enough."""
        return self.own.step_budget if self.own else None

    @property
    def takes_choices(self) -> bool:
        """Whether the explorer takes choices, so that its schedules can be enumerated."""
        return "choices" in self.keywords

    def player(self, notice: Callable[[str], None] = nobody) -> Player:
        """The explorer with its keywords bound; its code must be in this process."""
        assert self.explore is not None
        return bound(self.explore, self.keywords, notice)

    def running(self) -> AbstractContextManager[object]:
        """A context at whose end the program or library behind the explorer is stopped."""
        if self.inside:
            return self.inside.running()
        behind = self.program or self.native
        return closing(behind) if behind else nullcontext()


def with_shield(inside: Subject) -> Subject:
    """The explorer with a shield; one shield is enough."""
    if has_shield(inside.name):
        return inside
    name, keywords = SHIELD + inside.name, inside.keywords - {"notice"}
    if inside.explore is None:
        return Subject(name, keywords, source=inside.source)
    explore = inside.explore if isinstance(inside.explore, Shield) else Shield(inside.explore)
    return Subject(name, keywords, explore, source=inside.source, inside=inside)


def built_in(name: str) -> Subject:
    """The subject of the built-in explorer of that name."""
    own = BUILT_IN[name]
    keywords = frozenset(inspect.signature(own.explore).parameters) - {"first"}
    return Subject(name, keywords, own.explore, own)


def subject_known(name: str, keywords: Iterable[str]) -> Subject:
    """The subject of that name with known keywords; its code is not looked for."""
    return built_in(name) if name in BUILT_IN else Subject(name, frozenset(keywords))


def in_process_subject(explore: Callable[..., Any]) -> Subject:
    """The subject for a function of this process.

    One that can be imported by its name is played in processes of its own, any other (a closure,
    or one of the running script) in this process.

    Raises:
        InputError: if it is no generator function.
    """
    if isinstance(explore, Shield):
        inside = in_process_subject(explore.explorer)
        return with_shield(inside if inside.own is None else replace(inside, explore=None))
    for name, own in BUILT_IN.items():
        if explore is own.explore:
            return built_in(name)
    module = getattr(explore, "__module__", None) or "?"
    name = f"{module}:{getattr(explore, '__qualname__', type(explore).__qualname__)}"
    found = subject_of(name, explore)
    return replace(found, explore=None) if _is_found_by_name(explore) else found


def subject_of(name: str, found: Any, source: SourceText | None = None) -> Subject:
    """The subject of a generator function, with the text of its file.

    Raises:
        InputError: if it is none, or must be called in another way.
    """
    return Subject(name, keywords_of(name, found), found, source=source)


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


@overload
def shield(explorer: str) -> str: ...
@overload
def shield(explorer: Callable[..., Generator[Any, Any, Any]]) -> Shield: ...
def shield(explorer: str | Callable[..., Generator[Any, Any, Any]]) -> str | Shield:
    """Return an explorer with a shield: right in every world under the directional lighthouse.

    It walks less than nine times what the explorer walks until its log has no open dart, and less
    than nine times the sum of the paper's bounds (1) and (2), whichever is less.  An explorer that
    neither yields nor returns still breaks the law ``timeout``.

    Args:
        explorer: a generator function; or a name, as on the command line, of which
            ``exec:COMMAND`` is a program and ``native:PATH`` a shared library.

    Returns:
        a generator function of a function, a name of a name.

    Raises:
        InputError: if it is neither.
    """
    if isinstance(explorer, str):
        return SHIELD + explorer
    if not callable(explorer):
        raise InputError(f"explorer = {show(explorer)} is neither a name nor a function")
    return Shield(explorer)
