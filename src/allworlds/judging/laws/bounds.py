"""Bounds on the number of traversals in a run; a bound has a name, or an expression defines it.

A bound is a function of the world; n, m, d0, D, d and g are its variables, see :func:`bound_named`.
"""

import ast
import operator
import re
import warnings
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache

from allworlds.inputs.checks import InputError, did_you_mean, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart

VARIABLES = ("n", "m", "d0", "D", "d", "g")
_NAMES = (*VARIABLES, "paper")


def default_step_budget(bound: int) -> int:
    """The default step budget of a run: 8 times ``bound``, the paper's bound, plus 100.

    A run with more traversals than its step budget is cut off.
    """
    return 8 * bound + 100


def far_beyond(bound: int) -> int:
    """100 times ``bound``, plus 100: the largest default step budget of a run under this bound.

    ``bound`` is the bound that the law ``bound`` checks.  Unless a step budget is given, a run is
    cut off after this number of traversals, even if the step budget of :func:`default_step_budget`
    is larger.  Such a run breaks the law ``bound`` anyway, so its rest need not be played.
    """
    return 100 * max(0, bound) + 100


def paper_bound(vertices: int, edges: int) -> int:
    """The paper's bound for a map of this size: the exact sum of its formulas (1) and (2)."""
    growing, closing = paper_terms(vertices, edges)
    return growing + closing


@cache
def paper_terms(vertices: int, edges: int) -> tuple[int, int]:
    """The values of the formulas (1) and (2) of the paper's Section VI, for a map of this size.

    The paper prints the upper limit of the sum (2) as 'n-n+1', but the text above the formula says
    m-n+1.  This function uses m-n+1.
    """
    n, m = vertices, edges
    growing = sum(s + 2 * (s - 1) * (2 * m - 2 * (s - 1)) for s in range(1, n))
    closing = sum(
        n + 2 * (n - 1) * (2 * m - 2 * (n - 1) - 2 * (i - 1)) for i in range(1, m - n + 2)
    )
    return growing, closing


def two_vertices_bound(vertices: int, edges: int, degree: int) -> int:
    """The bound ``two-vertices``, for Algorithm 1 with marks at two neighbours, v0 and v1.

    The bound is the paper's bound, plus two traversals for each test of a hypothesis, plus the cost
    of the search for v1.  In pass p = 0, 1, ..., m-1 there are at most 2m - 2p - 1 hypotheses to
    test, which makes m^2 tests in all passes.  The search tries the darts of v0, and costs at most
    2 deg(v0).  ``degree`` is deg(v0).
    """
    return paper_bound(vertices, edges) + 2 * edges**2 + 2 * degree


@dataclass(frozen=True, slots=True)
class Bound:
    """A bound with its value for each world; bounds of the same name are equal.

    Attributes:
        name: the name that the user gives.
        value: the function from n, m, d0, D, d and g, which :func:`bound_named` explains, to the
            largest number of traversals that the bound allows; or to None if there is no bound.
        variables: the names of those variables on which the value depends.
    """

    name: str
    value: Callable[[int, int, int, int, int, int], int | None] = field(compare=False)
    variables: frozenset[str]

    def __str__(self) -> str:
        return self.name

    def __reduce__(self) -> "tuple[Callable[[str], Bound], tuple[str]]":
        # Compiled expressions cannot be pickled, but their texts can.
        return bound_named, (self.name,)

    def of(self, map_: CombinatorialMap, start: Dart) -> int | None:
        """The bound's value in the world with the map ``map_`` and the start dart ``start``.

        A run with more traversals breaks the law ``bound``.  The result is None if there is no
        bound.
        """
        # Most bounds do not depend on these two variables, which take longer than all others.
        diameter = map_.diameter if "d" in self.variables else 0
        genus = map_.genus if "g" in self.variables else 0
        degrees = (map_.degree_at[start], max(map_.degrees))
        return self.value(map_.vertex_count, map_.edge_count, *degrees, diameter, genus)


NO_BOUND = Bound("none", lambda *_: None, frozenset())

BOUNDS = {
    bound.name: bound
    for bound in (
        Bound("paper", lambda n, m, *_: paper_bound(n, m), frozenset({"n", "m"})),
        Bound(
            "two-vertices",
            lambda n, m, d0, *_: two_vertices_bound(n, m, d0),
            frozenset({"n", "m", "d0"}),
        ),
        NO_BOUND,
    )
}
"""The bounds with names of their own."""


