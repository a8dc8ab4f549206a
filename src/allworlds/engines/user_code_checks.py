"""Checks that the user's conditions and lighthouses give the same answers in fresh processes.

A condition must select the same maps in each process.  On the walk of a finding a lighthouse must
tell the robot the same value before the start, and give the same percepts.
"""

from collections.abc import Sequence
from random import sample
from typing import Any

from allworlds.engines import limits, player, players
from allworlds.explorers.loading import load
from allworlds.inputs.checks import InputError, show
from allworlds.judging.findings.finding import Finding
from allworlds.maps.classes import Extent
from allworlds.world.lighthouses.kinds import kind_of

PROCESSES = 8
"""The number of fresh processes, each with a hash seed of its own.

A condition that tosses one coin in each process gives the same answer in all processes with
probability 1/128.
"""

SMALL, DRAWN = 4, 16
"""The largest m of the levels of which all units are checked; the number of units of each larger
level that are drawn at random and checked."""


def ensure_same_worlds(extent: Extent | None, units: Sequence[Any], deadline: float | None) -> None:
    """Raise InputError unless the condition of the extent selects the same maps in all processes.

    Without an extent, or without a condition of the user, nothing is checked.

    Args:
        extent: the class of the maps with the condition; or None.
        units: the units whose maps are compared.
        deadline: the end of the time limit, on the monotonic clock; or None.

    Raises:
        InputError: if the condition does not select the same maps, or if it fails.
        TimeIsUp: when the time limit has been reached.
    """
    where: Any = extent and extent.where
    if not units or not getattr(where, "codes", ()):
        return
    said = f"where {show(where.name)}"
    maps = _answers_of_processes("maps", (extent, units), len(units), said, deadline)
    for number, unit in enumerate(units):
        if len({each[number] for each in maps}) > 1:
            raise InputError(
                f"{said} is no function of the map: asked in {PROCESSES} processes, it is not true "
                f"of the same maps of the unit {unit.key}"
            )


def ensure_same_senses(finding: Finding) -> None:
    """Raise InputError unless a user's lighthouse again gives what a finding has recorded.

    Several fresh processes make the world of the finding anew, and follow the walk of the finding.
    In each process the lighthouse must tell the robot the recorded value before the start, and give
    the recorded percepts.  Nothing is checked if the lighthouse is not a user's.
    """
    world, transcript = finding.world, finding.transcript
    kind = kind_of(world.lighthouse)
    if not kind.codes:
        return
    said = f"lighthouse {show(kind.name)}"
    answers = _answers_of_processes("walk", (world, transcript.actions), 1, said, None)
    if {bytes(each[0]) for each in answers} != {player.in_bytes(world.told, transcript)}:
        raise InputError(
            f"{said} is no function of its map and place: asked again in {PROCESSES} processes, "
            f"{world.lighthouse} senses or tells something else on the walk of a finding in "
            f"{world.map}"
        )


def _answers_of_processes(
    kind: str, content: Any, number: int, said: str, deadline: float | None
) -> list[Any]:
    """The answers of :data:`PROCESSES` fresh processes to one message.

    Each answer is a list of byte strings, its items.  For the kind ``maps`` an item is the digest
    of the maps of one unit; item i belongs to unit i.  For the kind ``walk`` the only item holds
    the value that the lighthouse tells before the start, and the percepts of the walk.

    Args:
        kind: the kind of the message: ``maps`` or ``walk``.
        content: for ``maps`` the extent and the list of units; for ``walk`` the world and the list
            of actions.
        number: the number of items in an answer.  Each process computes the items in a random
            order, which does not change their places in the answer.
        said: the words by which error messages name the user's code.
        deadline: the end of the time limit, on the monotonic clock; or None.

    Raises:
        TimeIsUp: when the time limit has been reached.
        InputError: if a process is lost, or if the user's condition or lighthouse fails in one.
    """
    patient = limits.Limits(answer_timeout=limits.MOST["answer-timeout"])
    setup = players.Setup(load("algorithm1"), patient)
    others = [players.PlayerProcess(setup, seed) for seed in range(PROCESSES)]
    answers = list[Any]()
    try:
        for other in others:
            order = sample(range(number), number)
            other.give(None, {"kind": kind, "content": content, "runs": number, "order": order})
        while len(answers) < len(others):
            players.wait(others, limits.POLL)
            answers += [logs for other in others for _, logs in other.heard()]
            limits.check_deadline(deadline)
    except players.Lost as lost:
        raise InputError(f"{said}: a process that asked it came to {lost.seen}") from None
    finally:
        for other in others:
            other.close()
    return answers
