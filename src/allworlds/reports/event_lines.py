"""The lines of a file of events: a document each."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypeAlias

from allworlds.document import SCHEMA, Document, Natural, Positive, Text, about, read_by
from allworlds.judging import FindingDocument
from allworlds.outcome import Result


class EventLine(Document):
    """One line of what `--events FILE` writes."""

    schema: Annotated[Literal[1], about("the version of the document")] = SCHEMA


class LevelEvent(EventLine):
    """A level begins."""

    event: Literal["level"] = "level"
    edges: Positive
    worlds: Annotated[Natural, about("rooted maps; of a shard about so many")]


class StageEvent(EventLine):
    """A part of another kind begins."""

    event: Literal["stage"] = "stage"
    name: Annotated[Text, about("of the part")]
    all: Annotated[Natural, about("how many are to be done")]
    of: Annotated[Text, about("what is counted")]


class ProgressEvent(EventLine):
    """Once a second: what is done of the level or stage that began last."""

    event: Literal["progress"] = "progress"
    done: Annotated[Natural, about("worlds, or what the stage counts")]


class UnitEvent(EventLine):
    """A unit is finished."""

    event: Literal["unit"] = "unit"
    unit: Annotated[Text, about("its key, `EDGES:DECISION,...`")]
    worlds: Annotated[Natural, about("rooted maps")]


class FindingEvent(EventLine):
    """A run that refutes was met in a unit that is finished."""

    event: Literal["finding"] = "finding"
    finding: Annotated[
        Any,
        read_by(FindingDocument),
        about("not confirmed yet; the report may hold a smaller one"),
    ]


class NoticeEvent(EventLine):
    """Something that the user may want to know."""

    event: Literal["notice"] = "notice"
    text: Annotated[Text, about("what stands on stderr too")]


class VerdictEvent(EventLine):
    """The end."""

    event: Literal["verdict"] = "verdict"
    report: Annotated[
        Any,
        read_by(Result),
        about("the whole report, as `--json` prints it, without `made_by`"),
    ]


Event: TypeAlias = (
    LevelEvent | StageEvent | ProgressEvent | UnitEvent | FindingEvent | NoticeEvent | VerdictEvent
)
"""One line of what `--events FILE` writes."""
