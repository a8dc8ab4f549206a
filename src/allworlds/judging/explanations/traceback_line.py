"""The one line of a traceback, in any language, that names the error."""

from __future__ import annotations

import re

PYTHON = "Traceback (most recent call last):"

TELLING = re.compile(
    r"""(\b\w*(Error|Exception)\b.*:)  # Node, Java, Ruby, C#
    |(^panic:)                         # Go
    |(\bpanicked\ at\b)                # Rust
    |(^\s*what\(\):)                   # C++
    |(\bAssertion\b.*\bfailed\b)        # C
    |(^(fatal|Segmentation\ fault|Aborted|Killed)\b)
    """,
    re.VERBOSE | re.IGNORECASE,
)
"""The words at the beginning of that line, or in it."""

FRAME = re.compile(r"^\s+at\s|^\s*File \"|^note: ")
"""The words in a line about the place of an error, not about the error."""


def telling_line(text: str) -> str:
    """The line of a traceback, or of a text on stderr, that names the error.

    Python writes this line last, other languages first, followed by places, or a version.  If no
    line looks like one, it is the last line; empty if there is none.
    """
    lines = [line for line in text.split("\n") if line.strip()]
    if not lines:
        return ""
    if any(line.startswith(PYTHON) for line in lines):
        return next((line for line in reversed(lines) if line[0] != " "), lines[-1]).strip()
    for i in reversed(range(len(lines))):
        if TELLING.search(lines[i]) and not FRAME.search(lines[i]):
            # Rust tells where on this line, and what on the next.
            after = lines[i + 1 : i + 2] if lines[i].endswith(":") else []
            return " ".join(line.strip() for line in [lines[i], *after])
    return lines[-1].strip()
