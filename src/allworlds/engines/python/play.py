"""Playing: the runs of a unit in their worlds, and records without a world."""

from __future__ import annotations

from collections.abc import Callable, Iterator, MutableSequence, Sequence
from random import Random
from typing import NamedTuple

from msgspec import Struct, field

from allworlds.engines.python.examiner import name_run
from allworlds.engines.python.run_counter import RunCounter
from allworlds.engines.python.runs_of_unit import NumberedRun, UnitOfRuns
from allworlds.judging import EndingOf, Log, any_ending_of, ending_of, perform
from allworlds.protocol import Choices, Percept, Player, Told, policy_named
from allworlds.world import IllegalAction, World


class Record(NamedTuple):
    """The inputs of a run that is played again: of its world, the percepts alone.

    Attributes:
        percepts: at the start, and after each action of the first play.
        told: by the lighthouse before the start, or None.
        choices: answers to the choices.
        budget: the largest legal number of traversals.
        name: of the run, for a random policy.
        any_answer: the task asks for no estimate.
        over: the first play was ended since all was done, and so is this one.
    """

    percepts: Sequence[Percept]
    told: Told
    choices: tuple[int, ...]
    budget: int
    name: str
    any_answer: bool = False
    over: bool = False


RECORD_ENDS = "nothing: the record ends here"
"""The expectation at the end of the recorded percepts of an explorer."""


class Recorded:
    """An environment in place of a world: answers every action with the next recorded percept.

    The state, which is a world's elsewhere, is the number of the step.
    """

    def __init__(self, percepts: Sequence[Percept], told: Told, over: bool = False) -> None:
        self.initial, self.first, self.told = 0, percepts[0], told
        self.over = over and len(percepts) == 1
        self._percepts, self._ends = percepts, over

    def step(self, state: int, _action: object) -> tuple[int, Percept]:
        """The next percept.

        Raises:
            IllegalAction: past the end of the record.
        """
        if state + 1 == len(self._percepts):
            raise IllegalAction(RECORD_ENDS)
        self.over = self._ends and state + 2 == len(self._percepts)
        return state + 1, self._percepts[state + 1]


def ending_maker(*, any_answer: bool) -> EndingOf:
    """Return what makes an ending of an answer: of an estimate alone, or of any."""
    return any_ending_of if any_answer else ending_of


class ExplorerRunner(Struct):
    """A runner plays runs of an explorer in this process.

    Attributes:
        player: the explorer.
        beat: ``beat[0]`` is set to the number of each run; see
            :func:`allworlds.judging.episode.play`.
        intact: called after each play, to check the parts that the explorer may have broken.
        second: the explorer as it is played once more, if that is another way.
    """

    player: Player
    beat: MutableSequence[int] = field(default_factory=lambda: [0, 0])
    intact: Callable[[], None] = lambda: None
    second: Player | None = None
    _unit: UnitOfRuns | None = None
    _runs: Iterator[NumberedRun] = field(default_factory=lambda: iter(()))
    _next: int = 0

    def play_runs(
        self,
        engine: RunCounter,
        unit: UnitOfRuns,
        numbers: Sequence[int],
        order: int,
        script: tuple[int, ...] | None = None,
    ) -> Iterator[tuple[int, Log | None]]:
        """Yield the logs of these runs, each with its number; None behind the last of a run.

        Args:
            engine: the scope, with its rules.
            unit: the unit.
            numbers: of the runs, ascending.
            order: seed of the order.
            script: the choices to be made; None for every schedule that the scope asks for.
        """
        scope, rules = engine.scope, engine.scope.rules
        placed = self._find(engine, unit, numbers)
        Random(order).shuffle(placed)  # noqa: S311  # it need not be secret for longer than a run
        for number, world in placed:
            self.beat[0] = number
            name = name_run(rules, world)
            budget = rules.budget(world.map)
            every = [rules.choices(name, script)] if script is not None else scope.schedule(name)
            for choices in every:
                log = perform(
                    rules.task.environment(world),
                    self.player,
                    choices,
                    budget,
                    self.beat,
                    ended=ending_maker(any_answer=not rules.task.is_map),
                )
                self.intact()
                yield number, log
            yield number, None

    def play_records(
        self, records: Sequence[Record], policy: str, order: int, *, plain: bool = False
    ) -> list[Log]:
        """The logs of these records, in their order, which is not the order of playing.

        If ``plain``, they are played as in the first play.
        """
        player = self.player if plain or self.second is None else self.second
        logs: dict[int, Log] = {}
        numbers = list(range(len(records)))
        Random(order).shuffle(numbers)  # noqa: S311  # as above
        for number in numbers:
            self.beat[0] = number
            record = records[number]
            choices = Choices(policy_named(policy, record.name), record.choices)
            log = perform(
                Recorded(record.percepts, record.told, record.over),
                player,
                choices,
                record.budget,
                self.beat,
                ended=ending_maker(any_answer=record.any_answer),
            )
            # Checkpoints are judged once, and must not influence the walk.
            logs[number] = log._replace(checkpoints=())
            self.intact()
        return [logs[number] for number in range(len(records))]

    def _find(
        self, engine: RunCounter, unit: UnitOfRuns, numbers: Sequence[int]
    ) -> list[tuple[int, World]]:
        """The worlds of these runs; going on in a unit costs nothing."""
        if unit != self._unit or not numbers or numbers[0] < self._next:
            self._unit, self._next = unit, 0
            self._runs = engine.runs(unit)
        wanted = set(numbers)
        found: list[tuple[int, World]] = []
        while len(found) < len(wanted):
            run = next(self._runs)
            self._next = run.number + 1
            if run.number in wanted:
                assert run.lighthouse is not None
                found.append((run.number, World(run.map, run.lighthouse, 0)))
        return found
