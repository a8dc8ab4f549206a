"""Decoding a solver's model into two worlds, with every check that does not need the formula."""

from __future__ import annotations

from allworlds.inputs import InputError
from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import Move, Percept
from allworlds.studies.ambiguity.smt.formula import Block
from allworlds.studies.ambiguity.smt.one_world import OneWorld
from allworlds.studies.ambiguity.smt.pair import Pair
from allworlds.studies.ambiguity.smt.question import SEARCHED, Question
from allworlds.studies.ambiguity.smt.result import Twins
from allworlds.studies.ambiguity.smt.witness import bisimulation, code
from allworlds.world import Where, World, flaw


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
