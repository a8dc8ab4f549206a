"""Trees of runs, walked by an explorer in Python, or by a program, that can be copied.

The twin is :mod:`allworlds.engines.kernel.tree_player`, which walks those of shared libraries; the
logs are the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, MutableSequence, Sequence
from itertools import chain
from typing import TYPE_CHECKING, NamedTuple

from allworlds.engines.isolation.jobs import PlaySegments, PlayTree
from allworlds.engines.isolation.log_entries import (
    entry_of_answer,
    entry_of_checkpoint,
    motion_of,
)
from allworlds.engines.isolation.messages import StretchResult
from allworlds.engines.isolation.shared_logs import OpenedMemories
from allworlds.engines.kernel.tree_requests import END_OF_RUN, INSIDE, LAST, NEXT, PERCEPT, SEGMENT
from allworlds.engines.kernel.writing import LogEnd
from allworlds.engines.python.partial_world import PartialWorld, beginning, places
from allworlds.explorers import CopyingExplorer
from allworlds.inputs import let_users_interrupt
from allworlds.maps import Decision, MapClass
from allworlds.protocol import Checkpoint, ExplorerFault, Move, Percept

if TYPE_CHECKING:
    from allworlds.engines.kernel.tree_memory import TreeMemory

_CLASSES = {(each.simple, each.planar): each for each in MapClass}


class _CannotBeTold(Exception):
    """Raised if a run can only be played by itself: its log does not fit, or the machine failed."""


class _Branch(NamedTuple):
    """The other ways to decide a dart, and the run before the motion there."""

    ways: Iterator[tuple[Decision | None, PartialWorld]]
    cost: int
    shown: int


class ChunkPlayer:
    """A player's side of trees, for an explorer that is here.

    Args:
        explorer: its runs.
        beat: as for :class:`~allworlds.engines.isolation.generator_player.GeneratorPlayer`.
        memories: the opened memories.
    """

    def __init__(
        self, explorer: CopyingExplorer, beat: MutableSequence[int], memories: OpenedMemories
    ) -> None:
        self._explorer, self._beat, self._memories = explorer, beat, memories

    def play(self, job: PlayTree | PlaySegments) -> StretchResult:
        """Play a chunk, or its segments; the size is -1 if that is not possible here."""
        try:
            if isinstance(job, PlayTree):
                memory = self._memories.tree(job)
                walk = _Walk(self._explorer, job, self._beat)
                last = walk.chunk(len(memory.logs) // 2)
                return StretchResult(memory.put(walk.log), 0, last)
            _Repetition(self._explorer, self._memories.tree(job), self._beat).play(job.roots)
        except _CannotBeTold:
            return StretchResult(-1, 0)
        finally:
            self._beat[1] = 0
        return StretchResult(0, 0)


class _Actor:
    """The explorer, whose messages become bytes."""

    def __init__(self, explorer: CopyingExplorer, beat: MutableSequence[int]) -> None:
        self._explorer, self._beat = explorer, beat

    def heard(self, percept: Percept, *, first: bool = False) -> object:
        """The message after a percept; the end of the log if the explorer raises."""
        self._beat[1] += 1
        try:
            return self._explorer.begin(percept, None) if first else self._explorer.step(percept)
        except BaseException as error:  # noqa: BLE001  # an explorer may raise anything
            let_users_interrupt(error)
            machine = type(error) is ExplorerFault and error.machine
            if machine or isinstance(error, MemoryError):
                raise _CannotBeTold from None
            return LogEnd.WITHOUT_ANSWER

    def store(self, place: int) -> None:
        """Keep a copy of the explorer at that place."""
        self._guarded(lambda: self._explorer.store(place))

    def restore(self, place: int, *, last: bool) -> None:
        """Go on from the copy at that place."""
        self._guarded(lambda: self._explorer.restore(place, last=last))

    @staticmethod
    def _guarded(work: Callable[[], None]) -> None:
        try:
            work()
        except BaseException as error:  # noqa: BLE001  # a copy may raise anything
            let_users_interrupt(error)
            raise _CannotBeTold from None


def _entry(message: object) -> bytes:
    """The bytes of a message that is no motion."""
    if isinstance(message, LogEnd):
        return bytes((message,))
    try:
        entry = (
            entry_of_checkpoint(message)
            if type(message) is Checkpoint
            else entry_of_answer(message)
        )
    except BaseException as error:  # noqa: BLE001  # what is published may raise anything
        let_users_interrupt(error)
        return bytes((LogEnd.WITHOUT_ANSWER,))
    if entry[0] == LogEnd.STRANGE:
        raise _CannotBeTold
    return entry


class _Walk(_Actor):
    """A chunk of the tree of a unit, on its way.

    Attributes:
        log: the bytes so far.
    """

    def __init__(
        self, explorer: CopyingExplorer, job: PlayTree, beat: MutableSequence[int]
    ) -> None:
        super().__init__(explorer, beat)
        self.log = bytearray()
        self._request, self._runs = job.request, job.runs
        self._place, self._given = job.chunk.place, job.chunk.path
        self._branches: list[_Branch] = []
        self._cost = self._shown = 0

    def chunk(self, room: int) -> bool:
        """Walk the chunk; return whether the tree ends with it.

        It ends after some runs, or when the log has as many bytes.
        """
        request, runs = self._request, 0
        of_class = _CLASSES[request.simple, request.planar]
        maps = request.edges, of_class, request.limit, request.prefix
        for place in range(self._place, places(request.prefix, request.lighthouse)):
            self._cost = self._shown = 0
            start = beginning(*maps, request.lighthouse, place)
            message = self.heard(start.percept(), first=True)
            world: PartialWorld | None = start
            while world is not None:
                if self._ends(world, message):
                    runs, self._given = runs + 1, ()
                    if runs == self._runs or len(self.log) >= room:
                        return False
                world = self._go_on()
                if world is not None:
                    message = self.heard(world.percept())
        return True

    def _ends(self, world: PartialWorld, message: object) -> bool:
        """Follow the run; return False if there is no world in which it goes on so."""
        while True:
            over = self._over(world, message)
            if over is not None:
                self.log += over
                return True
            if type(message) is Move:
                motion = motion_of(message, world.degree)
                self.log.append(motion)
                after = self._first(world.after(motion))
                if after is None:
                    return False
                world = after
                self._cost += 1
            else:
                self.log += _entry(message)
                self._shown += 1
            message = self.heard(world.percept())

    def _over(self, world: PartialWorld, message: object) -> bytes | None:
        """The bytes with which the run ends; None if it goes on."""
        budget = self._budget(world)
        moves = type(message) is Move
        if not moves and type(message) is not Checkpoint:
            return _entry(message)
        spent = self._cost >= budget if moves else self._shown > budget
        if not spent:
            return None
        if not world.whole:
            raise _CannotBeTold
        return bytes((LogEnd.OVER_BUDGET if moves else LogEnd.SHOWN_TOO_OFTEN,))

    def _budget(self, world: PartialWorld) -> int:
        """The largest number of traversals that is legal, however the world is decided."""
        budgets, n = self._request.budgets, world.vertices
        return budgets[n] if world.whole else min(budgets[n : self._request.limit + 1])

    def _first(self, ways: Iterator[tuple[Decision | None, PartialWorld]]) -> PartialWorld | None:
        """The world in the first way, or in that which is given; copies are kept for the others."""
        for way, world in ways:
            given = way is not None and world.ways <= len(self._given)
            if not given or way == self._given[world.ways - 1]:
                self._keep(ways, len(self._branches), self._cost, self._shown)
                return world
        return None

    def _keep(
        self,
        ways: Iterator[tuple[Decision | None, PartialWorld]],
        place: int,
        cost: int,
        shown: int,
    ) -> None:
        """Keep a branch, and a copy of the explorer for it, if there are ways left."""
        left = next(ways, None)
        if left is not None:
            self.store(place)
            self._branches.append(_Branch(chain([left], ways), cost, shown))

    def _go_on(self) -> PartialWorld | None:
        """The world in the next way at the last branch; None if there is no branch left."""
        if not self._branches:
            return None
        ways, self._cost, self._shown = self._branches.pop()
        place = len(self._branches)
        _, world = next(ways)
        left = next(ways, None)
        self.restore(place, last=left is None)
        if left is not None:
            self._branches.append(_Branch(chain([left], ways), self._cost, self._shown))
        self._cost += 1
        return world


class _Repetition(_Actor):
    """The second play of a chunk: along recorded segments, without a world."""

    def __init__(
        self, explorer: CopyingExplorer, memory: TreeMemory, beat: MutableSequence[int]
    ) -> None:
        super().__init__(explorer, beat)
        self._memory = memory

    def play(self, roots: Sequence[int]) -> None:
        """Play the trees of these first segments."""
        for root in roots:
            waiting: list[int] = []
            segment, first = root, True
            while segment >= 0:
                branches = self._play_segment(segment, first=first)
                first = False
                segment = self._next(segment, waiting, branches=branches)

    def _play_segment(self, segment: int, *, first: bool) -> bool:
        """Play one segment; return whether there is a branch at its end."""
        at, place, left, _, inside = self._row(segment)
        log = bytearray()
        percept = self._percept(place)
        message = self.heard(percept, first=first)
        while True:
            if type(message) is Move:
                if not left:
                    log.append(LogEnd.STRANGE)  # the first play ended here
                    break
                log.append(motion_of(message, percept.degree))
                left -= 1
                if not left and inside != END_OF_RUN:
                    break
                place += PERCEPT
                percept = self._percept(place)
            else:
                log += _entry(message)
                if type(message) is not Checkpoint:
                    break
            message = self.heard(percept)
        self._memory.put(log, at)
        return not left and inside >= 0 and type(message) is Move

    def _next(self, segment: int, waiting: list[int], *, branches: bool) -> int:
        """The segment that is played next; -1 at the end of the tree."""
        place = len(waiting)
        if branches:
            after = self._row(segment)[INSIDE]
            if (left := self._row(after)[NEXT]) != LAST:
                self.store(place)
                waiting.append(left)
            return after
        if not waiting:
            return -1
        after = waiting.pop()
        left = self._row(after)[NEXT]
        self.restore(place - 1, last=left == LAST)
        if left != LAST:
            waiting.append(left)
        return after

    def _row(self, segment: int) -> list[int]:
        """The row of a segment."""
        row: list[int] = self._memory.segments[SEGMENT * segment : SEGMENT * (segment + 1)].tolist()
        return row

    def _percept(self, place: int) -> Percept:
        degree, marks, bearing = self._memory.percepts[place : place + PERCEPT].tolist()
        return Percept(degree, marks, bearing - 1 if bearing else None)
