"""The common part of the documents of verbs: who made them, and how they are shown."""

from __future__ import annotations

from typing import Annotated, Any, Final, Literal

from msgspec import UNSET, Meta, UnsetType

from allworlds.document.struct import (
    Document,
    ExitCode,
    Figure,
    Positive,
    Seconds,
    Text,
    about,
    computed,
)
from allworlds.outcome import Facts

SCHEMA: Final = 2
"""The version of every document that a verb writes, and of a corpus's manifest."""


class Pictured:
    """A value that notebooks show as a picture."""

    __slots__ = ()

    def _repr_svg_(self) -> str:
        """The picture that notebooks show."""
        from allworlds.reports.drawing.svg import draw

        return draw(self).svg  # type: ignore[arg-type]  # one of the two that it draws


class Paged:
    """A value that is printed as text, and that notebooks show as a page, or as a part of one."""

    __slots__ = ()

    def __str__(self) -> str:
        """The text of the command line, 100 columns wide."""
        from allworlds.reports.notebook import text_of

        return text_of(self)  # type: ignore[arg-type]  # a report, or a part of one

    def __init_subclass__(cls, **keywords: Any) -> None:
        super().__init_subclass__(**keywords)
        # IPython takes the first class in line that has this, or a repr as dataclasses have.
        cls._repr_pretty_ = Paged._repr_pretty_  # type: ignore[method-assign]

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:  # noqa: ARG002  # IPython's call
        """Print the text in a plain IPython."""
        printer.text(str(self))

    def _repr_html_(self) -> str:
        """The element that notebooks show."""
        from allworlds.reports.notebook import shown

        return shown(self)  # type: ignore[arg-type]  # as above


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

    Who made a document, where, when and how fast: nothing else in it depends on that.
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
        tuple[Seconds, ...] | UnsetType, about("of `search`: for each of its `levels`")
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
        """Facts that the exit code depends on.

        The default stands for a question that was answered.
        """
        return Facts()

    @computed
    def exit_code(self) -> ExitCode:
        """The exit code of the command."""
        return self.facts.exit

    @property
    def seconds_by_part(self) -> dict[str, list[float]]:
        """The seconds that its parts took, by their keys in ``made_by``; by default no part."""
        return {}

    def records(self) -> list[dict[str, Any]]:
        """The rows of ``-o FILE.csv``, by the names of their columns, for ``pandas.DataFrame``."""
        from allworlds.reports.notebook import records

        return records(self)
