"""Write the JSON Schemas from the typed descriptions, and the reference of keys from them.

``python tests/schemas/generate.py`` writes ``src/allworlds/schemas`` and ``docs/documents.md``
anew, the table of explorers in ``docs/protocol.md``, and the names of the verbs in the package's
``__init__.py``; ``test_generated.py`` compares.  The descriptions are in ``allworlds.documents``,
names in the tables that these name.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from types import NoneType, UnionType
from typing import (
    Annotated,
    Any,
    Literal,
    NotRequired,
    Union,
    get_args,
    get_origin,
    get_type_hints,
    is_typeddict,
)

from allworlds import documents
from allworlds.documents import MORE_KEYS, PAGES, Begins, Keywords, KindsOf, Named
from allworlds.verbs import VERBS

ROOT = Path(__file__).parents[2]
SCHEMAS = ROOT / "src" / "allworlds" / "schemas"
PACKAGE = ROOT / "src" / "allworlds" / "__init__.py"
DRAFT = "https://json-schema.org/draft/2020-12/schema"

# ---------------------------------------------------------------- types and their metadata


def peeled(tp: Any) -> tuple[Any, list[Any]]:
    """The type without its wrappers, and its metadata."""
    if get_origin(tp) is NotRequired:
        return peeled(get_args(tp)[0])
    if get_origin(tp) is Annotated:
        base, *notes = get_args(tp)
        return base, notes
    return tp, []


def key(tp: Any) -> Any:
    """Equal for a type and the same type with another description."""
    base, notes = peeled(tp)
    return base, tuple(note for note in notes if not isinstance(note, str))


def description(tp: Any) -> str:
    """What is said of the value; empty where its type says enough."""
    said = [note for note in peeled(tp)[1] if isinstance(note, str)]
    return said[-1] if said else ""


def keywords(tp: Any) -> dict[str, Any]:
    """The keywords that narrow it."""
    found: dict[str, Any] = {}
    for note in peeled(tp)[1]:
        if isinstance(note, Keywords):
            found |= note.given
    return found


def note_of(tp: Any, kind: type) -> Any:
    """Its metadata of that kind, or None."""
    return next((note for note in peeled(tp)[1] if isinstance(note, kind)), None)


def members(base: Any) -> tuple[Any, ...]:
    """The types of a union; of anything else itself."""
    return get_args(base) if get_origin(base) in (Union, UnionType) else (base,)


def table(name: str) -> Any:
    """The table of ``module:name``."""
    module, _, attribute = name.partition(":")
    return getattr(import_module(f"allworlds.{module}"), attribute)


def names(named: Named) -> dict[str, Any]:
    """One of the names that a table has, each with its summary where it has one."""
    found = [*table(named.table)]
    if all(hasattr(name, "summary") for name in found):
        return {"oneOf": [{"const": str(name), "description": name.summary} for name in found]}
    return {"enum": [str(name) for name in found]}


def kinds(of: KindsOf) -> Iterator[tuple[str, Any]]:
    """The entries of a table by name, with what their ``to_json`` is typed to return."""
    for name, entry in table(of.table).items():
        hints = get_type_hints(entry.to_json, localns={"documents": documents})
        yield name, hints["return"]


# ---------------------------------------------------------------- schemas

TOLD = {
    key(part): f"{page}.schema.json#/$defs/{name}"
    for page, told in PAGES.items()
    for name, part in told.parts.items()
} | {key(told.root): f"{page}.schema.json" for page, told in PAGES.items() if told.root}


def reference(tp: Any, page: str) -> str | None:
    """Where the type is told, as seen from a schema; None if it is told on the spot."""
    found = TOLD.get(key(tp))
    return found and found.removeprefix(f"{page}.schema.json")


def schema(tp: Any, page: str) -> dict[str, Any]:
    """The schema of a value."""
    told = reference(tp, page)
    found = {"$ref": told} if told else shape(tp, page)
    said = description(tp)
    return {"description": said, **found} if said else found


PLAIN = {int: "integer", float: "number", str: "string", bool: "boolean", NoneType: "null"}


def shape(tp: Any, page: str) -> dict[str, Any]:
    """The schema of a value, told on the spot."""
    base, _ = peeled(tp)
    if named := note_of(tp, Named):
        return names(named)
    if of := note_of(tp, KindsOf):
        return {"oneOf": [kind_schema(name, written, page) for name, written in kinds(of)]}
    if is_typeddict(base):
        return object_schema(base, page)
    match get_origin(base):
        case origin if origin in (Union, UnionType):
            return union_schema([schema(member, page) for member in members(base)])
        case origin if origin is Literal:
            values = [*get_args(base)]
            return {"const": values[0]} if len(values) == 1 else {"enum": values}
        case origin if origin is list:
            return {**list_schema(tp, page), **keywords(tp)}
        case origin if origin is dict:
            name, value = get_args(base)
            narrowed = {"propertyNames": keywords(name)} if keywords(name) else {}
            inner = {} if value is object else {"additionalProperties": schema(value, page)}
            return {"type": "object", **narrowed, **inner}
    return {"type": PLAIN[base], **keywords(tp)}


def object_schema(shape_: Any, page: str) -> dict[str, Any]:
    """The schema of a typed dictionary."""
    required = [name for name in shape_.__annotations__ if name in shape_.__required_keys__]
    return {
        "type": "object",
        "properties": {name: schema(tp, page) for name, tp in shape_.__annotations__.items()},
        "required": required,
        **({} if shape_ in MORE_KEYS else {"additionalProperties": False}),
    }


def kind_schema(name: str, written: Any, page: str) -> dict[str, Any]:
    found = object_schema(written, page)
    found["properties"]["kind"] = {"const": name}
    return found


def list_schema(tp: Any, page: str) -> dict[str, Any]:
    (item,) = get_args(peeled(tp)[0])
    begins = note_of(tp, Begins)
    if begins is None:
        return {"type": "array", "items": schema(item, page)}
    rest = [schema(member, page) for member in members(item) if member is not begins.first]
    return {
        "type": "array",
        "prefixItems": [schema(begins.first, page)],
        "items": union_schema(rest),
    }


def union_schema(parts: list[dict[str, Any]]) -> dict[str, Any]:
    """One of these; ``X | None`` of a plain type is told in one object."""
    match parts:
        case [{"type": str(plain), **more}, {"type": "null"}] if plain not in ("object", "array"):
            return {"type": [plain, "null"], **more}
    return {"anyOf": parts}


def headings(name: str, tp: Any) -> dict[str, str]:
    """Title and description of a part: the first line and the rest of what is said of it."""
    said = tp.__doc__.strip() if is_typeddict(tp) else TITLES[name]
    title, _, rest = said.partition("\n\n")
    more = " ".join(rest.split())
    return {"title": title.removesuffix("."), **({"description": more} if more else {})}


TITLES = {
    "event": "Event.\n\nOne line of what `--events FILE` writes.",
    "merge": "Report of 'merge'.\n\nThat of the verb whose shards were joined.",
    "transcript": "Transcript.",
    "read": "Transcript, as it is read.",
    "law": "Law.",
    "judged_law": "Judged law.\n\nOne that a finished run is held to.",
    "class": "Class of maps.",
    "verdict": "Verdict.",
    "engine": "Engine.",
    "names": "Names.\n\nThose that stand in tables.",
}


def schema_of_page(name: str) -> dict[str, Any]:
    """The schema of a page."""
    page = PAGES[name]
    parts = {part: {**headings(part, tp), **shape(tp, name)} for part, tp in page.parts.items()}
    return {
        "$schema": DRAFT,
        "$id": f"{name}.schema.json",
        **headings(name, page.root),
        **(shape(page.root, name) if page.root else {}),
        **({"$defs": parts} if parts else {}),
    }


def schema_text(name: str) -> str:
    """The file of a page's schema."""
    return json.dumps(schema_of_page(name), indent=2) + "\n"


