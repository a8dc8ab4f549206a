"""JSON Schemas of all documents, made from the documents' classes.

``python -m allworlds.reports.schemas DIRECTORY`` writes one file for each document; the build of
the package does so.  Every file is complete in itself: the types to which it refers stand under
its key ``$defs``.
"""

import json
import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import MISSING, fields as fields_of_dataclass, is_dataclass
from functools import cache
from inspect import unwrap
from pathlib import Path
from pkgutil import resolve_name
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, TypeAlias, Union, get_args, get_origin, get_type_hints

from msgspec import UNSET, Meta, Struct, UnsetType, defstruct
from msgspec.json import schema_components
from msgspec.structs import fields

from allworlds import outcome, verbs
from allworlds.documents import document as doc
from allworlds.documents.report import MadeBy
from allworlds.engines.engine_table import ENGINES
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.law_table import JUDGED, PRECEDENCE
from allworlds.maps.classes import MapClass
from allworlds.protocol import actions
from allworlds.studies.check.time_estimate import TimeEstimate
from allworlds.studies.run import WorldNames
from allworlds.world import named, world
from allworlds.world.lighthouses import kinds, options
from allworlds.world.lighthouses.base import Lighthouse

Schema: TypeAlias = dict[str, Any]

DRAFT = "https://json-schema.org/draft/2020-12/schema"

WRITTEN_AS = {
    world.World: world.WorldDocument,
    actions.Estimate: actions.RootedMap,
    Path: doc.Text,
}
"""For each type that JSON does not have, the type of the JSON that is written for its values."""


class OwnLighthouse(Struct):
    """Lighthouse of the user's own.

    The JSON object has further keys: those fields of the user's class that users cannot set by an
    option of ``--lighthouse``, for example the dart at which the lighthouse stands.
    """

    kind: Annotated[doc.Text, doc.about("the name by which it is found")]
    options: Annotated[dict[str, Any], doc.about("those that are no defaults")]
    digest: Annotated[doc.Text, doc.about("of the text of its code")]


READ = {"finding", "world", "transcript", "manifest"}
"""The documents that this program also reads; their schemas allow all that the program accepts."""

NAMES: dict[str, tuple[str, Iterable[Any]]] = {
    "law": ("Law", PRECEDENCE),
    "judged_law": ("Judged law", JUDGED),
    "class": ("Class of maps", MapClass),
    "verdict": ("Verdict", outcome.Verdict),
    "engine": ("Engine", ENGINES),
}
"""The tables of names: for each the title of its schema, and the names."""


@cache
def reports() -> dict[str, Any]:
    """The types of all reports, by the names of their schemas."""
    found: dict[str, Any] = {}
    for verb in verbs.VERBS:
        if reports_of(verb) != [Any]:  # merge hands on that of another verb
            first, *others = reports_of(verb)
            found[verb.document] = first
            found |= {other.__name__.lower(): other for other in others}
    return found | {"estimate": TimeEstimate, "worldnames": WorldNames}


def reports_of(verb: verbs.Verb) -> list[Any]:
    """The types of the reports that a verb may return."""
    function = unwrap(resolve_name(verb.path))
    return [*members(get_type_hints(function)["return"])]


@cache
def pages() -> dict[str, Any]:
    """The types of the documents that have a schema, by the names of the schemas.

    The reports come first, and then the other documents, such as a finding or a world.
    """
    merged = dict.fromkeys(kind for verb in verbs.VERBS if verb.swept for kind in reports_of(verb))
    return reports() | {
        "merge": Union[tuple(merged)],  # noqa: UP007  # of as many as there are
        "finding": Finding,
        "world": world.WorldDocument,
        "transcript": actions.Transcript,
        "made-by": MadeBy,
        "manifest": named.Manifest,
    }


# ---------------------------------------------------------------- types that msgspec knows


