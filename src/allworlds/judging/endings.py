"""The ending of a run: the explorer's answer, checked, or a fault."""

from __future__ import annotations

import json
from typing import Any, TypeAlias

from msgspec import Struct

from allworlds.inputs.checks import show
from allworlds.maps.canonical import numbering
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.protocol.answers import Ambiguous, Estimate
from allworlds.protocol.playing import A_QUOTIENT, A_VALUE, AN_ESTIMATE, NO_MAP


class Answered(Struct, frozen=True):
    """The explorer has returned a well-formed estimate."""

    estimate: Estimate


class Fault(Struct, frozen=True):
    """The run ended without an answer.

    Attributes:
        law: ``crash``, ``timeout``, ``illegal-action``, ``no-estimate`` or ``budget``.
        expected, seen: sentences.
        detail: a traceback, or the tail of a program's stderr; may be empty.
        machine: whether the machine, not the explorer, may be the cause: a signal, a time-out, no
            memory.
    """

    law: str
    expected: str
    seen: str
    detail: str = ""
    machine: bool = False


class Undecided(Struct, frozen=True):
    """The explorer has returned a well-formed rooted quotient, and no map.

    Attributes:
        quotient: its permutations are valid, and ``here`` is one of its darts.
    """

    quotient: Ambiguous


class Said(Struct, frozen=True):
    """The explorer has returned an answer that is no map, where any answer may be given.

    Attributes:
        value: as JSON has it.
    """

    value: Any


class Over(Struct, frozen=True):
    """The run was ended, since all was done that the task asks for."""


class UncheckedValue(Struct, frozen=True):
    """An answer that is no map, as it was given.

    Attributes:
        text: JSON.
    """

    text: str


Ending: TypeAlias = Answered | Undecided | Said | Over | Fault


class UncheckedAnswer(Struct, frozen=True):
    """An answer whose integers are not checked yet.

    Attributes:
        sigma, alpha: of the map that is claimed.
        here: the dart that is claimed.
    """

    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    here: int


class UncheckedAmbiguous(UncheckedAnswer, frozen=True):
    """The unchecked integers of an answer that names no map.

    Attributes:
        degree, marks: of each dart.
    """

    degree: tuple[int, ...]
    marks: tuple[int, ...]


UncheckedEnding: TypeAlias = UncheckedAnswer | UncheckedAmbiguous | UncheckedValue | Over | Fault
"""How a run has ended, as a player tells it."""


def answered(ending: UncheckedEnding) -> Ending:
    """The ending for an answer: a fault unless it is a map or a quotient with one of its darts."""
    if isinstance(ending, Fault | Over):
        return ending
    if isinstance(ending, UncheckedValue):
        return _said_value(ending)
    if isinstance(ending, UncheckedAmbiguous):
        return _undecided(ending)
    try:
        map_ = CombinatorialMap(ending.sigma, ending.alpha)
    except InvalidMap as error:
        return Fault("no-estimate", AN_ESTIMATE, f"{NO_MAP}{error}", error.tried)
    here = ending.here
    if here not in map_.darts:
        last = len(map_.sigma) - 1
        return Fault(
            "no-estimate", AN_ESTIMATE, f"here = {show(here)}, but the darts are 0..{last}"
        )
    return Answered(Estimate(map_, here))


def _said_value(ending: UncheckedValue) -> Said | Fault:
    try:
        return Said(json.loads(ending.text))
    except (ValueError, RecursionError):
        return Fault("no-estimate", A_VALUE, show(ending.text))


def _undecided(ending: UncheckedAmbiguous) -> Undecided | Fault:
    if flaw := _flaw(ending):
        return Fault("no-estimate", A_QUOTIENT, flaw)
    return Undecided(
        Ambiguous(ending.sigma, ending.alpha, ending.degree, ending.marks, ending.here)
    )


def _flaw(said: UncheckedAmbiguous) -> str:
    """The reason why the answer is no rooted quotient; empty if it is one."""
    size = len(said.sigma)
    for name, values in (("alpha", said.alpha), ("degree", said.degree), ("marks", said.marks)):
        if len(values) != size:
            return f"{name} has {len(values)} entries, and sigma {size}"
    for name, values in (("degree", said.degree), ("marks", said.marks)):
        for value in values:
            if value.bit_length() > 63:
                return f"{name} holds {show(value)}, which is sensed nowhere"
    if said.here not in range(size):
        return f"here = {show(said.here)}, but the darts are 0..{size - 1}"
    for name, values in (("sigma", said.sigma), ("alpha", said.alpha)):
        if sorted(values) != list(range(size)):
            return f"{name} = {show(list(values))} is no permutation of 0..{size - 1}"
    if any(said.alpha[other] != dart for dart, other in enumerate(said.alpha)):
        return f"alpha = {show(list(said.alpha))} is no involution"
    reached = len(numbering(said.sigma, said.alpha, said.here))
    return "" if reached == size else f"only {reached} of {size} darts are reached from here"