# ---------------------------------------------------------------- the package


def package_text(source: str) -> str:
    """The package's door, with the function of every verb that it does not name yet."""
    lines = source.splitlines(keepends=True)
    for verb in VERBS:
        module, _, name = verb.function.partition(":")
        if verb.python.count(".") == 1 and f" {name} as {name}" not in source:
            begin = lines.index("if TYPE_CHECKING:\n") + 1
            line = f"    from allworlds.{module} import {name} as {name}\n"
            tails = (
                i for i in range(begin, len(lines)) if lines[i] > line or lines[i] == "else:\n"
            )
            lines.insert(next(tails), line)
    return "".join(lines)


# ---------------------------------------------------------------- files


def main() -> None:
    """Write everything anew."""
    from reference import PROTOCOL, REFERENCE, page_text, with_tables

    texts = {f"{name}.schema.json": schema_text(name) for name in PAGES}
    for file in SCHEMAS.iterdir():
        if file.name not in texts:
            file.unlink()
    for file, text in texts.items():
        (SCHEMAS / file).write_text(text, encoding="utf-8")
    PACKAGE.write_text(package_text(PACKAGE.read_text("utf-8")), "utf-8")
    PROTOCOL.write_text(with_tables(PROTOCOL.read_text("utf-8")), "utf-8")
    REFERENCE.write_text(page_text({name: schema_of_page(name) for name in PAGES}), "utf-8")


if __name__ == "__main__":
    main()
