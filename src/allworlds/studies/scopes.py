"""The scope of a report: what was asked, as it took effect, and the keys of several scopes."""

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
    """The places of a lighthouse that are tried in an extent, in words; empty: every place."""
    return kind.as_class.tried_in_maps_of(extent.levels[-1])


FileDigests: TypeAlias = Annotated[
    doc.IfAny[dict[str, doc.Text] | None], doc.about("the SHA-256 of each file of given worlds")
]
GivenCount: TypeAlias = Annotated[
    doc.IfAny[doc.Positive | None],
    doc.about("how many worlds were given; where it is left out, none"),
]


Scope_ = TypeVar("Scope_", bound=doc.Document)


def told_scope(
    kind: type[Scope_], request: requests.Request, rules: Rules | None = None, **more: Any
) -> Scope_:
    """The scope of a document: what was asked, as it took effect.

    Args:
        kind: the class of the scope.
        request: whose options stand there by their names.
        rules: in place of options of rules, if runs were judged.
        more: further keys, or other values.
    """
    keys = {*kind.__struct_fields__}
    asked = {
        one.name: requests.as_json(getattr(request, one.name))
        for one in requests.in_scope(type(request))
    }
    of_rules = rules.in_effect if rules else {}
    told = {"sha256": None, "given": None, **asked, **of_rules, **request.in_effect}
    return kind(**({name: told[name] for name in told if name in keys} | more))
