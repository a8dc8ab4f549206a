"""The schemas and the package's door are what the classes and tables say."""

import json
from importlib.resources import files
from typing import Annotated

import pytest
from msgspec import UNSET, UnsetType

from allworlds.documents.document import (
    Document,
    IfAny,
    Natural,
    NotInDocument,
    Some,
    about,
    computed,
    key,
)
from allworlds.maps import MapClass
from allworlds.outcome import Verdict
from allworlds.reports import schemas as generator
from allworlds.reports.schemas import Shapes, schema_of, schemas
from allworlds.verbs import VERBS
from allworlds.world import Door, World


def test_the_package_holds_the_schemas():
    shipped = {
        file.name: json.loads(file.read_text(encoding="utf-8"))
        for file in (files("allworlds") / "schemas").iterdir()
    }
    made = {f"{name}.schema.json": told for name, told in schemas().items()}
    assert shipped == made, "pip install -e . writes them anew"


def test_a_verb_with_several_reports_has_a_schema_for_each():
    assert {"compare", "growth", "init", "header"} <= schemas().keys()


def test_every_key_has_words():
    for name, told in schemas().items():
        for word, inner in keys(told):
            part = told.get("$defs", {}).get(inner.get("$ref", "").rpartition("/")[2], inner)
            assert "description" in inner or "title" in part, f"{name}: {word}"


# A bound is any expression, and a motion and what is answered any integer; what a claim counts may
# fall; a lighthouse may tell any integer; a position is anywhere; so is a fitted exponent.
ANY_NUMBER = {
    *("bound", "expected", "seen", "move", "figures", "expected_figures", "told", "positions"),
    *("exponent", "interval"),
}


def test_every_number_has_a_range_unless_it_may_be_any():
    free = {
        word
        for told in schemas().values()
        for word, inner in keys(told)
        for number in numbers(inner)
        if not number.keys() & {"minimum", "maximum", "enum", "const"}
    }
    assert free == ANY_NUMBER


def numbers(told):
    """The schemas of numbers in the schema of a key, but those of keys inside."""
    match told:
        case {"type": kind} if {"integer", "number"} & {
            *([kind] if isinstance(kind, str) else kind)
        }:
            yield told
        case dict():
            for key, inner in told.items():
                yield from numbers(inner) if key != "properties" else ()
        case list():
            for inner in told:
                yield from numbers(inner)


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
    made = schemas()
    for verb in VERBS:
        if verb.name == "merge":  # one of the others
            continue
        told = made[verb.document]
        assert told["properties"]["schema"]["const"] == 2
        assert told["properties"]["made_by"]["$ref"] == "#/$defs/MadeBy"
        assert "made_by" not in told["required"]


# ---------------------------------------------------------------- the generator itself


class Inner(Document):
    """Inner.

    What is inside.
    """

    x: Annotated[Natural, about("how many")] = 1


class Other(Document):
    """Another one."""

    y: str


class Outer(Document, kw_only=True):
    """Outer."""

    map_class: Annotated[MapClass, about("of maps")] = key(name="class")
    inner: Annotated[Some[Inner], about("some")]
    more: Annotated[Inner | Other | None, about("one of two")] = None
    sometimes: Annotated[int | UnsetType, about("if at all")] = UNSET
    detail: Annotated[IfAny[str], about("if there is any")] = ""
    world: Annotated[World | None, about("a value that writes itself")] = None
    secret: NotInDocument[object] = None

    @computed
    def verdict(self) -> Verdict:
        """Always."""
        return Verdict.HOLDS


OUTER = Outer(map_class=MapClass.MAPS, inner=(Inner(),))


def test_an_object_has_its_keys_and_no_others():
    found, parts = schema_of(Outer)
    assert found == {"$ref": "#/$defs/Outer"}
    outer = parts["Outer"]
    assert outer["required"] == ["class", "inner", "more", "world", "verdict"]
    optional = ["sometimes", "detail"]
    assert [*outer["properties"]] == [*outer["required"][:3], *optional, "world", "verdict"]
    assert outer["additionalProperties"] is False
    assert [*OUTER.to_json()] == ["class", "inner", "more", "world", "verdict"]
    assert parts["Inner"]["title"] == "Inner"
    assert parts["Inner"]["description"] == "What is inside."
    assert parts["Inner"]["properties"]["x"] == {
        "description": "how many",
        "type": "integer",
        "minimum": 0,
    }


def test_what_is_read_may_leave_out_what_has_a_default():
    assert schema_of(Outer, written=False)[1]["Outer"]["required"] == ["class", "inner"]
    assert "required" not in schema_of(Inner, written=False)[1]["Inner"] or (
        schema_of(Inner, written=False)[1]["Inner"]["required"] == []
    )


def test_each_kind_of_type_has_its_schema():
    outer = schema_of(Outer)[1]["Outer"]["properties"]
    assert outer["more"]["anyOf"] == [
        {"$ref": "#/$defs/Inner"},
        {"$ref": "#/$defs/Other"},
        {"type": "null"},
    ]
    assert outer["world"]["anyOf"] == [{"$ref": "#/$defs/WorldDocument"}, {"type": "null"}]
    assert outer["inner"]["minItems"] == 1
    assert outer["sometimes"]["type"] == "integer"


@pytest.mark.parametrize(
    ("tp", "expected"),
    [
        (int, {"type": "integer"}),
        (float | None, {"type": ["number", "null"]}),
        (dict[str, bool], {"type": "object", "additionalProperties": {"type": "boolean"}}),
    ],
)
def test_a_plain_type_has_a_plain_schema(tp, expected):
    assert schema_of(tp) == (expected, {})


def test_the_schemas_are_written_anew_and_old_ones_go(tmp_path, monkeypatch):
    monkeypatch.setattr(generator, "schemas", lambda: {"one": {"title": "One"}})
    there = tmp_path / "schemas"
    generator.main(there)
    for name in ("one.schema.json", "gone.schema.json", "notes.txt"):
        (there / name).write_text("old")
    generator.main(there)
    assert {file.name: file.read_text() for file in there.iterdir()} == {
        "one.schema.json": '{\n  "title": "One"\n}\n',
        "notes.txt": "old",
    }


def test_what_is_read_of_a_dataclass_may_leave_out_its_defaults():
    needed = {
        written: {name for name, _, required in Shapes(written=written)._keys(Door) if required}
        for written in (True, False)
    }
    assert needed == {True: {"dart", "start"}, False: {"dart"}}
