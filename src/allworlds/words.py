"""Numbers and lists in words, for all sentences that a person reads."""

import re
from collections.abc import Sequence

_MISLEADING = re.compile(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\xad\u061c\u180e\u200b-\u200f\u2028-\u202e"
    "\u2060-\u206f\ufeff\ufff9-\ufffb\U0001d173-\U0001d17a\U000e0000-\U000e007f]"
)
"""Characters that control a terminal or the direction of text, or that are invisible; tabs and the
ends of lines are excluded."""

COMMAND = re.compile(r"(?<![^\r\n])[^\S\r\n]*::|##(?:vso)?\[")
"""The beginning of a command for the runner of a CI service, in a wide sense: ``::`` at the start
of a line, also after a carriage return; ``##[`` and ``##vso[`` anywhere."""


def escaped(text: str) -> str:
    r"""The text in which an escape such as ``\x1b`` replaces each control or invisible character.

    An escape has the form that Python's ``ascii`` gives: ``\x``, ``\u`` or ``\U``, and the number
    of the character.  Tabs and the ends of lines stay.  Texts contain words from explorers and
    files; a reader must be able to see all their characters.
    """
    return _MISLEADING.sub(lambda found: ascii(found[0])[1:-1], text)


def harmless(text: str) -> str:
    """The :func:`escaped` text, changed so that no line is a command for a CI service's runner."""
    return COMMAND.sub(lambda found: f"{found[0][:-1]}\\x{ord(found[0][-1]):02x}", escaped(text))


def harmless_json(text: str) -> str:
    """A JSON text of the same value as ``text``, without a command for a CI service's runner."""
    return re.sub(r"(?<=##)\[|(?<=##vso)\[", r"\\u005b", text)


def number(value: int) -> str:
    """The number with its thousands separated."""
    return f"{value:,}"


def plural(count: int, one: str, many: str = "") -> str:
    """A number with its noun, such as ``1 world`` or ``2 worlds``.

    ``one`` is the singular of the noun, ``many`` the plural; if ``many`` is empty, the plural is
    the singular with an ``s``.
    """
    return f"{number(count)} {one if count == 1 else many or one + 's'}"


def ended_by(code: int) -> str:
    """Words for the return code of a process: ``exit code 1``, or ``signal 11`` for -11."""
    return f"exit code {code}" if code >= 0 else f"signal {-code}"


def size(edges: int, vertices: int) -> str:
    """Words for the size of a map, such as ``1 edge and 2 vertices``."""
    return f"{plural(edges, 'edge')} and {plural(vertices, 'vertex', 'vertices')}"


def listed(names: Sequence[str]) -> str:
    """The names in one text: ``a``, ``a and b``, or ``a, b and c``."""
    *others, last = names
    return f"{', '.join(others)} and {last}" if others else last


def about(value: int) -> str:
    """The number in digits; if there are more than 15, a short form such as ``6.3 x 10^76``."""
    digits = str(value)
    if len(digits) <= 15:
        return number(value)
    return f"{digits[0]}.{digits[1]} x 10^{len(digits) - 1}"


def duration(seconds: float) -> str:
    """A number of seconds in words: ``12 s``, ``5 min``, ``3 h 20 min``, ``4 days 3 h``.

    The time is rounded down, and has at most two units.  A number of years has two significant
    digits; a million million years or more are ``more than 1,000,000,000,000 years``.
    """
    whole = int(seconds)
    minutes, hours, days = whole // 60, whole // 3600, whole // 86400
    if minutes == 0:
        return f"{whole} s"
    if hours == 0:
        return f"{minutes} min"
    if days == 0:
        return f"{hours} h {minutes % 60} min"
    if days < 2 * 365:
        return f"{plural(days, 'day')} {hours % 24} h"
    years = days // 365
    if years >= 10**12:
        return "more than 1,000,000,000,000 years"
    step = 10 ** max(0, len(str(years)) - 2)
    return f"{number(years // step * step)} years"


def counted(source: str) -> str:
    """Words that say that the enumerated number equals the number from the source ``source``."""
    return f"the number equals an independent count ({source})"
