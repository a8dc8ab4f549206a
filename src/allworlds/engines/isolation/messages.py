"""Messages of a player to its referee: integers and texts alone.

A user's code has a player's pipe at hand.  A pickle would let it choose the reader's calls, so
the messages are msgpack, and are read as one of a few types.  A value of another type, wherever it
stands, makes the whole message unreadable.
"""

from __future__ import annotations

from typing import Any, TypeAlias

from msgspec import Struct, ValidationError, convert, to_builtins
from msgspec.msgpack import Decoder, Encoder, Ext

from allworlds.judging import Log
from allworlds.protocol import Percept


class _Message(Struct, frozen=True, array_like=True, forbid_unknown_fields=True, tag=True):
    """An array of the name of its class and of its fields."""


class ExplorerDescription(_Message, frozen=True):
    """The keywords that the explorer takes, and the digest of its code, if it is known.

    An explorer that has a shield of its own says so, since its bound is that of a shield.
    """

    keywords: frozenset[str]
    digest: str
    has_shield: bool = False


class RunLogs(_Message, frozen=True):
    """Logs of runs, each with the number of its run, and the runs that have no more of them."""

    logs: list[tuple[int, Log]]
    finished: list[int]


class RecordLogs(_Message, frozen=True):
    """The logs of all records of a job, in their order."""

    logs: list[Log]


class StretchResult(_Message, frozen=True):
    """The number of bytes of the logs (-1: there are none), and of threads left behind."""

    size: int
    threads: int


class TraceEvent(_Message, frozen=True):
    """A part of a trace: a new schedule (None), a choice, or an action and its percept."""

    what: int | tuple[int, Percept] | None


class Refusal(_Message, frozen=True):
    """The reason why the input cannot be used: the text of an InputError."""

    text: str


class Failure(_Message, frozen=True):
    """The traceback of an error outside the user's code."""

    text: str


Message: TypeAlias = (
    ExplorerDescription | RunLogs | RecordLogs | StretchResult | TraceEvent | Refusal | Failure
)

_INTEGER, _TEXT = 1, 2


def write_message(message: Message) -> bytes:
    """The bytes of a message; unreadable where an explorer has put an object of its own into it."""
    try:
        return _ENCODER.encode(message)
    except (OverflowError, UnicodeEncodeError):
        return _ENCODER.encode(_extended(to_builtins(message, enc_hook=_no_value)))


def read_message(data: bytes) -> Message:
    """The message of these bytes, which may come from any process.

    Raises:
        ValueError: if there is none.
    """
    try:
        try:
            return _DECODER.decode(data)
        except ValidationError:
            message: Message = convert(_EXTENDED.decode(data), Message)
            return message
    except Exception as error:  # foreign bytes may cause an error of any kind
        raise ValueError("what a player has said is none of its messages") from error


def _no_value(_object: object) -> None:
    """Return None, which no reader takes for an integer or a text."""


def _extended(value: Any) -> Any:
    """A value with extension types for long integers and lone surrogates, which msgpack lacks."""
    if isinstance(value, list | tuple):
        return [_extended(each) for each in value]
    if isinstance(value, int) and value.bit_length() > 63:
        return Ext(_INTEGER, value.to_bytes(value.bit_length() // 8 + 1, signed=True))
    if isinstance(value, str) and not value.isascii():
        return Ext(_TEXT, value.encode(errors="surrogatepass"))
    return value


def _of_extension(code: int, data: memoryview) -> int | str:
    if code == _INTEGER:
        return int.from_bytes(data, signed=True)
    if code == _TEXT:
        return bytes(data).decode(errors="surrogatepass")
    raise ValueError(code)


_ENCODER = Encoder(enc_hook=_no_value)
_DECODER: Decoder[Message] = Decoder(Message)
_EXTENDED: Decoder[Any] = Decoder(ext_hook=_of_extension)
