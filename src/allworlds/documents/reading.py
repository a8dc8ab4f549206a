"""The strict reading of documents: from a JSON value to a value of a type."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, TypeVar

from msgspec import ValidationError, convert, inspect

from allworlds.inputs.checks import InputError, show

T = TypeVar("T")


def parse(document: object, kind: type[T], what: str) -> T:
    """The value of type ``kind`` that a JSON value describes.

    Args:
        document: the parsed JSON value.
        kind: a type that msgspec knows.
        what: the words that name the whole JSON value in errors.

    Raises:
        InputError: naming the offending value, its place, and what would be legal.
    """
    try:
        return convert(document, kind)
    except ValidationError as error:
        if isinstance(error.__cause__, InputError):
            raise error.__cause__ from None
        said, path = _PLACED.fullmatch(str(error)).groups("")  # type: ignore[union-attr]
        steps = _STEP.findall(path)
        where = f"{path.lstrip('.')} = {show(_at(document, steps))}" if path else what
        legal = ", ".join(map(str, _legal(inspect.type_info(kind), steps)))
        if legal and said.startswith("Invalid enum"):
            raise InputError(f"{where} is not one of {legal}") from None
        said = show(said[:1].lower() + said[1:].replace("`", ""))[1:-1]
        raise InputError(f"{where}: {said}") from None
    except UnicodeEncodeError:
        raise InputError(f"{what}: a key or a word in it is no text") from None


_PLACED = re.compile(r"(.*?)(?: - at `(?:key` in `)?\$([^`\n]*)`)?", re.DOTALL)
"""The pattern of an error of msgspec: the words, and the path to the offending value."""

_STEP = re.compile(r"\[[^]]*\]|[^.[]+")
"""The pattern of a step in a path: a key, an index such as ``[0]``, or ``[...]`` for the value in
a dictionary."""


def _at(document: Any, steps: Iterable[str]) -> object:
    """The part of a JSON value to which steps such as ``rows`` and ``[0]`` lead.

    If a step does not exist, the result is the part to which the steps before it lead.
    """
    for step in steps:
        if step == "[...]":
            return document
        try:
            document = document[int(step[1:-1])] if step[:1] == "[" else document[step]
        except (LookupError, TypeError, ValueError):
            return document
    return document


def _legal(kind: inspect.Type, steps: Sequence[str]) -> Iterator[object]:
    """Yield the legal values of a part of a JSON value, if the type of the part is an enumeration.

    ``kind`` is msgspec's description of the type of the whole JSON value; ``steps``, such as
    ``rows`` and ``[0]``, lead to the part.
    """
    match kind:
        case inspect.Metadata(type=one):
            yield from _legal(one, steps)
        case inspect.UnionType(types=several):
            for one in several:
                yield from _legal(one, steps)
        case inspect.LiteralType(values=values) if not steps:
            yield from values
        case inspect.EnumType(cls=values) if not steps:
            yield from (each.value for each in values)
        case inspect.StructType(fields=parts) if steps:
            for part in parts:
                if part.encode_name == steps[0]:
                    yield from _legal(part.type, steps[1:])
        case inspect.DictType(value_type=one) | inspect.CollectionType(item_type=one) if steps:
            yield from _legal(one, steps[1:])
