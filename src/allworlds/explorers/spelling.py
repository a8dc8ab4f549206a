"""Names that are nearly those of an explorer: what is left out, and what was meant."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from difflib import get_close_matches
from pathlib import Path

from allworlds.inputs import InputError, read_text, show


def whole_name(name: str) -> str:
    """The name; of a file that has one generator function alone, with that function.

    The file is read, and not run.

    Raises:
        InputError: if the file has several, or none.
    """
    if not name.endswith(".py") or ":" in name or not Path(name).is_file():
        return name
    functions = [*generator_functions(read_text(name))]
    if len(functions) == 1:
        return f"{name}:{functions[0]}"
    if not functions:
        raise InputError(f"{show(name)} has no generator function: none that yields motions")
    legal = ", ".join(f"{name}:{function}" for function in functions)
    raise InputError(f"{show(name)} has several generator functions; legal are {legal}")


def generator_functions(text: str) -> Iterator[str]:
    """The names of the generator functions of a module, in their order; none if it is no Python."""
    try:
        module = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError):
        return
    for statement in module.body:
        if isinstance(statement, ast.FunctionDef) and _yields(statement.body):
            yield statement.name


def _yields(body: Iterable[ast.AST]) -> bool:
    """Whether there is a yield that is not one of another function within."""
    for node in body:
        if isinstance(node, ast.Yield | ast.YieldFrom):
            return True
        inner = isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda | ast.ClassDef)
        if not inner and _yields(ast.iter_child_nodes(node)):
            return True
    return False


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """``; did you mean 'algorithm1'?``; empty where nothing is like it."""
    close = get_close_matches(name, [*known], n=1)
    return f"; did you mean {show(close[0])}?" if close else ""
