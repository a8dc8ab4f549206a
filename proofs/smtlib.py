"""SMT-LIB scripts that define all their symbols, read and evaluated without a solver.

A sort is either numbers or a finite datatype whose constructors are constants; a quantifier
over a datatype is tried with each of them.  Numbers are exact.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import reduce
from itertools import pairwise, product
from math import prod
from typing import Any

from lrat import Refused

Term = str | list[Any]
"""A word, or a list of terms."""

FUNCTIONS: dict[str, Callable[[list[Any]], Any]] = {
    "and": all,
    "or": any,
    "not": lambda v: not v[0],
    "=>": lambda v: not all(v[:-1]) or v[-1],
    "=": lambda v: all(a == b for a, b in pairwise(v)),
    "<=": lambda v: all(a <= b for a, b in pairwise(v)),
    "<": lambda v: all(a < b for a, b in pairwise(v)),
    "+": sum,
    "-": lambda v: reduce(operator.sub, v) if len(v) > 1 else -v[0],
    "*": prod,
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
    """The sorts and functions that a script defines.

    Attributes:
        sorts: the values of each datatype.
        functions: the names of the arguments, and the body.
    """

    sorts: dict[str, list[str]] = field(default_factory=dict)
    functions: dict[str, tuple[list[str], Term]] = field(default_factory=dict)

    def value(self, term: Term, point: Mapping[str, Any]) -> Any:
        """The value of a term where its free names have these values.

        Raises:
            Refused: naming a symbol that has no value.
        """
        if isinstance(term, str):
            return self._name(term, point)
        head, *arguments = term
        if head in {"forall", "exists"}:
            bound, body = arguments
            names = [name for name, _ in bound]
            points = (
                {**point, **dict(zip(names, values, strict=True))}
                for values in product(*(self._sort(sort) for _, sort in bound))
            )
            return {"forall": all, "exists": any}[head](self.value(body, p) for p in points)
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
        if re.fullmatch(r"\d+(\.\d+)?", name):
            return Fraction(name)
        if name in {"true", "false"}:
            return name == "true"
        if any(name in values for values in self.sorts.values()):
            return name
        raise Refused(f"{name} is not defined")

    def _sort(self, name: str) -> list[str]:
        if name not in self.sorts:
            raise Refused(f"{name} is no finite sort")
        return self.sorts[name]


def definitions(script: Sequence[list[Any]]) -> Definitions:
    """The definitions of a script; symbols that it only declares have no value."""
    found = Definitions()
    for command in script:
        match command:
            case ["declare-datatypes", [[sort, "0"]], [values]]:
                found.sorts[sort] = [value for (value,) in values]
            case ["define-fun", name, arguments, _, body]:
                found.functions[name] = ([argument[0] for argument in arguments], body)
    return found


# ---- Sorts ----

NUMBERS = ("Int", "Real")
Signature = tuple[list[str], str]
"""The sorts of the arguments, and of the value."""


@dataclass
class Sorts:
    """The symbols that may be used at a place in a script, with their sorts.

    Attributes:
        values: the constants of each datatype.
        functions: those that are defined before this place.
    """

    values: dict[str, list[str]] = field(default_factory=dict)
    functions: dict[str, Signature] = field(default_factory=dict)

    def of(self, term: Term, bound: Mapping[str, str]) -> str:
        """Return the sort of a term, where the names that are bound have these.

        Raises:
            Refused: if it has none.
        """
        if isinstance(term, str):
            return self._of_name(term, bound)
        if not term or not isinstance(term[0], str):
            raise Refused(f"{term} is no term")
        head, *arguments = term
        if head in {"forall", "exists"}:
            if len(arguments) != 2:
                raise Refused(f"{head} without variables and one body")
            self.require(arguments[1], "Bool", {**bound, **self.variables(arguments[0])})
            return "Bool"
        sorts = [self.of(argument, bound) for argument in arguments]
        if head in self.functions:
            wanted, sort = self.functions[head]
        elif head in FUNCTIONS or head == "ite":
            wanted, sort = _built_in(head, sorts)
        else:
            raise Refused(f"{head} is not defined")
        if sorts != wanted:
            raise Refused(f"{head} of {sorts}, not of {wanted}")
        return sort

    def variables(self, bound: Any) -> dict[str, str]:
        """Return the sorts of bound variables; refuse what is not a list of names with sorts."""
        found = {}
        for name, sort in bound:
            if name in found or not self.is_sort(sort) or not self.is_free(name):
                raise Refused(f"{name} cannot be a variable of sort {sort}")
            found[name] = sort
        return found

    def is_sort(self, sort: Any) -> bool:
        """Whether a sort is there."""
        return isinstance(sort, str) and (sort in self.values or sort in ("Bool", *NUMBERS))

    def is_free(self, name: Any) -> bool:
        """Whether SMT-LIB itself leaves the name free; a variable may hide a function."""
        return (
            isinstance(name, str)
            and re.fullmatch(r"[A-Za-z_][A-Za-z_0-9-]*", name) is not None
            and name not in (*FUNCTIONS, "ite", "forall", "exists", "let", "true", "false")
        )

    def define(self, name: Any, signature: Signature) -> None:
        """Add a function; refuse a name that is taken."""
        taken = {*self.functions, *self.values, *(v for vs in self.values.values() for v in vs)}
        if not self.is_free(name) or name in taken or name in ("Bool", *NUMBERS):
            raise Refused(f"{name} cannot be defined, or not twice")
        self.functions[name] = signature

    def _of_name(self, name: str, bound: Mapping[str, str]) -> str:
        if name in bound:
            return bound[name]
        if name in self.functions and not self.functions[name][0]:
            return self.functions[name][1]
        if re.fullmatch(r"0|[1-9]\d*", name):
            return "Int"
        if re.fullmatch(r"(0|[1-9]\d*)\.\d+", name):
            return "Real"
        if name in {"true", "false"}:
            return "Bool"
        for sort, values in self.values.items():
            if name in values:
                return sort
        raise Refused(f"{name} is not defined")

    def require(self, term: Term, sort: str, bound: Mapping[str, str]) -> None:
        """Accept a term of this sort."""
        if (found := self.of(term, bound)) != sort:
            raise Refused(f"{term} is of sort {found}, not {sort}")


def _built_in(head: str, sorts: list[str]) -> Signature:
    """Return the sorts that a function of SMT-LIB wants of so many arguments, and its value's."""
    count = len(sorts)
    if head == "ite":
        chosen = sorts[1] if count > 1 else "Bool"
        return ["Bool", chosen, chosen], chosen
    if head == "not":
        return ["Bool"], "Bool"
    first = sorts[0] if sorts else "Bool"
    if head in {"and", "or", "=>"}:
        return ["Bool"] * max(count, 2), "Bool"
    if head == "=":
        return [first] * max(count, 2), "Bool"
    number = first if first in NUMBERS else "Real"
    return [number] * max(count, 1 if head == "-" else 2), "Bool" if "<" in head else number


