"""A document: its keys, what follows from them, and what is refused where one is read."""

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal, get_type_hints

import numpy as np
import pytest
from msgspec import UNSET, UnsetType

from allworlds.documents.document import (
    Document,
    IfAny,
    Natural,
    NotInDocument,
    Positive,
    Some,
    WrittenByFields,
    about,
    computed,
    key,
    keys_of,
    plain,
    replace,
    with_options,
)
from allworlds.documents.reading import parse
from allworlds.inputs.checks import InputError
from allworlds.inputs.requests import SCOPE, Option, Request
from allworlds.outcome import Exit, Verdict


class Part(Document):
    """A part."""

    size: Annotated[Natural, about("how large")]
    kind: Literal["round", "square"] = "round"


class Whole(Document, kw_only=True):
    """A whole."""

    class_: Annotated[str, about("of something")] = key(name="class")
    parts: Annotated[Some[Part], about("at least one")]
    note: IfAny[str] = ""
    step: IfAny[Natural | None] = None
    seldom: int | UnsetType = UNSET
    counted: NotInDocument[object] = None

    @computed
    def total(self) -> int:
        """Of all parts."""
        return sum(part.size for part in self.parts)

    @computed
    def code(self) -> Exit:
        """The exit code."""
        return Exit.HOLDS if self.total else Exit.VACUOUS


WHOLE = Whole(class_="toys", parts=(Part(size=2), Part(size=3, kind="square")), counted=object())


def test_the_keys_stand_in_their_order_and_what_is_aside_is_none():
    assert WHOLE.to_json() == {
        "class": "toys",
        "parts": [{"size": 2, "kind": "round"}, {"size": 3, "kind": "square"}],
        "total": 5,
        "code": 0,
    }
    assert [key.name for key in keys_of(Whole)][2:5] == ["note", "step", "seldom"]


def test_a_key_that_is_left_out_while_empty_is_told_when_it_is_not_even_if_it_is_0():
    told = replace(WHOLE, note="of wood", step=0, seldom=0).to_json()
    assert (told["note"], told["step"], told["seldom"]) == ("of wood", 0, 0)


def test_what_follows_cannot_be_contradicted():
    with pytest.raises(TypeError):
        Whole(class_="toys", parts=WHOLE.parts, total=9)
    with pytest.raises(AttributeError):
        WHOLE.total = 9
    empty = replace(WHOLE, parts=(Part(size=0),))
    assert (empty.total, empty.code) == (0, Exit.VACUOUS)


def test_a_document_is_frozen():
    with pytest.raises(AttributeError):
        WHOLE.note = "of tin"


@dataclass(frozen=True)
class Point(WrittenByFields):
    """Two numbers."""

    x: int
    y: int


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (Verdict.HOLDS, "holds"),
        (Exit.REFUTED, 1),
        (Path("a/b"), "a/b"),
        ({2: (Point(1, 2),)}, {"2": [{"x": 1, "y": 2}]}),
        ([None, True, 1.5, "text"], [None, True, 1.5, "text"]),
        (10**40, 10**40),
        (7, 7),
        (np.float64(1.5), np.float64(1.5)),
        (np.int64(3), 3),
    ],
)
def test_a_value_becomes_what_json_holds(value, expected):
    assert plain(value) == expected
    assert type(plain(value)) is type(expected)


def test_what_cannot_be_told_is_an_error_and_not_a_guess():
    with pytest.raises(AttributeError):
        plain(object())


def test_a_copy_of_a_dataclass_is_made_like_one_of_a_document():
    assert replace(Point(1, 2), y=3) == Point(1, 3)


class Read(Document):
    """A document that is read."""

    name: str
    rows: tuple[Part, ...] = ()
    count: Positive = 1
    sizes: dict[str, int] | None = None
    verdict: Verdict | None = None
    verdicts: dict[str, Verdict] | None = None


def test_what_is_written_is_read():
    read = Read(name="a", rows=WHOLE.parts, count=7, sizes={"x": 1}, verdict=Verdict.REFUTED)
    assert parse(read.to_json(), Read, "reading") == read


@pytest.mark.parametrize(
    ("document", "said"),
    [
        ([], "reading: expected object, got array"),
        ({}, "reading: object missing required field name"),
        ({"name": 3}, "name = 3: expected str, got int"),
        ({"name": "a", "count": 0}, "count = 0: expected int >= 1"),
        ({"name": "a", "count": True}, "count = True: expected int, got bool"),
        ({"name": "a", "other": 1}, "reading: object contains unknown field other"),
        ({"name": "a", "rows": [{"size": 1}, {"size": "b"}]}, "rows[1].size = 'b': expected int"),
        (
            {"name": "a", "rows": [{"size": 1, "kind": "flat"}]},
            "rows[0].kind = 'flat' is not one of round, square",
        ),
        (
            {"name": "a", "sizes": {"x": 1, "y": "b"}},
            "sizes[...] = {'x': 1, 'y': 'b'}: expected int, got str",
        ),
        (
            {"name": "a", "verdicts": {"x": "true"}},
            "verdicts[...] = {'x': 'true'} is not one of holds, refuted, inconclusive, vacuous, er",
        ),
        (
            {"name": "a", "verdict": "true"},
            "verdict = 'true' is not one of holds, refuted, inconclusive, vacuous, error, not-refu",
        ),
        ({"name": "a", "verdict": "\ud800"}, "reading: a key or a word in it is no text"),
        ({"name": "a", "\ud800": 1}, "reading: a key or a word in it is no text"),
    ],
)
def test_what_is_none_is_refused_by_its_place_and_value(document, said):
    with pytest.raises(InputError) as refusal:
        parse(document, Read, "reading")
    assert said in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_what_is_computed_is_told_with_its_own_note_or_its_docstring():
    class Sums(Document):
        """Sums."""

        @computed
        def small(self) -> Annotated[Natural, about("of a few")]:
            """Not this."""
            return 1

    hints = {key.name: key.type for key in (*keys_of(Sums), *keys_of(Whole))}
    told = {name: hints[name].__metadata__[-1].description for name in ("small", "total")}
    assert told == {"small": "of a few", "total": "of all parts"}


class Asked(Request):
    """Options of a scope."""

    size: Annotated[int, Option(SCOPE, "N", "How large.")] = 1
    form: Annotated[Literal["round", "square"] | None, Option(SCOPE, "WORD", "Of form.")] = None
    place: Annotated[Path, Option(SCOPE, "PATH", "Where.")] = Path("here")
    way: Annotated[Path | None, Option(SCOPE, "PATH", "How.")] = None


@with_options(Asked)
class WithOptions(Document):
    """A document of options."""


def test_the_key_of_an_option_has_its_type_or_is_a_text():
    assert get_type_hints(WithOptions) == {
        "size": int,
        "form": Literal["round", "square"] | None,
        "place": str,
        "way": str | None,
    }
    told = {key.name: key.type.__metadata__[-1].description for key in keys_of(WithOptions)}
    assert told == {"size": "How large", "form": "Of form", "place": "Where", "way": "How"}
    told = {"size": 2, "form": None, "place": "there", "way": None}
    assert parse(told, WithOptions, "it").to_json() == told
    for wrong in ({"form": "flat"}, {"place": ""}, {"way": ""}, {"place": None}, {"size": None}):
        with pytest.raises(InputError):
            parse({**told, **wrong}, WithOptions, "it")
