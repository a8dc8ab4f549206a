"""Can any motion tell two worlds apart?  A bisimulation says no, a walk says yes."""

from __future__ import annotations

from typing import Annotated, Any, Literal, NamedTuple, TypeAlias

from msgspec import UNSET, UnsetType

from allworlds.document.report import Report
from allworlds.document.struct import Natural, Pair, Some, about, computed, narrowed
from allworlds.inputs.checks import InputError
from allworlds.inputs.requests import answers
from allworlds.maps.canonical import carries, numbering
from allworlds.maps.combinatorial import Dart
from allworlds.maps.quotient import classes_of_union
from allworlds.outcome import Disagreement
from allworlds.protocol.actions import Move, Percept
from allworlds.studies.ambiguity.ambiguity_requests import TwinsRequest
from allworlds.world.bisimulation import flaw
from allworlds.world.lighthouses.kinds import LIGHTHOUSES, kind_of
from allworlds.world.named import world_named
from allworlds.world.world import World

Relation: TypeAlias = Literal["same", "same-map", "different"]
"""``different``: two maps, or two places of the lighthouse."""


class Separation(NamedTuple):
    """Motions after which two worlds show different percepts, for the first time.

    Attributes:
        motions: the shortest, and of these the lexicographically first.
        percepts: for each world what is sensed at the start and after each motion; equal but
            for the last.
    """

    motions: tuple[int, ...]
    percepts: tuple[tuple[Percept, ...], tuple[Percept, ...]]


class ComparedWorlds(Report):
    """Report of 'twins'.

    Two worlds, how they are related, and the proof that they can be told apart, or cannot.
    """

    worlds: Annotated[Pair[World], about("the two, as they were understood")]
    relation: Annotated[
        Relation,
        about("`same`: one world; `same-map`: one world entered at two darts; `different`"),
    ]
    distinguishable: Annotated[bool, about("whether any motion tells them apart")] = computed(
        lambda compared: compared.bisimulation is UNSET
    )
    twins: Annotated[bool, about("different, and not distinguishable")] = computed(
        lambda compared: compared.relation == "different" and not compared.distinguishable
    )
    motions: Annotated[
        tuple[Natural, ...] | UnsetType,
        about("if distinguishable: the shortest motions that tell them apart"),
    ] = UNSET
    percepts: Annotated[
        Pair[Some[Percept]] | UnsetType,
        about("with the motions: for each world the percepts at the start and after each of them"),
    ] = UNSET
    told: Annotated[
        Pair[int | dict[str, int] | None] | UnsetType,
        about("if that is different: what is told in each world before the start"),
    ] = UNSET
    bisimulation: Annotated[
        Pair[Annotated[tuple[Natural, ...], narrowed(minItems=2)]] | UnsetType,
        about("if not: for each world the class of each dart"),
    ] = UNSET


@answers(TwinsRequest)
def twins(request: TwinsRequest) -> ComparedWorlds:
    """Decide whether any motion can tell the worlds apart, with a proof that has been checked.

    Raises:
        InputError: if the lighthouses are of different kinds: what is sensed is then no
            matter of the worlds.

    Cost: O(m log m) where no motion can; else as many steps as pairs of darts are met.
    """
    a, b = (world_named(world, request.lighthouse) for world in (request.a, request.b))
    kinds = [world.lighthouse.kind for world in (a, b)]
    if kinds[0] != kinds[1]:
        raise InputError(
            f"the worlds have the lighthouses {kinds[0]} and {kinds[1]}; two worlds are compared "
            "under one lighthouse"
        )
    if kind_of(a.lighthouse).as_class.leaves_marks:
        raise InputError(
            f"under the lighthouse {kinds[0]} the robot leaves marks itself, and twins are "
            f"compared by motions alone; legal are {standing()}"
        )
    first, second = classes_of_union(*((w.map, w.percepts, w.start) for w in (a, b)))
    proof: dict[str, Any]
    if a.told != b.told:
        proof = {"motions": (), "percepts": ((a.first,), (b.first,)), "told": (a.told, b.told)}
        wrong = None
    elif first[a.start] == second[b.start]:
        proof = {"bisimulation": (first, second)}
        wrong = flaw((a, b), (first, second))
    else:
        told = separation(a, b)
        proof = told._asdict()
        wrong = replayed(a, b, told)
    if wrong:
        raise Disagreement(f"the proof about {a} and {b} is wrong: {wrong}")
    return ComparedWorlds(worlds=(a, b), relation=_relation(a, b), **proof)


