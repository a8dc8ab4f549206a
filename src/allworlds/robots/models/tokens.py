"""Robots that drop tokens and pick them up, and must meet."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, product
from typing import Annotated, Any, NamedTuple

from msgspec import Meta
from typing_extensions import override

from allworlds.maps.combinatorial import CombinatorialMap, Dart, Vertex
from allworlds.protocol.actions import Drop, IllegalAction, Move, Pick
from allworlds.robots.model import Places
from allworlds.robots.models.goals import Apart, are_together, others_with, replaced


class TokensState(NamedTuple):
    """A state of a world with tokens.

    Attributes:
        darts: the dart of each robot.
        hands: the number of tokens in each robot's hand.
        lying: the number of tokens at each vertex.
    """

    darts: tuple[Dart, ...]
    hands: tuple[int, ...]
    lying: tuple[int, ...]


@dataclass(frozen=True)
class Tokens(Apart):
    """Anonymous robots with indistinguishable tokens, which must meet at one vertex.

    A percept is ``[degree, tokens, others, hand]``: the degree, the number of tokens that lie here,
    the number of other robots here, and the number of tokens in the robot's hand.  Actions are
    ``Move``, ``Drop`` and ``Pick``.  ``Pick`` takes nothing if no token lies here.  If more robots
    pick at once than tokens lie here, the adversary chooses the robots that get a token.

    Attributes:
        tokens: the number of tokens in each hand at the start.
        movable: whether tokens can be picked up.
    """

    tokens: Annotated[int, Meta(ge=0)] = 1
    movable: bool = True

    @override
    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterator[TokensState]:
        yield TokensState(tuple(starts), (self.tokens,) * len(starts), (0,) * map_.vertex_count)

    @override
    def sensed(self, map_: CombinatorialMap, state: TokensState, robot: int) -> list[int]:
        dart = state.darts[robot]
        others = others_with(map_, state.darts, robot)
        lying = state.lying[map_.vertex_of[dart]]
        return [map_.degree_at[dart], lying, others, state.hands[robot]]

    @override
    def step(
        self, map_: CombinatorialMap, state: TokensState, acts: Mapping[int, Any]
    ) -> Iterator[tuple[TokensState, str]]:
        darts, hands, lying = [*state.darts], [*state.hands], [*state.lying]
        picking: dict[Vertex, list[int]] = {}
        for robot, action in acts.items():
            here = map_.vertex_of[darts[robot]]
            if type(action) is Move:
                darts[robot] = map_.move(darts[robot], action.k)
            elif type(action) is Drop and hands[robot]:
                hands[robot] -= 1
                lying[here] += 1
            elif type(action) is Pick and self.movable:
                picking.setdefault(here, []).append(robot)
            else:
                raise IllegalAction(f"{action} with {hands[robot]} tokens in the hand")
        after = TokensState(tuple(darts), tuple(hands), tuple(lying))
        choices = [combinations(who, min(len(who), state.lying[v])) for v, who in picking.items()]
        for winners in product(*choices):
            yield _picked(after, dict(zip(picking, winners, strict=True)))

    @override
    def over(self, map_: CombinatorialMap, state: TokensState) -> bool:
        return are_together(map_, state.darts)

    @override
    def places(self, map_: CombinatorialMap, state: TokensState) -> Places:
        return Places(state.darts, {v: f"{n} tokens" for v, n in enumerate(state.lying) if n})


def _picked(state: TokensState, winners: Mapping[Vertex, Sequence[int]]) -> tuple[TokensState, str]:
    hands, lying = state.hands, state.lying
    for vertex, robots in winners.items():
        lying = replaced(lying, vertex, lying[vertex] - len(robots))
        for robot in robots:
            hands = replaced(hands, robot, hands[robot] + 1)
    words = [f"robot {robot} gets a token" for robots in winners.values() for robot in robots]
    return state._replace(hands=hands, lying=lying), ", ".join(words)
