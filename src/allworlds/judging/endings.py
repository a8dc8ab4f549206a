"""The ending of a run: the explorer's answer as plain integers, checked, or a fault."""

from __future__ import annotations

import json
from collections.abc import Iterable
from itertools import islice
from typing import Annotated, Any, TypeAlias

from msgspec import Meta, Struct

from allworlds.inputs import LARGEST_SIZE, are_plain, integer, let_users_interrupt, show
from allworlds.maps import CombinatorialMap, InvalidMap, numbering
from allworlds.protocol import Ambiguous, Estimate


class Answered(Struct, frozen=True):
    """The explorer has returned a well-formed estimate."""

    estimate: Estimate


class Fault(Struct, frozen=True, array_like=True, forbid_unknown_fields=True, tag="fault"):
    """The run ended without an answer.

    Attributes:
        law: ``crash``, ``timeout``, ``illegal-action``, ``no-estimate`` or ``budget``.
        expected, seen: sentences.
        detail: a traceback, or the tail of a program's stderr; may be empty.
        machine: whether the machine, not the explorer, may be the cause: a signal, a time-out, no
            memory.
    """

    law: Annotated[str, Meta(pattern=r"\A(crash|timeout|illegal-action|no-estimate|budget)\Z")]
    expected: str
    seen: str
    detail: str = ""
    machine: bool = False


class LostRun(Fault, frozen=True, tag="lost"):
    """The process of the run was lost, so its walk is not known."""


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


class Over(Struct, frozen=True, array_like=True, forbid_unknown_fields=True, tag="over"):
    """The run was ended, since all was done that the task asks for."""


class UncheckedValue(Struct, frozen=True, array_like=True, forbid_unknown_fields=True, tag="said"):
    """An answer that is no map, as it was given.

    Attributes:
        text: JSON.
    """

    text: str


Ending: TypeAlias = Answered | Undecided | Said | Over | Fault


class UncheckedAnswer(
    Struct, frozen=True, array_like=True, forbid_unknown_fields=True, tag="answer"
):
    """An answer whose integers are not checked yet.

    Attributes:
        sigma, alpha: of the map that is claimed.
        here: the dart that is claimed.
    """

    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    here: int


class UncheckedAmbiguous(UncheckedAnswer, frozen=True, tag="ambiguous"):
    """The unchecked integers of an answer that names no map.

    Attributes:
        degree, marks: of each dart.
    """

    degree: tuple[int, ...]
    marks: tuple[int, ...]


UncheckedEnding: TypeAlias = UncheckedAnswer | UncheckedAmbiguous | UncheckedValue | Over | Fault
"""How a run has ended, as a player tells it."""

MOST_DARTS = 2 * LARGEST_SIZE
"""The largest number of darts in an answer, unless twice the step budget is more."""


class TooManyDarts(ValueError):
    """Raised for a map of more darts than the robot can have walked along."""


AN_ESTIMATE = "Estimate(map, here) with a dart of the map"
"""The expectation of every answer but a quotient, as a finding states it."""

NO_MAP, BUILT = "no map: ", "built "
"""The first words of the text about a map that could not be built, and of its line of code."""

_AMBIGUOUS = "Ambiguous(sigma, alpha, degree, marks, here): a connected rooted quotient"


def ending_of(answer: object, most: int = MOST_DARTS) -> UncheckedAnswer | Fault:
    """The integers of an answer, which may be a subclass, or tampered with.

    Args:
        answer: anything.
        most: the largest number of darts that is looked at.
    """
    if type(answer) is Ambiguous:
        return _said_ambiguous(answer, most)
    if type(answer) is not Estimate:
        return Fault("no-estimate", AN_ESTIMATE, show(answer))
    try:
        claimed: object = answer.map
        if not isinstance(claimed, CombinatorialMap):
            return Fault("no-estimate", AN_ESTIMATE, f"a map that is {show(claimed)}")
        sigma, alpha = integers(claimed.sigma, most), integers(claimed.alpha, most)
        return UncheckedAnswer(sigma, alpha, integer(answer.here))
    except TooManyDarts as error:
        return Fault("no-estimate", AN_ESTIMATE, str(error))
    except BaseException as error:  # noqa: BLE001  # the parts are the explorer's code
        let_users_interrupt(error)
        return Fault("no-estimate", AN_ESTIMATE, show(answer))


def any_ending_of(answer: object, most: int = MOST_DARTS) -> UncheckedEnding:
    """The ending for a task with any answer: an estimate, or a value that JSON has."""
    if type(answer) in (Estimate, Ambiguous):
        return ending_of(answer, most)
    try:
        text = json.dumps(answer, allow_nan=False)
    except BaseException as error:  # noqa: BLE001  # the parts are the explorer's code
        let_users_interrupt(error)
        return Fault("no-estimate", "an Estimate, or an answer that JSON has", show(answer))
    return UncheckedValue(text)


def _said_ambiguous(answer: Ambiguous, most: int) -> UncheckedAnswer | Fault:
    try:
        return UncheckedAmbiguous(
            integers(answer.sigma, most),
            integers(answer.alpha, most),
            integer(answer.here),
            integers(answer.degree, most),
            integers(answer.marks, most),
        )
    except TooManyDarts as error:
        return Fault("no-estimate", _AMBIGUOUS, str(error))
    except BaseException as error:  # noqa: BLE001  # the parts are the explorer's code
        let_users_interrupt(error)
        return Fault("no-estimate", _AMBIGUOUS, show(answer))


def integers(values: Iterable[object], most: int = MOST_DARTS) -> tuple[int, ...]:
    """The values, perhaps an endless sequence, as integers.

    Raises:
        TypeError: if one is none.
        TooManyDarts: if there are more than ``most``; no more than that are asked for.
    """
    kept = values if type(values) is tuple else tuple(islice(values, most + 1))
    if len(kept) > most:
        raise TooManyDarts(f"more than {most:,} darts")
    if are_plain(kept):
        return kept  # type: ignore[return-value]
    return tuple([integer(value) for value in kept])


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
        return Fault("no-estimate", "an Estimate, or an answer that JSON has", show(ending.text))


def _undecided(ending: UncheckedAmbiguous) -> Undecided | Fault:
    if flaw := _flaw(ending):
        return Fault("no-estimate", _AMBIGUOUS, flaw)
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
