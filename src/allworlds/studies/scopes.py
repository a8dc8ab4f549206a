"""The function that makes the scope of a report, and the types of keys that many scopes have.

These keys are the places of the lighthouse that were tried, and the number and the files of given
worlds.
"""

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
"""The type of a key that names, in words, the places of the lighthouse that were tried."""


def tried_places(kind: LighthouseKind, extent: classes.Extent) -> str:
    """Words about the places of a lighthouse of the kind ``kind`` that are tried in an extent.

    The text is empty if all places are tried in every map.
    """
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
    """Return the scope of a request as a document, with the values that took effect.

    A value that took effect may differ from the value in the request: for example the explorer's
    own lighthouse took effect if the request names none.

    Args:
        kind: the class of the document.
        request: the request; each key that has the name of an option gets the option's value.
        rules: the rules of the runs; their values replace those of the request.  None: no run was
            judged.
        more: further values, each with its key; they replace all other values of these keys.
    """
    asked = {
        one.name: requests.as_json(getattr(request, one.name))
        for one in requests.in_scope(type(request))
    }
    of_rules = rules.in_effect if rules else {}
    values = {"sha256": None, "given": None, **asked, **of_rules, **request.in_effect}
    return kind(**({key: values[key] for key in values if key in kind.__struct_fields__} | more))
