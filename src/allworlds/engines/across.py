"""All runs in small worlds, in two opposite orders, to find runs that change a later run.

An :class:`AcrossUnit` consists of all runs in all worlds up to some size.  Let N be the number of
these runs.  Two processes play them, and no others::

    one process:      run 1, run 2, ..., run N
    another process:  run N, ..., run 2, run 1

So of any two runs, each is played before the other in one of the two processes.  If no world has
more than :data:`TWICE` edges, the other process then plays run 1, run 2, ..., run N once more; so
it plays each run after the same run, too.

If a run has different logs in the two processes, a bisection finds a few earlier runs that suffice
to cause the difference.  The plays are not counted, because each run is counted in another unit.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, TypeAlias

from allworlds.engines.batch import FIRST, Due, RunBatch, Work
from allworlds.engines.judge import PythonJudge
from allworlds.engines.players import (
    Lost,
    PlayerHere,
    PlayerProcess,
    Setup,
    answered,
    lost_log,
    started,
)
from allworlds.engines.units import ACROSS, TWICE, AcrossUnit, GivenUnit, LevelUnit
from allworlds.judging.differences import after_worlds, difference_of, overruled
from allworlds.judging.findings.finding import canonical_world
from allworlds.judging.referee import Outcome
from allworlds.log import Log
from allworlds.maps.combinatorial import CombinatorialMap, rooted_code
from allworlds.world.world import World

MOST_EARLIER = 4
"""The largest number of earlier runs that a finding names."""

FEW = 3
"""The largest number of runs that :meth:`Across.settle` tries.

For each of these runs the method searches for earlier runs that change the run's log.
"""

AtPlace: TypeAlias = tuple[CombinatorialMap, int]
"""A map, and the number of the lighthouse's place."""


class FirstLog(NamedTuple):
    """A run, with the log of its first play in the unit that counts the run.

    Attributes:
        due: the run.
        log: the log.
        right: whether the run breaks no law in this play.
    """

    due: Due
    log: bytes
    right: bool


def remember(batch: RunBatch, known: dict[AtPlace, FirstLog]) -> None:
    """Add the runs of a batch to ``known``, each with the log of its first play.

    The keys of ``known`` are the map and the place of a run.  The runs are added in the order in
    which they were played.  Nothing is added if the worlds have more than :data:`ACROSS` edges.
    Nothing is added, too, if compiled code has played the runs, because it plays them in an order
    that it draws itself.
    """
    unit, logs, broken = batch.work.unit, batch.logs[FIRST], {*batch.broken}
    small = isinstance(unit, LevelUnit | GivenUnit) and unit.edges <= ACROSS
    if small and batch.plain:  # a library draws the order
        for index in range(len(batch)):
            due = batch.due(index)
            one = FirstLog(due, logs[index], right=index not in broken)
            known.setdefault((due.world.map, due.place), one)


class _Play:
    """The play of all runs in one order, by one process.

    Attributes:
        seed: the hash seed.
        order: the indices of the runs in the order of the play; an index may occur twice.
        logs: the logs of the runs in this order; None until all logs are known.
        player: the player that plays the runs; None before the play begins and after its end.
    """

    def __init__(self, seed: int, player: PlayerProcess | PlayerHere | None) -> None:
        self.seed, self.player = seed, player
        self.order: list[int] = []
        self.logs: Sequence[bytes] | None = None

    def end(self) -> None:
        """End the player, if there is one."""
        if self.player:
            self.player.close()
        self.player = None


