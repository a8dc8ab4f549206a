"""Lines of a file of events, a document each."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypeAlias

from allworlds.document import SCHEMA, Document, Edges, Natural, Text, about, read_by
from allworlds.judging import Finding
from allworlds.outcome import Result

WHICH = about("which event it is")


class EventLine(Document):
    """One line of the file that `--events FILE` writes."""

    schema: Annotated[Literal[1], about("the version of the document")] = SCHEMA


class LevelEvent(EventLine):
    """The beginning of a level."""

    event: Annotated[Literal["level"], WHICH] = "level"
    edges: Edges
    worlds: Annotated[Natural, about("rooted maps; of a shard about so many")]


class StageEvent(EventLine):
    """The beginning of a stage of another kind."""

    event: Annotated[Literal["stage"], WHICH] = "stage"
    name: Annotated[Text, about("of the part")]
    all: Annotated[Natural, about("the number of items in the stage")]
    of: Annotated[Text, about("the items that are counted")]


class ProgressEvent(EventLine):
    """Progress of the level or stage that began last, once a second."""

    event: Annotated[Literal["progress"], WHICH] = "progress"
    done: Annotated[Natural, about("worlds, or what the stage counts")]


class UnitEvent(EventLine):
    """The end of a unit."""

    event: Annotated[Literal["unit"], WHICH] = "unit"
    unit: Annotated[Text, about("its key, `EDGES:DECISION,...`")]
    worlds: Annotated[Natural, about("rooted maps")]


class FindingEvent(EventLine):
    """A run that breaks a law, in a finished unit."""

    event: Annotated[Literal["finding"], WHICH] = "finding"
    finding: Annotated[
        Any,
        read_by(Finding),
        about("not confirmed yet; the report may hold a smaller one"),
    ]


class NoticeEvent(EventLine):
    """A message for the user."""

    event: Annotated[Literal["notice"], WHICH] = "notice"
    text: Annotated[Text, about("the line that also goes to stderr")]


class VerdictEvent(EventLine):
    """The end of the job."""

    event: Annotated[Literal["verdict"], WHICH] = "verdict"
    report: Annotated[
        Any,
        read_by(Result),
        about("the whole report, as `--json` prints it, without `made_by`"),
    ]


Event: TypeAlias = (
    LevelEvent | StageEvent | ProgressEvent | UnitEvent | FindingEvent | NoticeEvent | VerdictEvent
)
"""One line of what `--events FILE` writes."""
