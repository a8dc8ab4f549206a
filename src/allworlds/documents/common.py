"""What many reports hold."""

from typing import Annotated, NotRequired, TypedDict

from allworlds.document import MadeBy
from allworlds.documents.vocabulary import ClassName, Positive, Text, Version


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
