"""The part of a request that says for what there are rows for programs."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from allworlds.inputs import OUTPUT, InputError, Option, Request, Taken, show

By: TypeAlias = Literal["size", "world", "run"]
"""Rows for programs: one for each size, each world, or each run, and explorer."""


def by_named(given: str | None) -> By | None:
    """The word, or None.

    Raises:
        InputError: naming another word.
    """
    if given in (None, "size", "world", "run"):
        return given  # type: ignore[return-value]  # one of these
    raise InputError(f"by {show(given)} is not one of size, world, run")


class AskedRows(Request):
    """The part of a request that says for what there are rows."""

    by: Annotated[
        Taken[str | None, By | None],
        Option(
            OUTPUT,
            "size|world|run",
            "Rows of --csv: one for each size, world, or run, and explorer [default: size; of "
            "worlds that grow: run].",
            apart=True,
        ),
    ] = Taken(by_named, None)
