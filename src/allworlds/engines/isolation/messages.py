"""What a player says, in integers and texts alone.

Foreign code has a player's pipe at hand.  A pickle would let it choose what is called by whoever
reads it, so none of its messages names a class: they are told apart by their first word, and
looked at piece by piece.
"""

from __future__ import annotations

import io
import pickle
from typing import Any, NoReturn, TypeAlias, assert_never

from allworlds.engines.isolation.jobs import Described, HarnessError, Played, Stretched, TraceEvent
from allworlds.inputs import InputError, are_plain
from allworlds.judging import ADAPTERS_LAWS, Fault, Log, UncheckedAmbiguous, UncheckedAnswer
from allworlds.protocol import Percept

Message: TypeAlias = (
    Described | Played | Stretched | list[Log] | TraceEvent | InputError | HarnessError
)
"""Everything that a player can say."""

_LAWS = (*ADAPTERS_LAWS, "budget")


def written(message: Message) -> bytes:
    """The bytes of a message."""
    return pickle.dumps(_words(message))


def read(text: bytes) -> Message:
    """The message of these bytes, whoever wrote them.

    Raises:
        ValueError: if it is none.
    """
    try:
        return _message(*_Plain(io.BytesIO(text)).load())
    except Exception as error:  # what is no pickle can be an error of any kind
        raise ValueError("what a player has said is none of its messages") from error


class _Plain(pickle.Unpickler):
    """Integers, texts and what holds them; nothing that would have to be looked up."""

    def find_class(self, module: str, name: str) -> NoReturn:
        raise pickle.UnpicklingError(f"{module}.{name}")


def _words(message: Message) -> tuple[Any, ...]:
    match message:
        case Described(keywords, digest):
            return "described", sorted(keywords), digest
        case Played(logs, done):
            return "played", [(number, _of_log(log)) for number, log in logs], done
        case Stretched(size, threads):
            return "stretched", size, threads
        case list():
            return "again", [_of_log(log) for log in message]
        case TraceEvent((action, Percept(degree, marks, bearing))):
            return "step", action, degree, marks, bearing
        case TraceEvent(what):
            return "told", what
        case InputError():
            return "refused", str(message)
        case HarnessError():
            return "failed", str(message)
        case _:
            assert_never(message)


def _message(kind: str, *parts: Any) -> Message:
    match kind, *parts:
        case "described", keywords, digest:
            return Described(frozenset(map(_text, keywords)), _text(digest))
        case "played", logs, done:
            return Played(
                [(_integer(number), _log(*log)) for number, log in logs], [*_integers((*done,))]
            )
        case "stretched", size, threads:
            return Stretched(_integer(size), _integer(threads))
        case "again", logs:
            return [_log(*log) for log in logs]
        case "step", action, degree, marks, bearing:
            sensed = None if bearing is None else _integer(bearing)
            return TraceEvent(
                (_integer(action), Percept(_integer(degree), _integer(marks), sensed))
            )
        case "told", what:
            return TraceEvent(None if what is None else _integer(what))
        case "refused", text:
            return InputError(_text(text))
        case "failed", text:
            return HarnessError(_text(text))
        case _:
            raise ValueError(kind)


def _of_log(log: Log) -> tuple[Any, ...]:
    match log.ending:
        case UncheckedAmbiguous(sigma, alpha, here, degree, marks):
            ending: tuple[Any, ...] = (sigma, alpha, here, (degree, marks))
        case UncheckedAnswer(sigma, alpha, here):
            ending = (sigma, alpha, here)
        case Fault(law, expected, seen, detail, machine):
            ending = (law, expected, seen, detail, machine)
    return log.actions, log.checkpoints, ending, log.choices, log.widths


def _log(actions: Any, shown: Any, ending: Any, choices: Any, widths: Any) -> Log:
    checkpoints = tuple(
        [
            (_integer(steps), _integers(sigma), _integers(alpha), _integer(here))
            for steps, sigma, alpha, here in shown
        ]
    )
    return Log(
        _integers(actions), checkpoints, _ending(*ending), _integers(choices), _integers(widths)
    )


def _ending(*parts: Any) -> UncheckedAnswer | Fault:
    if len(parts) == 3:
        sigma, alpha, here = parts
        return UncheckedAnswer(_integers(sigma), _integers(alpha), _integer(here))
    if len(parts) == 4:
        sigma, alpha, here, (degree, marks) = parts
        return UncheckedAmbiguous(
            *(_integers(sigma), _integers(alpha), _integer(here)),
            *(_integers(degree), _integers(marks)),
        )
    law, expected, seen, detail, machine = parts
    if law not in _LAWS or not isinstance(machine, bool):
        raise ValueError(law)
    return Fault(law, _text(expected), _text(seen), _text(detail), machine)


def _integer(value: Any) -> int:
    if type(value) is not int:
        raise TypeError(value)
    return value


def _integers(values: Any) -> tuple[int, ...]:
    if type(values) is not tuple or not are_plain(values):
        raise TypeError(values)
    return values


def _text(value: Any) -> str:
    if type(value) is not str:
        raise TypeError(value)
    return value
