"""Trees of runs of an explorer that can be copied: judged here, walked in other processes.

:class:`UnitTree` is the judge of a unit, and has no explorer; :class:`CopyingPlayer` is the
explorer's side.  Memory that is shared with users' code is copied before it is read.
"""

from __future__ import annotations

import mmap
from collections.abc import Sequence
from random import Random
from typing import Any, NamedTuple

from numpy import array, asarray, int32, int64, searchsorted, uint8, zeros

from allworlds.engines.kernel import tree_judge, tree_player
from allworlds.engines.kernel.batches import NativePlayer, any_level, no_player
from allworlds.engines.kernel.classes import rule_address
from allworlds.engines.kernel.compiling import uncollected
from allworlds.engines.kernel.engine import asked_of, rows_of, set_up
from allworlds.engines.kernel.memory_arrays import TreeArrays
from allworlds.engines.kernel.on_demand import KINDS, POINTED
from allworlds.engines.kernel.records import JOB, READER, ROBOT, new
from allworlds.engines.kernel.rows import Level, Rows
from allworlds.engines.kernel.tables import gluing_rule
from allworlds.engines.kernel.tree_ends import ALPHA, BYTES, COST, HEAD, PLACE, SENSED, SIGMA
from allworlds.engines.kernel.tree_judge import ROOM
from allworlds.engines.kernel.tree_memory import (
    LOG_BYTES,
    LONGEST_SINGLE,
    MOST_RUNS,
    MOST_SEGMENTS,
    MOST_SINGLES,
    PERCEPT_BYTES,
    TreeMemory,
)
from allworlds.engines.kernel.tree_records import BRANCHES, DEMAND, HEARING
from allworlds.engines.kernel.tree_requests import (
    END_OF_RUN,
    LAST,
    SEGMENT,
    Chunk,
    TreeRequest,
)


class RunOfTree(NamedTuple):
    """A run of a chunk that can be played again from its start.

    Attributes:
        sigma, alpha: its map, rooted at dart 0.
        place: the number of the lighthouse's place.
        motions: their number.
        percepts, log: bytes.
    """

    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    place: int
    motions: int
    percepts: Any
    log: Any


class _JudgedChunk(NamedTuple):
    """A chunk: its beginning, the log of the run that is repeated, its size in bytes."""

    chunk: Chunk
    before: Any
    size: int
    last: bool


