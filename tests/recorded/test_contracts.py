"""What users' programs rely on, one line each: functions, their defaults, options and documents.

``python tests/recorded/test_contracts.py`` writes the text anew; what then differs is a
change that users see.
"""

import inspect
import json
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

from allworlds.reports.schemas import schemas
from allworlds.robots.models.table import MODELS, WRAPPERS
from allworlds.verbs import VERBS
from allworlds.world.lighthouses.kinds import LIGHTHOUSES

FILE = Path(__file__).with_suffix(".txt")
TOLD_ELSEWHERE = {"title", "description", "properties", "$defs", "$schema", "$id"}
MODULES = ("", "ambiguity", "claims", "maps", "robots", "strategies", "testing", "world")


def test_what_users_programs_rely_on_is_what_is_recorded():
    assert contracts() == FILE.read_text(encoding="utf-8")


def contracts() -> str:
    """All lines, under a heading for each kind."""
    kinds = {
        "functions and classes": functions(),
        "models": map(options, [*MODELS.items(), *WRAPPERS.items()]),
        "lighthouses": map(options, LIGHTHOUSES.items()),
        "verbs": verbs(),
        "documents": documents(),
    }
    return "\n".join("\n".join([f"## {kind}", *lines, ""]) for kind, lines in kinds.items())


def functions() -> Iterator[str]:
    """The signature of each public function and class, without types."""
    for name in MODULES:
        module = import_module(f"allworlds.{name}".rstrip("."))
        for each in sorted(module.__all__):
            thing = getattr(module, each)
            if callable(thing) and not (inspect.isclass(thing) and issubclass(thing, Exception)):
                yield f"{module.__name__}.{each}({', '.join(parameters(thing))})"


def parameters(function: Any) -> Iterator[str]:
    """The parameters of a function with their defaults; a default that is code has no text."""
    for each in inspect.signature(function).parameters.values():
        shown = each.replace(annotation=each.empty)
        if inspect.isroutine(each.default):
            shown = shown.replace(default=Ellipsis)
        yield str(shown)


def options(named: tuple[str, Any]) -> str:
    """The options of a model or a lighthouse."""
    return f"{named[0]}({', '.join(parameters(named[1]))})"


def verbs() -> Iterator[str]:
    """What the table says of each verb, but for the texts of its help."""
    for verb in VERBS:
        has = ", ".join(verb.has)
        yield f"{verb.name} ({verb.panel}): {verb.path}, {verb.document}; {has}; swept {verb.swept}"


def documents() -> Iterator[str]:
    """The rules for each key of each document, and of each part that documents share."""
    shared = set[str]()
    for name, schema in schemas().items():
        yield from keys(name, schema)
        for part, rules in schema.get("$defs", {}).items():
            shared |= {*keys(f"#{part}", rules)}
    yield from sorted(shared)


def keys(name: str, schema: Any) -> Iterator[str]:
    """The rules of an object or a value, then of each of its keys."""
    yield f"{name}: {json.dumps(rules_of(schema), sort_keys=True, ensure_ascii=False)}"
    for key, rules in sorted(schema.get("properties", {}).items()):
        yield f"{name}.{key}: {json.dumps(rules_of(rules), sort_keys=True, ensure_ascii=False)}"


def rules_of(schema: Any) -> Any:
    """A schema without titles, descriptions, the keys of objects and the parts that are shared."""
    if isinstance(schema, list):
        return [rules_of(each) for each in schema]
    if not isinstance(schema, dict):
        return schema
    return {key: rules_of(value) for key, value in schema.items() if key not in TOLD_ELSEWHERE}


if __name__ == "__main__":
    FILE.write_text(contracts(), encoding="utf-8")
