"""What a run directory is of: the same for two runs if their results can be put together."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Self

from allworlds.inputs import show
from allworlds.version import __version__
from allworlds.work import Portion, a_shard, shards_of


@dataclass(frozen=True, slots=True)
class Identity:
    """A verb, with everything that its result depends on.

    Attributes:
        verb: its name.
        parameters: by their names, as JSON values.
        explorer: the name, and what else is to be known of it without loading it; its digest.
        portion: which part of the units is done.
        version: of this program.
    """

    verb: str
    parameters: Mapping[str, Any]
    explorer: Mapping[str, Any]
    portion: Portion
    version: str = __version__

    @property
    def text(self) -> str:
        """It as JSON, the same for equal ones."""
        return canonical(
            {
                "verb": self.verb,
                "version": self.version,
                "parameters": dict(self.parameters),
                "explorer": dict(self.explorer),
                "shard": str(self.portion),
            }
        )

    @property
    def digest(self) -> str:
        """SHA-256 of the text, in hexadecimal."""
        return hashlib.sha256(self.text.encode()).hexdigest()

    @classmethod
    def of_text(cls, text: str) -> Self:
        """The identity of :attr:`text`."""
        told = json.loads(text)
        index, _, count = told["shard"].partition("/")
        return cls(
            told["verb"],
            told["parameters"],
            told["explorer"],
            a_shard((int(index), int(count))),
            told["version"],
        )

    @property
    def shards(self) -> int:
        """Into how many the job is cut."""
        return shards_of(self.portion)

    def difference(self, other: Identity) -> str:
        """What the other one differs in, as a clause about the other; empty if in nothing.

        Which of the shards it is makes no difference here; how many there are does.
        """
        if other.version != self.version:
            return f"is of version {show(other.version)}, not {show(self.version)}"
        if other.verb != self.verb:
            return f"is of {show(other.verb)}, not {show(self.verb)}"
        for name in sorted({*self.parameters, *other.parameters}):
            mine, its = self.parameters.get(name), other.parameters.get(name)
            if mine != its:
                said = name.replace("_", "-")
                return f"is of {said} = {show(its)}, not {show(mine)}"
        mine, its = self.explorer["name"], other.explorer["name"]
        if mine != its:
            return f"is of the explorer {show(its)}, not {show(mine)}"
        if other.explorer != self.explorer:
            return f"is of another text of the explorer {show(mine)}, or of its program"
        if other.shards != self.shards:
            return f"is of {other.portion}, one of {other.shards} shards, not of {self.shards}"
        return ""


def canonical(value: Any) -> str:
    """A JSON value as a text that is the same for equal values."""
    return _CANONICAL.encode(value)


_CANONICAL = json.JSONEncoder(sort_keys=True, separators=(",", ":"))
