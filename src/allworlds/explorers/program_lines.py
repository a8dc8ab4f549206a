"""The lines between this program and a user's program, as values.

To it: ``{"episode": 1, "percept": P}`` (with ``"told"`` if there is something to tell), then
``{"percept": P}`` after each action.  From it: ``{"move": k}``, ``{"drop": true}``,
``{"pick": true}``, ``{"write": k}``, ``{"checkpoint": {...}}`` (unanswered) or
``{"estimate": {"sigma", "alpha", "here"}}`` or
``{"ambiguous": {"sigma", "alpha", "degree", "marks", "here"}}``, or ``{"answer": VALUE}`` where
the task is not ``map``.  Unknown keys are ignored by both sides.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple, TypeAlias

from allworlds.inputs import SHOWN, show
from allworlds.maps import CombinatorialMap, InvalidMap
from allworlds.protocol import (
    Action,
    Ambiguous,
    Checkpoint,
    Estimate,
    ExplorerFault,
    Percept,
    Told,
    action_from_json,
)

SAYINGS = ("move", "drop", "pick", "write", "checkpoint", "estimate", "ambiguous", "answer")
"""A line of the program has exactly one of these keys."""

SHORT = 64
"""Lines of fewer bytes, as most are, are parsed once."""


class EpisodeEnd(NamedTuple):
    """The answer of an episode, which is over."""

    answer: object


Message: TypeAlias = Action | Checkpoint | EpisodeEnd
"""A line of the program, as a value."""


# ---------------------------------------------------------------- to the program


def beginning(number: int, first: Percept, told: Told) -> bytes:
    """The line that begins an episode."""
    heard = b"" if told is None else b'"told": %b, ' % json.dumps(told).encode()
    return b'{"episode": %d, ' % number + heard + answering(first)[1:]


@lru_cache(maxsize=1 << 12)
def answering(percept: Percept) -> bytes:
    """The line that answers an action."""
    return json.dumps({"percept": percept.to_json()}).encode() + b"\n"


# ---------------------------------------------------------------- from the program


def message_of(line: bytes) -> Message:
    """The message of a line.

    Raises:
        ExplorerFault: if it is no line of the protocol, or what it says is malformed.
    """
    action = _short_action(line) if len(line) < SHORT else None
    return _message_of(line) if action is None else action


@lru_cache(maxsize=1 << 12)
def _short_action(line: bytes) -> Action | None:
    """The action of a short line; None if the line must be parsed more carefully."""
    try:
        message = json.loads(line)
    except (ValueError, RecursionError):
        return None
    one = isinstance(message, dict) and _sayings(message) == 1
    return action_from_json(message) if one else None


def _message_of(line: bytes) -> Message:
    message = _object_of(line)
    if (said := _sayings(message)) != 1:
        keys = f"it has {said or 'none'} of the keys {', '.join(SAYINGS)}, and needs one"
        raise _illegal(f"the line {_short(message)}: {keys}")
    action = action_from_json(message)
    if action is not None:
        return action
    if "checkpoint" in message:
        return _checkpoint(message["checkpoint"])
    if "estimate" in message:
        return EpisodeEnd(_estimate(message["estimate"]))
    if "ambiguous" in message:
        return EpisodeEnd(_ambiguous(message["ambiguous"]))
    if "answer" in message:
        return EpisodeEnd(message["answer"])
    legal = "move takes an integer, write one from 0 on, drop and pick take true"
    raise _illegal(f"the line {_short(message)}: {legal}")


def _object_of(line: bytes) -> dict[str, Any]:
    try:
        message = json.loads(line)
    except (ValueError, RecursionError):
        raise _illegal(f"a line that is no JSON: {shown(line)}") from None
    if not isinstance(message, dict):
        raise _illegal(f"a line that is no object: {shown(line)}")
    return message


def _sayings(message: dict[str, Any]) -> int:
    """The number of keys of :data:`SAYINGS` in a message."""
    return sum(key in message for key in SAYINGS)


def _illegal(seen: str) -> ExplorerFault:
    return ExplorerFault("illegal-action", seen)


def _checkpoint(value: object) -> Checkpoint:
    if not isinstance(value, dict):
        raise ExplorerFault("illegal-action", f"a checkpoint that is no object: {_short(value)}")
    if missing := _missing(value):
        raise ExplorerFault("illegal-action", f"a checkpoint without {missing}: {_short(value)}")
    return Checkpoint(value["sigma"], value["alpha"], value["here"])


def _estimate(value: object) -> Estimate:
    if not isinstance(value, dict):
        raise ExplorerFault("no-estimate", f"an estimate that is no object: {_short(value)}")
    if missing := _missing(value):
        raise ExplorerFault("no-estimate", f"an estimate without {missing}: {_short(value)}")
    try:
        return Estimate(CombinatorialMap.from_json(value), value["here"])
    except InvalidMap as error:
        raise ExplorerFault("no-estimate", f"no map: {error}", error.tried) from None


def _ambiguous(value: object) -> Ambiguous:
    if not isinstance(value, dict):
        raise ExplorerFault("no-estimate", f"a quotient that is no object: {_short(value)}")
    if missing := _missing(value, ("sigma", "alpha", "degree", "marks", "here")):
        raise ExplorerFault("no-estimate", f"a quotient without {missing}: {_short(value)}")
    return Ambiguous(*(value[key] for key in ("sigma", "alpha", "degree", "marks", "here")))


def _missing(value: dict[str, Any], keys: Sequence[str] = ("sigma", "alpha", "here")) -> str:
    """The missing keys of a checkpoint or an answer, in words."""
    return " and ".join(key for key in keys if key not in value)


def _short(value: object) -> str:
    try:
        text = json.dumps(value)
    except (RecursionError, ValueError):  # nested too deeply, or an integer too long
        return show(value)
    return text if len(text) <= SHOWN else text[: SHOWN - 3] + "..."


def shown(line: bytes | bytearray) -> str:
    """A line as it is shown: its beginning, quoted."""
    return repr(line[:SHOWN].decode(errors="replace"))
