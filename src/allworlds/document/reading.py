"""Strict reading: a JSON value becomes one of a type, or an error that names what is wrong."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any, TypeVar

from msgspec import ValidationError, convert, inspect

from allworlds.inputs.checks import InputError, show

T = TypeVar("T")


def parse(document: object, kind: type[T], what: str) -> T:
    """The value of that type that a JSON value stands for.

    Args:
        document: as a parser of JSON hands it back.
        kind: a type that msgspec knows.
        what: the words for the whole.

    Raises:
        InputError: naming the offending value, where it stands, and what would be legal.
    """
    try:
        return convert(document, kind)
    except ValidationError as error:
        if isinstance(error.__cause__, InputError):
            raise error.__cause__ from None
        said, path = _PLACED.fullmatch(str(error)).groups("")  # type: ignore[union-attr]
        steps = path.lstrip(".").replace("[", ".[").split(".") if path else []
        where = f"{path.lstrip('.')} = {show(_at(document, steps))}" if path else what
        if legal := _legal(kind, steps) if said.startswith("Invalid enum") else []:
            raise InputError(f"{where} is not one of {', '.join(map(str, legal))}") from None
        said = show(said[:1].lower() + said[1:].replace("`", ""))[1:-1]
        raise InputError(f"{where}: {said}") from None
    except UnicodeEncodeError:
        raise InputError(f"{what}: a key or a word in it is no text") from None


_PLACED = re.compile(r"(.*?)(?: - at `(?:key` in `)?\$([^`\n]*)`)?", re.DOTALL)
"""An error of msgspec: its words, and the path of the value."""


def _at(document: Any, steps: Iterable[str]) -> object:
    """The value to which steps such as ``rows`` and ``[0]`` lead, or the last one on the way."""
    for step in steps:
        if step == "[...]":
            return document
        try:
            document = document[int(step[1:-1])] if step[:1] == "[" else document[step]
        except (LookupError, TypeError, ValueError):
            return document
    return document


def _legal(kind: Any, steps: Iterable[str]) -> list[object]:
    """The values of an enumeration that stands where the steps lead."""
    kinds = _alternatives(inspect.type_info(kind))
    for step in steps:
        kinds = [part for one in kinds for part in _part(one, step)]
    legal: list[object] = []
    for one in kinds:
        if isinstance(one, inspect.LiteralType):
            legal += one.values
        elif isinstance(one, inspect.EnumType):
            legal += [each.value for each in one.cls]
    return legal


def _part(kind: inspect.Type, step: str) -> list[inspect.Type]:
    match kind:
        case inspect.StructType(fields=told):
            return [part for f in told if f.encode_name == step for part in _alternatives(f.type)]
        case inspect.DictType(value_type=part) | inspect.CollectionType(item_type=part):
            return _alternatives(part)
    return []


def _alternatives(kind: inspect.Type) -> list[inspect.Type]:
    match kind:
        case inspect.Metadata(type=one):
            return _alternatives(one)
        case inspect.UnionType(types=several):
            return [one for each in several for one in _alternatives(each)]
    return [kind]
