"""Doors: packages whose names are loaded when they are first used."""

from __future__ import annotations

import ast
import inspect
import sys
from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any

from allworlds.inputs import InputError


def open_door(package: str, replaced: Mapping[str, str] = {}) -> None:
    """Give a package its names: ``__getattr__``, ``__dir__`` and ``__all__``.

    The names are those that the ``__init__`` of the package imports under ``if TYPE_CHECKING``,
    so each stands there once, and is found by editors and type checkers.

    Args:
        package: its name; it is being imported.
        replaced: functions that are gone, and what does the same; they refuse to be called.

    Cost: the ``__init__`` is parsed, in less than a millisecond; each module is loaded with the
    first of its names.
    """
    homes = _homes(package)
    names = vars(sys.modules[package])

    def load(name: str) -> Any:
        if name in replaced:
            return _gone(f"{package}.{name}", f"{package}.{replaced[name]}")
        if name not in homes:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        module, original = homes[name]
        home = import_module(module)
        try:
            names[name] = getattr(home, original)
        except AttributeError:  # the name is a module
            names[name] = import_module(f"{module}.{original}")
        return names[name]

    names.update(__getattr__=load, __dir__=lambda: sorted(homes), __all__=sorted(homes))


def _homes(package: str) -> dict[str, tuple[str, str]]:
    """Return module and name there of each name that is imported under ``if TYPE_CHECKING``."""
    source = inspect.getsource(sys.modules[package])
    return {
        alias.asname or alias.name: (imported.module, alias.name)
        for block in ast.parse(source).body
        if isinstance(block, ast.If) and ast.unparse(block.test) == "TYPE_CHECKING"
        for imported in block.body
        if isinstance(imported, ast.ImportFrom) and imported.module
        for alias in imported.names
    }


def _gone(name: str, instead: str) -> Callable[..., Any]:
    """Return a function that refuses to be called, and names what does the same."""

    def refuse(*_: Any, **__: Any) -> Any:
        raise InputError(f"{name} is gone: call {instead}")

    return refuse
