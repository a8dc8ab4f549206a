"""Whiteboards: a JSON value at each vertex, which all robots read and write."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from typing import Any, NamedTuple

from msgspec.json import decode, encode
from typing_extensions import override

from allworlds.maps.combinatorial import CombinatorialMap, Dart, Vertex
from allworlds.protocol.actions import Do, IllegalAction, Move, Write
from allworlds.robots.model import Model, Places
from allworlds.robots.models.goals import others_with, replaced


class BoardsState(NamedTuple):
    """A state of a world with whiteboards.

    Attributes:
        darts: the dart of each robot.
        boards: the value at each vertex, as canonical JSON, in which 1 and true differ.
        wrote: the robots that have already written, at their look, and whose move comes later.
        home: the dart at which all robots have started, in a world with a black hole.
        hole: the vertex that destroys robots, if there is one.
    """

    darts: tuple[Dart, ...]
    boards: tuple[bytes, ...]
    wrote: frozenset[int] = frozenset()
    home: Dart = 0
    hole: Vertex | None = None


@dataclass(frozen=True)
class WhiteboardModel(Model):
    """The base of models with whiteboards; at first each whiteboard has the value null.

    ``Do({"write": value, "move": k})`` writes, then moves; one of the two keys may be missing.
    ``Move(k)`` and ``Write(k)`` are short for an action with one key.  If several robots write on
    one board in the same round, the adversary chooses which robot writes last.

    Attributes:
        at_once: whether a robot reads and writes a board in one step, as asynchronous agents do. If
            not, a robot reads when it looks and writes when it moves; under the scheduler ``async``
            other robots may write in between.
    """

    at_once: bool = False

    def board(self, map_: CombinatorialMap, state: BoardsState, robot: int) -> tuple[int, int, Any]:
        """For a robot's vertex: the degree, the number of other robots, and the board's value."""
        dart = state.darts[robot]
        board = decode(state.boards[map_.vertex_of[dart]])
        return map_.degree_at[dart], others_with(map_, state.darts, robot), board

    @override
    def looked(
        self, map_: CombinatorialMap, state: BoardsState, robot: int, action: Any
    ) -> Iterator[tuple[BoardsState, str]]:
        if self.at_once and "write" in _parts(action):
            (after, words), *_ = _written(map_, state, {robot: action})
            yield after._replace(wrote=state.wrote | {robot}), words
        else:
            yield state, ""

    @override
    def step(
        self, map_: CombinatorialMap, state: BoardsState, acts: Mapping[int, Any]
    ) -> Iterator[tuple[BoardsState, str]]:
        darts = [*state.darts]
        for robot, action in acts.items():
            if "move" in (parts := _parts(action)):
                darts[robot] = map_.move(darts[robot], parts["move"])
        for after, words in _written(map_, state, acts):
            yield after._replace(darts=tuple(darts), wrote=state.wrote - {*acts}), words

    @override
    def places(self, map_: CombinatorialMap, state: BoardsState) -> Places:
        words = {at: text.decode() for at, text in enumerate(state.boards) if text != b"null"}
        if state.hole is not None:
            words[state.hole] = "hole"
        alive = [None if map_.vertex_of[dart] == state.hole else dart for dart in state.darts]
        return Places(tuple(alive), words)


def _parts(action: Any) -> dict[str, Any]:
    """The parts of an action, by their keys: ``write`` for the value, ``move`` for the motion.

    The action may have only one of the two parts.

    Raises:
        IllegalAction: for any other action.
    """
    match action:
        case Move(k):
            return {"move": k}
        case Write(k):
            return {"write": k}
        case Do(dict() as parts) if parts and {*parts} <= {"write", "move"}:
            if type(parts.get("move", 0)) is int:
                return parts
    raise IllegalAction(f"legal is Do with the keys write and move, not {action}")


def _written(
    map_: CombinatorialMap, state: BoardsState, acts: Mapping[int, Any]
) -> Iterator[tuple[BoardsState, str]]:
    """The states after robots of ``acts`` have written, each with the adversary's choice in words.

    A robot writes if its action says so, and if it has not written at its look already.  If several
    robots write on one board, the adversary chooses the robot that writes last; there is one state
    for each such choice.
    """
    writers: dict[Vertex, list[int]] = {}
    for robot, action in acts.items():
        if "write" in _parts(action) and robot not in state.wrote:
            writers.setdefault(map_.vertex_of[state.darts[robot]], []).append(robot)
    for last in product(*writers.values()):
        boards, words = state.boards, []
        for (vertex, here), robot in zip(writers.items(), last, strict=True):
            text = encode(_parts(acts[robot])["write"], order="deterministic")
            boards = replaced(boards, vertex, text)
            if len(here) > 1:
                words.append(f"robot {robot} writes last")
        yield state._replace(boards=boards), "; ".join(words)
