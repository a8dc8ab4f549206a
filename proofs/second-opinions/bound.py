"""The bound of Section VI as a polynomial, by sympy: exactly, for symbolic n and m.

python proofs/second-opinions/bound.py
"""

from __future__ import annotations

import sympy

n, m, s, i, p = sympy.symbols("n m s i p", integer=True, positive=True)

SUM_1 = sympy.Sum(s + 2 * (s - 1) * (2 * m - 2 * (s - 1)), (s, 1, n - 1))
SUM_2 = sympy.Sum(n + 2 * (n - 1) * (2 * m - 2 * (n - 1) - 2 * (i - 1)), (i, 1, m - n + 1))
"""Sums (1) and (2) as printed, but for the upper limit of (2), there misprinted as n-n+1."""

POLYNOMIAL = (
    2 * m**2 * n
    - 2 * m * n**2
    + sympy.Rational(2, 3) * n**3
    - 2 * m**2
    + 5 * m * n
    - sympy.Rational(5, 2) * n**2
    - 2 * m
    + sympy.Rational(11, 6) * n
)

PRINTED_3 = (
    2 * m**2 * n
    - 2 * m * n**2
    + sympy.Rational(2, 3) * n**3
    - 2 * m**2
    - sympy.Rational(5, 2) * n**2
)
"""Expression (3) without its unstated 'lower order terms'."""


def pass_bound(vertices: sympy.Expr, explored: sympy.Expr) -> sympy.Expr:
    """The bound of a pass that finds so many vertices known and so many edges explored."""
    return vertices + 2 * (vertices - 1) * (2 * m - 2 * explored)


def difference(polynomial: sympy.Expr = POLYNOMIAL) -> sympy.Expr:
    """(1) + (2) minus a polynomial in n and m, expanded: 0 iff they are equal."""
    return sympy.expand(SUM_1.doit() + SUM_2.doit() - polynomial)


def passes() -> sympy.Expr:
    """The bounds of all m passes, with as many vertices known as can be: min(p+1, n)."""
    growing = sympy.summation(pass_bound(p + 1, p), (p, 0, n - 2))
    full = sympy.summation(pass_bound(n, p), (p, n - 1, m - 1))
    return sympy.expand(growing + full)


if __name__ == "__main__":
    print("(1) + (2) minus the polynomial:", difference())
    print("the bounds of the passes minus the polynomial:", sympy.expand(passes() - POLYNOMIAL))
