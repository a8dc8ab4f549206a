"""Options that verbs share and that are of no request: the files and words of the command line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from allworlds.inputs import OUTPUT, SCOPE, Argument, Option, one_of
from allworlds.world import LIGHTHOUSES

WORLD = "Inline JSON, @file, or a name such as k4, wheel-4, fig1-left."
WorldText = Annotated[str, Argument("", "WORLD", WORLD)]
LighthouseOfWorld = Annotated[
    str,
    Option(SCOPE, "KIND", f"The lighthouse of a WORLD that names none: {one_of(LIGHTHOUSES)}."),
]


CsvFile = Annotated[str | None, Option(OUTPUT, "FILE", "Write the rows as CSV too.")]


@dataclass(frozen=True, slots=True)
class OutputGroup:
    """What is printed."""

    as_json: Annotated[bool, Option(OUTPUT, "", "One JSON document on stdout.", "json")] = False
    quiet: Annotated[
        bool, Option(OUTPUT, "", "No progress, and of a verdict one line.", "quiet", "q")
    ] = False


@dataclass(frozen=True, slots=True)
class LongOutputGroup(OutputGroup):
    """What is printed of a verb that may take long, and what is told of it meanwhile."""

    events: Annotated[
        str | None,
        Option(OUTPUT, "FILE", "Write what happens, as it happens: a line of JSON each."),
    ] = None
