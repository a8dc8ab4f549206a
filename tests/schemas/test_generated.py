"""The schemas and the reference of keys are what the typed descriptions say."""

import json
from importlib.resources import files
from inspect import getsource
from typing import Annotated, NotRequired, TypedDict

import pytest

import allworlds
from allworlds.documents import PAGES, Begins, Keywords
from allworlds.outcome import SCHEMA
from allworlds.verbs import VERBS
from schemas.generate import package_text, schema, schema_text
from schemas.reference import PROTOCOL, REFERENCE, page_text, with_tables

WRITTEN = {
    file.name.removesuffix(".schema.json"): file.read_text(encoding="utf-8")
    for file in (files("allworlds") / "schemas").iterdir()
}
WRITE_ANEW = "python tests/schemas/generate.py writes it anew"


@pytest.mark.parametrize("name", PAGES)
def test_a_schema_is_what_the_types_say(name):
    assert WRITTEN[name] == schema_text(name), WRITE_ANEW


def test_there_is_no_other_schema():
    assert set(WRITTEN) == set(PAGES), WRITE_ANEW


def test_the_reference_is_what_the_schemas_say():
    told = {name: json.loads(WRITTEN[name]) for name in PAGES}
    assert REFERENCE.read_text(encoding="utf-8") == page_text(told), WRITE_ANEW


def test_the_table_of_explorers_is_what_the_code_says():
    page = PROTOCOL.read_text(encoding="utf-8")
    assert page == with_tables(page), WRITE_ANEW
    assert "| `algorithm1-natural` | `natural` | `two-vertices` |" in page


def test_the_package_names_every_verb_for_those_who_do_not_run_it():
    source = getsource(allworlds)
    assert source == package_text(source), WRITE_ANEW
    less = "".join(line for line in source.splitlines(keepends=True) if "count" not in line)
    assert less != source
    assert package_text(less) == source


def test_every_key_that_needs_words_has_them():
    # What a number of edges is, or a verdict's exit code, is told once for all documents.
    plain = {"edges", "vertices", "exit_code", "kind", "rounds", "status"}
    plain |= {"lighthouse", "median", "lowest", "highest"}
    for name, text in WRITTEN.items():
        for key, told in keys(json.loads(text)):
            words = told.get("description") or "$ref" in told or "const" in told
            assert words or key in plain, f"{name}: {key}"


def keys(told):
    """Every key that a schema tells of, with its own schema."""
    if isinstance(told, dict):
        yield from told.get("properties", {}).items()
        for inner in told.values():
            yield from keys(inner)
    if isinstance(told, list):
        for inner in told:
            yield from keys(inner)


def test_every_document_is_of_one_version():
    for verb in VERBS:
        if verb.name == "merge":  # one of the others
            continue
        told = json.loads(WRITTEN[verb.document])["properties"]
        assert told["schema"]["const"] == SCHEMA
        assert told["made_by"]["$ref"] == "made-by.schema.json"
        assert "made_by" not in json.loads(WRITTEN[verb.document])["required"]


# ---------------------------------------------------------------- the generator itself


class Inner(TypedDict):
    """Inner."""

    x: Annotated[int, Keywords(minimum=1), "how many"]


class Outer(TypedDict):
    """Outer."""

    inner: Inner
    more: NotRequired[Annotated[list[Inner | str], Keywords(minItems=1)]]


@pytest.mark.parametrize(
    ("tp", "expected"),
    [
        (int, {"type": "integer"}),
        (float | None, {"type": ["number", "null"]}),
        (Annotated[str, Keywords(minLength=1), "a"], {"type": "string", "minLength": 1}),
        (list[int] | None, {"anyOf": [{"type": "array", "items": {"type": "integer"}}, "null"]}),
        (dict[str, bool], {"type": "object", "additionalProperties": {"type": "boolean"}}),
        (dict[str, object], {"type": "object"}),
        (Annotated[list[Inner | Outer], Begins(Inner)], "a list that begins otherwise"),
    ],
)
def test_each_kind_of_type_has_its_schema(tp, expected):
    found = schema(tp, "here")
    match expected:
        case "a list that begins otherwise":
            (first,), rest = found["prefixItems"], found["items"]["anyOf"]
            assert [*first["properties"]] == ["x"]
            assert [[*other["properties"]] for other in rest] == [["inner", "more"]]
        case {"anyOf": [option, "null"]}:
            assert found == {"anyOf": [option, {"type": "null"}]}
        case _:
            assert {key: found[key] for key in found if key != "description"} == expected


def test_an_object_has_its_keys_and_no_others():
    found = schema(Outer, "here")
    assert found["required"] == ["inner"]
    assert found["additionalProperties"] is False
    inner = found["properties"]["inner"]
    assert inner["properties"]["x"] == {"description": "how many", "type": "integer", "minimum": 1}
    assert found["properties"]["more"]["minItems"] == 1


def test_what_is_told_elsewhere_is_referred_to():
    from allworlds.documents import LawName, WorldDocument

    assert schema(WorldDocument, "run") == {"$ref": "world.schema.json#/$defs/written"}
    assert schema(WorldDocument, "world") == {"$ref": "#/$defs/written"}
    said = schema(Annotated[LawName, "the one"], "run")
    assert said == {"description": "the one", "$ref": "names.schema.json#/$defs/law"}
