"""The door of the minimax search: plain numbers in, bounds and motions out."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from numpy import (
    arange,
    array,
    ascontiguousarray,
    concatenate,
    full,
    int16,
    int32,
    int64,
    maximum,
    random,
    stack as stacked,
    uint8,
    uint64,
    unique,
    where,
    zeros,
)

from allworlds.engines.kernel.minimax import (
    FIELDS,
    UNKNOWN,
    YES,
    MinimaxTables,
    Room,
    Stack,
    advance,
    begin,
    look_up,
)
from allworlds.engines.kernel.minimax_memory import (
    ENOUGH,
    FAR,
    MIRRORED,
    MOTION,
    VALUES,
    Memory,
)

STATES = 4096
"""The number of states that are looked into before a listener is asked."""

MOST_BITS = 23
"""The binary logarithm of the largest number of entries in a memory."""

UNLIMITED = 1 << 40


class PlaceTable(NamedTuple):
    """Places by number, and what motions make of them.

    Attributes:
        after: by place and motion the place after it.
        code: by place and motion the number of the percept after it.
        own: by place the number of a percept there.
        answer: by place the number of the right answer.
        mirror: by place its mirror image.
        told_apart: by percept and traversals left the largest number of places that can be told
            apart after it; empty where nothing is known of it.
    """

    after: Sequence[Sequence[int]]
    code: Sequence[Sequence[int]]
    own: Sequence[int]
    answer: Sequence[int]
    mirror: Sequence[int]
    told_apart: Sequence[Sequence[int]]


def tables_of(table: PlaceTable) -> MinimaxTables:
    """The tables in memory, with which states are given up early."""
    degree = max(map(len, table.after))
    step = _rectangle(table.after, degree, int32)
    code = _rectangle(table.code, degree, int16)
    percepts = int(code.max()) + 1
    sketch = maximum(code, 0).astype(int32)
    sketch_code, sketch_row = arange(percepts), zeros((percepts, 0), int16)
    kind, limit = zeros(percepts, int64), full((1, FAR + 1), UNLIMITED)
    if table.told_apart:
        kind, limit = arange(percepts), array(table.told_apart)
        sketch, sketch_code, sketch_row = _sketches(step, code)
    half = random.default_rng(0).integers(0, 1 << 64, (len(step), 2), dtype=uint64)
    made = MinimaxTables(
        step=step,
        code=code,
        answer=array(table.answer, int32),
        kind=kind,
        limit=limit,
        alike=_alike(step, code, array(table.own)),
        sketch=sketch,
        sketch_code=sketch_code,
        sketch_row=sketch_row,
        random=concatenate([half, half[array(table.mirror)]], 1),
    )
    return MinimaxTables(*map(ascontiguousarray, made))  # one signature for all worlds


def _rectangle(rows: Sequence[Sequence[int]], width: int, kind: Any) -> Any:
    """The rows, filled with -1."""
    made = full((len(rows), width), -1, kind)
    for i, row in enumerate(rows):
        made[i, : len(row)] = row
    return made


def _sketches(step: Any, code: Any) -> tuple[Any, Any, Any]:
    """By place and motion the number of a sketch; by sketch its percept, and the next ones."""
    rows, row_of = unique(code, axis=0, return_inverse=True)
    pair = where(step >= 0, int64(1) * code * len(rows) + row_of.reshape(-1)[maximum(step, 0)], -1)
    pairs, numbers = unique(pair, return_inverse=True)
    pairs = maximum(pairs, 0)
    return numbers.reshape(pair.shape).astype(int32), pairs // len(rows), rows[pairs % len(rows)]


def _alike(step: Any, code: Any, own: Any) -> Any:
    """By traversals left and place a class of those that no such motions tell apart."""
    classes = [unique(own, return_inverse=True)[1].reshape(-1)]
    while True:
        finer = classes[-1].astype(int64)
        for k in range(step.shape[1]):
            there = classes[-1][maximum(step[:, k], 0)].astype(int64) * (int(code.max()) + 2)
            column = where(step[:, k] >= 0, there + code[:, k] + 1, 0)
            finer = unique(finer * (int(column.max()) + 1) + column, return_inverse=True)[1]
            finer = finer.reshape(-1)
        if finer.max() == classes[-1].max():
            return stacked(classes).astype(int32)
        classes.append(finer)


class MinimaxSearch:
    """A search with its memory, which can be stopped and continued.

    Attributes:
        width: the number of motions tried in each state; a NO of a narrow search is no proof.
        states: the number of states looked into.
    """

    def __init__(self, tables: MinimaxTables, width: int | None = None) -> None:
        self._tables = tables
        places, degree = tables.step.shape
        self.width = min(width or degree, degree)
        size = 1 << min(places.bit_length() + 9, MOST_BITS)
        self._memory = Memory(zeros((size, 2), uint64), zeros((size, VALUES), uint8))
        percepts, classes = len(tables.kind), int(tables.alike.max()) + 1
        self._room = Room(
            counts=zeros((degree, len(tables.sketch_code)), int64),
            sizes=zeros(percepts, int64),
            again=zeros(percepts, int64),
            place=zeros(percepts, int64),
            seen=zeros((classes, 2), int64),
            numbers=zeros(2, int64),
        )
        self._depth = 0
        self._stack: Stack | None = None

    @property
    def states(self) -> int:
        """The number of states looked into."""
        return int(self._room.numbers[1])

    def ask(self, known: Sequence[int], most: int) -> bool | None:
        """Ask whether ``most`` traversals are enough; None: :meth:`go_on` says it."""
        self._stack = stack = self._framed(known, most)
        self._depth = 0
        found = begin(self._tables, stack, self._memory, self._room, self.width)
        return None if found == UNKNOWN else bool(found == YES)

    def go_on(self, states: int = STATES) -> bool | None:
        """Look into more states; None: it is not decided."""
        assert self._stack is not None
        found, self._depth = advance(
            *(self._tables, self._stack, self._memory, self._room, self.width),
            *(self._depth, states),
        )
        return None if found == UNKNOWN else bool(found == YES)

    def within(self, known: Sequence[int], most: int, tick: Callable[[], None]) -> bool:
        """Whether ``most`` traversals are enough; ``tick`` is called now and then."""
        answer = self.ask(known, most)
        while answer is None:
            tick()
            answer = self.go_on()
        return answer

    def motion(
        self, known: Sequence[int], most: int, tick: Callable[[], None]
    ) -> tuple[int, int] | None:
        """A number of traversals that is enough, at most ``most``, and a first motion.

        None if there is none, or with none left the answer is known.
        """
        if not self.within(known, most, tick):
            return None
        stack = self._framed(known, most)
        entry = look_up(self._tables, stack, self._memory)
        if entry < 0:
            return None
        enough, motion = map(int, self._memory.values[entry, [ENOUGH, MOTION]])
        if stack.keys[0, 0, MIRRORED]:
            degree = int((self._tables.step[known[0]] >= 0).sum())
            motion = (degree - motion) % degree
        return enough, motion

    def _framed(self, known: Sequence[int], most: int) -> Stack:
        """A stack whose first frame is that state."""
        size, depth, percepts = len(known), most + 2, len(self._tables.kind)
        degree = self._tables.step.shape[1]
        stack = Stack(
            pool=zeros(2 * size * (depth + 1), int32),
            frame=zeros((depth, FIELDS), int64),
            order=zeros((depth, 2, degree), int64),
            parts=zeros((depth, percepts, 3), int64),
            keys=zeros((depth, percepts, 3), uint64),
            own=zeros((depth, 3), uint64),
        )
        stack.pool[:size] = known
        stack.frame[0, 1:3] = size, most
        return stack
