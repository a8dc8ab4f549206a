"""The user's corpus: a directory of findings.

A check first tries these findings again; at its end it adds its new findings to the directory.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Any, Generic, Protocol, TypeVar

from msgspec import Struct, field

from allworlds.documents.document import Document, IfAny, Text, about
from allworlds.inputs.checks import InputError, a_path, show
from allworlds.inputs.requests import RARE_EFFORT, Option, Request
from allworlds.judging.findings.finding import DIGITS, digest_of
from allworlds.outcome import NoResult
from allworlds.protocol.user_code import OtherText


class CorpusOptions(Request):
    """The part of a request that names the directory of the user's corpus."""

    corpus: Annotated[
        str | Path | None,
        Option(
            RARE_EFFORT,
            "DIR",
            "A directory of findings, which are tried first; new ones are added to it.",
            apart=True,
        ),
    ] = None


class CorpusReport(Document):
    """The files of a corpus after a check, sorted by what the check did with their findings."""

    directory: Annotated[Text, about("the path of the corpus")]
    reproduced: Annotated[tuple[Text, ...], about("the files whose findings still stand")]
    beyond_scope: Annotated[
        tuple[Text, ...],
        about("findings that still stand but lie outside this check's scope; they refute nothing"),
    ]
    fixed: Annotated[
        tuple[Text, ...], about("the files whose worlds no longer refute; they are kept")
    ]
    stale: Annotated[
        IfAny[tuple[Text, ...]],
        about(
            "the files that were not tried: what they name has another text now, or they are of "
            "another number of robots"
        ),
    ]
    undecided: Annotated[
        IfAny[tuple[Text, ...]], about("the files that a limit of this check leaves open")
    ]
    written: Annotated[tuple[Text, ...], about("the files that this check has added")]

    @property
    def summary(self) -> str:
        """A text with the number and the names of the files of each kind."""
        found = {
            "reproduced": self.reproduced,
            "still refuted, but beyond the scope": self.beyond_scope,
            "fixed and kept": self.fixed,
            "stale and not tried": self.stale,
            "left open by a limit": self.undecided,
            "written": self.written,
        }
        named = {what: names for what, names in found.items() if names}
        counts = (f"{len(names)} {what} ({', '.join(names)})" for what, names in named.items())
        return "; ".join(counts) or "no finding"


class LeftOpen(NoResult):
    """Raised if a limit, such as the time limit, ends the retry of a finding without an answer."""


class Storable(Protocol):
    """A finding that a corpus can hold: of one robot, or of several."""

    @property
    def key(self) -> Any:
        """The value by which findings are sorted, the smallest first."""

    @property
    def text(self) -> str:
        """The text of the finding's file, in JSON."""

    @property
    def file_name(self) -> str:
        """The name of the finding's file, which contains a digest of the file's text."""


Found = TypeVar("Found", bound=Storable)


class UserCorpus(Struct, Generic[Found]):
    """A directory of findings during one check.

    Attributes:
        directory: the path, which need not exist yet.
        read: the function that makes a finding from the text of its file.
        files: the names of the files, for each key of :class:`CorpusReport`.
    """

    directory: Path
    read: Callable[[str], Found]
    files: dict[str, list[str]] = field(default_factory=lambda: defaultdict(list))
    _standing: list[Found] = field(default_factory=list)

    def retry(
        self, again: Callable[[Found], Found | None], is_inside: Callable[[Found], bool]
    ) -> list[Found]:
        """Try every recorded finding again; return those that are reproduced and in the scope.

        Each finding is tried separately, so that a lost player does not affect other findings.

        Args:
            again: a function that tries a finding again, and returns the reproduced finding, or
                None if no law is broken any more.  It raises ``OtherText`` if the finding cannot be
                tried, and ``LeftOpen`` if a limit ends the retry.
            is_inside: a function that says whether a finding is in the scope of this check.

        Raises:
            InputError: naming a file that cannot be read, has no finding, or was changed since it
                was written.
        """
        for name, finding in self._past():
            try:
                found = again(finding)
            except OtherText:
                self.files["stale"].append(name)
                continue
            except LeftOpen:
                self.files["undecided"].append(name)
                continue
            if found is None:
                self.files["fixed"].append(name)
            elif is_inside(found):
                self.files["reproduced"].append(name)
                self._standing.append(found)
            else:
                self.files["beyond_scope"].append(name)
        return self._standing

    def _past(self) -> list[tuple[str, Found]]:
        """The findings of the directory with the names of their files, smallest first.

        A file is left out, and noted in ``files["stale"]``, if a program that its finding names has
        another text now.

        Raises:
            InputError: naming a file that cannot be read, has no finding, or was changed since it
                was written.
        """
        past = list[tuple[str, Found]]()
        for file in sorted(self.directory.glob("*.json")):
            said = f"corpus file {show(file.name)}"
            if not file.is_file():
                raise InputError(f"{said} is no regular file; legal are findings")
            try:
                text = file.read_text(encoding="utf-8-sig")
            except (OSError, UnicodeDecodeError) as error:
                reason = error.strerror if isinstance(error, OSError) else "it is no text"
                raise InputError(f"{said} cannot be read: {reason}") from None
            written = re.search(rf"-([0-9a-f]{{{DIGITS}}})\.json$", file.name)
            if written and written[1] != digest_of(text):
                raise InputError(f"{said} has been changed since it was written")
            try:
                past.append((file.name, self.read(text)))
            except OtherText:
                self.files["stale"].append(file.name)
            except ValueError as error:
                raise InputError(f"{said}: {error}") from None
        return sorted(past, key=lambda each: each[1].key)

    @property
    def report(self) -> CorpusReport:
        """The part of the check's report about this corpus."""
        keys = ("reproduced", "beyond_scope", "fixed", "stale", "undecided", "written")
        files = {key: tuple(self.files[key]) for key in keys}
        return CorpusReport(directory=str(self.directory), **files)

    def holds(self, finding: Found) -> bool:
        """Whether the finding is one of the corpus's findings that this check has reproduced."""
        return finding in self._standing

    def write(self, findings: Iterable[Found]) -> Iterator[str]:
        """Write those of ``findings`` that are new; yield a message for each file that fails.

        A finding is new if this check has not reproduced it from the corpus.
        """
        for finding in findings:
            if not self.holds(finding):
                try:
                    self._write(finding)
                except OSError as error:
                    yield f"the corpus could not take {finding.file_name}: {error.strerror}"
                else:
                    self.files["written"].append(finding.file_name)

    def _write(self, finding: Found) -> None:
        """Write the file of a finding, unless the file exists already.

        The file is written completely, or not at all.
        """
        self.directory.mkdir(parents=True, exist_ok=True)
        path = self.directory / finding.file_name
        if path.exists():
            return
        with TemporaryDirectory(prefix=".allworlds-", dir=self.directory) as beside:
            draft = Path(beside) / path.name
            draft.write_text(finding.text, encoding="utf-8")
            draft.replace(path)


def corpus_of(
    named: str | Path | None, run: str | Path | None, read: Callable[[str], Found]
) -> UserCorpus[Found] | None:
    """The corpus in the directory ``named``; None if no directory is named.

    ``read`` makes a finding from the text of its file.

    Raises:
        InputError: if both a corpus and a run directory (``run``) are named.
    """
    if named is None:
        return None
    if run is not None:
        raise InputError(
            f"corpus {show(str(named))} cannot be given with run {show(str(run))}: what is in the "
            "one would change what the other keeps; give one of them"
        )
    return UserCorpus(a_path("corpus", named), read)
