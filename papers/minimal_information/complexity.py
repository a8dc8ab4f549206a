"""Section VI: the cost of a run, pass by pass and in all, and the sums that bound it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from importlib.util import find_spec
from itertools import product
from math import log
from typing import Any, NamedTuple

from algorithm import worst_rows
from allworlds import World, check, compare
from allworlds.claims import EverySchedule, Found, Means, NotChecked, Picture, of_check, truth
from allworlds.maps import family as map_of, rooted_maps
from formulas import paper_bound, printed_bound
from passes import PassWalked, every_run, pass_bound


def every_edge_walked(_: Means, *, edges: int) -> Found:
    """Check that the cheapest of all schedules walks at least m edges in each world; exact."""
    cheapest = []
    for m in range(1, edges + 1):
        best = [EverySchedule(map_, 0).best - m for map_ in rooted_maps(m)]
        cheapest += best
    attained = sum(spare == 0 for spare in cheapest)
    witnesses = {"worlds": len(cheapest), "walked with m": attained}
    return Found(truth(min(cheapest) >= 0), witnesses)


def dfs_2m(means: Means, *, edges: int) -> Found:
    """Depth first where every vertex has a number; by the number of edges the largest cost."""
    report = check("dfs", edges=edges, bound="2*m", workers=means.workers)
    largest = _largest((row.edges, row.max_cost) for row in report.rows)
    return of_check(report, **{"largest cost": list(largest.values())})


def lower_bound_2m(_: Means, *, length: int) -> Found:
    """On cycles: the cheapest schedule of Algorithm 1, over all schedules."""
    best = [EverySchedule(map_of(f"cycle:{m}"), 0).best for m in range(2, length + 1)]
    below = sum(cost < 2 * m for m, cost in enumerate(best, 2))
    pictures = (Picture("walked round once", World(map_of("cycle:4"), "directional")),)
    return Found(
        truth(not below), {"cycles": len(best)}, {"traversals for 2, 3, ... edges": best}, pictures
    )


class _Part(NamedTuple):
    """A part of a pass.

    Attributes:
        spent: what it took, each time.
        allowed: by the paper, each time.
        possible: the most that can be taken, where that is less.
    """

    spent: Sequence[int]
    allowed: int
    possible: int


def _in_every_pass(
    edges: int, policies: list[str], part_of: Callable[[int, PassWalked], _Part]
) -> Found:
    """Collect a part of each pass, from the world's edges and the pass, beside its bound."""
    passes = tests = wrong = attained = 0
    for world, met in every_run(edges, policies):
        for one in met:
            part = part_of(world.map.edge_count, one)
            passes += 1
            tests += len(one.tests)
            wrong += any(cost > part.allowed for cost in part.spent)
            attained += part.possible in part.spent
    witnesses = {"passes": passes, "tests": tests, "passes with as much as can be": attained}
    return Found(truth(wrong == 0), witnesses)


def pass_walk(_: Means, *, edges: int, policies: list[str]) -> Found:
    """Check that the walk to the unknown end takes at most n_s traversals."""

    def walk(_m: int, one: PassWalked) -> _Part:
        return _Part([one.walk], one.vertices, one.vertices)

    return _in_every_pass(edges, policies, walk)


def pass_tests(_: Means, *, edges: int, policies: list[str]) -> Found:
    """Check that a test, there and back, takes at most 2(n_s - 1)."""

    def tests(_m: int, one: PassWalked) -> _Part:
        allowed = 2 * (one.vertices - 1)
        return _Part(one.tests, allowed, allowed)

    return _in_every_pass(edges, policies, tests)


def pass_hypotheses(_: Means, *, edges: int, policies: list[str]) -> Found:
    """Check that a pass has at most 2m - 2(n_s - 1) hypotheses."""

    def hypotheses(m: int, one: PassWalked) -> _Part:
        allowed = 2 * m - 2 * (one.vertices - 1)
        # The dart that is explored is no hypothesis.
        return _Part([one.hypotheses], allowed, allowed - 1)

    return _in_every_pass(edges, policies, hypotheses)