class Across:
    """The two plays, in opposite orders, of all runs in small worlds; see the text of this module.

    Args:
        setup: the explorer, with the limits of its players.
        judge: the judge of the explorer's runs.
        work: the state of the work on the unit, which is an :class:`AcrossUnit`.
        seeds: the hash seeds of the two processes.

    Attributes:
        batch: the batch of all runs; empty before the plays begin.
        begun: whether the plays have begun.
        found: a dictionary from the index of each run that refutes the explorer to the outcome of
            the run.
        odd: a list of pairs: the index of a run whose two logs differ, and the log of its second
            play. The caller must find out why they differ; the reason may be the hash seeds. The
            list is filled by :meth:`settle`. It stays empty if :meth:`settle` finds a run whose log
            is changed by earlier runs, because this run, which is in ``found``, refutes the
            explorer already.
    """

    def __init__(
        self, setup: Setup, judge: PythonJudge, work: Work, seeds: tuple[int, int]
    ) -> None:
        self._setup, self._judge, self.work = setup, judge, work
        self._seed = seeds[0]
        self._plays = _Play(seeds[0], None), _Play(seeds[1], started(setup, seeds[1]))
        self.batch = RunBatch(judge, work, [])
        self.begun = False
        self.found: dict[int, Outcome] = {}
        self.odd: list[tuple[int, Log]] = []

    def begin(self, known: Mapping[AtPlace, FirstLog]) -> None:
        """Begin the plays of the runs of this unit.

        The caller does this after the other units in which these runs are counted.

        Args:
            known: runs in small worlds with their logs, by the map and the place of the run. One
                process has played these runs, and no others, in the order of the dictionary. If
                ``known`` has all runs of this unit, these logs serve as the first of the two plays;
                if not, a new process makes the first play.
        """
        assert isinstance(self.work.unit, AcrossUnit)
        self.begun = True
        runs = [
            Due(run.number, run.place, World(run.map, run.lighthouse, 0))
            for run in self._judge.counter.runs(self.work.unit)
            if run.lighthouse
        ]
        first, second = self._plays
        wanted = {(due.world.map, due.place) for due in runs}
        if wanted <= known.keys():
            logs = [one for at, one in known.items() if at in wanted]
            runs, first.logs = [one.due for one in logs], [one.log for one in logs]
        else:
            first.player = started(self._setup, first.seed)
        self._right = {(*at, one.log) for at, one in known.items() if one.right}
        self.batch = RunBatch(self._judge, self.work, runs)
        self._message = self._judge.worlds_message(self.batch.runs)
        first.order = [*range(len(runs))]
        second.order = first.order[::-1] + (first.order if self.work.unit.edges <= TWICE else [])
        for play in self._plays:
            if play.player:
                play.player.give(None, self._in_order(play.order))

    def _in_order(self, order: Sequence[int]) -> dict[str, Any]:
        """The message that tells a player to play the runs of these indices in this order."""
        content = self._message["content"]
        return self._judge.message(self._message["kind"], [content[index] for index in order])

    # ---------------------------------------------------------------- plays

    @property
    def players(self) -> list[PlayerProcess | PlayerHere]:
        """The players that are at work."""
        return [play.player for play in self._plays if play.player]

    def hear(self, note: Callable[[Work, Lost], None]) -> bool:
        """Read the logs that the players have sent; return whether both plays have ended.

        If a player is lost in a run, fresh players play this run again, and :meth:`_is_repeated`
        says whether they show a fault of the explorer.  If they do, both plays end here.  If not,
        the loss is reported to ``note``, and a new player plays all runs in the same order.

        Args:
            note: the function to call with the unit and the loss, if fresh players show no fault.
        """
        for play in self._plays:
            if play.player:
                try:
                    answers = play.player.heard()
                except Lost as lost:
                    if self._is_repeated(play, play.player, lost):
                        self.close()
                        break
                    note(self.work, lost)
                    play.player.again()
                else:
                    for _, play.logs in answers:
                        play.end()
        return not self.players

    def close(self) -> None:
        """End the players.  If a play is not finished, :meth:`settle` will compare no run."""
        for play in self._plays:
            play.end()

    def _is_repeated(self, play: _Play, player: Any, lost: Lost) -> bool:
        """Whether fresh players show that the loss of a player was the explorer's fault.

        They show it in two cases.  First: the log of the run in which the player was lost is
        changed by some of the runs that the player had played before it; then the outcome that
        names these earlier runs is added to :attr:`found`.  Second: a fresh player that plays this
        run alone is lost in the same way.

        Args:
            play: the play in which the player was lost.
            player: this player, which knows the position of the run in which it was lost.
            lost: the loss.
        """
        position = player.beat[0]
        if player.description is None or not 0 <= position < len(play.order):
            return False
        index = play.order[position]
        if named := self._named(index, play.order[:position]):
            self.found[index] = named
            return True
        return not self._differ(self._after(play.seed, [], index), lost_log(b"", lost))

    def _after(self, seed: int, earlier: Sequence[int], index: int) -> bytes:
        """The log of the run ``index``, which a fresh player plays after the runs ``earlier``.

        ``seed`` is the hash seed of the fresh player.  The log is empty if the fresh player is lost
        in one of the earlier runs.
        """
        logs = self._fresh(seed, [*earlier, index])
        return logs[-1] if len(logs) > len(earlier) else b""

    def _fresh(self, seed: int, order: Sequence[int]) -> list[bytes]:
        """The logs of a fresh player that plays the runs of the indices ``order``, in this order.

        ``seed`` is the hash seed of the player.  A player sends its logs after the last run.  So if
        it is lost in a run, the logs of the runs before this run are unknown, and the list has
        empty logs for them.  The last log of the list is then that of the run in which the player
        was lost, and holds only the loss.
        """
        player = started(self._setup, seed)
        try:
            return [*answered(player, self._in_order(order))]
        except Lost as lost:
            return [b""] * player.beat[0] + [lost_log(b"", lost)]
        finally:
            player.close()

    def _differ(self, one: bytes, other: bytes) -> bool:
        """Whether two logs of a run differ; False if one of them is empty, since it is unknown."""
        if one == other or not (one and other):
            return False
        return difference_of(Log(one), Log(other), choices=self._judge.every) is not None

    # ---------------------------------------------------------------- differences

    def settle(self) -> None:
        """Find the smallest run that shows a fault, and put its outcome into :attr:`found`.

        A run shows a fault in two cases.  Either earlier runs in the same process change its log;
        then the outcome names these runs.  Or the run breaks a law, and has the same log if it is
        played alone.  The runs whose logs depend on the order of the play, and the runs that break
        a law in the first play, are tried from the smallest on, at most :data:`FEW` runs in all.
        If none of them shows a fault, or if a play is not finished, :attr:`found` does not change.
        """
        first, second = self._plays
        if not (first.logs and second.logs):
            return
        forwards = self.batch.logs[0] = first.logs
        odd = by_order = self._unlike(forwards)
        if odd and first.seed != second.seed:
            by_order = self._unlike(self._fresh(second.seed, first.order))
        self.odd = [(i, Log(second.logs[position])) for i, position in (odd | by_order).items()]
        for index in sorted({*by_order, *self._broken()}, key=self._size)[:FEW]:
            if index not in by_order and self._after(first.seed, [], index) == forwards[index]:
                self.found[index] = self.batch.outcome(index).outcome  # by itself
                return
            every = sorted(first.order, key=self._size)  # not in the order of these plays
            for earlier in (every, first.order[:index], second.order[: by_order.get(index, 0)]):
                if named := self._named(index, earlier):
                    self.found, self.odd = {index: named}, []
                    return

    def _unlike(self, forwards: Sequence[bytes]) -> dict[int, int]:
        """Find the runs whose logs in the second play differ from their logs in ``forwards``.

        Item i of ``forwards`` is a log of run i.  The second play may hold two logs of the same
        run; the run is found if one of these two logs differs from item i.  Return a dictionary
        from the index of each run that is found to a position in the second play: the position of
        the run's first log that differs.
        """
        second, found = self._plays[1], dict[int, int]()
        assert second.logs is not None
        for position, (index, log) in enumerate(zip(second.order, second.logs, strict=True)):
            if index < len(forwards) and self._differ(forwards[index], log):
                found.setdefault(index, position)
        return found

    def _broken(self) -> list[int]:
        """The indices of the runs that break a law in the first play."""
        return [
            i
            for i, (due, log) in enumerate(zip(self.batch.runs, self.batch.logs[0], strict=True))
            if (due.world.map, due.place, log) not in self._right
            and self.batch.outcome(i).outcome.violation
        ]

    def _size(self, index: int) -> tuple[Any, ...]:
        """The sort key of the run with this index; runs are sorted as findings are, small first."""
        _, place, world, _ = self.batch.runs[index]
        map_ = world.map
        code = rooted_code(map_.sigma, map_.alpha, world.start)
        return map_.edge_count, map_.vertex_count, code, place

    def _named(self, index: int, earlier: Sequence[int]) -> Outcome | None:
        """The outcome of the run ``index``, if some of the runs ``earlier`` change its log.

        The outcome names the runs that :meth:`_needed` finds.  Return None if there are no such
        runs, or if a second play after the same runs does not show the change again.
        """
        alone = self._after(self._seed, [], index)
        needed = self._needed(alone, index, earlier)
        after, again = (self._after(self._seed, needed, index) for _ in range(2))
        if not self._differ(alone, after) or self._differ(after, again):
            return None
        outcome = self._judge.judged(self.batch.runs[index], alone).outcome
        wrong = overruled(outcome, Log(alone), Log(after), choices=self._judge.every)
        return after_worlds(wrong, [canonical_world(self.batch.runs[i].world) for i in needed])

    def _needed(self, alone: bytes, index: int, earlier: Sequence[int]) -> list[int]:
        """The indices of a few of the runs ``earlier`` that suffice to change the log of a run.

        ``index`` is the index of the run, and ``alone`` is its log if the run is played alone.  The
        result is found by bisection.  It is empty if the log after all runs of ``earlier`` equals
        ``alone``, if a second play of the run alone has another log, or if the bisection would need
        more than :data:`MOST_EARLIER` runs.
        """

        def shows(indices: Sequence[int]) -> bool:
            return self._differ(alone, self._after(self._seed, indices, index))

        needed, rest = list[int](), [*earlier]
        if shows([]) or not shows(rest):
            return []
        while rest and not (needed and shows(needed)):
            if len(needed) == MOST_EARLIER:
                return []
            low, high = 0, len(rest)
            while high - low > 1:
                middle = (low + high) // 2
                if shows([*rest[:middle], *needed]):
                    high = middle
                else:
                    low = middle
            needed, rest = [rest[low], *needed], rest[:low]
        return needed