def bound_named(text: str) -> Bound:
    """The bound with a name in :data:`BOUNDS`, or the bound that an expression defines.

    ``text`` is the name or the expression.  An expression is built from integers, n (the number of
    vertices), m (the number of edges), d0 (the degree of the vertex where the robot starts), D (the
    largest degree), d (the diameter), g (the genus), paper (the value of :func:`paper_bound`),
    ``+ - * // **``, ``min``, ``max`` and parentheses.  Values are computed exactly.

    Raises:
        InputError: naming the part of ``text`` that is illegal.
    """
    if text in BOUNDS:
        return BOUNDS[text]
    try:
        # Python would read letters that look like n and m as n and m, and 1_0 as 10.
        plain = text.isascii() and not re.search("[0-9]_", text)
        with warnings.catch_warnings():
            # Python's warnings about the text are of no use to the user.
            warnings.simplefilter("ignore")
            tree = ast.parse(text if plain else "", mode="eval")
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        product = re.fullmatch(r"(\d+) *([a-zA-Z]\w*)", text)
        hint = f"; did you mean '{product[1]}*{product[2]}'?" if product else ""
        raise InputError(
            f"bound {show(text)} is not one of {', '.join(BOUNDS)} or an expression{hint}"
        ) from None
    too_deep = f"bound of {len(text)} characters is nested too deeply"
    try:
        evaluate = _compile(tree.body, text)
    except RecursionError:
        raise InputError(too_deep) from None

    named = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    if papers := "paper" in named:
        named |= {"n", "m"}

    def value(n: int, m: int, d0: int, largest: int, d: int, g: int) -> int:
        numbers = {"n": n, "m": m, "d0": d0, "D": largest, "d": d, "g": g}
        try:
            result = evaluate(numbers | {"paper": paper_bound(n, m)} if papers else numbers)
        except ZeroDivisionError:
            usual = [f"{k}={v}" for k, v in numbers.items() if k not in ("d", "g") or k in named]
            raise InputError(f"bound {show(text)} divides by zero at {' '.join(usual)}") from None
        except RecursionError:
            raise InputError(too_deep) from None
        except InputError as error:
            raise InputError(f"bound {show(text)} {error}") from None
        if result.bit_length() > _LARGEST_BITS:
            raise InputError(f"bound {show(text)} {TOO_LARGE}")
        return result

    return Bound(text, value, frozenset(named & set(VARIABLES)))


_Evaluate = Callable[[dict[str, int]], int]
_LARGEST_POWER = 64
_LARGEST_BITS = 4096
_FUNCTIONS: dict[str, Callable[..., int]] = {"min": min, "max": max}


def _power(base: int, exponent: int) -> int:
    if not 0 <= exponent <= _LARGEST_POWER:
        raise InputError(f"raises to the power {show(exponent)}; legal are 0..{_LARGEST_POWER}")
    if base.bit_length() * exponent > _LARGEST_BITS:
        raise InputError(TOO_LARGE)
    result: int = base**exponent
    return result


TOO_LARGE = f"has a value of over {_LARGEST_BITS} bits"

_OPERATORS: dict[type[ast.operator], Callable[[int, int], int]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.FloorDiv: operator.floordiv,
    ast.Pow: _power,
}


def _compile(node: ast.expr, text: str) -> _Evaluate:
    apply: Callable[..., int]
    operands: list[ast.expr]
    match node:
        case ast.Constant(value=int() as number) if not (
            isinstance(number, bool) or number.bit_length() > _LARGEST_BITS
        ):
            return lambda _names: number
        case ast.Name(id=name) if name in _NAMES:
            return operator.itemgetter(name)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            apply, operands = operator.neg, [operand]
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
            apply, operands = _OPERATORS[type(op)], [left, right]
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]) if (
            name in _FUNCTIONS and len(args) > 1
        ):
            apply, operands = _FUNCTIONS[name], args
        case _:
            part = ast.get_source_segment(text, node) or text
            raise InputError(
                f"{show(part)} in bound {show(text)} is not one of integers, {', '.join(_NAMES)}, "
                f"+ - * // **, min(,), max(,) and parentheses{did_you_mean(part, BOUNDS)}"
            )
    parts = [_compile(part, text) for part in operands]
    return lambda names: apply(*[part(names) for part in parts])
