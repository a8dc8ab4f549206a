"""Conditions that narrow a class of maps, as requests ask for them: ours, and the user's own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from random import Random
from typing import Annotated, TypeAlias

from allworlds.document import IfAny, Text, about
from allworlds.inputs import SCOPE, InputError, Option, Request, Taken, let_users_interrupt, show
from allworlds.maps import (
    AND,
    LEGAL,
    AllOf,
    CombinatorialMap,
    Condition,
    condition_named,
    rooted_maps,
)
from allworlds.protocol import UserCode, find_code, function_of, said

ENTRY_POINTS = "allworlds.predicates"

TRIED_EDGES = 3
"""In all maps with so many edges a predicate must not depend on the numbering of the darts."""

Predicate: TypeAlias = Callable[[CombinatorialMap], bool]


@dataclass(frozen=True, slots=True)
class OwnCondition:
    """A predicate of the user's; it is loaded where maps are made."""

    name: str
    code: UserCode

    @property
    def codes(self) -> tuple[UserCode, ...]:
        """The predicate."""
        return (self.code,)

    def holds(self, map_: CombinatorialMap) -> bool:
        """Whether the predicate says so.

        Raises:
            InputError: if it raises, or says neither True nor False.
        """
        predicate = _predicate(self.code)
        try:
            found = predicate(map_)
        except BaseException as error:  # noqa: BLE001  # a predicate may raise anything
            let_users_interrupt(error)
            raise InputError(f"where {show(self.name)} raises {said(error)}") from None
        if type(found) is not bool:
            raise InputError(f"where {show(self.name)} returns {show(found)}, not True or False")
        return found

    def __str__(self) -> str:
        return self.name


@cache
def _predicate(code: UserCode) -> Predicate:
    shape = "def predicate(map), which returns True or False"
    predicate: Predicate = function_of("where", code, ENTRY_POINTS, shape)
    return predicate


def a_condition(given: object) -> Condition | None:
    """The condition of a name, or all of those of several, the user's tried on small maps.

    Raises:
        InputError: naming the legal ones, or two numberings of one map that it takes apart.
    """
    if given is None:
        return None
    several = given.split(AND) if isinstance(given, str) else given
    if not isinstance(several, list | tuple):
        return _one_condition(given)
    parts = tuple(dict.fromkeys(map(_one_condition, several)))
    return AllOf(parts) if len(parts) > 1 else next(iter(parts), None)


def _one_condition(given: object) -> Condition:
    if not isinstance(given, str):
        if isinstance(getattr(given, "name", None), str) and hasattr(given, "holds"):
            return given  # type: ignore[return-value]  # it has what conditions have
        raise InputError(f"where = {show(given)} is not a text")
    if (ours := condition_named(given)) is not None:
        return ours
    own = OwnCondition(given, find_code("where", given, ENTRY_POINTS, (LEGAL,)))
    _ensure_no_numbering_counts(own)
    return own


def _ensure_no_numbering_counts(own: OwnCondition) -> None:
    """Raise InputError if the condition holds of a map and not of the same with other names."""
    names = Random(TRIED_EDGES)  # noqa: S311  # any names
    for edges in range(1, TRIED_EDGES + 1):
        for map_ in rooted_maps(edges):
            other = [*map_.darts]
            names.shuffle(other)
            renamed = map_.relabelled(other)
            if own.holds(map_) != own.holds(renamed):
                raise InputError(
                    f"where {show(own.name)} depends on the numbering of the darts: it says "
                    f"{own.holds(map_)} of {map_}, and {own.holds(renamed)} of the same map as "
                    f"{renamed}"
                )


class AskedWhere(Request):
    """The part of a request that adds a condition on the maps."""

    where: Annotated[
        Taken[str | Condition | Sequence[str | Condition] | None, Condition | None],
        Option(
            SCOPE,
            "WHERE",
            f"Only maps of which that is true: {LEGAL}, or path/to/file.py:predicate, a function "
            "of a map; of several, given one by one, each is.",
            repeated=True,
            told=Annotated[IfAny[Text | None], about("what besides is true of the maps")],
        ),
    ] = Taken(a_condition, None)

    @property
    def condition(self) -> Condition | None:
        """The condition, for the extent."""
        return self.where


def files_of_condition(condition: Condition | None) -> tuple[Path, ...]:
    """The files of the user's that a condition needs."""
    codes: Sequence[UserCode] = getattr(condition, "codes", ())
    return tuple(code.file(ENTRY_POINTS) for code in codes)
