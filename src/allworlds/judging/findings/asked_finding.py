"""Findings as they are asked for: a file, or a directory of them."""

from __future__ import annotations

import hashlib
import json
import re
from pathlib import Path
from typing import Annotated, NamedTuple

from msgspec import Struct

from allworlds.inputs.checks import InputError, in_file, integer_of, parse_json, read_text, show
from allworlds.inputs.requests import SCOPE, Argument, Named, Option, Request
from allworlds.judging.findings.finding import Finding, findings_of
from allworlds.protocol.user_code import OtherText


class ChosenFinding(NamedTuple):
    """A finding, its number in its report, from 1 on, and the number of findings there."""

    finding: Finding
    number: int = 1
    findings: int = 1


class FindingWords(Request):
    """The argument and options of the command line that name a finding."""

    file: Annotated[str, Argument("", "FILE", "A finding, or a check's report; - for stdin.")]
    number: Annotated[
        int,
        Option(
            SCOPE,
            "K",
            "Which finding of a report: 1 is the smallest.",
            "finding",
            parse=integer_of,
        ),
    ] = 1

    def chosen(self) -> ChosenFinding:
        """The finding of that number in the file.

        Raises:
            InputError: naming the file, the offending value in it, or the number.
        """
        document = parse_json(read_text(self.file), file=self.file)
        with in_file(self.file):
            found = findings_of(document)
        if not 1 <= self.number <= len(found):
            holds = f"findings 1 to {len(found)}" if len(found) > 1 else "1 finding"
            raise InputError(f"finding = {self.number} is not there: the file holds {holds}")
        with in_file(self.file):
            finding = Finding.from_json(found[self.number - 1])
        return ChosenFinding(finding, self.number, len(found))

    def value(self) -> Finding:
        """The chosen finding alone, without its number."""
        return self.chosen().finding


class AskedFinding(Request, kw_only=False):
    """The part of a request that names a finding."""

    finding: Annotated[Finding, Named(FindingWords, "the finding")]


DIGITS = 12
"""The hexadecimal digits of the digest in a file's name."""


class KeptFinding(Struct, frozen=True):
    """A finding with the name of its file."""

    name: str
    finding: Finding


class FindingsOfDirectory(NamedTuple):
    """The findings of a directory, smallest first.

    Attributes:
        kept: those that can be tried again.
        stale: the names of the files whose lighthouse or judge has another text now.
    """

    kept: list[KeptFinding]
    stale: list[str]


def kept_findings(directory: Path) -> FindingsOfDirectory:
    """The findings of a directory; there are none if there is no directory yet.

    Raises:
        InputError: naming the file that cannot be read, is no finding, or has been changed
            since it was written.
    """
    past, stale = list[KeptFinding](), list[str]()
    for file in sorted(directory.glob("*.json")):
        try:
            text = file.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            reason = error.strerror if isinstance(error, OSError) else "it is no text"
            raise InputError(f"corpus file {show(file.name)} cannot be read: {reason}") from None
        written = re.search(rf"-([0-9a-f]{{{DIGITS}}})\.json$", file.name)
        if written and written[1] != _digest(text):
            raise InputError(f"corpus file {show(file.name)} has been changed since it was written")
        try:
            finding = Finding.from_json(text)
        except OtherText:
            stale.append(file.name)
            continue
        except ValueError as error:
            raise InputError(f"corpus file {show(file.name)}: {error}") from None
        past.append(KeptFinding(file.name, finding))
    return FindingsOfDirectory(sorted(past, key=lambda one: (one.finding.key, one.name)), stale)


def write_finding(directory: Path, finding: Finding) -> str:
    """Write a finding, unless it is there already; return the name of its file."""
    directory.mkdir(parents=True, exist_ok=True)
    text = _text(finding)
    name = file_name(finding)
    path = directory / name
    if not path.exists():
        # Whole or not at all: a reader never sees half a finding.
        draft = path.with_suffix(".tmp")
        try:
            draft.write_text(text, encoding="utf-8")
            draft.replace(path)
        except OSError:
            draft.unlink(missing_ok=True)
            raise
    return name


def file_name(finding: Finding) -> str:
    """The name ``LAW-mMnN-DIGEST.json``."""
    map_ = finding.world.map
    size = f"m{map_.edge_count}n{map_.vertex_count}"
    return f"{finding.law}-{size}-{_digest(_text(finding))}.json"


def _text(finding: Finding) -> str:
    return json.dumps(finding.to_json(), indent=1) + "\n"


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:DIGITS]
