"""One job in a fresh process: records that are played again, or a run that is sent step by step."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple

from allworlds.engines.isolation.jobs import PlayerSetup, PlayRecords, Trace
from allworlds.engines.isolation.messages import RecordLogs, TraceEvent
from allworlds.engines.isolation.one_player import PlayerLost, receive, start_player
from allworlds.engines.isolation.process import Process, guardian
from allworlds.engines.python.examiner import name_run
from allworlds.engines.python.play import Record
from allworlds.engines.python.players import OTHER_SEED
from allworlds.inputs import InputError
from allworlds.judging import Log, Rules
from allworlds.maps import Dart
from allworlds.protocol import Percept, Transcript, action_numbered
from allworlds.world import World

MOST_CHOICES = 1000
"""The number of choices that are kept of the turn in which a run was lost: there may be no end."""


class Traced(NamedTuple):
    """A walk that was sent step by step.

    Attributes:
        transcript: the walk.
        choices: the index taken at each choice.
        settled: the darts behind which an explorer has settled a vertex, against an adversary,
            each with the number of actions before.
        lost: the way the player was lost; None if it was not.
    """

    transcript: Transcript
    choices: tuple[int, ...]
    settled: tuple[tuple[int, Dart], ...]
    lost: PlayerLost | None


def record_of(
    rules: Rules, world: World, transcript: Transcript, choices: tuple[int, ...]
) -> Record:
    """The record of a run."""
    return Record(
        tuple(transcript.percepts),
        world.told,
        choices,
        rules.budget(world.map),
        name_run(rules, world),
        any_answer=not rules.task.is_map,
        over=rules.task.over_at_the_end(world, transcript),
    )


def logs_of(
    records: tuple[Record, ...], policy: str, setup: PlayerSetup, hash_seed: int | None
) -> list[Log] | None:
    """The logs of records in a fresh process with that seed; None if it is lost."""
    try:
        with _fresh(setup, hash_seed, in_worlds=False) as player:
            player.send(PlayRecords(records, policy, 0))
            message = receive(player, setup)
    except (InputError, PlayerLost):  # an explorer may not be importable any more
        return None
    assert isinstance(message, RecordLogs)
    return message.logs


def traced(job: Trace, setup: PlayerSetup, hash_seed: int | None) -> Traced:
    """The walk of a job in a fresh process that sends every step before it can be lost."""
    steps: list[tuple[int, Percept]] = []
    choices: list[int] = []
    vertices: list[tuple[int, Dart]] = []
    settled = 0
    lost: PlayerLost | None = None
    try:
        seed = OTHER_SEED if hash_seed is None else hash_seed
        with _fresh(setup, seed, in_worlds=True) as player:
            player.send(job)
            while isinstance(message := receive(player, setup), TraceEvent):
                match message.what:
                    case None:
                        steps, choices, vertices, settled = [], [], [], 0
                    case int() as dart if message.settled:
                        vertices.append((len(steps), dart))
                    case int() as index:
                        choices.append(index)
                    case tuple() as step:
                        steps.append(step)
                        settled = len(choices)
    except InputError:
        pass  # the explorer may not be importable any more: the run was not repeated
    except PlayerLost as error:
        lost = error
    kept = choices if lost is None else choices[: settled + MOST_CHOICES]
    walk = tuple((action_numbered(number), percept) for number, percept in steps)
    return Traced(Transcript(job.world.first, walk), tuple(kept), tuple(vertices), lost)


@contextmanager
def _fresh(setup: PlayerSetup, hash_seed: int | None, *, in_worlds: bool) -> Iterator[Process]:
    player, _ = start_player(guardian(), setup, hash_seed, in_worlds=in_worlds)
    try:
        yield player
    finally:
        player.close()
