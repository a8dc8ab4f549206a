"""Every document that is written or read, described once.

``vocabulary``
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
from allworlds.documents.vocabulary import *
from allworlds.documents.worlds import *
from allworlds.verbs import VERBS


class SchemaPage(NamedTuple):
    """One schema.

    Attributes:
        root: the document; None where the schema holds nothing but parts.
        parts: what is told in it for others too, by the name of its definition.
    """

    root: Any
    parts: Mapping[str, Any] = {}


def _of_verb(document: str) -> SchemaPage:
    """The page of a verb's document: of ``two-words`` the class is ``TwoWordsDocument``."""
    name = "".join(word.capitalize() for word in document.split("-"))
    return SchemaPage(globals()[f"{name}Document"])


PAGES = {verb.document: _of_verb(verb.document) for verb in VERBS} | {
    "finding": SchemaPage(FindingRead, {"written": FindingDocument, "options": Options}),
    "world": SchemaPage(
        WorldRead, {"written": WorldDocument, "rooted": Rooted, "rooted_quotient": RootedQuotient}
    ),
    "transcript": SchemaPage(
        Transcript,
        {"percept": PerceptDocument, "read": TranscriptRead, "percept_read": PerceptRead},
    ),
    "event": SchemaPage(Event),
    "header": SchemaPage(HeaderDocument),
    "estimate": SchemaPage(EstimateResult),
    "made-by": SchemaPage(MadeBy),
    "names": SchemaPage(
        None,
        {
            "law": LawName,
            "judged_law": JudgedLaw,
            "class": ClassName,
            "verdict": VerdictName,
            "engine": EngineName,
        },
    ),
    "manifest": SchemaPage(Manifest),
}
"""Every schema by its name: those of the verbs, then what they are built from."""

MORE_KEYS = (
    *(FindingRead, OptionsRead, PerceptRead),
    *(StartRead, MovedRead, DroppedRead, PickedRead),
)
"""What may hold other keys too, which are ignored."""