class UnitTree:
    """The tree of the runs of a unit, judged chunk by chunk.

    Args:
        level: as for :func:`allworlds.engines.kernel.engine.judge`.
        request: for the same level, and the unit.
        keep: the number of broken runs that are kept.
        first: the memory of the first player.
        second: that of the second.
        random: draws the order of segments, and the runs that are kept.
    """

    def __init__(
        self,
        level: Level,
        request: TreeRequest,
        keep: int,
        first: TreeMemory,
        second: TreeMemory,
        random: Random,
    ) -> None:
        self._first, self._second, self._random = first, second, random
        self._job, self._robot, self._reader, self._hearing = _room()
        set_up(self._job, self._robot, level)
        self._asked = asked_of(level, request.prefix, keep)
        self._prefix, self._viable, *_ = self._asked.arguments
        self._budgets = budget_table(request)
        ask(self._hearing.demand, request)
        self._before = zeros(0, uint8)
        self._size = 0
        self._judged = _JudgedChunk(Chunk(), self._before, 0, last=False)
        self._singles: list[tuple[int, RunOfTree]] = []
        self.roots: list[int] = []
        """The first segments of the trees in the second memory."""
        self.next: Chunk | None = Chunk()
        self._hearing.random = random.getrandbits(62) | 1

    def judge(
        self,
        size: int,
        singles: Sequence[RunOfTree] = (),
        *,
        last: bool,
        samples: int = MOST_SINGLES,
    ) -> int | None:
        """Judge the chunk in the first memory; return its runs, or None if that is not possible.

        Segments and percepts for the second play are written to its memory.  ``next`` is then the
        next chunk, or None at the end of the tree.

        Args:
            size: of the log, in bytes.
            singles: runs that are played again with the chunk.
            last: whether it is the last chunk of the tree, as the player has it.
            samples: the number of its runs that are kept, at most ``MOST_SINGLES``.
        """
        chunk = self.next
        assert chunk is not None
        size = max(0, min(size, LOG_BYTES))
        _LOGS[:size] = self._first.logs[:size]
        runs = max(1, size // _BYTES_OF_A_RUN)
        wanted = sorted({self._random.randrange(runs) for _ in range(samples)})
        self._judged = _JudgedChunk(chunk, self._before, size, last)
        if not self._judge(self._judged, wanted, _KEPT):
            return None
        h = self._hearing
        self._before = asarray(h.log)[: h.bytes].copy()
        path = tuple(asarray(h.demand.path)[: h.demand.ways].tolist())
        if not path:
            self._before = self._before[:0]
        self.next = None if last else Chunk(int(h.demand.place), path)
        if self.next == chunk:
            return None
        self._hand_over(singles)
        return int(h.runs)

    def _judge(self, judged: _JudgedChunk, wanted: Sequence[int], kept: Any) -> bool:
        """Judge a chunk; return whether that was possible.

        The runs of the wanted numbers are kept, each in a row if it has room.
        """
        h, asked, chunk = self._hearing, self._asked, judged.chunk
        h.demand.place, h.demand.given = chunk.place, len(chunk.path)
        asarray(h.demand.path)[: len(chunk.path)] = chunk.path
        _HEADS[:, BYTES] = 0
        tree_judge.judge_tree(
            h,
            self._job,
            self._reader,
            self._prefix,
            self._viable,
            self._budgets,
            *asked.arguments[2:4],
            *asked.arguments[5:9],
            _NEVER,
            _LOGS[: judged.size + ROOM],
            judged.last,
            judged.before,
            _SEGMENTS,
            _PERCEPTS,
            _STOPS,
            array([*wanted, -1], int64),
            kept,
            _HEADS,
        )
        return not h.strange

    @property
    def undefined(self) -> bool:
        """Whether a run has a bound without a value."""
        return bool(self._hearing.undefined)

    @property
    def rows(self) -> Rows:
        """The rows of all chunks so far."""
        return rows_of(self._asked, self._job, self._robot)

    def kept(self) -> list[RunOfTree]:
        """Some runs of the chunk that was judged last, drawn."""
        return self._runs_in(_KEPT)

    def _runs_in(self, rows: Any) -> list[RunOfTree]:
        """The runs that were kept in these rows."""
        found = []
        darts = 2 * int(self._job.gluing.edges)
        for head, kept in zip(_HEADS.tolist(), rows, strict=False):
            length, sensed = head[BYTES], head[SENSED]
            if length:
                sigma, alpha = (tuple(head[at : at + darts]) for at in (SIGMA, ALPHA))
                log, percepts = kept[:length].copy(), kept[length : length + sensed].copy()
                found.append(RunOfTree(sigma, alpha, head[PLACE], head[COST], percepts, log))
        return found

    def difference(self) -> int | None:
        """The first byte in which the log of the second play differs from that of the first."""
        at = int(tree_judge.first_difference(_LOGS, self._second.logs, self._size))
        return None if at == self._size else at

    def run_at(self, byte: int) -> RunOfTree | None:
        """A run of the chunk to whose log that byte belongs; None if its world is not decided.

        The tallies are void after that.
        """
        singles = [single for start, single in self._singles if start <= byte]
        if singles:
            return singles[-1]
        number = int(searchsorted(_STOPS[: self._hearing.runs], byte, "right"))
        self._judge(self._judged, [number], _SUSPECT)
        kept = self._runs_in(_SUSPECT)
        return kept[0] if kept else None

    def _hand_over(self, singles: Sequence[RunOfTree]) -> None:
        """Hand the segments of the chunk, and other runs, to the second player."""
        h, second, size = self._hearing, self._second, self._judged.size
        segments, noted = int(h.segments), int(h.noted)
        self.roots = asarray(h.roots)[: h.rooted].tolist()
        self._singles = []
        for single in singles:
            room = PERCEPT_BYTES - noted, LOG_BYTES - size
            if len(single.percepts) > room[0] or len(single.log) > room[1]:
                break
            self._singles.append((size, single))
            _SEGMENTS[segments] = size, noted, single.motions, LAST, END_OF_RUN
            self.roots.append(segments)
            _PERCEPTS[noted : noted + len(single.percepts)] = single.percepts
            _LOGS[size : size + len(single.log)] = single.log
            segments, size = segments + 1, size + len(single.log)
            noted += len(single.percepts)
        second.segments[:segments] = _SEGMENTS[:segments]
        second.percepts[:noted] = _PERCEPTS[:noted]
        self._size = size


class CopyingPlayer:
    """A native explorer that can be copied, and walks trees.

    Args:
        native: the same explorer, which plays stretches.
        states: the addresses of ``allworlds_clone`` and ``allworlds_new``.
    """

    def __init__(self, native: NativePlayer, states: Sequence[int]) -> None:
        self._native, self._states = native, array(states, int64)
        self._demand = new(DEMAND)
        self._pool, self._waiting = zeros(_DEEPEST, int64), zeros(_DEEPEST, int64)

    def play(
        self, memory: TreeMemory, request: TreeRequest, chunk: Chunk, runs: int
    ) -> tuple[int, bool]:
        """Play a chunk; return the number of bytes of its log, and whether the tree ends with it.

        The number is -1 if it cannot be played so.
        """
        d = self._demand
        ask(d, request)
        d.place, d.given = chunk.place, len(chunk.path)
        asarray(d.path)[: d.given] = chunk.path
        prefix = array(request.prefix, int64)
        size = int(
            tree_player.play_tree(
                d,
                *self._common(request.policy),
                prefix,
                gluing_rule(request.edges),
                budget_table(request),
                memory.logs,
                runs,
                self._native.beat,
            )
        )
        places = -prefix[0] if d.kind == POINTED else 1
        return size, bool(d.place == places)

    def play_again(self, memory: TreeMemory, policy: str, roots: Sequence[int]) -> int:
        """Play segments; return 0, or -1 if they cannot be played so."""
        return int(
            tree_player.play_segments(
                *self._common(policy),
                array(roots, int64),
                memory.segments,
                memory.percepts,
                self._waiting,
                memory.logs,
                self._native.beat,
            )
        )

    def _common(self, policy: str) -> tuple[Any, ...]:
        return (*self._native.handed(policy), self._states, self._pool)


def ask(d: Any, request: TreeRequest) -> None:
    """Fill the record of a world that is decided on demand with the request."""
    g = d.gluing
    g.edges, g.limit = request.edges, request.limit
    g.simple, g.planar = request.simple, request.planar
    g.rule = rule_address() if request.simple or request.planar else 0
    d.kind = KINDS[request.lighthouse]


def budget_table(request: TreeRequest) -> Any:
    """The budgets, by vertices; below each the least of it and of those of more vertices."""
    budgets = array([request.budgets] * 2, int64)
    for n in range(min(request.limit, request.edges + 1) - 1, 0, -1):
        budgets[1, n] = min(budgets[1, n], budgets[1, n + 1])
    return budgets


def load_trees() -> None:
    """Load or compile the code that trees need."""
    level = any_level()
    request = TreeRequest(
        1,
        2,
        simple=False,
        planar=False,
        lighthouse="none",
        policy="fifo",
        budgets=level.budgets,
        prefix=(-1,),
    )
    with uncollected():
        memory = TreeArrays(mmap.mmap(-1, TreeMemory.size()))
        tree = UnitTree(level, request, 1, memory, memory, Random(0))  # noqa: S311  # nothing is drawn
        tree.judge(0, last=False)
        player = CopyingPlayer(no_player(), (0, 0))
        player.play(memory, request, Chunk(), 0)
        player.play_again(memory, "fifo", [])


_LOGS = zeros(LOG_BYTES + ROOM, uint8)
"""This process's copy of the log of a chunk, and behind it those of single runs."""

_SEGMENTS = zeros((MOST_SEGMENTS, SEGMENT), int32)
_PERCEPTS = zeros(PERCEPT_BYTES, uint8)

_DEEPEST = BRANCHES + 1
"""Room for the states at the branches of the second play."""

_STOPS = zeros(2 * MOST_RUNS, int32)
"""Where the log of each run of a chunk ends."""

_BYTES_OF_A_RUN = 64
"""About so many bytes of a log are a run's own."""

_KEPT = zeros((MOST_SINGLES, LONGEST_SINGLE), uint8)
_SUSPECT = zeros((1, LOG_BYTES + PERCEPT_BYTES), uint8)
"""Room for one run, however long it is."""

_HEADS = zeros((MOST_SINGLES, HEAD), int64)
_NEVER = zeros(2, int64)

_ROOMS: list[tuple[Any, Any, Any, Any]] = []


def _room() -> tuple[Any, Any, Any, Any]:
    """This process's memory for a job, a robot, a reader and the judge of a tree."""
    if not _ROOMS:
        reader = new(READER)
        reader.begins, reader.starts = _ONE[:1].ctypes.data, _ONE[1:].ctypes.data
        reader.ends, reader.percepts = _ONE[2:].ctypes.data, _PATH.ctypes.data
        reader.room = len(_PATH)
        _ROOMS.append((new(JOB), new(ROBOT), reader, new(HEARING)))
    return _ROOMS[0]


_ONE = zeros(4, int32)
_PATH = zeros(1 << 18, uint8)
"""Room for the percepts of a single run, which are not read."""
