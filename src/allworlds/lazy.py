"""Packages that load each of their names only when the name is first used."""

from __future__ import annotations

import ast
import inspect
import sys
from importlib import import_module
from typing import Any


def open_door(package: str) -> None:
    """Give a package the three attributes ``__getattr__``, ``__dir__`` and ``__all__``.

    ``__getattr__`` loads a name of the package when the name is first used; ``__dir__`` and
    ``__all__`` list the names.  The names are those that the ``__init__`` of the package imports in
    a block under ``if TYPE_CHECKING``.  So the ``__init__`` has each name once, and editors and
    type checkers find the name.  If there are two such blocks, the names in the second block are
    for other packages of this program: these names are loaded, too, but ``__dir__`` and ``__all__``
    do not list them.

    Args:
        package: the name of the package, which is being imported.

    Cost: the ``__init__`` is parsed, in less than a millisecond; a module is loaded when one of its
    names is first used.
    """
    shown, *hidden = _homes(package)
    homes = {name: home for block in (shown, *hidden) for name, home in block.items()}
    names = vars(sys.modules[package])

    def load(name: str) -> Any:
        if name not in homes:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        module, original = homes[name]
        if module == package:  # one of its own modules
            names[name] = import_module(f"{package}.{original}")
            return names[name]
        home = import_module(module)
        try:
            names[name] = getattr(home, original)
        except AttributeError:  # the name is a module
            names[name] = import_module(f"{module}.{original}")
        return names[name]

    names.update(__getattr__=load, __dir__=lambda: sorted(shown), __all__=sorted(shown))


def _homes(package: str) -> list[dict[str, tuple[str, str]]]:
    """For each block under ``if TYPE_CHECKING`` the names that the block imports.

    The blocks are those in the ``__init__`` of ``package``.  The value for a name is a pair: the
    module from which the name is imported, and the name of the object in this module.
    """
    source = inspect.getsource(sys.modules[package])
    return [
        {
            alias.asname or alias.name: (imported.module, alias.name)
            for imported in block.body
            if isinstance(imported, ast.ImportFrom) and imported.module
            for alias in imported.names
        }
        for block in ast.parse(source).body
        if isinstance(block, ast.If) and ast.unparse(block.test) == "TYPE_CHECKING"
    ]
