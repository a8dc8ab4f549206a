"""What many reports hold, and who made them."""

from typing import Annotated, NotRequired, TypedDict

from allworlds.documents.vocabulary import (
    ClassName,
    Figure,
    Keywords,
    Positive,
    Seconds,
    Text,
    Version,
)


class Host(TypedDict):
    """A machine, and what runs on it."""

    name: Annotated[str, "in its network"]
    system: Annotated[str, "its operating system"]
    machine: Annotated[str, "its architecture"]
    processor: Annotated[str, "the model"]
    cores: Annotated[Positive | None, "of all processors"]
    load: Annotated[Figure, "how many processes wanted a core, over the last minute"]
    python: Annotated[Text, "the version of Python"]
    numba: Annotated[Text, "the version of the compiler"]


class MadeBy(TypedDict):
    """Made by.

    Who made a document, where, when and how fast: nothing else in it depends on that.
    """

    version: Annotated[Text, "of this program"]
    command: Annotated[list[str], "the words of the command line, as they were given"]
    workers: Annotated[Positive | None, "processes or threads; null: the verb takes none"]
    host: Annotated[Host, "where it ran"]
    started: Annotated[
        str, Keywords(pattern="^[0-9-]{10}T[0-9:]{8}Z$"), "when the command began, in UTC"
    ]
    seconds: Annotated[Seconds, "from then until this document was written"]
    level_seconds: NotRequired[Annotated[list[Seconds], "of `search`: for each of its `levels`"]]
    claim_seconds: NotRequired[Annotated[list[Seconds], "of `claims`: for each of them"]]


class ReportDocument(TypedDict):
    """What a verb writes."""

    schema: Version
    made_by: NotRequired[Annotated[MadeBy, "in Python; always there on the command line"]]


class InRows(ReportDocument):
    """What a verb writes that goes on row by row."""

    complete: Annotated[bool, "every row is there; false: the user has interrupted"]


OfClass = TypedDict("OfClass", {"class": Annotated[ClassName, "the class of maps"]})


class ExtentDocument(OfClass):
    """A class and its bounds."""

    edges: Annotated[Positive | None, "at most so many; null: not bounded"]
    vertices: Annotated[Positive | None, "at most so many; null: not bounded"]


class Gate(TypedDict):
    """A count gate."""

    source: Annotated[Text, "the independent source of the counts"]
    agrees: Annotated[bool, "each count is the source's"]
