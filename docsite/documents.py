"""The reference of keys, from the schemas and the table of verbs; the table of explorers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.reports.schemas import NAMES, pages, schemas
from allworlds.verbs import VERBS
from allworlds.world.lighthouses.kinds import lighthouse_kind

if TYPE_CHECKING:
    from mkdocs.config.defaults import MkDocsConfig
    from mkdocs.structure.files import Files
    from mkdocs.structure.pages import Page

EXPLORERS = "<!-- table explorers -->"
"""Where a page asks for the table of explorers."""


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """The files of the site, with the reference of keys."""
    from mkdocs.structure.files import File

    files.append(File.generated(config, "documents.md", content=page_text()))
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """The page with its table of explorers."""
    return markdown.replace(EXPLORERS, explorers_table())


INTRODUCTION = """\
# Documents

With `--json` a verb writes one JSON document on stdout. This page lists the keys of every document
that is written or read. It is made from the classes of the results, and so are the schemas (JSON
Schema, draft 2020-12) in `importlib.resources.files("allworlds") / "schemas"`, one file a document,
each complete in itself. What the words mean: [protocol](protocol.md) and
[verdicts](verdicts.md).

`rows[].edges` is the key `edges` of each entry of the list `rows`. A key is always there, unless it
says *may be missing*; a finding, a world, a transcript and a manifest are told as they are read:
where this program writes them, nothing is missing that has a value.

| verb | in Python | document | what it does |
|---|---|---|---|
"""
COMMON = """
## Every document of a verb

All that can differ between two runs of one command stands under `made_by`, which the command line
adds: whatever the number of workers, and wherever it runs, the rest is the same, byte for byte.