class Shapes:
    """The types in the schema of one document, in the form in which the library msgspec takes them.

    Attributes:
        written: True if the schema describes a document that this program writes: all keys that are
            always written are required, and no other keys are allowed. False if the schema
            describes a document that this program reads: only keys without a default are required,
            and other keys are allowed if the program accepts them.
        also: the schemas of those types that msgspec cannot describe, by the names of the types;
            they are added to the schema of the document.
    """

    def __init__(self, *, written: bool) -> None:
        self.written = written
        self.also: dict[str, Any] = {}
        self._made: dict[Any, Any] = {}

    def of(self, tp: Any) -> Any:
        """The type of the JSON for values of the type ``tp``, as a type that msgspec can describe.

        For example, for ``Path`` the result is the type of a text.
        """
        if get_origin(tp) is Annotated:
            base, *notes = get_args(tp)
            kind = next((n.extra["kind"] for n in notes if n.extra and "kind" in n.extra), base)
            shown = [note for note in notes if not note.extra]
            inner = self.of(kind)
            for note in shown:
                if values := (note.extra_json_schema or {}).get("enum"):
                    inner = Literal[*map(doc.plain, values)]
                    shown.remove(note)
            return Annotated[inner, *shown] if shown else inner
        if tp in WRITTEN_AS:
            return self.of(WRITTEN_AS[tp])
        if tp is actions.Transcript:
            return self._transcript()
        if tp is Lighthouse:
            ours = [self._lighthouse(kind) for kind in kinds.LIGHTHOUSES.values()]
            return self._one_of([*ours, OwnLighthouse])
        if isinstance(tp, type) and issubclass(tp, doc.Document | doc.WrittenByFields):
            return self._struct(tp)
        arguments = get_args(tp)
        if get_origin(tp) in (Union, UnionType):
            return self._union(arguments)
        if not arguments or get_origin(tp) is Literal:
            return tp
        origin = list if get_origin(tp) is Sequence else get_origin(tp)
        return origin[*(arg if arg is ... else self.of(arg) for arg in arguments)]

    def _union(self, arguments: tuple[Any, ...]) -> Any:
        shown = [self.of(arg) for arg in arguments if arg is not UnsetType]
        objects = [arg for arg in shown if arg in self._made.values()]
        if len(objects) < 2:
            return Union[tuple(shown)]  # noqa: UP007
        return self._one_of(objects, null=NoneType in shown)

    def _struct(self, kind: Any) -> Any:
        if kind not in self._made:
            closed = issubclass(kind, doc.Document) and kind.__struct_config__.forbid_unknown_fields
            self._made[kind] = self._defined(
                kind.__name__, kind.__doc__, self._keys(kind), closed=closed
            )
        return self._made[kind]

    def _keys(self, kind: Any) -> Iterator[tuple[str, Any, bool]]:
        """Yield for each key of an object of the type ``kind``: name, type, whether required."""
        hints = get_type_hints(kind, include_extras=True)
        if is_dataclass(kind):
            for field in fields_of_dataclass(kind):
                yield field.name, hints[field.name], self.written or field.default is MISSING
            return
        needed = {field.name for field in fields(kind) if field.required}
        for key in doc.keys_of(kind):
            tp = key.type
            bare = get_args(tp)[0] if get_origin(tp) is Annotated else tp
            sometimes = key.if_any or UnsetType in members(bare)
            must = not sometimes and (self.written or key.attribute in needed)
            yield key.name, tp, must

    def _defined(
        self, name: str, doc: str, keys: Iterable[tuple[str, Any, bool]], *, closed: bool = True
    ) -> Any:
        shown = [(key, self.of(tp), must) for key, tp, must in keys]
        fields = [(key, tp) if must else (key, tp | UnsetType, UNSET) for key, tp, must in shown]
        return defstruct(
            name,
            fields,
            kw_only=True,
            forbid_unknown_fields=self.written or closed,
            namespace={"__doc__": doc},
            module=__name__,
        )

    def _lighthouse(self, kind: type[Lighthouse]) -> Any:
        hints = get_type_hints(kind, include_extras=True)
        named: Any = Annotated[Literal[kind.kind], doc.about("which lighthouse it is")]
        keys: list[tuple[str, Any, bool]] = [("kind", named, True)]
        keys += [
            (key, hints[key], self.written and doc.IF_ANY not in get_args(hints[key])[1:])
            for key in options.place_keys(kind)
        ]
        self._made[kind] = self._defined(f"{kind.__name__}Lighthouse", kind.__doc__ or "", keys)
        return self._made[kind]

    def _transcript(self) -> Any:
        first, *rest = (
            self._struct(row)
            for row in (
                actions.AtStart,
                actions.Moved,
                actions.Dropped,
                actions.Picked,
                actions.Wrote,
            )
        )
        self.also |= {row.__name__: row for row in (first, *rest)}
        return Annotated[
            list[Any],
            Meta(
                min_length=1,
                extra_json_schema={
                    "prefixItems": [_reference(first)],
                    "items": {"anyOf": [*map(_reference, rest)]},
                },
            ),
        ]

    def _one_of(self, objects: list[Any], *, null: bool = False) -> Any:
        self.also |= {one.__name__: one for one in objects}
        options = [*map(_reference, objects), *([{"type": "null"}] if null else [])]
        return Annotated[Any, Meta(extra_json_schema={"anyOf": options})]


