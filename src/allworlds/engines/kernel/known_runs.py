"""Data of runs that are played: of a world, or of a record; the kind is known to the compiler."""

from __future__ import annotations

from typing import Any, NamedTuple

from numba import int32, types
from numba.extending import overload
from numpy import int64

from allworlds.engines.kernel.calls import address_of, put_word
from allworlds.engines.kernel.records import NONE
from allworlds.engines.kernel.stretch import (
    BEARING,
    DEGREE,
    FIRST,
    MARKS,
    PARTNER,
    RUN_MOTIONS,
    WIDE,
)


class WorldRuns(NamedTuple):
    """Runs that are played in their worlds: at a dart."""

    rows: Any


class RecordedRuns(NamedTuple):
    """Runs that are played against recorded percepts: at a percept of three bytes."""

    percepts: Any
    starts: Any


def enter(known: Any, run: int) -> int:
    """The place where the run begins."""
    raise NotImplementedError


def degree_of(known: Any, run: int, place: int) -> int:
    """The degree at the place."""
    raise NotImplementedError


def sense(known: Any, run: int, place: int, percept: Any) -> None:
    """Write the percept at the place."""
    raise NotImplementedError


def go(known: Any, head: Any, run: int, place: int, motion: Any, cost: int) -> int:
    """The place behind the motion, after ``cost`` others; NONE if the first play ended here."""
    raise NotImplementedError


@overload(enter, inline="always")
def _entering(known, run):
    def world(known, run):
        return int64(0)

    def record(known, run):
        return int64(known.starts[run])

    return _either(known, world, record)


@overload(degree_of, inline="always")
def _degree(known, run, place):
    def world(known, run, place):
        return known.rows[run, WIDE * place + DEGREE]

    def record(known, run, place):
        return known.percepts[place]

    return _either(known, world, record)


@overload(sense, inline="always")
def _sensing(known, run, place, percept):
    # Degree and marks are stored at once: who copies both waits for nothing.
    def world(known, run, place, percept):
        row, at = known.rows[run], WIDE * place
        put_word(address_of(percept), int64(row[at + DEGREE]) | int64(row[at + MARKS]) << 32)
        percept[2] = int32(row[at + BEARING]) - 1

    def record(known, run, place, percept):
        sensed = known.percepts
        put_word(address_of(percept), int64(sensed[place]) | int64(sensed[place + 1]) << 32)
        percept[2] = int32(sensed[place + 2]) - 1

    return _either(known, world, record)


@overload(go, inline="always")
def _going(known, head, run, place, motion, cost):
    def world(known, head, run, place, motion, cost):
        row, spot = known.rows[run], place + motion
        degree = int64(row[WIDE * place + DEGREE])
        if spot >= int64(row[WIDE * place + FIRST]) + degree:
            spot -= degree
        return int64(row[WIDE * spot + PARTNER])

    def record(known, head, run, place, motion, cost):
        return int64(NONE) if cost == head[RUN_MOTIONS] else place + 3

    return _either(known, world, record)


def _either(known: types.NamedTuple, world: Any, record: Any) -> Any:
    """The one of the two that the type selects."""
    return world if known.instance_class is WorldRuns else record
