"""A vertex that destroys every robot that enters it; one robot must survive and find it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from typing_extensions import override

from allworlds.inputs.checks import show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.robots.models.boards import BoardsState, WhiteboardModel


@dataclass(frozen=True)
class BlackHole(WhiteboardModel):
    """Robots with whiteboards that start at one dart, their home, and look for a black hole.

    The adversary chooses the hole: any vertex but home.  A robot is told the number of vertices and
    its own number, as ``[vertices, number]``.  A percept is ``[degree, home, others, board]``: the
    degree, whether this vertex is home, the number of other robots here, and the value on the
    whiteboard.  A robot in the hole is gone.  An answer is a walk from the home's dart to the hole.
    It is a list of numbers for ``Move``: on a ring ``[0, 1, 1]`` leads three vertices on.  The
    robots are right if at least one robot answers, and no answer is wrong.
    """

    @override
    def starts(self, map_: CombinatorialMap, robots: int) -> Iterator[tuple[Dart, ...]]:
        yield (0,) * robots

    @override
    def told(self, map_: CombinatorialMap, robot: int) -> Any:
        return [map_.vertex_count, robot]

    @override
    def initial(self, map_: CombinatorialMap, starts: Sequence[Dart]) -> Iterator[BoardsState]:
        home, boards = starts[0], (b"null",) * map_.vertex_count
        for hole in range(map_.vertex_count):
            if hole != map_.vertex_of[home]:
                yield BoardsState((home,) * len(starts), boards, home=home, hole=hole)

    @override
    def sensed(self, map_: CombinatorialMap, state: BoardsState, robot: int) -> Any:
        here = map_.vertex_of[state.darts[robot]]
        if here == state.hole:
            return None
        degree, others, board = self.board(map_, state, robot)
        return degree, here == map_.vertex_of[state.home], others, board

    @override
    def bad(self, map_: CombinatorialMap, state: BoardsState) -> str:
        lost = all(map_.vertex_of[dart] == state.hole for dart in state.darts)
        return "nobody is left" if lost else ""

    @override
    def flaw(self, map_: CombinatorialMap, state: BoardsState, answers: Sequence[Any]) -> str:
        given = [answer for answer in answers if answer is not None]
        for answer in given:
            if not _leads_to_hole(map_, state, answer):
                return f"the walk {show(answer)} does not lead to the hole"
        return "" if given else "nobody answers"


def _leads_to_hole(map_: CombinatorialMap, state: BoardsState, walk: Any) -> bool:
    if not isinstance(walk, list) or any(type(turn) is not int for turn in walk):
        return False
    dart = state.home
    for turn in walk:
        dart = map_.move(dart, turn)
    return map_.vertex_of[dart] == state.hole