def require_well_sorted(script: Sequence[list[Any]]) -> None:
    """Accept a script whose definitions and assertions have sorts, each symbol defined once.

    A function may use those that are defined before it: so none goes round in a circle.

    Raises:
        Refused: naming what has not the sort that it should.
    """
    sorts = Sorts()
    for command in script:
        match command:
            case ["declare-datatypes", [[sort, "0"]], [values]]:
                constants = [value[0] for value in values if len(value) == 1]
                if sorts.is_sort(sort) or not sorts.is_free(sort) or not constants:
                    raise Refused(f"{sort} cannot be a sort, or not twice")
                if len(constants) != len(values):
                    raise Refused(f"{sort} has a value with arguments")
                for constant in constants:
                    sorts.define(constant, ([], sort))
                sorts.values[sort] = constants
            case ["define-fun", name, arguments, sort, body]:
                bound = sorts.variables(arguments)
                if not sorts.is_sort(sort):
                    raise Refused(f"{sort} is no sort")
                sorts.require(body, sort, bound)
                sorts.define(name, (list(bound.values()), sort))
            case ["assert", law]:
                sorts.require(law, "Bool", {})
            case ["set-logic", str()] | ["check-sat"]:
                pass
            case _:
                raise Refused(f"no command that is expected: {command}")
