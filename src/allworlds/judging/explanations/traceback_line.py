"""The one line of a traceback, in whatever language, that tells what went wrong."""

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
"""What begins, or is in, such a line."""

FRAME = re.compile(r"^\s+at\s|^\s*File \"|^note: ")
"""What stands in a line about where, not about what."""


def telling_line(text: str) -> str:
    """The line of a traceback, or of what was written to stderr, that tells what went wrong.

    Python writes it last, others first, and then where they were, or their version.  Where no
    line looks like one it is the last; empty where there is none.
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
