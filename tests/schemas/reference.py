"""The reference of keys, ``docs/documents.md``, made from the schemas and the table of verbs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from allworlds.explorers import BUILT_IN
from allworlds.verbs import VERBS
from allworlds.world import lighthouse_named

DOCS = Path(__file__).parents[2] / "docs"
REFERENCE = DOCS / "documents.md"
PROTOCOL = DOCS / "protocol.md"

INTRODUCTION = """\
# Documents

With `--json` a verb writes one JSON document on stdout. This page lists the keys of every document
that is written or read. It is made from the types to which the code is held, and so are the
schemas (JSON Schema, draft 2020-12) in `importlib.resources.files("allworlds") / "schemas"`, which
refer to each other by their names. What the words mean: [protocol](protocol.md) and
[verdicts](verdicts.md).

`rows[].edges` is the key `edges` of each entry of the list `rows`. A key is always there, unless it
says *may be missing*.

| verb | in Python | document | what it does |
|---|---|---|---|
"""
COMMON = """
## Every document of a verb

All that can differ between two runs of one command stands under `made_by`, which the command line
adds: whatever the number of workers, and wherever it runs, the rest is the same, byte for byte.
(Only `bench` measures, so its figures differ.)

"""
TABLE = "| key | value | meaning |\n|---|---|---|\n"

Schema = dict[str, Any]


class Reference:
    """The page of these schemas."""

    def __init__(self, schemas: Mapping[str, Schema]) -> None:
        self.schemas = schemas
        self.headings = {
            f"{name}.schema.json{part}": heading
            for name in schemas
            for part, heading, _ in self.sections(name)
        }

    def sections(self, name: str) -> Iterator[tuple[str, str, Schema]]:
        """What of a schema has a section: its place in the file, its heading, itself."""
        told = self.schemas[name]
        verbs = [f"`{verb.name} --json`" for verb in VERBS if verb.document == name]
        if verbs:
            yield "", ", ".join(verbs), told
            return
        if {"type", "properties"} & told.keys() or self.kinds(told):
            yield "", told["title"], told
        for part, inner in told.get("$defs", {}).items():
            yield f"#/$defs/{part}", inner["title"], inner

    def kinds(self, told: Schema) -> list[Schema]:
        """The kinds of objects that a document is one of; none if it is something else."""
        kinds = told.get("anyOf", [])
        return kinds if all("properties" in kind for kind in kinds) else []

    def text(self) -> str:
        """All of it."""
        common = {key: self.schemas["check"]["properties"][key] for key in ("schema", "made_by")}
        text = INTRODUCTION + "".join(self.verb_rows())
        text += COMMON + TABLE + self.rows({"properties": common, "required": ["schema"]}, "check")
        for name in self.schemas:
            for part, heading, told in self.sections(name):
                said = f"{told['description']} " if "description" in told else ""
                text += f"\n## {heading}\n\n{said}Schema: `{name}.schema.json{part}`.\n\n"
                if "oneOf" in told:
                    rows = (
                        f"| `{one['const']}` | {one['description']} |\n" for one in told["oneOf"]
                    )
                    text += "| name | meaning |\n|---|---|\n" + "".join(rows)
                elif "properties" in told:
                    own = {k: v for k, v in told["properties"].items() if common.get(k) != v}
                    text += TABLE + self.rows({**told, "properties": own}, name)
                elif kinds := self.kinds(told):
                    text += "\n".join(TABLE + self.rows(kind, name) for kind in kinds)
                else:
                    text += f"{self.value(told, name).capitalize()}.\n"
        return text

    def verb_rows(self) -> Iterator[str]:
        """One row a verb."""
        for verb in VERBS:
            document = self.link(f"{verb.document}.schema.json")
            yield f"| `{verb.name}` | `{verb.python}` | {document} | {verb.summary} |\n"

    def link(self, reference: str) -> str:
        """A link to a section."""
        heading = self.headings[reference]
        kept = [c for c in heading.lower().replace(" ", "-") if c.isalnum() or c in "-_"]
        return f"[{heading}](#{''.join(kept)})"

    def rows(self, told: Schema, page: str, path: str = "") -> str:
        """A row for each key, and for the keys of what has no section of its own."""
        text = ""
        for key, value in told["properties"].items():
            said = [] if key in told["required"] else ["*may be missing*"]
            said += [value["description"]] if "description" in value else []
            text += f"| `{path}{key}` | {self.value(value, page)} | {': '.join(said)} |\n"
            for inner, more in self.below(value, page):
                text += self.rows(inner, page, f"{path}{key}{more}.")
        return text

    def below(self, value: Schema, page: str) -> Iterator[tuple[Schema, str]]:
        """The objects inside a value; what a reference leads to is told elsewhere."""
        if "properties" in value:
            yield value, ""
        elif "items" in value:
            yield from ((inner, f"[]{more}") for inner, more in self.below(value["items"], page))
        for option in value.get("anyOf", ()):
            yield from self.below(option, page)

    def value(self, told: Schema, page: str) -> str:
        """What a value can be, in words."""
        match told:
            case {"$ref": reference}:
                return self.link(
                    f"{page}.schema.json{reference}" if reference[0] == "#" else reference
                )
            case {"anyOf": options}:
                return " or ".join(self.value(option, page) for option in options)
            case {"const": one}:
                return f"`{words(one)}`"
            case {"enum": several}:
                return ", ".join(f"`{words(each)}`" for each in several)
            case {"type": "array"}:
                return self.list_value(told, page)
            case {"type": "object", "additionalProperties": dict(inner)}:
                return f"object, from text to {self.value(inner, page)}"
            case {"type": [plain, "null"]}:
                return f"{self.value({**told, 'type': plain}, page)} or null"
            case {"type": plain, "minimum": least, "maximum": most}:
                return f"{WORDS[plain]} {least}..{most}"
            case {"type": plain, "minimum": least}:
                return f"{WORDS[plain]} ≥ {least}"
            case {"type": plain}:
                return WORDS[plain]
        return "object"

    def list_value(self, told: Schema, page: str) -> str:
        """What a list can hold."""
        if "prefixItems" in told:
            first, rest = told["prefixItems"][0], told["items"]["anyOf"]
            return f"list of {row(first)}, then of {', '.join(map(row, rest))}"
        exactly = told.get("minItems", 0) == told.get("maxItems", -1)
        many = f"{told['minItems']} " if exactly else ""
        empty = "" if exactly or not told.get("minItems") else "non-empty "
        return f"{empty}list of {many}{plural(self.value(told['items'], page))}"


WORDS = {
    "integer": "integer",
    "number": "number",
    "string": "text",
    "boolean": "true or false",
    "null": "null",
    "object": "object",
}


def words(value: object) -> str:
    """A value as JSON has it, without quotes."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def row(told: Schema) -> str:
    """A row of a transcript by its keys."""
    return "`{" + ", ".join(told["properties"]) + "}`"


def plural(text: str) -> str:
    """The same of several."""
    for one in ("integer", "number", "text", "object", "list"):
        if text == one or text.startswith(f"{one} "):
            return f"{one}s" + text.removeprefix(one)
    return text


def page_text(schemas: Mapping[str, Schema]) -> str:
    """The page of these schemas."""
    return Reference(schemas).text()


def explorers_table() -> str:
    """The built-in explorers, a row each."""
    rows = [
        f"| `{name}` | `{own.lighthouse}` "
        f"| `{own.bound or lighthouse_named(own.lighthouse).default_bound}` | {own.about} |"
        for name, own in BUILT_IN.items()
    ]
    return "\n".join(["| name | lighthouse | bound | what it is |", "|---|---|---|---|", *rows])


def with_tables(page: str) -> str:
    """A page whose tables between ``<!-- explorers -->`` and ``<!-- end -->`` are made anew."""
    begin, end = "<!-- explorers -->\n", "\n<!-- end -->"
    head, _, rest = page.partition(begin)
    return head + begin + explorers_table() + end + rest.partition("<!-- end -->")[2]
