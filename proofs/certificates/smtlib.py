"""SMT-LIB scripts about integers that define all their functions, evaluated without a solver."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import reduce
from itertools import pairwise
from typing import Any

from lrat import Refused

Term = str | list[Any]
"""A word, or a list of terms."""

FUNCTIONS: dict[str, Callable[[list[Any]], Any]] = {
    "and": all,
    "or": any,
    "not": lambda v: not v[0],
    "=": lambda v: all(a == b for a, b in pairwise(v)),
    "<=": lambda v: all(a <= b for a, b in pairwise(v)),
    "<": lambda v: all(a < b for a, b in pairwise(v)),
    "+": sum,
    "-": lambda v: reduce(operator.sub, v) if len(v) > 1 else -v[0],
}


def commands(text: str) -> list[list[Any]]:
    """The commands of a script, without comments.

    Raises:
        Refused: if the parentheses do not match, or something stands outside them.
    """
    stack: list[list[Any]] = [[]]
    for word in re.findall(r"[()]|[^\s()]+", re.sub(r";.*", "", text)):
        if word == "(":
            stack.append([])
        elif word == ")":
            done = stack.pop()
            if not stack:
                raise Refused("a parenthesis is closed that was not opened")
            stack[-1].append(done)
        elif len(stack) == 1:
            raise Refused(f"{word!r} stands outside of a command")
        else:
            stack[-1].append(word)
    if len(stack) > 1:
        raise Refused("a parenthesis is not closed")
    return stack[0]


def assertions(script: Sequence[list[Any]]) -> list[Term]:
    """The assertions of a script, in its order."""
    return [command[1] for command in script if command[0] == "assert"]


@dataclass
class Definitions:
    """The functions that a script defines: the names of the arguments, and the body."""

    functions: dict[str, tuple[list[str], Term]] = field(default_factory=dict)

    def value(self, term: Term, point: Mapping[str, Any]) -> Any:
        """The value of a term where its free names have these values.

        Raises:
            Refused: naming a symbol that has no value.
        """
        if isinstance(term, str):
            return self._name(term, point)
        head, *arguments = term
        if head == "ite":
            chosen = arguments[1 if self.value(arguments[0], point) else 2]
            return self.value(chosen, point)
        values = [self.value(argument, point) for argument in arguments]
        if head in self.functions:
            names, body = self.functions[head]
            return self.value(body, dict(zip(names, values, strict=True)))
        if head not in FUNCTIONS:
            raise Refused(f"{head} is not defined")
        return FUNCTIONS[head](values)

    def _name(self, name: str, point: Mapping[str, Any]) -> Any:
        if name in point:
            return point[name]
        if name in self.functions:
            return self.value(self.functions[name][1], {})
        if re.fullmatch(r"\d+", name):
            return int(name)
        raise Refused(f"{name} is not defined")


def definitions(script: Sequence[list[Any]]) -> Definitions:
    """The definitions of a script; symbols that it only declares have no value."""
    found = Definitions()
    for command in script:
        match command:
            case ["define-fun", name, arguments, _, body]:
                found.functions[name] = ([argument[0] for argument in arguments], body)
    return found
