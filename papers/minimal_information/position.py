"""Section III: without a marker, with a marker that points nowhere, with directions alone."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from itertools import combinations
from pathlib import Path

from allworlds import CombinatorialMap, Move, Percept, World, ambiguity, check
from allworlds.claims import Found, Means, Picture, of_check, truth
from allworlds.maps import family, named_map, project, unrooted_code

CORPUS = Path(__file__).parents[2] / "corpus"

FIGURE_1 = ("fig1-left", "fig1-right")
CAPTION = (1, 1, 2, 2, 1)
SENSED_IN_CAPTION = ("3A", "3A", "3A", "3A", "4P")


def _cycles(lighthouse: Callable[[int], World], length: int) -> Iterator[tuple[World, World]]:
    return combinations([lighthouse(n) for n in range(1, length + 1)], 2)


def _plain(n: int) -> World:
    return World(family(f"cycle:{n}"), "none")


def _marked(n: int) -> World:
    return World(family(f"cycle:{n}"), "position")


def _north(n: int) -> World:
    """Every reference dart points on along the cycle, so that directions are global."""
    map_ = family(f"cycle:{n}")
    dart, darts = 0, []
    for _ in range(n):
        darts.append(dart)
        dart = map_.sigma[map_.alpha[dart]]
    return _with(map_, {"kind": "compass", "darts": sorted(darts)})


def _compared(lighthouse: Callable[[int], World], length: int, *, apart: bool) -> Found:
    pairs = as_said = 0
    for one, other in _cycles(lighthouse, length):
        pairs += 1
        as_said += ambiguity.twins(one, other).distinguishable == apart
    pictures = tuple(Picture(f"the cycle of {n}", lighthouse(n)) for n in (3, 4) if n <= length)
    return Found(truth(pairs == as_said), {"pairs": pairs}, {}, pictures)


def _walked_together(one: World, other: World) -> tuple[int, bool]:
    """Pairs of darts reached by equal motions, and whether both always sense the same.

    No partition and no certificate: motions are tried until two percepts differ, or until no
    new pair of darts comes.
    """
    met = {(one.start, other.start)}
    for x, y in (queue := [(one.start, other.start)]):
        if one.percepts[x] != other.percepts[y]:
            return len(met), False
        for k in range(one.percepts[x].degree):
            pair = (one.map.alpha[one.map.turn(x, k)], other.map.alpha[other.map.turn(y, k)])
            if pair not in met:
                met.add(pair)
                queue.append(pair)
    return len(met), True


def cycles(_: Means, *, length: int) -> Found:
    """Walk all motions at once in two cycles without a marker; as a control, with one marker."""
    plain = [_walked_together(*pair) for pair in _cycles(_plain, length)]
    control = [_walked_together(*pair) for pair in _cycles(_marked, length)]
    witnesses = {
        "pairs": len(plain),
        "pairs of darts": sum(met for met, _ in plain),
        "told apart with a marker": sum(not alike for _, alike in control),
    }
    pictures = tuple(Picture(f"the cycle of {n}", _plain(n)) for n in (3, 4) if n <= length)
    return Found(truth(all(alike for _, alike in plain)), witnesses, {}, pictures)


def two_door_rooms(_: Means, *, length: int) -> Found:
    """A cycle with all that looks alike taken together is one class of darts, of degree 2."""
    quotients = [
        project((w.map, w.percepts, 0)).quotient for w in map(_plain, range(1, length + 1))
    ]
    alike = all((q.sigma, q.alpha, q.degree) == ((0,), (0,), (2,)) for q in quotients)
    return Found(truth(alike), {"cycles": len(quotients)})


def orientation_alone(_: Means, *, length: int) -> Found:
    """Two cycles with global directions: no motion tells them apart."""
    return _compared(_north, length, apart=False)


def position_tells_cycles(_: Means, *, length: int) -> Found:
    """Two cycles with one marked vertex each: some motion tells them apart."""
    return _compared(_marked, length, apart=True)


def _figure_1() -> tuple[World, World]:
    one, other = (World(named_map(name), "position") for name in FIGURE_1)
    return one, other


def _figure_1_pictures() -> tuple[Picture, ...]:
    return tuple(
        Picture(f"{side} graph", world)
        for side, world in zip(("left", "right"), _figure_1(), strict=True)
    )


def fig1(_: Means) -> Found:
    """Walk all motions at once from each dart of v0; as a control with a direction there."""
    one, other = _figure_1()
    starts = [one.map.turn(0, k) for k in range(one.first.degree)]
    walked = [_walked_together(marked(one.map, "position", dart, dart), other) for dart in starts]
    pointed = World(other.map, "directional")
    control = [
        _walked_together(marked(one.map, "directional", 0, dart), pointed)
        for dart in one.map.vertices[one.map.vertex_of[0]]
    ]
    witnesses = {
        "starts": len(starts),
        "pairs of darts": sum(met for met, _ in walked),
        "told apart with a direction": sum(not alike for _, alike in control),
    }
    return Found(truth(all(alike for _, alike in walked)), witnesses, {}, _figure_1_pictures())


def fig1_different(_: Means) -> Found:
    """No dart of the right graph gives the code of the left one."""
    one, other = _figure_1()
    different = unrooted_code(one.map) != unrooted_code(other.map)
    sizes = [one.map.edge_count, one.map.vertex_count, one.map.genus, other.map.genus]
    rootings = len(one.map.sigma) + len(other.map.sigma)
    figures = {"edges vertices genus genus": sizes}
    return Found(truth(different), {"rootings": rootings}, figures, _figure_1_pictures())


def fig1_caption(_: Means) -> Found:
    """Compare the percepts of the caption's motions with the caption, on both graphs."""
    one, other = _figure_1()
    walks = [
        tuple(
            f"{p.degree}{'P' if p.marks else 'A'}"
            for p in _sensed(marked(world.map, "position", dart, dart), CAPTION)
        )
        for world in (one, other)
        for dart in (world.map.turn(0, k) for k in range(world.first.degree))
    ]
    return Found(
        truth(set(walks) == {SENSED_IN_CAPTION}),
        {"walks": len(walks)},
        {"percepts": list(walks[0])},
        _figure_1_pictures(),
    )


