"""Can any motion tell two worlds apart?  A bisimulation says no, a walk says yes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY
from typing import Annotated, Any, Literal, TypeAlias

from msgspec import UNSET, UnsetType

from allworlds.document.report import Report
from allworlds.document.struct import Natural, Pair, Some, about, computed, narrowed
from allworlds.inputs.checks import InputError
from allworlds.inputs.requests import Argument, Request, answers
from allworlds.maps.quotient import classes_of_union
from allworlds.outcome import Disagreement
from allworlds.protocol.actions import Percept
from allworlds.world.bisimulation import flaw, same_world_from, sensed
from allworlds.world.lighthouses.kinds import LIGHTHOUSES, GivenLighthouse, kind_of
from allworlds.world.lighthouses.marked import Position
from allworlds.world.named import LIGHTHOUSE, WORLD, world_named
from allworlds.world.world import World


class TwinsRequest(Request, kw_only=False):
    """Request of ``ambiguity twins``: the two worlds."""

    a: Annotated[World | str, Argument("", "A", WORLD.help)]
    b: Annotated[World | str, Argument("", "B", "Another one.")]
    _: KW_ONLY
    lighthouse: Annotated[GivenLighthouse, LIGHTHOUSE] = Position.kind


Relation: TypeAlias = Literal["same", "same-map", "different"]
"""``different``: two maps, or two places of the lighthouse."""


class ComparedWorlds(Report):
    """Report of 'twins'.

    Two worlds, how they are related, and the proof that they can be told apart, or cannot.
    """

    worlds: Annotated[Pair[World], about("the two, as they were understood")]
    relation: Annotated[
        Relation,
        about("`same`: one world; `same-map`: one world entered at two darts; `different`"),
    ]
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

    @computed
    def distinguishable(self) -> bool:
        """Whether any motion tells them apart."""
        return self.bisimulation is UNSET

    @computed
    def twins(self) -> bool:
        """Different, and not distinguishable."""
        return self.relation == "different" and not self.distinguishable


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
        motions = separation(a, b)
        proof = {"motions": motions, "percepts": (sensed(a, motions), sensed(b, motions))}
        wrong = replayed(a, b, motions)
    if wrong:
        raise Disagreement(f"the proof about {a} and {b} is wrong: {wrong}")
    start = None if a.told != b.told else same_world_from(a, b)
    relation: Relation = "different" if start is None else "same-map"
    return ComparedWorlds(worlds=(a, b), relation="same" if start == b.start else relation, **proof)


def separation(a: World, b: World) -> tuple[int, ...]:
    """The first motions, by length and then in ascending order, that tell the worlds apart.

    There must be some.  Breadth-first over pairs of darts, motions ``0..degree-1``.
    """
    seen = {(a.start, b.start)}
    # Two darts, and the motion that led there from the darts of an earlier entry.
    queue = [(a.start, b.start, 0, 0)]
    for number, (x, y, _, _) in enumerate(queue):
        if a.percepts[x] != b.percepts[y]:
            motions, at = list[int](), number
            while at:
                _, _, at, k = queue[at]
                motions.insert(0, k)
            return tuple(motions)
        for k in range(a.percepts[x].degree):
            reached = (a.map.alpha[a.map.turn(x, k)], b.map.alpha[b.map.turn(y, k)])
            if reached not in seen:
                seen.add(reached)
                queue.append((*reached, number, k))
    raise Disagreement(f"no motion tells {a} from {b}, but their quotients differ")


def replayed(a: World, b: World, motions: Sequence[int]) -> str | None:
    """Why the percepts do not differ after the last motion for the first time; None if they do."""
    one, other = sensed(a, motions), sensed(b, motions)
    if one[-1] == other[-1]:
        return "the last percepts are equal"
    return None if one[:-1] == other[:-1] else "a part of the motions is enough"


def standing() -> str:
    """The kinds of lighthouses that stand where they are, in words."""
    return ", ".join(name for name, kind in LIGHTHOUSES.items() if not kind.leaves_marks)