"""
TABLE = "| key | value | meaning |\n|---|---|---|\n"

Schema = dict[str, Any]

PARTS = ("RootedMap", "Ambiguous", "Percept", "RecordedRules", "Host")
"""The parts of documents that have a section of their own; all others are told where they stand."""


class Reference:
    """The page of these schemas."""

    def __init__(self, schemas: Mapping[str, Schema], roots: Mapping[str, str]) -> None:
        self.schemas = schemas
        self.parts = {
            name: told for schema in schemas.values() for name, told in schema["$defs"].items()
        }
        self.headings = {roots[page]: self.heading(page) for page in schemas if page in roots}
        self.tables = [{*table} for _, table in NAMES.values()]
        self.headings |= {part: self.parts[part]["title"] for part in PARTS}

    def heading(self, page: str) -> str:
        """The heading of a schema: the verbs that write it, else its title."""
        verbs = [f"`{verb.name} --json`" for verb in VERBS if verb.document == page]
        title: str = self.schemas[page]["title"]
        return ", ".join(verbs) or title

    def text(self) -> str:
        """All of it."""
        common = {key: self.schemas["check"]["properties"][key] for key in ("schema", "made_by")}
        text = INTRODUCTION + "".join(self.verb_rows())
        text += COMMON + TABLE + self.rows({"properties": common, "required": ["schema"]})
        for name, told in self.schemas.items():
            text += self.section(self.heading(name), told, f"Schema: `{name}.schema.json`.", common)
        for part in PARTS:
            text += self.section(self.headings[part], self.parts[part], "", {})
        return text

    def section(self, heading: str, told: Schema, place: str, common: Schema) -> str:
        """A heading, what is said of the whole, and a row for each key."""
        said = " ".join(filter(None, [told.get("description", ""), place]))
        text = f"\n## {heading}\n\n{said}\n\n" if said else f"\n## {heading}\n\n"
        if "properties" in told:
            own = {k: v for k, v in told["properties"].items() if common.get(k) != v}
            return text + TABLE + self.rows({**told, "properties": own})
        if told["title"] == "Names":
            return text + "\n".join(map(self.names, told["$defs"].values()))
        names = [name_of(option) for option in told.get("anyOf", [])]
        if names and not self.headings.keys() & names:
            kinds = [self.parts[name] for name in names]
            tables = (f"{kind['title']}.\n\n{TABLE}{self.rows(kind)}" for kind in kinds)
            return text + "\n".join(tables)
        return f"{text}{self.value(told).capitalize()}.\n"

    def names(self, told: Schema) -> str:
        """The names of a table."""
        if "enum" in told:
            return f"{told['title']}: {', '.join(f'`{name}`' for name in told['enum'])}.\n"
        rows = (f"| `{one['const']}` | {one['description']} |\n" for one in told["oneOf"])
        return f"{told['title']}:\n\n| name | meaning |\n|---|---|\n" + "".join(rows)

    def verb_rows(self) -> Iterator[str]:
        """One row a verb."""
        for verb in VERBS:
            document = link(self.heading(verb.document))
            yield f"| `{verb.name}` | `{verb.path}` | {document} | {verb.summary} |\n"

    def rows(self, told: Schema, path: str = "") -> str:
        """A row for each key, and for the keys of what has no section of its own."""
        text = ""
        for key, value in told["properties"].items():
            said = [] if key in told.get("required", ()) else ["*may be missing*"]
            said += [value["description"]] if "description" in value else []
            text += f"| `{path}{key}` | {self.value(value)} | {': '.join(said)} |\n"
            for inner, more in self.below(value):
                text += self.rows(inner, f"{path}{key}{more}.")
        return text

    def below(self, value: Schema) -> Iterator[tuple[Schema, str]]:
        """The objects inside a value; what has a section is told there."""
        if value.get("$ref", "")[:1] == "#" and name_of(value) not in self.headings:
            yield from self.below(self.parts[name_of(value)])
        elif "properties" in value:
            yield value, ""
        elif "items" in value and "prefixItems" not in value:
            yield from ((inner, f"[]{more}") for inner, more in self.below(value["items"]))
        for option in value.get("anyOf", ()):
            yield from self.below(option)

    def value(self, told: Schema) -> str:
        """The legal values of a schema, in words."""
        match told:
            case {"$ref": _} if name_of(told) in self.headings:
                return link(self.headings[name_of(told)])
            case {"$ref": str(file)} if file[0] != "#":
                return link(self.heading(file.removesuffix(".schema.json")))
            case {"$ref": _}:
                return self.value(self.parts[name_of(told)])
            case {"anyOf": options}:
                return " or ".join(dict.fromkeys(map(self.value, options)))
            case {"const": one}:
                return f"`{words(one)}`"
            case {"enum": several} if {*several} in self.tables:
                return link("Names")
            case {"enum": several}:
                return ", ".join(f"`{words(each)}`" for each in several)
            case {"type": "array"}:
                return self.list_value(told)
            case {"type": "object", "additionalProperties": dict(inner)} if inner:
                return f"object, from text to {self.value(inner)}"
            case {"type": [plain, "null"]}:
                return f"{self.value({**told, 'type': plain})} or null"
            case {"type": plain, "minimum": least, "maximum": most}:
                return f"{WORDS[plain]} {least}..{most}"
            case {"type": plain, "minimum": least}:
                return f"{WORDS[plain]} ≥ {least}"
            case {"type": plain}:
                return WORDS[plain]
        return "any value"

    def list_value(self, told: Schema) -> str:
        """The legal items of a list, in words."""
        if "prefixItems" in told:
            first = self.row(told["prefixItems"][0])
            rest = told["items"] and told["items"]["anyOf"]
            return f"list of {first}" + (
                f", then of {', '.join(map(self.row, rest))}" if rest else ""
            )
        exactly = told.get("minItems", 0) == told.get("maxItems", -1)
        many = f"{told['minItems']} " if exactly else ""
        empty = "" if exactly or not told.get("minItems") else "non-empty "
        return f"{empty}list of {many}{plural(self.value(told['items']))}"

    def row(self, told: Schema) -> str:
        """A row of a transcript by its keys."""
        return "`{" + ", ".join(self.parts[name_of(told)]["properties"]) + "}`"


def name_of(told: Schema) -> str:
    """The name of what a schema refers to."""
    name: str = told["$ref"].rpartition("/")[2]
    return name


def link(heading: str) -> str:
    """A link to a section."""
    kept = [c for c in heading.lower().replace(" ", "-") if c.isalnum() or c in "-_"]
    return f"[{heading}](#{''.join(kept)})"


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


def plural(text: str) -> str:
    """The plural of a description."""
    for one in ("integer", "number", "text", "object", "list"):
        if text == one or text.startswith(f"{one} "):
            return f"{one}s" + text.removeprefix(one)
    return text


def page_text() -> str:
    """The page of all schemas."""
    roots = {name: tp.__name__ for name, tp in pages().items() if isinstance(tp, type)}
    return Reference(schemas(), roots).text()


def explorers_table() -> str:
    """The built-in explorers, a row each."""
    rows = [
        f"| `{name}` | `{own.lighthouse}` "
        f"| `{own.bound or lighthouse_kind(own.lighthouse).as_class.default_bound}` | {own.about} |"
        for name, own in BUILT_IN.items()
    ]
    return "\n".join(["| name | lighthouse | bound | what it is |", "|---|---|---|---|", *rows])
