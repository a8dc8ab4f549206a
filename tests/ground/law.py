"""The law of every input, good or bad, and the one place that tries one.

Whatever is given, the command line answers with an exit code that is documented for the verb,
with lines on stderr that are its own, at most 300 characters long, and one alone where the
input is refused; with nothing on stdout where it is, and else a report, which is a document
where one was asked for.
"""

from __future__ import annotations

import io
import json
import re
import sys
import warnings
from collections.abc import Callable
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from dataclasses import dataclass, field
from pathlib import Path

from allworlds.cli.app import call

CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]|^\\s*::|##\\[", re.MULTILINE)
"""A character that a terminal obeys, and a command of the runner of a CI service."""

LONGEST = 300
"""The longest line on stderr."""

MOST_NOTICES = 3
"""Lines on stderr beside a report."""

ANSWERED, REFUSED = 0, 2
CODES = {
    "check": {0, 1, 3, 4},
    "fuzz": {0, 1, 3, 4},
    "run": {0, 1, 3},
    "replay": {0, 5},
    "ledger": {0, 1, 3, 4},
    "worst": {0, 1, 4},
    "ambiguity search": {0, 3, 4},
    "count": {0, 4},
    "ambiguity census": {0, 4},
}
"""The codes that README.md and docs/verdicts.md give a verb besides 2; others answer with 0.

Neither 70 nor 130 is among them: no input is an internal error or an interrupt.
"""


@dataclass(frozen=True)
class Case:
    """One input.

    Attributes:
        kind: what was mutated.
        arguments: of the command line.
        files: what lies in the working directory, by names.
        stdin: what can be read there.
    """

    kind: str
    arguments: tuple[str, ...]
    files: dict[str, bytes] = field(default_factory=dict)
    stdin: bytes = b""

    def __str__(self) -> str:
        files = [f"  {name}: {content[:2000]!r}" for name, content in self.files.items()]
        words = [ascii(word[:2000]) for word in self.arguments]
        return "\n".join([f"{self.kind}: {' '.join(words)}", *files, f"  stdin: {self.stdin!r}"])


@dataclass(frozen=True)
class Said:
    """The answer of the command line to an input."""

    code: int
    out: str
    err: str


def tried(case: Case, folder: Path) -> list[str]:
    """Breaches of the law with this input; the folder must be the working directory."""
    with written(case.files, folder):
        return wrong(case.arguments, said(case))


@contextmanager
def written(files: dict[str, bytes], folder: Path):
    """A context in which these files lie in the folder."""
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(content)
    try:
        yield
    finally:
        for name in files:
            (folder / name).unlink(missing_ok=True)


def said(case: Case, entry: Callable[[list[str]], int] = call) -> Said:
    """The answer of the command line, with streams like those that it prepares for itself."""
    out, err = _stream(), _stream()
    before, sys.stdin = sys.stdin, io.TextIOWrapper(io.BytesIO(case.stdin), encoding="utf-8")
    try:
        with redirect_stdout(out), redirect_stderr(err), warnings.catch_warnings():
            # As users are shown them: pytest keeps them to itself.
            warnings.simplefilter("default")
            warnings.showwarning = _show
            code = entry(list(case.arguments))
    finally:
        sys.stdin = before
    return Said(code, _text(out), _text(err))


def _show(message, category, filename, lineno, file=None, line=None) -> None:
    sys.stderr.write(warnings.formatwarning(message, category, filename, lineno, line))


def _stream() -> io.TextIOWrapper:
    return io.TextIOWrapper(io.BytesIO(), encoding="utf-8", errors="backslashreplace")


def _text(stream: io.TextIOWrapper) -> str:
    stream.flush()
    return stream.buffer.getvalue().decode()


def wrong(arguments: tuple[str, ...], told: Said) -> list[str]:
    """Breaches of the law by this answer."""
    lines = told.err.split("\n")[:-1] if told.err.endswith("\n") else told.err.split("\n")
    lines = [] if told.err == "" else lines
    found = []
    if any(line.startswith("Traceback") for line in lines):
        found.append("a traceback")
    if told.code not in codes_of(arguments):
        found.append(f"the exit code {told.code}")
    if any(not line.startswith("allworlds: ") for line in lines):
        found.append("a line on stderr that is not ours")
    if any(len(line) > LONGEST for line in lines):
        found.append("a line that is too long")
    if CONTROL.search(told.err) or CONTROL.search(told.out):
        found.append("a control character")
    if told.code == REFUSED:
        found += ["no line on stderr, or several"] * (len(lines) != 1)
        found += ["a refusal with a report"] * (told.out != "")
    else:
        found += ["too many lines on stderr"] * (len(lines) > MOST_NOTICES)
        found += _wrong_report(arguments, told.out)
    return found


def codes_of(arguments: tuple[str, ...]) -> set[int]:
    """The exit codes that are documented for what is asked."""
    verbs = [" ".join(arguments[:2]), *arguments[:1]]
    own = next((CODES[verb] for verb in verbs if verb in CODES), {ANSWERED})
    return own | {ANSWERED, REFUSED}


def _wrong_report(arguments: tuple[str, ...], out: str) -> list[str]:
    if not out.strip():
        return ["no report"]
    if "--json" not in arguments or "--help" in arguments or "--version" in arguments:
        return []
    try:
        document = json.loads(out)
    except ValueError:
        return ["a document that is no JSON"]
    whole = isinstance(document, dict) and document.get("schema") == 2 and "made_by" in document
    return [] if whole else ["a document that is none of ours"]
