"""Predicates of the user's, asked again in fresh processes: each must make the same worlds."""

from collections.abc import Sequence
from random import sample
from typing import Any

from allworlds.engines import limits, players
from allworlds.explorers.loading import load
from allworlds.inputs.checks import InputError, show
from allworlds.maps.classes import Extent

PROCESSES = 8
"""The number of fresh processes, each with a hash seed of its own.  A predicate that goes by one
coin in each process is the same in all of them once in 128 times."""

SMALL, DRAWN = 4, 16
"""The largest m whose units are all asked about, and the number of units of a larger level."""


def ensure_same_worlds(extent: Extent | None, asked: Sequence[Any], deadline: float | None) -> None:
    """Raise InputError unless fresh processes make the same maps of each of these units.

    Raises:
        TimeIsUp: when the time limit has been reached.
    """
    where: Any = extent and extent.where
    if not asked or not getattr(where, "codes", ()):
        return
    patient = limits.Limits(answer_timeout=limits.MOST["answer-timeout"])
    setup, said = players.Setup(load("algorithm1"), patient), f"where {show(where.name)}"
    others = [players.PlayerProcess(setup, seed) for seed in range(PROCESSES)]
    try:
        for other in others:
            order = sample(range(len(asked)), len(asked))
            message = {"kind": "maps", "rows": (extent, asked), "runs": len(asked), "order": order}
            other.give(None, message)
        maps = list[Any]()
        while len(maps) < len(others):
            players.wait(others, limits.POLL)
            maps += [logs for other in others for _, logs in other.heard()]
            limits.check_deadline(deadline)
    except players.Lost as lost:
        raise InputError(f"{said}: a process that asked it came to {lost.seen}") from None
    finally:
        for other in others:
            other.close()
    for number, unit in enumerate(asked):
        if len({each[number] for each in maps}) > 1:
            raise InputError(
                f"{said} is no function of the map: asked in {PROCESSES} processes, it is not true "
                f"of the same maps of the unit {unit.key}"
            )
