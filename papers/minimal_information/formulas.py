"""The bounds of Section VI, and those of its variants, as formulas."""

from __future__ import annotations

from fractions import Fraction


def paper_bound(vertices: int, edges: int) -> int:
    """The sum of (1) and (2), exactly; the limit of (2) is m-n+1, as the text above it says."""
    n, m = vertices, edges
    growing = sum(s + 2 * (s - 1) * (2 * m - 2 * (s - 1)) for s in range(1, n))
    left = (2 * m - 2 * (n - 1) - 2 * (i - 1) for i in range(1, m - n + 2))
    return growing + sum(n + 2 * (n - 1) * darts for darts in left)


def printed_bound(vertices: int, edges: int) -> Fraction:
    """(3) as it is printed, without the terms that it does not state."""
    n, m = vertices, edges
    return 2 * m**2 * n - 2 * m * n**2 + Fraction(2 * n**3, 3) - 2 * m**2 - Fraction(5 * n**2, 2)


def two_vertices_bound(vertices: int, edges: int, degree: int) -> int:
    """(1) + (2), two traversals for each test, and the search among the darts of v0.

    In pass p = 0, 1, ..., m-1 there are at most 2m - 2p - 1 hypotheses to test.
    """
    tests = sum(2 * edges - 2 * p - 1 for p in range(edges))
    return paper_bound(vertices, edges) + 2 * tests + 2 * degree