def pass_cost(_: Means, *, edges: int, policies: list[str]) -> Found:
    """Check that each pass by itself costs at most s + 2(s-1)(2m-2p)."""

    def cost(m: int, one: PassWalked) -> _Part:
        allowed = pass_bound(m, one.vertices, one.explored)
        return _Part([one.cost], allowed, allowed)

    return _in_every_pass(edges, policies, cost)


def pass_cost_all_schedules(_: Means, *, edges: int) -> Found:
    """The most expensive pass from every state that any schedule can come to."""
    states = wrong = 0
    for m in range(1, edges + 1):
        for map_ in rooted_maps(m):
            for state in EverySchedule(map_, 0).most_expensive_passes():
                states += 1
                wrong += state.cost > pass_bound(m, state.vertices, state.explored)
    return Found(truth(wrong == 0), {"states with a dart": states})


def pass_kinds(_: Means, *, edges: int, policies: list[str]) -> Found:
    """Check that in every run n-1 passes find a vertex and m-n+1 close a loop."""
    runs = wrong = vertices = loops = 0
    for world, met in every_run(edges, policies):
        m, n = world.map.edge_count, world.map.vertex_count
        found = sum(one.found for one in met)
        runs += 1
        vertices += found
        loops += len(met) - found
        wrong += found != n - 1 or len(met) - found != m - n + 1
    seen = {"runs": runs, "that find a vertex": vertices, "that close a loop": loops}
    return Found(truth(wrong == 0), seen)


def vertices_first(_: Means, *, edges: int) -> Found:
    """Check every order of both kinds of passes, each at its bound: none exceeds (1)+(2)."""
    orders = over = attained = 0
    for m in range(1, edges + 1):
        for kinds in product((0, 1), repeat=m):
            n = sum(kinds) + 1
            s, total = 1, 0
            for explored, grows in enumerate(kinds):
                total += pass_bound(m, s, explored)
                s += grows
            orders += 1
            over += total > paper_bound(n, m)
            first = all(kinds[: n - 1])
            attained += total == paper_bound(n, m) and first
    witnesses = {"orders": orders, "vertices first, equal to the bound": attained}
    return Found(truth(over == 0), witnesses)


def bound(means: Means, *, edges: int) -> Found:
    """The exact worst cost over all worlds and all schedules, beside (1)+(2)."""
    rows = worst_rows(means, edges).rows
    slack = [paper_bound(row.vertices, row.edges) - row.worst for row in rows]
    seen = {
        "worlds": sum(row.worlds for row in rows),
        "sizes": len(rows),
        "sizes that attain it": slack.count(0),
    }
    return Found(truth(min(slack) >= 0), seen)


def polynomial(n: int, m: int) -> Fraction:
    """Compare (1)+(2) with ``2m^2 n - 2mn^2 + (2/3)n^3 - 2m^2 + 5mn - (5/2)n^2 - 2m + (11/6)n``."""
    return printed_bound(n, m) + 5 * m * n - 2 * m + Fraction(11, 6) * n


def bound_polynomial(_: Means, *, edges: int) -> Found:
    """Compare both at enough points to determine the polynomial, and at more."""
    points = [(n, m) for m in range(1, edges + 1) for n in range(1, m + 2)]
    agree = sum(paper_bound(n, m) == polynomial(n, m) for n, m in points)
    return Found(truth(agree == len(points)), {"pairs of n and m": len(points)})


def printed_3(_: Means, *, edges: int) -> Found:
    """Compare expression (3), without its unstated terms, with the cost of Algorithm 1."""
    points = [(m, n) for m in range(1, edges + 1) for n in range(1, m + 2)]
    below = [(m, n) for m, n in points if printed_bound(n, m) < paper_bound(n, m)]
    beaten = [(m, n) for m, n in points if printed_bound(n, m) < m]
    first = list(beaten[0]) if beaten else []
    seen = {"pairs of n and m": len(points), "below (1)+(2)": len(below), "below m": len(beaten)}
    figures: dict[str, Any] = {
        "first edges and vertices": first,
        "its value at n = 2, m = 1": str(printed_bound(2, 1)),
    }
    return Found(truth(not beaten), seen, figures)


