"""The one kind of error that is the user's to mend, and how a bad value is shown in it."""

from __future__ import annotations

import json
from typing import Any

SHOWN = 200
"""The number of characters of a value that are shown."""


class InputError(ValueError):
    """Bad input: one line that names the offending value and what would be legal."""


def show(value: object) -> str:
    """A short text for any object, also for one whose repr fails."""
    try:
        text = str.__str__(repr(value))
    except BaseException:  # noqa: BLE001  # repr may be anybody's code
        return f"an object of type {type(value).__name__} whose repr fails"
    return text if len(text) <= SHOWN else text[: SHOWN - 3] + "..."


def parse_json(text: str, kind: type[InputError] = InputError) -> Any:
    """The value of a JSON text.

    Raises:
        InputError: of the kind that was asked for, if it is none.
    """
    try:
        return json.loads(text)
    except (ValueError, RecursionError) as error:
        raise kind(f"not JSON: {show(str(error))[1:-1]}") from None
