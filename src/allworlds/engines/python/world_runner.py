"""Playing in worlds: the runs of a unit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from random import Random

from msgspec import Struct, field

from allworlds.engines.python.examiner import name_run
from allworlds.engines.python.play import ExplorerRunner, ending_maker
from allworlds.engines.python.run_counter import RunCounter
from allworlds.engines.python.runs_of_unit import NumberedRun, UnitOfRuns
from allworlds.judging import Log, perform
from allworlds.world import World


class WorldRunner(Struct):
    """A runner plays runs of an explorer in this process, each in its world.

    Attributes:
        runner: plays the explorer.
    """

    runner: ExplorerRunner
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
            self.runner.beat[0] = number
            name = name_run(rules, world)
            budget = rules.budget(world.map)
            every = [rules.choices(name, script)] if script is not None else scope.schedule(name)
            for choices in every:
                log = perform(
                    rules.task.environment(world),
                    self.runner.player,
                    choices,
                    budget,
                    self.runner.beat,
                    ended=ending_maker(any_answer=not rules.task.is_map),
                )
                self.runner.intact()
                yield number, log
            yield number, None

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
