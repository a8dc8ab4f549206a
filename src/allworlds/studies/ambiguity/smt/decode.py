"""A model of a formula, decoded into two worlds with every check that needs no formula."""

from __future__ import annotations

from allworlds.inputs.checks import InputError
from allworlds.maps.canonical import numbering, rooted_code
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Move, Percept
from allworlds.studies.ambiguity.smt.formula import Block
from allworlds.studies.ambiguity.smt.one_world import OneWorld
from allworlds.studies.ambiguity.smt.pair import Pair
from allworlds.studies.ambiguity.smt.question import SEARCHED, Question
from allworlds.studies.ambiguity.smt.result import Twins
from allworlds.world.bisimulation import flaw
from allworlds.world.lighthouses.base import Where
from allworlds.world.world import World


def bisimulation(a: World, b: World) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    """Class numbers of the darts of ``a`` and of ``b``; None if a motion tells them apart.

    The finest classes of which the starts share one, sigma and alpha take classes to classes,
    and the darts of a class sense the same.  They are numbered in the order of the darts of
    ``a``.

    Cost: O(m^2) at worst.
    """
    pairs = {(a.start, b.start)}
    for x, y in (todo := list(pairs)):
        if a.percepts[x] != b.percepts[y]:
            return None
        for pair in ((a.map.sigma[x], b.map.sigma[y]), (a.map.alpha[x], b.map.alpha[y])):
            if pair not in pairs:
                pairs.add(pair)
                todo.append(pair)
    # Every dart of b is met, for its map is connected; the least dart of a names the class.
    label = list(a.map.darts), [len(a.map.sigma)] * len(b.map.sigma)
    changed = True
    while changed:
        changed = False
        for x, y in sorted(pairs):
            least = min(label[0][x], label[1][y])
            if (label[0][x], label[1][y]) != (least, least):
                label[0][x] = label[1][y] = least
                changed = True
    names = {least: i for i, least in enumerate(sorted(set(label[0])))}
    return tuple(names[x] for x in label[0]), tuple(names[y] for y in label[1])


def code(world: World, start: Dart) -> tuple[object, ...]:
    """The canonical code from a dart, equal exactly for the same world entered at the same dart."""
    sigma, alpha = world.map.sigma, world.map.alpha
    sensed = (world.percepts[dart] for dart in numbering(sigma, alpha, start))
    return (*rooted_code(sigma, alpha, start), *sensed)


def same_world_from(a: World, b: World) -> Dart | None:
    """The start at which ``b`` would be the same world as ``a``; None if the two differ.

    Where v0 is marked it is a dart of v0, as every start is.
    """
    if len(a.map.sigma) != len(b.map.sigma):
        return None
    mine = code(a, a.start)
    return next((dart for dart in b.map.darts if code(b, dart) == mine), None)


def decoded(pair: Pair, model: frozenset[int]) -> Twins:
    """The two worlds of a model, the set of its true variables.

    Raises:
        RuntimeError: if they are not what was asked for; then encoder or solver is wrong.
    """
    asked = pair.question
    pointed = pair.pointed or (None, None)
    try:
        one, two = (
            _world(asked, world, block, model)
            for world, block in zip((pair.one, pair.two), pointed, strict=True)
        )
    except InputError as error:
        raise RuntimeError(f"the solver's model is no pair of worlds: {error}") from None
    classes = bisimulation(one, two)
    if (
        classes is None
        or flaw((one, two), classes)
        or code(one, one.start) == code(two, two.start)
        or not all(_fits(world, asked) for world in (one, two))
    ):
        raise RuntimeError(f"the solver's pair {one}, {two} does not answer: {asked}")
    return Twins(pair=(one, two), bisimulation=classes)


def _world(asked: Question, world: OneWorld, pointed: Block | None, model: frozenset[int]) -> World:
    sigma, alpha = (
        [_only([y for y, variable in enumerate(row) if variable in model]) for row in block.rows()]
        for block in (world.sigma, world.alpha)
    )
    references: list[Dart] = []
    if pointed is not None:
        references = [x for x, variable in enumerate(pointed.variables) if variable in model]
        if asked.sensing.where is Where.AT_V0:
            _only(references)
    return World(CombinatorialMap(sigma, alpha), SEARCHED[asked.lighthouse](references), 0)


def _only(darts: list[Dart]) -> Dart:
    if len(darts) != 1:
        raise InputError(f"the darts {darts}, where there is exactly one")
    return darts[0]


def _fits(world: World, asked: Question) -> bool:
    """Whether the world has the class, sizes and degrees of the question, and senses the walk."""
    map_, home = world.map, world.map.vertex_of[world.start]
    root, others = asked.degrees.root, asked.degrees.others
    return (
        asked.map_class.includes(map_)
        and map_.vertex_count <= asked.vertices
        and map_.edge_count <= asked.edges
        and (root is None or map_.degrees[home] == root)
        and (others is None or all(d == others for v, d in enumerate(map_.degrees) if v != home))
        and [(percept.degree, percept.marks > 0) for percept in sensed(world, asked.walk.motions)]
        == [*asked.walk.percepts]
    )


def sensed(world: World, motions: tuple[int, ...]) -> list[Percept]:
    """The percepts after each motion of a walk from the start."""
    state, percepts = world.initial, []
    for motion in motions:
        state, percept = world.step(state, Move(motion))
        percepts.append(percept)
    return percepts
