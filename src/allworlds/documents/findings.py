"""A finding, and the options that it was found under."""

from typing import Annotated, Literal, NotRequired, TypeAlias, TypedDict

from allworlds.documents.vocabulary import Different, JudgedLaw, LawName, Natural, Positive, Text
from allworlds.documents.worlds import Rooted, Transcript, TranscriptRead, WorldDocument, WorldRead

Value: TypeAlias = Rooted | int | str
"""What was expected, or seen: rooted maps for map and pose, integers for bound, else a sentence."""


class Options(TypedDict):
    """Options of a run.

    How it was played and judged.
    """

    policy: Annotated[Text, "who answered the explorer's choices"]
    bound: Annotated[Text, "the bound on the traversals; `none` where the law was not checked"]
    step_budget: Annotated[Positive | None, "the largest legal number of traversals; null: default"]
    laws: Annotated[list[JudgedLaw], Different, "those that were checked"]


class OptionsRead(TypedDict, total=False):
    """The options of a finding that is read."""

    policy: Annotated[Text, "else `fifo`"]
    bound: Annotated[Text, "else the explorer's own, or the lighthouse's"]
    step_budget: Annotated[Positive | None, "else the default"]
    laws: Annotated[list[JudgedLaw], Different, "else all that apply"]


class FindingDocument(TypedDict):
    """Finding.

    A refuting run, as it is written: enough to replay it with nothing else.
    """

    version: Annotated[Literal[1], "the version of findings"]
    explorer: Annotated[str, "its name"]
    law: Annotated[LawName, "the broken law"]
    world: Annotated[WorldDocument, "in canonical numbering: the start is dart 0"]
    options: Annotated[Options, "how the run was played and judged"]
    choices: Annotated[
        list[Natural],
        "the index taken at each choice; of a turn that never ended the first 1000",
    ]
    transcript: Annotated[Transcript, "the log"]
    expected: Annotated[
        Value, "a rooted map for `map` and `pose`, an integer for `bound`, else a sentence"
    ]
    seen: Annotated[Value, "the same of what was found"]
    confirmed: Annotated[bool, "a fresh process did the same, from the recorded percepts alone"]
    minimal: Annotated[bool, "no smaller world of the scope refutes"]
    reproduce: Annotated[Text, "a shell command that runs it again"]
    step: NotRequired[
        Annotated[Natural, "how many steps came before the checkpoint that breaks the law"]
    ]
    detail: NotRequired[Annotated[Text, "a traceback, or the end of a program's stderr"]]


class FindingRead(TypedDict):
    """Finding, as it is read.

    Other keys are ignored, but not in its world.
    """

    version: Annotated[Literal[1], "the version of findings"]
    explorer: Annotated[str, "its name"]
    law: Annotated[LawName, "the broken law"]
    world: Annotated[WorldRead, "in any numbering"]
    options: NotRequired[Annotated[OptionsRead, "else those that are the default"]]
    choices: NotRequired[Annotated[list[Natural], "else none"]]
    transcript: Annotated[TranscriptRead, "the log, which must be a walk in the world"]
    confirmed: NotRequired[Annotated[bool, "else false"]]
    minimal: NotRequired[Annotated[bool, "else false"]]
    reproduce: NotRequired[Annotated[str, "not looked at"]]
    step: NotRequired[Annotated[Natural | None, "else null"]]
    detail: NotRequired[Annotated[str, "else empty"]]
