"""Playing without a world: records, which are the percepts of an earlier play."""

from __future__ import annotations

from collections.abc import Callable, MutableSequence, Sequence
from random import Random
from typing import NamedTuple

from msgspec import Struct, field

from allworlds.judging import EndingOf, Log, any_ending_of, ending_of, perform
from allworlds.protocol import Choices, Percept, Player, Told, policy_named
from allworlds.world import IllegalAction


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
    """A runner plays an explorer in this process.

    Attributes:
        player: the explorer.
        beat: ``beat[0]`` is set to the number of each run; see
            :func:`allworlds.judging.episode.play`.
        intact: called after each play, to check the parts that the explorer may have broken.
    """

    player: Player
    beat: MutableSequence[int] = field(default_factory=lambda: [0, 0])
    intact: Callable[[], None] = lambda: None

    def play_records(self, records: Sequence[Record], policy: str, order: int) -> list[Log]:
        """The logs of these records, in their order, which is not the order of playing."""
        logs: dict[int, Log] = {}
        numbers = list(range(len(records)))
        Random(order).shuffle(numbers)  # noqa: S311  # it need not be secret for longer than a run
        for number in numbers:
            self.beat[0] = number
            record = records[number]
            choices = Choices(policy_named(policy, record.name), record.choices)
            log = perform(
                Recorded(record.percepts, record.told, record.over),
                self.player,
                choices,
                record.budget,
                self.beat,
                ended=ending_maker(any_answer=record.any_answer),
            )
            # Checkpoints are judged once, and must not influence the walk.
            logs[number] = log._replace(checkpoints=())
            self.intact()
        return [logs[number] for number in range(len(records))]
