"""A report: the document that a verb writes, and the program and machine that made it."""

from __future__ import annotations

from typing import Annotated, Any, Final, Literal

from msgspec import UNSET, Meta, UnsetType

from allworlds.documents.document import Document, Figure, Positive, Seconds, Text, about, computed
from allworlds.documents.shown import Paged, writers
from allworlds.outcome import Exit, Facts

ExitCode = Annotated[Exit, about("the exit code of the command")]

SCHEMA: Final = 2
"""The version of every document that a verb writes, and of a corpus's manifest."""


class Host(Document):
    """Host.

    A machine and its software.
    """

    name: Annotated[str, about("in its network")]
    system: Annotated[str, about("its operating system")]
    machine: Annotated[str, about("its architecture")]
    processor: Annotated[str, about("the model")]
    cores: Annotated[Positive | None, about("of all processors")]
    load: Annotated[Figure, about("processes that wanted a core, averaged over the last minute")]
    python: Annotated[Text, about("the version of Python")]
    numba: Annotated[Text | None, about("the version of the compiler; null: there is none")]


class MadeBy(Document, kw_only=True):
    """Made by.

    The program, the command and the machine that made a document, with the date and the seconds.
    All other keys of the document are independent of the machine and of the time.
    """

    version: Annotated[Text, about("of this program")]
    command: Annotated[tuple[str, ...], about("the words of the command line, as they were given")]
    defaults: Annotated[
        dict[str, dict[str, Any]] | UnsetType,
        about("the options that a file gave, by the file; left out: every option was given so"),
    ] = UNSET
    workers: Annotated[Positive | None, about("processes or threads; null: the verb takes none")]
    host: Annotated[Host, about("the machine and its software")]
    started: Annotated[
        str,
        Meta(
            description="when the command began, in UTC",
            pattern="^[0-9-]{10}T[0-9:]{8}Z$",
        ),
    ]
    seconds: Annotated[Seconds, about("from the beginning until this document was written")]
    level_seconds: Annotated[
        tuple[Seconds, ...] | UnsetType, about("for each level: of `search`, `check`, `fuzz`")
    ] = UNSET
    claim_seconds: Annotated[
        tuple[Seconds, ...] | UnsetType, about("of `claims`: for each of them")
    ] = UNSET


class Report(Paged, Document, kw_only=True):
    """A document that a verb writes."""

    schema: Annotated[Literal[2], about("the version of the document")] = SCHEMA
    made_by: Annotated[MadeBy | UnsetType, about("in Python; always there on the command line")] = (
        UNSET
    )

    @property
    def facts(self) -> Facts:
        """The facts on which the exit code depends, such as that a law is broken.

        This base class returns no such fact, so that the exit code is 0; classes with a verdict
        override the method.
        """
        return Facts()

    @computed
    def exit_code(self) -> ExitCode:
        """The exit code of the command."""
        return self.facts.exit

    @property
    def seconds_by_part(self) -> dict[str, list[float]]:
        """A dictionary from a key of :class:`MadeBy` to the seconds that each part of the job took.

        In a report of levels the key is ``level_seconds``, with a number for each level; in a
        report of claims the key is ``claim_seconds``, with a number for each claim.  By default the
        dictionary is empty.
        """
        return {}

    def records(self) -> list[dict[str, Any]]:
        """The rows of the file that ``-o FILE.csv`` writes, each as a dictionary by column.

        ``pandas.DataFrame`` takes such a list.
        """
        return writers().records(self)
