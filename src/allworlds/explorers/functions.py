"""Explorers that are generator functions in Python: found by name, looked at, and called.

Nothing of the built-in ones is loaded with it, so that a player starts fast.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager, nullcontext
from typing import Any

from allworlds.inputs.checks import InputError, show
from allworlds.protocol.actions import Percept
from allworlds.protocol.choices import Choices
from allworlds.protocol.importing import (
    SourceText,
    arguments_of,
    attribute_of,
    called,
    module_named,
    module_of_text,
)
from allworlds.protocol.player import Player, Told

EXPLORER = "an explorer is def explore(first) with yield"


class Function:
    """An explorer that is a function, loaded here.

    Attributes:
        name: by which it was found.
        explore: the function.
        source: the text of its file, if it stands in a file.
        keywords: the ones of ``choices`` and ``told`` that it takes.
    """

    program = native = None

    def __init__(self, name: str, source: SourceText | None) -> None:
        self.name, self.source = name, source
        self.explore = function_named(name, source)
        self.keywords = keywords_of(name, self.explore)

    @property
    def innermost(self) -> Function:
        """Itself: it has no shield that its name would tell."""
        return self

    def player(self) -> Player:
        """The explorer with its keywords bound."""
        return bound(self.explore, self.keywords)

    def running(self) -> AbstractContextManager[object]:
        """A context: nothing is to be stopped at its end."""
        return nullcontext()


def function_named(name: str, source: SourceText | None) -> Any:
    """The object that a name ``module:attribute`` or ``FILE.py:attribute`` stands for.

    Raises:
        InputError: if there is none, or it does not import.
    """
    plain, arguments = arguments_of(name)
    place, _, attribute = plain.rpartition(":")
    module = module_of_text(place, source) if source else module_named(place)
    return called(name, _attribute(module, attribute, place), arguments)


def _attribute(module: Any, attribute: str, place: str) -> Any:
    try:
        return attribute_of(module, attribute, place)
    except InputError as error:
        names = [n for n, v in vars(module).items() if inspect.isgeneratorfunction(v)]
        if not names and attribute == "explore":
            raise InputError(f"{show(place)} has no generator function: {EXPLORER}") from None
        raise InputError(
            f"{error}; its generator functions are: {', '.join(names) or 'none'}"
        ) from None


def _nobody(_event: str) -> None:
    """Hear nothing."""


def bound(
    explore: Callable[..., Generator[Any, Any, Any]],
    keywords: frozenset[str],
    notice: Callable[[str], None] = _nobody,
) -> Player:
    """The explorer with its keywords bound."""

    def play(first: Percept, choices: Choices, told: Told) -> Generator[Any, Any, Any]:
        offered = {"choices": choices, "told": told, "notice": notice}
        return explore(first, **{key: offered[key] for key in keywords})

    return play


def keywords_of(name: str, explore: Any) -> frozenset[str]:
    """The keywords ``choices`` and ``told`` that a generator function takes.

    Raises:
        InputError: if it is no generator function, or must be called in another way.
    """
    function = explore if inspect.isroutine(explore) else getattr(explore, "__call__", None)  # noqa: B004
    generates = inspect.isgeneratorfunction(explore) or inspect.isgeneratorfunction(function)
    if not callable(explore) or not generates:
        raise InputError(f"{name} is no generator function: {EXPLORER}")
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