def position_not_enough(_: Means, *, pairs: list[str]) -> Found:
    """Pairs of different maps that no motion tells apart with the position marked."""
    compared = [ambiguity.twins(*pair_of_corpus(name)) for name in pairs]
    pictures = tuple(
        Picture(f"{name}, the {which}", world)
        for name, result in zip(pairs, compared, strict=True)
        for which, world in zip(("one", "other"), result.worlds, strict=True)
    )
    alike = [
        result.twins and unrooted_code(result.worlds[0].map) != unrooted_code(result.worlds[1].map)
        for result in compared
    ]
    return Found(truth(all(alike)), {"pairs": len(compared)}, {}, pictures)


def pair_of_corpus(name: str) -> tuple[World, World]:
    """The two worlds of that pair, their position marked."""
    file = CORPUS / "pairs" / f"{name.removeprefix('pair-')}.json"
    one, other = json.loads(file.read_text(encoding="utf-8"))["worlds"]
    return World.from_json(one), World.from_json(other)


def marked(map_: CombinatorialMap, kind: str, dart: int, start: int) -> World:
    """The world with a marker at a dart, and a start."""
    return _with(map_, {"kind": kind, "dart": dart}, start)


def _with(map_: CombinatorialMap, lighthouse: dict[str, object], start: int = 0) -> World:
    return World.from_json(
        {
            "sigma": [*map_.sigma],
            "alpha": [*map_.alpha],
            "start": start,
            "lighthouse": lighthouse,
        }
    )


def _sensed(world: World, motions: Sequence[int]) -> list[Percept]:
    """The percepts after each of these motions."""
    state, percepts = world.initial, []
    for k in motions:
        state, percept = world.step(state, Move(k))
        percepts.append(percept)
    return percepts


def movable_marker(means: Means, *, edges: int) -> Found:
    """Run the explorer of Dudek et al. in every simple world."""
    report = check("dudek91", edges=edges, map_class="simple", workers=means.workers)
    return of_check(report, "new-vertex", "back-link")


def elsewhere(means: Means, *, edges: int) -> Found:
    """Run Algorithm 1, after a search for v0, in every world and from every start."""
    asked = {"lighthouse": "directional:start=any", "edges": edges, "workers": means.workers}
    return of_check(check("elsewhere:algorithm1", **asked))


def movable_marker_multigraphs(means: Means, *, edges: int) -> Found:
    """Run that explorer where loops and parallel edges are allowed."""
    report = check("dudek91", edges=edges, workers=means.workers)
    figures = {}
    for finding in report.findings[:1]:
        failed = finding.world.map
        figures = {"edges": failed.edge_count, "vertices": failed.vertex_count}
    return of_check(report, **figures)
