"""A model is believed only where its worlds are what was asked for, whatever the formula says."""

import sys

import pytest

from allworlds.maps import named_map
from allworlds.studies.ambiguity.formulas import pair_formula
from allworlds.studies.ambiguity.question import Size, Sizes
from allworlds.studies.ambiguity.twin_search import decoded
from allworlds.world import Compass, Directional, Nothing, Position, World
from searches import question

PLANE, TORUS = named_map("two-loops-plane"), named_map("two-loops-torus")
LOOPS = (World(PLANE, Position(0)), World(TORUS, Position(0)))


def model_of(pair, *worlds):
    """The true variables of sigma, alpha and the pointed darts of a pair of worlds."""
    true = set()
    for world, variables in zip(worlds, (pair.one, pair.two), strict=True):
        for block, images in (
            (variables.sigma, world.map.sigma),
            (variables.alpha, world.map.alpha),
        ):
            true |= {block[dart, image] for dart, image in enumerate(images)}
    for world, block in zip(worlds, pair.pointed or (), strict=False):
        true |= {block[dart] for dart in world.lighthouse.references(world.map)}
    return frozenset(true)


def asked_for(kind, edges=2, map_class="maps", **more):
    size = Size(edges, 1, edges + 1)
    return pair_formula(question(kind, map_class, edges + 1, edges, **more), Sizes(size, size))[1]


def test_a_model_is_decoded_to_worlds_with_their_bisimulation():
    pair = asked_for("position")
    twins = decoded(pair, model_of(pair, *LOOPS))
    assert twins.pair == LOOPS
    assert twins.bisimulation == ((0, 0, 0, 0), (0, 0, 0, 0))


@pytest.mark.parametrize("kind", [Nothing, Directional, Compass])
def test_a_model_keeps_its_pointed_darts(kind):
    pair = asked_for(kind.kind)
    place = next(kind.places(PLANE, 0))
    twice = World(PLANE, place), World(PLANE, place)
    with pytest.raises(RuntimeError, match="does not answer") as refusal:
        decoded(pair, model_of(pair, *twice))
    assert f"the solver's pair {twice[0]}, {twice[1]} does" in str(refusal.value)


@pytest.mark.parametrize(
    ("asked", "worlds"),
    [
        ({}, (LOOPS[0], LOOPS[0])),
        ({}, (LOOPS[0], World(named_map("path-3"), Position(0)))),
        ({"map_class": "planar"}, LOOPS),
        ({"degree_marked": 3}, LOOPS),
        ({"motions": (0,), "percepts": ("3A",)}, LOOPS),
        ({"motions": (0,), "percepts": ("4A",)}, LOOPS),
    ],
)
def test_a_pair_that_is_no_answer_is_an_internal_error(asked, worlds):
    pair = asked_for("position", **asked)
    with pytest.raises(RuntimeError, match="does not answer"):
        decoded(pair, model_of(pair, *worlds))


@pytest.mark.parametrize("kind", ["directional", "compass"])
def test_a_model_without_its_pointed_darts_is_an_internal_error(kind):
    pair = asked_for(kind)
    with pytest.raises(RuntimeError, match="no pair of worlds"):
        decoded(pair, model_of(pair, *(World(map_, Nothing()) for map_ in (PLANE, TORUS))))


def test_a_wrong_bisimulation_is_an_internal_error(monkeypatch):
    pair = asked_for("position")
    wrong = ((0, 0, 0, 0), (0, 0, 0, 1))
    monkeypatch.setattr(
        sys.modules["allworlds.studies.ambiguity.twin_search"], "bisimulation", lambda *_: wrong
    )
    with pytest.raises(RuntimeError, match="does not answer"):
        decoded(pair, model_of(pair, *LOOPS))