def separation(a: World, b: World) -> Separation:
    """The first motions, by length and then in ascending order, that tell the worlds apart.

    There must be some.  Breadth-first over pairs of darts, motions ``0..degree-1``.
    """
    came: dict[tuple[Dart, Dart], tuple[tuple[Dart, Dart], int] | None] = {(a.start, b.start): None}
    queue = [(a.start, b.start)]
    for pair in queue:
        x, y = pair
        if a.percepts[x] != b.percepts[y]:
            return _told(a, b, _way(came, pair))
        for k in range(a.percepts[x].degree):
            reached = (_along(a, x, k), _along(b, y, k))
            if reached not in came:
                came[reached] = (pair, k)
                queue.append(reached)
    raise Disagreement(f"no motion tells {a} from {b}, but their quotients differ")


def _along(world: World, dart: Dart, k: int) -> Dart:
    return world.map.alpha[world.map.turn(dart, k)]


def _way(
    came: dict[tuple[Dart, Dart], tuple[tuple[Dart, Dart], int] | None], pair: tuple[Dart, Dart]
) -> list[int]:
    """The motions that lead to a pair."""
    motions = []
    while (step := came[pair]) is not None:
        pair, k = step
        motions.append(k)
    return motions[::-1]


def _told(a: World, b: World, motions: list[int]) -> Separation:
    return Separation(tuple(motions), (sensed(a, motions), sensed(b, motions)))


def sensed(world: World, motions: list[int] | tuple[int, ...]) -> tuple[Percept, ...]:
    """The percepts at the start and after each of the motions."""
    state, percepts = world.initial, [world.first]
    for k in motions:
        state, percept = world.step(state, Move(k))
        percepts.append(percept)
    return tuple(percepts)


def replayed(a: World, b: World, told: Separation) -> str | None:
    """Why walking the motions again does not tell the worlds apart; None if it does."""
    seen = (sensed(a, told.motions), sensed(b, told.motions))
    if seen != told.percepts:
        return "the walk shows other percepts"
    if seen[0][-1] == seen[1][-1]:
        return "the last percepts are equal"
    if seen[0][:-1] != seen[1][:-1]:
        return "a part of the motions is enough"
    return None


def _relation(a: World, b: World) -> Relation:
    if len(a.map.sigma) != len(b.map.sigma) or a.told != b.told:
        return "different"
    order = numbering(a.map.sigma, a.map.alpha, a.start)
    if _carries_all(a, b, order, b.start):
        return "same"
    alike = any(_carries_all(a, b, order, image) for image in b.map.darts)
    return "same-map" if alike else "different"


def _carries_all(a: World, b: World, order: list[Dart], image: Dart) -> bool:
    """Whether ``a.start -> image`` extends to an isomorphism of the maps and their percepts."""
    if a.first != b.percepts[image]:
        return False
    if not carries(a.map.sigma, a.map.alpha, order, b.map.sigma, b.map.alpha, image):
        return False
    images = numbering(b.map.sigma, b.map.alpha, image)
    return all(a.percepts[d] == b.percepts[e] for d, e in zip(order, images, strict=True))


def standing() -> str:
    """The kinds of lighthouses that stand where they are, in words."""
    return ", ".join(name for name, kind in LIGHTHOUSES.items() if not kind.leaves_marks)
