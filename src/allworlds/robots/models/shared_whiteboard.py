"""Robots that write on whiteboards, one at each vertex."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from msgspec.json import encode
from typing_extensions import override

from allworlds.inputs.checks import show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.robots.models.boards import BoardsState, WhiteboardModel
from allworlds.robots.models.goals import Apart, are_together


@dataclass(frozen=True)
class SharedWhiteboard(WhiteboardModel, Apart):
    """Robots with a whiteboard at each vertex.

    A percept is ``[degree, others, board]``: the degree, the number of other robots here, and the
    value on the board.

    Attributes:
        goal: ``meet``: all robots must come to one vertex; ``agree``: all robots must give equal
            answers that are not null.
        labels: whether each robot is told its number.
    """

    goal: Literal["meet", "agree"] = "meet"
    labels: bool = False

    @override
    def told(self, map_: CombinatorialMap, robot: int) -> Any:
        return robot if self.labels else None

    @override
    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterator[BoardsState]:
        yield BoardsState(tuple(starts), (b"null",) * map_.vertex_count)

    @override
    def sensed(self, map_: CombinatorialMap, state: BoardsState, robot: int) -> Any:
        return self.board(map_, state, robot)

    @override
    def over(self, map_: CombinatorialMap, state: BoardsState) -> bool:
        return self.goal == "meet" and are_together(map_, state.darts)

    @override
    def flaw(self, map_: CombinatorialMap, state: BoardsState, answers: Sequence[Any]) -> str:
        if self.goal == "meet":
            return "they have not met"
        texts = {encode(answer) for answer in answers}
        return (
            "" if len(texts) == 1 and texts != {b"null"} else f"the answers are {show([*answers])}"
        )
