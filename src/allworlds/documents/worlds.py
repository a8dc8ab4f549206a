"""Maps, worlds, and what is done and sensed in them."""

from typing import Annotated, Literal, NotRequired, TypeAlias, TypedDict

from allworlds.documents.vocabulary import (
    Begins,
    Dart,
    Keywords,
    KindsOf,
    Natural,
    Positive,
    Some,
    Text,
)

Permutation = Annotated[list[Dart], Keywords(minItems=2)]


class Map(TypedDict):
    """Map."""

    sigma: Annotated[Permutation, "for each dart the next one clockwise round its vertex"]
    alpha: Annotated[Permutation, "for each dart the other one of its edge"]


class Rooted(Map):
    """Rooted map.

    A map, and where the robot is in it.
    """

    here: Annotated[Dart, "the robot's dart"]


class RootedQuotient(TypedDict):
    """Rooted quotient.

    What a robot can know of a world that has lookalikes, and where it is in it.
    """

    sigma: Annotated[list[Dart], Some, "for each dart the next one clockwise round its vertex"]
    alpha: Annotated[
        list[Dart], Some, "for each dart the other one of its edge; of half an edge itself"
    ]
    degree: Annotated[list[Positive], Some, "for each dart the degree that is sensed there"]
    marks: Annotated[list[Natural], Some, "for each dart how many markers lie there"]
    here: Annotated[Dart, "the robot's dart"]


class LighthouseDocument(TypedDict):
    """A lighthouse that stands nowhere."""

    kind: Annotated[str, "its name"]


class AtDart(LighthouseDocument):
    """A lighthouse that stands at one dart."""

    dart: Annotated[Dart, "where it stands"]


class AtDarts(LighthouseDocument):
    """A lighthouse that stands at several darts."""

    darts: Annotated[
        list[Dart], Some, "where it stands: of a compass ascending, of labels in their order"
    ]


class InHand(LighthouseDocument):
    """A lighthouse in the robot's hand."""

    markers: Annotated[Positive, "how many markers"]
    pick: Annotated[bool, "whether one that was dropped may be taken up again"]


class WorldDocument(Map):
    """World.

    A map, a start and a lighthouse, as they are written.
    """

    start: Annotated[Dart, "the dart that the robot faces"]
    lighthouse: Annotated[
        LighthouseDocument,
        KindsOf("world:LIGHTHOUSES"),
        "its `kind`, and where it stands: see [the lighthouses](protocol.md#words)",
    ]


class LighthouseRead(TypedDict):
    """A lighthouse as it is read."""

    kind: Annotated[Text, "its name"]
    dart: NotRequired[Annotated[Dart, "where it stands; else at the first place"]]
    darts: NotRequired[
        Annotated[
            list[Dart],
            "of a compass one dart of each vertex, else the smallest; of labels, in their order",
        ]
    ]
    single: NotRequired[Annotated[bool, "of a cluster: exactly one edge joins v0 and v1"]]
    markers: NotRequired[Annotated[Positive, "of movable: how many are in hand; else 1"]]
    pick: NotRequired[Annotated[bool, "of movable: they may be taken up again; else true"]]


class WorldRead(Map):
    """World, as it is read.

    Any other key is refused.
    """

    start: NotRequired[Annotated[Dart, "the dart that the robot faces; else 0"]]
    lighthouse: NotRequired[
        Annotated[LighthouseRead, "else the explorer's own, or a directional one"]
    ]


class PerceptDocument(TypedDict):
    """Percept.

    What is sensed at a vertex.
    """

    degree: Annotated[Positive, "the number of darts"]
    marks: Annotated[Natural, "the number of markers that lie here"]
    bearing: Annotated[
        Natural | None,
        "the offset clockwise from the dart arrived by to the pointed dart; null where no "
        "direction is sensed",
    ]


class Start(TypedDict):
    """The first row of a transcript."""

    percept: Annotated[PerceptDocument, "what was sensed before any motion"]


class Moved(TypedDict):
    """A motion."""

    move: Annotated[Natural, "by how many darts clockwise the robot turned before it left"]
    percept: Annotated[PerceptDocument, "what was sensed then"]


class Dropped(TypedDict):
    """A marker laid down."""

    drop: Literal[True]
    percept: Annotated[PerceptDocument, "what was sensed then"]


class Picked(TypedDict):
    """A marker taken up."""

    pick: Literal[True]
    percept: Annotated[PerceptDocument, "what was sensed then"]


Step: TypeAlias = Moved | Dropped | Picked
Transcript = Annotated[list[Start | Moved | Dropped | Picked], Some, Begins(Start)]


class PerceptRead(TypedDict):
    """Percept, as it is read.

    Other keys are ignored.
    """

    degree: Annotated[Positive, "the number of darts"]
    marks: NotRequired[Annotated[Natural, "else 0"]]
    bearing: NotRequired[Annotated[Natural | None, "else null"]]


class StartRead(TypedDict):
    """The first row of a transcript as it is read."""

    percept: Annotated[PerceptRead, "what was sensed then"]


class MovedRead(StartRead):
    """A motion as it is read."""

    move: Annotated[int, "of any size"]


class DroppedRead(StartRead):
    """A marker laid down, as it is read."""

    drop: Literal[True]


class PickedRead(StartRead):
    """A marker taken up, as it is read."""

    pick: Literal[True]


TranscriptRead = Annotated[
    list[StartRead | MovedRead | DroppedRead | PickedRead], Some, Begins(StartRead)
]
