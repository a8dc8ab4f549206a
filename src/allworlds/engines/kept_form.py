"""The form in which results are kept as JSON: it follows from the types of their fields.

A struct, or a dataclass, is kept by its fields; a counter, or a dictionary whose keys are no texts,
as pairs; and whatever has a ``from_json`` as that reads it.  Everything else is msgspec's business.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import is_dataclass
from functools import cache
from typing import Annotated, Any, NamedTuple, TypeVar, get_args, get_origin, get_type_hints

from msgspec import Struct

from allworlds.document.reading import taken
from allworlds.document.struct import names_of, plain, plain_at_once
from allworlds.inputs.checks import InputError, show

T = TypeVar("T")

WHAT = "what is kept of a unit"


class Form(NamedTuple):
    """How the values of a type are kept; beside a type it goes before what would follow from it.

    Attributes:
        write: the JSON value of a value.
        read: the value of that; raises InputError for anything else.
    """

    write: Callable[[Any], Any]
    read: Callable[[Any], Any]


def to_kept(result: object) -> Any:
    """The JSON value of a result."""
    kind: Any = type(result)
    return _form(kind).write(result)


def from_kept(told: object, kind: type[T]) -> T:
    """The result of that class of which this is :func:`to_kept`'s value.

    Raises:
        InputError: for any other value.
    """
    made: Any = kind
    found: T = _form(made).read(told)
    return found


@cache
def _form(kind: Any) -> Form:
    return _own_form(kind) or Form(plain_at_once, lambda told: taken(told, kind, WHAT))


def _own_form(kind: Any) -> Form | None:
    """The form of a type that msgspec cannot read and write by itself; None where it can."""
    origin, parts = get_origin(kind), get_args(kind)
    if origin is Annotated:
        return next((note for note in parts if isinstance(note, Form)), None) or _own_form(parts[0])
    if origin is Counter or (origin is dict and parts[0] is not str):
        items = _form(list[tuple[(*parts, int)[:2]]])  # type: ignore[misc]  # a type made of types
        return Form(
            lambda table: items.write([*table.items()]),
            lambda told: origin(dict(items.read(told))),
        )
    if origin is list and (one := _own_form(parts[0])):
        return Form(
            lambda values: [one.write(value) for value in values],
            lambda told: [one.read(value) for value in taken(told, list[Any], WHAT)],
        )
    if origin is tuple and any(map(_own_form, parts)):
        return _tuple(tuple(map(_form, parts)))
    if hasattr(kind, "from_json"):
        return Form(plain, kind.from_json)
    if is_dataclass(kind) or (isinstance(kind, type) and issubclass(kind, Struct)):
        return _by_fields(kind)
    return None


def _tuple(forms: tuple[Form, ...]) -> Form:
    def read(told: object) -> tuple[Any, ...]:
        values = taken(told, list[Any], WHAT)
        if len(values) != len(forms):
            raise InputError(f"{WHAT}: {show(told)} does not have {len(forms)} entries")
        return tuple(form.read(value) for form, value in zip(forms, values, strict=True))

    return Form(
        lambda values: [form.write(value) for form, value in zip(forms, values, strict=True)], read
    )


def _by_fields(kind: Any) -> Form | None:
    hints = get_type_hints(kind, include_extras=True)
    if not any(_own_form(hints[name]) for name in names_of(kind)):
        return None
    forms = {name: _form(hints[name]) for name in names_of(kind)}

    def read(told: object) -> Any:
        values = taken(told, dict[str, Any], WHAT)
        if values.keys() != forms.keys():
            raise InputError(f"{WHAT}: the keys are {', '.join(forms)}, not {show([*values])}")
        return kind(**{name: form.read(values[name]) for name, form in forms.items()})

    return Form(
        lambda value: {name: form.write(getattr(value, name)) for name, form in forms.items()}, read
    )
