"""Canonical codes of rooted maps, and the least few of them."""

from __future__ import annotations

from numba import njit
from numpy import int64, zeros


@njit(cache=True, nogil=True)
def rotation(vertices, degree, sigma):
    """``sigma`` for vertices whose darts are consecutive and clockwise."""
    first = 0
    for v in range(vertices):
        for i in range(degree[v]):
            sigma[first + i] = first + (i + 1) % degree[v]
        first += degree[v]


@njit(cache=True, nogil=True)
def encode(darts, sigma, alpha, root, code):
    """The canonical code, sigma then alpha, in ``code[:2 * darts]``."""
    number = zeros(darts, int64)
    order = zeros(darts, int64)
    number[:] = -1
    number[root] = 0
    order[0] = root
    known = 1
    taken = 0
    while taken < known:
        x = order[taken]
        for y in (sigma[x], alpha[x]):
            if number[y] < 0:
                number[y] = known
                order[known] = y
                known += 1
        taken += 1
    for i in range(known):
        code[i] = number[sigma[order[i]]]
        code[darts + i] = number[alpha[order[i]]]


@njit(cache=True, nogil=True)
def keep_least(least, row):
    """Sort a row into the ascending rows of ``least``; the greatest falls out.

    A row begins with its number of vertices; 0 there marks a row that is empty.
    """
    place = least.shape[0]
    while place > 0 and (least[place - 1, 0] == 0 or _before(row, least[place - 1])):
        place -= 1
    for i in range(least.shape[0] - 1, place, -1):
        least[i] = least[i - 1]
    if place < least.shape[0]:
        least[place] = row


@njit(cache=True, nogil=True)
def _before(a, b):
    """Whether row ``a`` is lexicographically smaller than row ``b``."""
    for i in range(len(a)):
        if a[i] != b[i]:
            return a[i] < b[i]
    return False