def terms_left_out(_: Means, *, edges: int) -> Found | NotChecked:
    """Sum (1) and (2) by sympy, and subtract the printed terms of (3)."""
    if find_spec("sympy") is None:
        return NotChecked("sympy is not installed: in a clone, pip install '.[proofs]'")
    import sympy

    n, m, s, i = sympy.symbols("n m s i", integer=True, positive=True)
    one = sympy.summation(s + 2 * (s - 1) * (2 * m - 2 * (s - 1)), (s, 1, n - 1))
    two = sympy.summation(n + 2 * (n - 1) * (2 * m - 2 * (n - 1) - 2 * (i - 1)), (i, 1, m - n + 1))
    three = (
        2 * m**2 * n
        - 2 * m * n**2
        + sympy.Rational(2, 3) * n**3
        - 2 * m**2
        - sympy.Rational(5, 2) * n**2
    )
    left = sympy.Poly(sympy.expand(one + two - three), m, n)
    told = {
        f"m^{a} n^{b}": str(coefficient)
        for (a, b), coefficient in sorted(left.terms(), reverse=True)
    }
    points = [(x, y) for y in range(1, edges + 1) for x in range(1, y + 2)]
    agree = all(
        left.eval({n: x, m: y})
        == polynomial(x, y) - printed_bound(x, y)
        == paper_bound(x, y) - printed_bound(x, y)
        for x, y in points
    )
    # A term that is left out is of lower order if each kept one outgrows it; mn does not.
    kept = min(sum(powers) for powers in sympy.Poly(three, m, n).monoms())
    agree = agree and left.total_degree() >= kept
    return Found(truth(agree), {"terms": len(told), "pairs of n and m": len(points)}, told)


def printed_limit_of_2(means: Means, *, edges: int) -> Found:
    """Compare (1), and (2) with its printed upper limit, with the exact worst cost."""
    rows = worst_rows(means, edges).rows
    beaten = []
    for row in rows:
        n, m = row.vertices, row.edges
        growing = sum(s + 2 * (s - 1) * (2 * m - 2 * (s - 1)) for s in range(1, n))
        once = n + 2 * (n - 1) * (2 * m - 2 * (n - 1))
        if row.worst > growing + once:
            beaten.append(row)
    figures = {} if not beaten else {"edges": beaten[0].edges, "vertices": beaten[0].vertices}
    pictures = tuple(Picture("costs more than is printed", row.world) for row in beaten[:1])
    return Found(
        truth(not beaten), {"sizes": len(rows), "sizes beaten": len(beaten)}, figures, pictures
    )


def bound_order(_: Means, *, edges: int) -> Found:
    """Compare (1)+(2) with 2 m^2 n."""
    points = [(n, m) for m in range(1, edges + 1) for n in range(1, m + 2)]
    over = [(n, m) for n, m in points if paper_bound(n, m) > 2 * m * m * n]
    return Found(truth(not over), {"pairs of n and m": len(points)})


def order_reached(means: Means, *, family: str, to: int, growing: float) -> Found:
    """The cost in a family in which n grows like m: between the last two sizes like m^3 or more."""
    report = compare("algorithm1", family=family, to=to, draws=2, places=1, workers=means.workers)
    rows = report.uninterrupted().rows
    shares = [row.mean / (row.edges**2 * row.vertices) for row in rows]
    shorter, longer = rows[-2:]
    last = log(longer.mean / shorter.mean) / log(longer.edges / shorter.edges)
    judged = report.verdict == "not-refuted"
    return Found(
        truth(judged and last >= growing),
        {"runs": sum(row.runs for row in rows)},
        {
            "edges": [row.edges for row in rows],
            "vertices": [row.vertices for row in rows],
            "mean cost": [round(row.mean, 2) for row in rows],
            "cost / m^2 n": [round(share, 4) for share in shares],
            "exponent of m": round(last, 2),
        },
    )


def _largest(costs: Iterable[tuple[int, int]]) -> dict[int, int]:
    """The largest cost, by number of edges."""
    largest: dict[int, int] = {}
    for edges, cost in costs:
        largest[edges] = max(largest.get(edges, 0), cost)
    return largest
