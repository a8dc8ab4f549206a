"""What a player says, read as what it may say and nothing else.

Foreign code lives in a player, and may write what it likes into the pipe to its referee.  A
pickle can name any function of any module to be called by its reader; here it can name the
types of a player's messages only.

Source: the documentation of ``pickle``, "Restricting Globals".
"""

from __future__ import annotations

import io
import pickle
from typing import Any

from allworlds.episode import Fault, Log, Said
from allworlds.inputs import InputError
from allworlds.isolation.jobs import Described, HarnessError, Played, Told
from allworlds.protocol import Percept

SAID = (Described, Played, Told, Log, Said, Fault, Percept, InputError, HarnessError)
"""The types of all messages of a player, and of their parts; besides numbers, texts, tuples."""

_KNOWN = {(kind.__module__, kind.__qualname__): kind for kind in SAID}


class Garbled(Exception):
    """No message of a player."""


class _Reader(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> Any:
        """One of the types that may be named."""
        if (module, name) not in _KNOWN:
            raise Garbled(f"{module}.{name} is no part of a message")
        return _KNOWN[module, name]


def read(words: bytes) -> Any:
    """The message.

    Raises:
        Garbled: if it is none.
    """
    try:
        return _Reader(io.BytesIO(words)).load()
    except Garbled:
        raise
    except Exception as error:  # noqa: BLE001  # whatever is made of garbage
        raise Garbled(f"what is no message: {error}") from None
