"""Options that verbs share outside of their requests: files, and the form of the output."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from allworlds.inputs import OUTPUT, Option


@dataclass(frozen=True, slots=True)
class OutputGroup:
    """Options for the form of the output."""

    as_json: Annotated[bool, Option(OUTPUT, "", "One JSON document on stdout.", "json")] = False
    quiet: Annotated[
        bool, Option(OUTPUT, "", "Show no progress; tell a verdict in one line.", "quiet", "q")
    ] = False
