"""Every document that is written or read, described once.

``words``
    what narrows a type, and the narrowed types;
``worlds``, ``findings``, ``checks``, ``questions``, ``common``
    the shapes: a typed dictionary each, with a sentence for every key.

Strict types hold every ``to_json`` to them.  The JSON Schemas of the package and the reference
in ``docs/documents.md`` are written from them by ``tests/schemas/generate.py``, and compared by a
test.  A new document is a class here, and an entry of :data:`PAGES`.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

from allworlds.documents.checks import *
from allworlds.documents.common import *
from allworlds.documents.findings import *
from allworlds.documents.questions import *
from allworlds.documents.words import *
from allworlds.documents.worlds import *


class Page(NamedTuple):
    """One schema.

    Attributes:
        root: the document; None where the schema holds nothing but parts.
        parts: what is told in it for others too, by the name of its definition.
    """

    root: Any
    parts: Mapping[str, Any] = {}


PAGES = {
    "check": Page(CheckReport, {"scope": Scope, "row": CheckRow}),
    "run": Page(RunReport),
    "replay": Page(ReplayReport),
    "explain": Page(Explanation),
    "mutants": Page(MutantsReport),
    "count": Page(CountReport),
    "worst": Page(WorstReport),
    "twins": Page(TwinsReport),
    "search": Page(SearchReport),
    "bench": Page(BenchReport, {"spread": Spread}),
    "ambiguity-census": Page(CensusReport),
    "ambiguity-class": Page(ClassReport),
    "finding": Page(FindingRead, {"written": Finding, "options": Options}),
    "world": Page(WorldRead, {"written": World, "rooted": Rooted}),
    "transcript": Page(
        Transcript, {"percept": Percept, "read": TranscriptRead, "percept_read": PerceptRead}
    ),
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