def members(tp: Any) -> tuple[Any, ...]:
    """The types of a union; for any other type, this type alone."""
    return get_args(tp) if get_origin(tp) in (Union, UnionType) else (tp,)


def _reference(struct: Any) -> Schema:
    return {"$ref": f"#/$defs/{struct.__name__}"}


# ---------------------------------------------------------------- schemas


def schema_of(tp: Any, *, written: bool = True) -> tuple[Schema, dict[str, Schema]]:
    """The schema of a type, and the schemas to which it refers, by their names.

    If ``written`` is True, the schema is for documents that this program writes; if False, for
    documents that it reads, see :class:`Shapes`.
    """
    shapes = Shapes(written=written)
    root = shapes.of(tp)
    (found, *_), parts = schema_components(
        [root, *shapes.also.values()], ref_template="#/$defs/{name}"
    )
    return _plain(found), {name: _plain(part) for name, part in parts.items()}


def page(name: str) -> Schema:
    """The schema of the document with this name.

    If this program also reads the document, the schema allows all that the program accepts.
    """
    found, parts = schema_of(pages()[name], written=name not in READ)
    if found.keys() == {"$ref"}:
        found = parts.pop(found["$ref"].rpartition("/")[2])
    more = {"$defs": parts} if parts else {}
    return {**_head(name), "title": name.capitalize(), **found, **more}


def schemas() -> dict[str, Schema]:
    """The schemas of all documents, by their names, and one more schema, ``names``.

    Under the key ``$defs`` the schema ``names`` has the tables :data:`NAMES`, which list the legal
    names of laws, classes of maps, verdicts and engines.
    """
    parts: Schema = {}
    for name, (title, table) in NAMES.items():
        entries = [*table]
        parts[name] = {"title": title, "enum": [str(entry) for entry in entries]}
        if all(hasattr(entry, "summary") for entry in entries):
            named = [{"const": str(each), "description": each.summary} for each in entries]
            parts[name] = {"title": title, "oneOf": named}
    names = {**_head("names"), "title": "Names", "$defs": parts}
    return {name: page(name) for name in pages()} | {"names": names}


def _head(name: str) -> Schema:
    return {"$schema": DRAFT, "$id": f"{name}.schema.json"}


def _plain(schema: Any) -> Any:
    """The schema in short form; the same is done in all its parts.

    The keys ``default`` are left out.  An ``enum`` of one value becomes ``const``.  An ``anyOf`` of
    a simple type and null becomes one ``type`` with two names, such as ``["integer", "null"]``.
    The description of an object is cut: its first paragraph becomes the title, its second paragraph
    the description, and the rest is left out.
    """
    if isinstance(schema, list):
        return [_plain(inner) for inner in schema]
    if not isinstance(schema, dict):
        return schema
    kept = {key: _plain(value) for key, value in schema.items() if key != "default"}
    match kept:
        case {"enum": [only]}:
            del kept["enum"]
            kept["const"] = only
        case {"anyOf": [{"type": str(plain), **more}, {"type": "null"}]} if plain in SIMPLE:
            del kept["anyOf"]
            kept |= {"type": [plain, "null"], **more}
    if "properties" in kept and "description" in kept:
        # What follows the second paragraph is for those who read the class.
        title, *rest = kept.pop("description").split("\n\n")
        kept["title"] = title.removesuffix(".")
        if rest:
            kept["description"] = " ".join(rest[0].split())
    return kept


SIMPLE = {"integer", "number", "string", "boolean"}


def main(directory: Path) -> None:
    """Write every schema into the file ``NAME.schema.json`` of a directory.

    First delete all files ``*.schema.json`` of this directory; other files stay.
    """
    directory.mkdir(exist_ok=True)
    for file in directory.glob("*.schema.json"):
        file.unlink()
    for name, schema in schemas().items():
        text = json.dumps(schema, indent=2) + "\n"
        (directory / f"{name}.schema.json").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
