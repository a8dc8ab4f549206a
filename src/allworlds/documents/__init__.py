"""Every document that is written or read, described once.

``words``
    what narrows a type, and the narrowed types;
``worlds``, ``findings``, ``checks``, ``questions``, ``claims``, ``comparisons``, ``runs``,
``common``
    the shapes: a typed dictionary each, with a sentence for every key.

Strict types hold every ``to_json`` to them.  The JSON Schemas of the package and the reference
in ``docs/documents.md`` are written from them by ``tests/schemas/generate.py``, and compared by a
test.  The document of a new verb is a class in one of these modules.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

from allworlds.documents.checks import *
from allworlds.documents.claims import *
from allworlds.documents.common import *
from allworlds.documents.comparisons import *
from allworlds.documents.findings import *
from allworlds.documents.questions import *
from allworlds.documents.runs import *
from allworlds.documents.words import *
from allworlds.documents.worlds import *
from allworlds.verbs import VERBS


class Page(NamedTuple):
    """One schema.

    Attributes:
        root: the document; None where the schema holds nothing but parts.
        parts: what is told in it for others too, by the name of its definition.
    """

    root: Any
    parts: Mapping[str, Any] = {}


def _of_verb(document: str) -> Page:
    """The page of a verb's document: of ``two-words`` the class is ``TwoWordsReport``."""
    name = "".join(word.capitalize() for word in document.split("-"))
    return Page(globals()[f"{name}Report"])


PAGES = {verb.document: _of_verb(verb.document) for verb in VERBS} | {
    "finding": Page(FindingRead, {"written": Finding, "options": Options}),
    "world": Page(
        WorldRead, {"written": World, "rooted": Rooted, "rooted_quotient": RootedQuotient}
    ),
    "transcript": Page(
        Transcript, {"percept": Percept, "read": TranscriptRead, "percept_read": PerceptRead}
    ),
    "event": Page(Event),
    "estimate": Page(EstimateResult),
    "made-by": Page(MadeBy),
    "names": Page(
        None,
        {
            "law": LawName,
            "judged_law": JudgedLaw,
            "class": ClassName,
            "verdict": VerdictName,
            "engine": EngineName,
        },
    ),
    "manifest": Page(Manifest),
}
"""Every schema by its name: those of the verbs, then what they are built from."""

MORE_KEYS = (
    *(FindingRead, OptionsRead, PerceptRead),
    *(StartRead, MovedRead, DroppedRead, PickedRead),
)
"""What may hold other keys too, which are ignored."""
