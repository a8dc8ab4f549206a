"""The number of worlds that share a quotient, counted without making one of them.

The setting is one marked vertex v0 that is sensed, so that all darts over the root's vertex
of the quotient lie at v0.  The k sheets are permuted once round each vertex and across each
edge outside a spanning tree; a world is given by these permutations:

- round v0 by ``c = (0 1 .. k-1)``, since one vertex lies there;
- round any other vertex of cone index b by a permutation with cycles of length b only;
- across each of the beta1 ordinary edges by any permutation;
- across each semi-edge by an involution without fixed points, since no edge is half.

Renaming the sheets by a power of c gives the same world, and nothing else does.  So the
number of choices is the number of pose hypotheses P (which dart of which world stands for the
robot's), and the number of worlds is the number of orbits under the powers of c.
"""

from __future__ import annotations

from collections import Counter
from math import factorial, gcd, perm, prod

from allworlds.maps.quotient import Quotient


def is_ambiguous(quotient: Quotient) -> bool:
    """Whether two or more worlds have this quotient under position.

    True iff k >= 2, and not: there is no cycle (beta1 = 0), and k = 2, or there is no
    semi-edge and every cone index but that of v0 is 1.

    Cost: O(m).
    """
    if quotient.sheets == 1 or quotient.beta1:
        return quotient.sheets > 1
    rigid = not quotient.semi_edges and all(b == 1 for b in quotient.cone_indices[1:])
    return quotient.sheets > 2 and not rigid


def pose_count(quotient: Quotient) -> int:
    """The number of poses (world, dart of v0): P = (k!)^beta1 N(k,2)^s prod N(k,b_v).

    N(k,b) is the number of permutations of k things with cycles of length b only, s the
    number of semi-edges; the product is over the vertices other than v0.
    """
    return _fixed_by_rotations(quotient, quotient.sheets)


def class_size(quotient: Quotient) -> int:
    """The number of worlds with this quotient, by Burnside's count of orbits.

    Cost: at most k products of large integers for each vertex, each edge and each divisor of
    k; no world is made.
    """
    k = quotient.sheets
    divisors = [g for g in range(1, k + 1) if k % g == 0]
    # totient(k / g) powers of c have g cycles.
    return sum(_totient(k // g) * _fixed_by_rotations(quotient, g) for g in divisors) // k


def _fixed_by_rotations(quotient: Quotient, cycles: int) -> int:
    """The number of choices that commute with a power of c that has ``cycles`` cycles."""
    k = quotient.sheets
    lengths = Counter(quotient.cone_indices[1:])
    lengths[2] += len(quotient.semi_edges)
    uniform: int = prod(_uniform(k, cycles, b) ** times for b, times in lengths.items())
    free: int = ((k // cycles) ** cycles * factorial(cycles)) ** quotient.beta1
    return uniform * free


def _uniform(k: int, cycles: int, b: int) -> int:
    """The number of permutations of k things, all cycles of length b, that commute with c^i.

    The power c^i has ``cycles`` cycles of length ``r = k / cycles``.  A commuting permutation
    permutes these cycles, and turns each on the way.  Where it takes t of them round, with
    turns that add up to an element of order o in Z_r, it has cycles of length t o = b: there
    are ``r^(t-1) phi(o)`` such turns.
    """
    r = k // cycles
    weight = {
        t: r ** (t - 1) * _totient(b // t)
        for t in range(1, min(b, cycles) + 1)
        if b % t == 0 and r % (b // t) == 0
    }
    ways = [1]
    for g in range(1, cycles + 1):
        # The cycle of the g-th thing has t things: the others of it come in (g-1)!/(g-t)! ways.
        ways.append(sum(perm(g - 1, t - 1) * w * ways[g - t] for t, w in weight.items() if t <= g))
    return ways[cycles]


def _totient(n: int) -> int:
    return sum(gcd(n, j) == 1 for j in range(1, n + 1))
