"""Sections IV and VIII: lighthouses made of undirected markers, and of degrees."""

from __future__ import annotations

from collections import defaultdict

from allworlds import World, ambiguity, check, worlds
from allworlds.claims import Found, Means, Picture, Unfinished, of_check, truth
from allworlds.maps import project
from formulas import two_vertices_bound


def cluster(means: Means, *, edges: int) -> Found:
    """Algorithm 1 with one marker at v0 and two at v1, where one edge joins them."""
    report = check(
        "algorithm1-cluster",
        edges=edges,
        lighthouse="cluster:single=true",
        workers=means.workers,
    )
    return of_check(report, "case-1", "case-2", "case-3", "loop", "non-loop")


def cluster_multigraphs(_: Means, *, edges: int) -> Found:
    """Find two different worlds with a cluster that no motion tells apart."""
    return _twins_under("cluster", "maps", edges)


def natural(means: Means, *, edges: int) -> Found:
    """Algorithm 1 with a unique degree beside a unique degree, that of v1 told; in both engines."""
    compiled, readable = (
        of_check(
            check(
                "algorithm1-natural",
                edges=edges,
                map_class="simple",
                engine=engine,
                workers=means.workers,
            ),
            "case-3",
            "loop",
            "non-loop",
        )
        for engine in ("auto", "python")
    )
    if compiled.verdict == "holds" and readable.witnesses != compiled.witnesses:
        raise Unfinished("the engines differ on algorithm1-natural")
    seen = {**compiled.witnesses, "runs in Python": readable.witnesses["runs"]}
    return Found(readable.verdict if compiled.verdict == "holds" else "refuted", seen)


def natural_multigraphs(_: Means, *, edges: int) -> Found:
    """Find two different worlds with such degrees that no motion tells apart."""
    return _twins_under("natural", "maps", edges)


def _twins_under(kind: str, map_class: str, edges: int) -> Found:
    """The first two different worlds, by size, with one rooted quotient; their proof checked."""
    alike: dict[object, list[World]] = defaultdict(list)
    compared = 0
    for world in worlds(edges=edges, map_class=map_class, lighthouse=kind, places="all"):
        compared += 1
        quotient = project((world.map, world.percepts, 0)).quotient
        learnt = (quotient.sigma, quotient.alpha, quotient.labels, world.told)
        for one in alike[learnt]:
            if ambiguity.twins(one, world).twins:
                figures = {"edges": one.map.edge_count, "vertices": one.map.vertex_count}
                pictures = (Picture("one world", one), Picture("its twin", world))
                return Found("refuted", {"worlds": compared}, figures, pictures)
        alike[learnt].append(world)
    return Found("holds", {"worlds": compared})


def two_vertices_order(_: Means, *, edges: int) -> Found:
    """Compare these explorers' bound, with two traversals more a test, with 4 m^2 n."""
    points = [(n, m, d) for m in range(1, edges + 1) for n in range(2, m + 2) for d in (1, 2 * m)]
    over = [p for p in points if two_vertices_bound(*p) > 4 * p[1] ** 2 * p[0]]
    return Found(truth(not over), {"triples of n, m and deg(v0)": len(points)})
