"""A job's identity.  Results are put together only if their identities are equal."""

from __future__ import annotations

import hashlib
import json
from typing import Annotated, Any, Self

from allworlds.document import Document, Positive, ShardText, Text, about, taken
from allworlds.engines.units import Portion, a_shard, shards_of
from allworlds.inputs import show
from allworlds.version import __version__
from allworlds.words import plural

FORMAT = 3
"""The format of identities and of what is kept under them: raised whenever either changes.

1: version 0.1.0, whose identities hold no number.  2: version 0.2.0.  3: version 0.3.0.
"""


class Identity(Document):
    """A verb, with everything that its result depends on."""

    verb: Annotated[Text, about("its name")]
    parameters: Annotated[dict[str, Any], about("by their names, as JSON values")]
    explorer: Annotated[
        dict[str, Any],
        about("the name, and what else is to be known of it without loading it; its digest"),
    ]
    shard: Annotated[ShardText, about("which part of the units is done")]
    version: Annotated[Text, about("of this program")] = __version__
    format: Annotated[Positive, about("of what is kept: a number that `FORMAT` has had")] = FORMAT

    @property
    def text(self) -> str:
        """Canonical JSON, the same for equal identities."""
        return canonical(self.to_json())

    @property
    def digest(self) -> str:
        """SHA-256 of the text, in hexadecimal."""
        return hashlib.sha256(self.text.encode()).hexdigest()

    @classmethod
    def of_text(cls, text: str) -> Self:
        """The identity of :attr:`text`."""
        return taken({"format": 1} | json.loads(text), cls, "identity")

    @property
    def portion(self) -> Portion:
        """The part of the units that is done: the whole, or a shard."""
        index, _, count = self.shard.partition("/")
        return a_shard((int(index), int(count)))

    @property
    def code(self) -> dict[str, str]:
        """The user's code that it needs, as it was recorded: see ``as_recorded``."""
        code: dict[str, str] = self.parameters.get("code", {})
        return code

    @property
    def shards(self) -> int:
        """The number of shards into which the job is cut."""
        return shards_of(self.portion)

    def difference(self, other: Identity) -> str:
        """The difference of the other one, as a clause about the other; empty if there is none.

        The number of a shard makes no difference here; the number of all shards does.
        """
        if other.format != self.format:
            return f"is of format {other.format}, not {self.format}"
        if other.version != self.version:
            return f"is of version {show(other.version)}, not {show(self.version)}"
        if other.verb != self.verb:
            return f"is of {show(other.verb)}, not {show(self.verb)}"
        for name in sorted({*self.parameters, *other.parameters}):
            mine, its = self.parameters.get(name), other.parameters.get(name)
            if mine != its and isinstance(mine, dict) and isinstance(its, dict):
                changed = sorted(code for code in mine if mine[code] != its.get(code))
                return f"is of another text of {', '.join(map(show, changed or its))}"
            if mine != its:
                said = name.replace("_", "-")
                return f"is of {said} = {_in_words(its)}, not {_in_words(mine)}"
        mine, its = self.explorer["name"], other.explorer["name"]
        if mine != its:
            return f"is of the explorer {show(its)}, not {show(mine)}"
        if other.explorer != self.explorer:
            return f"is of another text of the explorer {show(mine)}, or of its program"
        if other.shards != self.shards:
            part = f"shard {other.shard}" if other.shards > 1 else "the whole job"
            return f"is of {part}, and not of a job in {plural(self.shards, 'part')}"
        return ""


def _in_words(value: Any) -> str:
    """A parameter as the command line has it: without a value the default, a list with commas."""
    if value is None:
        return "the default"
    return ",".join(map(str, value)) if isinstance(value, list | tuple) else show(value)


canonical = json.JSONEncoder(sort_keys=True, separators=(",", ":")).encode
"""The canonical text of a JSON value, equal for equal values."""

in_order = json.JSONEncoder(separators=(",", ":")).encode
"""A JSON value as a text that keeps the order of keys, in which a report tells them."""
