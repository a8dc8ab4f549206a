"""A user's corpus: a directory of findings, each named by what it holds."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path

from allworlds.checker.finding import Finding
from allworlds.checker.laboratory import Laboratory
from allworlds.checker.scope import Limits, Picked, Scope
from allworlds.errors import InputError
from allworlds.maps.classes import Bounds, MapClass
from allworlds.subjects import Subject

DIGITS = 12
"""The hexadecimal digits of the digest in a file's name."""


@dataclass(frozen=True, slots=True)
class PastFinding:
    """A finding with the name of its file."""

    name: str
    finding: Finding


@dataclass(slots=True)
class Past:
    """A directory of findings in the course of one check.

    Attributes:
        directory: need not exist yet.
        reproduced: the files whose findings still stand.
        fixed: the files whose worlds are no longer refuting; they are kept.
        written: the files that this check has added.
    """

    directory: Path
    reproduced: list[str] = field(default_factory=list)
    fixed: list[str] = field(default_factory=list)
    written: list[str] = field(default_factory=list)
    _standing: list[Finding] = field(default_factory=list)

    def retry(self, subject: Subject, limits: Limits) -> list[Finding]:
        """Run the explorer in every recorded world under its rules: what still refutes it.

        Each finding is tried by itself, so that one that kills its worker does no harm.
        """
        for past in past_findings(self.directory):
            found = _retry(past.finding, subject, limits)
            if found is None:
                self.fixed.append(past.name)
            else:
                self.reproduced.append(past.name)
                self._standing.append(found)
        return self._standing[: limits.max_findings]

    def holds(self, finding: Finding) -> bool:
        """The finding is one of the past that still stands, and has been confirmed."""
        return finding in self._standing

    def write(self, findings: Iterable[Finding]) -> None:
        """Add the findings that are new."""
        for finding in findings:
            if not self.holds(finding):
                self.written.append(write_finding(self.directory, finding))

    def to_json(self) -> dict[str, object]:
        """As it stands in a report."""
        return {
            "directory": str(self.directory),
            "reproduced": self.reproduced,
            "fixed": self.fixed,
            "written": self.written,
        }


def _retry(finding: Finding, subject: Subject, limits: Limits) -> Finding | None:
    map_ = finding.world.map
    # A recorded schedule other than the policy's own is met when all are tried.
    every = subject.takes_choices and finding.rules.policy == "fifo" and any(finding.choices)
    bounds = Bounds(MapClass.MAPS, map_.edge_count)
    scope = Scope(bounds, finding.rules, "all" if every else "one")
    laboratory = Laboratory(scope, subject, replace(limits, max_findings=1))
    with laboratory.open() as pool:
        for tally in laboratory.examine(pool, [Picked(((finding.world, finding.place),))]):
            for found in tally.findings:
                return laboratory.confirmed(found)
    return None


def past_findings(directory: Path) -> list[PastFinding]:
    """The findings of a directory, smallest first; an empty list where there is none yet.

    Raises:
        InputError: naming the file that cannot be read, is no finding, or has been changed
            since it was written.
    """
    past = []
    for file in sorted(directory.glob("*.json")):
        try:
            text = file.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(f"corpus file {file.name!r} cannot be read: {error}") from None
        written = re.search(rf"-([0-9a-f]{{{DIGITS}}})\.json$", file.name)
        if written and written[1] != _digest(text):
            raise InputError(f"corpus file {file.name!r} has been changed since it was written")
        try:
            finding = Finding.from_json(text)
        except ValueError as error:
            raise InputError(f"corpus file {file.name!r}: {error}") from None
        past.append(PastFinding(file.name, finding))
    return sorted(past, key=lambda one: (one.finding.key, one.name))


def write_finding(directory: Path, finding: Finding) -> str:
    """Write a finding, unless it stands there already; the name of its file."""
    directory.mkdir(parents=True, exist_ok=True)
    text = _text(finding)
    name = file_name(finding)
    path = directory / name
    if not path.exists():
        # Whole or not at all: a reader never sees half a finding.
        draft = path.with_suffix(".tmp")
        draft.write_text(text, encoding="utf-8")
        draft.replace(path)
    return name


def file_name(finding: Finding) -> str:
    """``LAW-mMnN-DIGEST.json``."""
    map_ = finding.world.map
    size = f"m{map_.edge_count}n{map_.vertex_count}"
    return f"{finding.law}-{size}-{_digest(_text(finding))}.json"


def _text(finding: Finding) -> str:
    return json.dumps(finding.to_json(), indent=1) + "\n"


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:DIGITS]
