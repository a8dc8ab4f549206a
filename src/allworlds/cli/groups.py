"""Options declared once and taken by many verbs: a dataclass of options in a verb's signature."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from functools import wraps
from typing import Any, get_type_hints


def grouped(verb: Callable[..., int]) -> Callable[..., int]:
    """The verb as typer is to see it: each parameter that is a group as the options in it.

    A group is a parameter whose type is a dataclass; every field is an option, with its default.
    The verb itself gets the group as one value.
    """
    hints = get_type_hints(verb, include_extras=True)
    seen: list[inspect.Parameter] = []
    groups: dict[str, Any] = {}
    for name, parameter in inspect.signature(verb).parameters.items():
        if isinstance(hints[name], type) and is_dataclass(hints[name]):
            groups[name] = hints[name]
            seen += _options(hints[name])
        else:
            seen.append(parameter.replace(annotation=hints[name]))

    @wraps(verb)
    def command(**given: Any) -> int:
        for name, group in groups.items():
            given[name] = group(**{field.name: given.pop(field.name) for field in fields(group)})
        return verb(**given)

    command.__signature__ = inspect.Signature(seen)  # type: ignore[attr-defined]  # for typer
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in seen}
    return command


def _options(group: Any) -> list[inspect.Parameter]:
    hints = get_type_hints(group, include_extras=True)
    return [
        inspect.Parameter(
            field.name,
            inspect.Parameter.KEYWORD_ONLY,
            default=field.default,
            annotation=hints[field.name],
        )
        for field in fields(group)
    ]
