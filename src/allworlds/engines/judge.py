"""The judge in Python, which knows every law, lighthouse and task.

The judge puts the runs of a unit into batches, and walks each log anew in the true map.  The second
player gets the percepts of this walk.  The judge imports lighthouses and tasks of users, but never
an explorer.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import lru_cache
from typing import Any

from allworlds.engines.batch import Due, Indices, Judged, Message, Recorded, RunBatch, Work
from allworlds.engines.tally import RunCounter
from allworlds.inputs.checks import InputError, show
from allworlds.judging.episode import Episode, Fault, Over, followed
from allworlds.judging.referee import LOST, Referee, name_run
from allworlds.log import Log
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import actions, playing
from allworlds.protocol.choices import DEFAULT_POLICY, are_due
from allworlds.world.lighthouses.kinds import kind_of
from allworlds.world.state import State
from allworlds.world.world import World


class PythonJudge:
    """The judge in Python, for the runs of one scope.

    Args:
        counter: the object that lists the runs of a unit, and adds runs and their outcomes to a
            tally; it also holds the scope.
        explorer: the explorer's name.
        given: for a single run, one index for each of the explorer's first choices: the index of
            the option to be taken at this choice.  None for the runs of a check: the policy makes
            all choices, or every schedule is tried.
    """

    name = "python"

    def __init__(
        self, counter: RunCounter, explorer: str, given: tuple[int, ...] | None = None
    ) -> None:
        self.counter, self.rules = counter, counter.scope.rules
        self.referee = Referee(explorer, self.rules)
        self.every = counter.scope.schedules == "all" and given is None
        self._given = given or ()

    def batches(self, work: Work, size: Callable[[], int]) -> Iterator[RunBatch]:
        """Yield the runs of a unit in batches.

        ``work`` is the unit.  After each run the function ``size`` is called: the batch is full if
        it has at least the returned number of runs.  The last batch may be smaller.
        """
        batch = RunBatch(self, work, ())
        for run in self.counter.runs(work.unit):
            world = self.counter.count_run(run, batch.tally)
            if world is not None:
                batch.runs.append(Due(run.number, run.place, world, self._given))
            if len(batch) >= size():
                yield batch
                batch = RunBatch(self, work, ())
        if batch.runs:
            yield batch
        else:  # worlds without a place may have been counted
            work.tally.add(batch.tally)

    def judge(self, batch: RunBatch) -> bool:
        """Judge the runs of a batch by the logs of their first play, and count the runs.

        Return True, because no log is missing.
        """
        work = batch.work
        for index, due in enumerate(batch.runs):
            one = batch.outcome(index)
            if one.outcome.violation or not one.fits:
                batch.broken.append(index)
            self.counter.count_outcome(due.world, due.place, one.outcome, batch.tally)
            if self.every:
                _, least = work.best.get(due.number, (due, one.outcome.cost))
                work.best[due.number] = due, min(least, one.outcome.cost)
        return True

    def judged(self, due: Due, log: bytes) -> Judged:
        """Return the judgement of the run ``due``, whose log is ``log``.

        Raises:
            InputError: if a user's task contradicts itself: in the player it said that the run was
                over, and asked again by the judge, it says that the run goes on.
        """
        read, rules, world = Log(log), self.rules, due.world
        episode = self.episode(world, read)
        # The log of a lost run may hold fewer choices than were due.
        lost = isinstance(episode.ending, Fault) and episode.ending.law in LOST
        choices = max(tuple(read.choices), due.script if lost else (), key=len)
        outcome = self.referee.outcome(world, episode, choices)
        if isinstance(episode.ending, Over) and not rules.task.is_over(episode.walk):
            raise InputError(
                f"over of task {show(rules.task.name)} is no function of the run: it has ended "
                f"one in {world.map}, and says now that it goes on"
            )
        fits = not self.every or are_due(due.script, read.choices, read.widths)
        return Judged(read, outcome, fits)

    def episode(self, world: World, log: Log) -> Episode:
        """The episode that follows from a log: the actions of the log are walked in ``world``.

        Raises:
            InputError: if an action that was legal in the play is illegal now, because a user's
                lighthouse has changed its answer.
        """
        rules = self.rules
        try:
            budget = rules.budget(world.map)
            return followed(log, world, budget, maps=rules.task.is_map)
        except actions.IllegalAction as error:
            if not kind_of(world.lighthouse).codes:
                raise RuntimeError(f"the log of a run is no walk in its world: {error}") from None
            raise InputError(
                f"lighthouse {show(world.lighthouse.kind)} is no function of the run: an action in "
                f"{world.map} was legal, and is not when the log is followed: {error}"
            ) from None

    # ---------------------------------------------------------------- messages

    def worlds(self, batch: RunBatch, indices: Indices) -> Message:
        """The message that tells a player to play these runs of the batch in their worlds."""
        return self.worlds_message([batch.due(index) for index in indices])

    def percepts(self, batch: RunBatch, indices: Indices, order: Indices = ()) -> Message:
        """The message that tells a player to play these runs of the batch by their percepts.

        The message holds no world.  ``order`` is the order of the play, as positions in
        ``indices``; if ``order`` is empty, the runs are played in the order of ``indices``.
        """
        return self.percepts_message([batch.record(index) for index in indices], order)

    def worlds_message(self, runs: Sequence[Due]) -> Message:
        """The message that tells a player to play these runs in their worlds."""
        task = self.rules.task
        worlds: Iterable[Any]
        if not task.ends_runs and all(each.world.lighthouse.static for each in runs):
            kind, worlds = "table", (table_of(each.world) for each in runs)
        else:
            kind, worlds = "model", ((each.world, task.over) for each in runs)
        content = [self._entry(due, world) for due, world in zip(runs, worlds, strict=True)]
        return self.message(kind, content)

    def percepts_message(self, runs: Sequence[Recorded], order: Sequence[int] = ()) -> Message:
        """The message that tells a player to play these runs by their percepts.

        ``order`` is the order of the play, as positions in ``runs``; if ``order`` is empty, the
        runs are played in the order of ``runs``.
        """
        sensed = [playing.numbers_of(each.percepts) for each in runs]
        content = [self._entry(run, s, over=run.over) for run, s in zip(runs, sensed, strict=True)]
        return self.message("record", content, order)

    def _entry(self, run: Due | Recorded, around: Any, *, over: bool = False) -> tuple[Any, ...]:
        """The entry of a run in a message to a player, a tuple of six values.

        The values are ``around``; the value that the lighthouse tells before the start; ``over``;
        the step budget; the name of the run, for a random policy; and the script.

        Args:
            run: the run.
            around: the world or the percepts of the run, in the form that its player takes.
            over: whether the task has ended the run after the last percept; the player then ends
                the run there.
        """
        rules, world = self.rules, run.world
        told: Any = world.told
        if not (told is None or type(told) is int):  # marshal writes no other mapping
            told = dict(told)
        return around, told, over, rules.budget(world.map), name_run(rules, world), run.script

    def message(self, kind: str, content: Any, order: Sequence[int] = ()) -> Message:
        """A message to a player, which asks for plays of some runs.

        Args:
            kind: the form of the runs' surroundings: ``table`` for worlds as tables of numbers,
                ``model`` for worlds as pickled objects, ``record`` for percepts.
            content: the entries, one for each run.
            order: the positions of the entries in the order in which the runs are played; if it is
                empty, the runs are played in the order of the entries.
        """
        return {
            "kind": kind,
            "content": content,
            "runs": len(content),
            "order": [*(order or range(len(content)))],
            "policy": DEFAULT_POLICY if self.every else self.rules.policy,
            "every": self.every,
            "any_answer": not self.rules.task.is_map,
            "hear": False,
            "lines": False,
        }


def table_of(world: World) -> bytes | tuple[int, ...]:
    """The table from which a player makes a :class:`allworlds.protocol.playing.TableWorld`.

    The table has five numbers for each dart: the first dart of its vertex; the other dart of its
    edge; and the percept of a robot that arrives by the dart, which is three numbers: degree,
    marks, and the bearing plus 1 (0 stands for no bearing).

    Args:
        world: a world with a static lighthouse: no action changes a percept.
    """
    map_, numbers = world.map, list[int]()
    first = _vertex_by_vertex(map_, world.start)
    position = {dart: number for number, dart in enumerate(first)}
    for dart, begin in first.items():
        after, _ = world.step(State(dart), BACK)
        p = world.percepts[dart]
        bearing = 0 if p.bearing is None else p.bearing + 1
        numbers += (begin, position[after.dart], p.degree, p.marks, bearing)
    return playing.packed(numbers)


BACK = actions.Move(0)
"""The motion through the door by which the robot came."""


@lru_cache(1)
def _vertex_by_vertex(map_: CombinatorialMap, start: Dart) -> dict[Dart, int]:
    """A new numbering of the darts, in which the darts of each vertex have successive numbers.

    The dart ``start`` has the number 0, and the numbers of a vertex go clockwise.  The keys of the
    dictionary are the darts in this order; the value of a dart is the new number of the first dart
    of its vertex.
    """
    first: dict[Dart, int] = {}
    for dart in (start, *map_.darts):
        begin, each = len(first), dart
        while each not in first:
            first[each] = begin
            each = map_.sigma[each]
    return first
