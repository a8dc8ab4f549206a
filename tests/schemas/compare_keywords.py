"""The module of the keywords of ``compare``, made from the fields of its request."""

from __future__ import annotations

import ast
import builtins
import sys
from collections import defaultdict
from pathlib import Path

import allworlds
from allworlds import engines, judging, maps, world
from allworlds.studies.compare.compare_request import CompareRequest

MODULE = Path(allworlds.__file__).parent / "studies" / "compare" / "compare_keywords.py"

GROWN = ("to", "worlds", "places")
"""The fields that are for worlds that grow alone."""

HEAD = '''"""The keywords of ``compare`` for type checkers, made from the fields of its request.

Types have no other way to describe keywords beside a list of explorers of any length.
``python tests/schemas/generate.py`` writes this module.
"""

from __future__ import annotations

'''


def module_text() -> str:
    """The text of the module."""
    told = {name: kind for name, kind in _annotations() if name != "explorers"}
    same = "".join(f"    {name}: {told[name]}\n" for name in told if name not in GROWN)
    more = "".join(f"    {name}: {told[name]}\n" for name in GROWN)
    return (
        f"{HEAD}{_imports([*told.values()])}\n\n"
        "class SameWorldsKeywords(TypedDict, total=False):\n"
        '    """The fields of a request but the explorers, for worlds that do not grow."""\n\n'
        f"{same}\n\n"
        "class CompareKeywords(SameWorldsKeywords, total=False):\n"
        '    """All fields of a request but the explorers."""\n\n'
        f"{more}"
    )


def _annotations():
    """The type of each field for callers, in its own words."""
    words = {}
    for kind in reversed(CompareRequest.__mro__):
        words |= vars(kind).get("__annotations__", {})
    for name in CompareRequest.__dataclass_fields__:
        tree = ast.parse(words[name], mode="eval").body
        for outer in ("Annotated", "Taken"):
            if isinstance(tree, ast.Subscript) and tree.value.id == outer:
                tree = tree.slice.elts[0]
        yield name, ast.unparse(tree)


def _imports(kinds):
    """The imports that these types need."""
    names = {n.id for kind in kinds for n in ast.walk(ast.parse(kind)) if isinstance(n, ast.Name)}
    homes = defaultdict(list)
    homes["typing"].append("TypedDict")
    for name in names - {*vars(builtins)}:
        homes[_home(name)].append(name)
    lines = [f"from {home} import {', '.join(sorted(found))}\n" for home, found in homes.items()]
    own = sorted(line for line in lines if "allworlds" in line)
    return "".join(sorted({*lines} - {*own})) + "\n" + "".join(own)


def _home(name):
    """The module from which a name is imported: a wing, or one of the library."""
    for wing in (engines, judging, maps, world):
        if hasattr(wing, name):
            return wing.__name__
    owner = next(kind for kind in CompareRequest.__mro__ if hasattr(_module(kind), name))
    return getattr(_module(owner), name).__module__.removesuffix("._local")  # pathlib of 3.13


def _module(kind):
    return sys.modules[kind.__module__]
