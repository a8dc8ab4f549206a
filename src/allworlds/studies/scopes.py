"""The scope of a report, with the values that took effect, and keys that several scopes share."""

from typing import Annotated, Any, TypeAlias, TypeVar

from allworlds.documents import document as doc
from allworlds.inputs import requests
from allworlds.judging.rules import Rules
from allworlds.maps import classes
from allworlds.world.lighthouses.kinds import LighthouseKind

TriedPlaces = Annotated[
    doc.IfAny[doc.Text | None],
    doc.about("the places of the lighthouse that were tried; where it is left out, every one"),
]
"""A key of every scope with a lighthouse."""


def tried_places(kind: LighthouseKind, extent: classes.Extent) -> str:
    """The tried places of a lighthouse in an extent, in words; empty if all places are tried."""
    return kind.as_class.tried_in_maps_of(extent.levels[-1])


FileDigests: TypeAlias = Annotated[
    doc.IfAny[dict[str, doc.Text] | None], doc.about("the SHA-256 of each file of given worlds")
]
GivenCount: TypeAlias = Annotated[
    doc.IfAny[doc.Positive | None],
    doc.about("how many worlds were given; where it is left out, none"),
]


Scope_ = TypeVar("Scope_", bound=doc.Document)


def as_scope(
    kind: type[Scope_], request: requests.Request, rules: Rules | None = None, **more: Any
) -> Scope_:
    """Return a request's scope as a document, with the values that took effect.

    Args:
        kind: the class of the document.
        request: the request; the keys are the names of its options.
        rules: the rules of the runs, which replace the options of rules; None: no run was judged.
        more: the values of further keys, or other values of keys of the request.
    """
    asked = {
        one.name: requests.as_json(getattr(request, one.name))
        for one in requests.in_scope(type(request))
    }
    of_rules = rules.in_effect if rules else {}
    values = {"sha256": None, "given": None, **asked, **of_rules, **request.in_effect}
    return kind(**({key: values[key] for key in values if key in kind.__struct_fields__} | more))
