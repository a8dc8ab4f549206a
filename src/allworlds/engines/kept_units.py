"""The contents of a run directory: the identity of its job, and results of units as JSON.

The identity of a job is a verb with everything that the verb's result depends on.

The JSON of a result follows from the types of its fields.  A struct or a dataclass becomes an
object with its fields as keys.  A counter, or a dictionary whose keys are not texts, becomes a list
of pairs.  A type with a function ``from_json`` is kept in the form that this function reads.
msgspec determines the form of any other type.
"""

import hashlib
import json
from collections import Counter
from collections.abc import Callable
from dataclasses import is_dataclass
from functools import cache
from typing import Annotated, Any, NamedTuple, Self, TypeVar, get_args, get_origin, get_type_hints

from msgspec import Struct

from allworlds import words
from allworlds.documents import document as doc
from allworlds.documents.reading import parse
from allworlds.engines.units import Shard, Sum, a_shard, shard_numbers
from allworlds.inputs.checks import InputError, show
from allworlds.version import __version__

FORMAT = 5
"""The format of identities and of kept units; the number grows whenever one of the two changes."""


class Identity(doc.Document):
    """A verb, with everything that its result depends on."""

    verb: Annotated[doc.Text, doc.about("its name")]
    parameters: Annotated[dict[str, Any], doc.about("by their names, as JSON values")]
    explorer: Annotated[
        dict[str, Any],
        doc.about("the name, and what else is to be known of it without loading it; its digest"),
    ]
    shard: Annotated[doc.ShardText, doc.about("which part of the units is done")]
    version: Annotated[doc.Text, doc.about("of this program")] = __version__
    format: Annotated[
        doc.Positive, doc.about("of what is kept: a number that `FORMAT` has had")
    ] = FORMAT

    @property
    def text(self) -> str:
        """The identity as canonical JSON; equal identities have equal texts."""
        return canonical(self.to_json())

    @property
    def digest(self) -> str:
        """SHA-256 of :attr:`text`, in hexadecimal."""
        return hashlib.sha256(self.text.encode()).hexdigest()

    @classmethod
    def of_text(cls, text: str) -> Self:
        """The identity with this :attr:`text`."""
        return parse({"format": 1} | json.loads(text), cls, "identity")

    @property
    def portion(self) -> Shard:
        """The shard: the part of all units that the job does."""
        return a_shard(shard_numbers(self.shard))

    @property
    def code(self) -> dict[str, str]:
        """The user's code that the job needs.

        Return a dictionary from the name of each piece of code to its text, or to its digest if it
        is a module.
        """
        code: dict[str, str] = self.parameters.get("code", {})
        return code

    @property
    def shards(self) -> int:
        """The number of shards into which the job is cut."""
        return self.portion.count

    def difference(self, other: "Identity") -> str:
        """A clause about the first value in which ``other`` differs from this identity.

        The clause is empty if there is no such value.  The number of shards is compared, but not
        the index of the shard.
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
            return f"is of {part}, and not of a job in {words.plural(self.shards, 'part')}"
        return ""


def _in_words(value: Any) -> str:
    """The value of a parameter as a user writes it on the command line.

    For the value None these words are ``the default``; a list becomes a text with commas.
    """
    if value is None:
        return "the default"
    return ",".join(map(str, value)) if isinstance(value, list | tuple) else show(value)


canonical = json.JSONEncoder(sort_keys=True, separators=(",", ":")).encode
"""The function from a JSON value to its canonical text, which is equal for equal values."""

ENDED = "complete"
"""The value that is noted under the name ``ended`` once the whole job is done."""


class KeptUnits:
    """The finished units of a job, and further values that are noted under names.

    This base class keeps nothing; a run directory is a subclass.

    Attributes:
        added: the number of units that were added.
    """

    added = 0

    def result(self, key: str) -> Any:
        """Return the JSON value of the result of the finished unit with this key.

        Return None if there is no such unit.
        """

    def keep(self, key: str, result: Sum) -> None:
        """Add a finished unit: its key, and its whole result."""

    def recall(self, name: str) -> Any:
        """Return the value that was noted under a name; None if no value was noted."""

    def note(self, name: str, value: Any) -> None:
        """Note a JSON value under a name."""


NOTHING_KEPT = KeptUnits()


T = TypeVar("T")

WHAT = "what is kept of a unit"


class Form(NamedTuple):
    """The form in which values of a type are kept.

    A field can have a form of its own: its type is then ``Annotated`` with the form.

    Attributes:
        write: the function from a value to its JSON value.
        read: the function from this JSON value back to the value; it raises InputError for any
            other JSON value.
    """

    write: Callable[[Any], Any]
    read: Callable[[Any], Any]


def to_kept(result: object) -> Any:
    """The JSON value of a result."""
    kind: Any = type(result)
    return _form(kind).write(result)


def from_kept(kept: object, kind: type[T]) -> T:
    """The result of the class ``kind`` for which :func:`to_kept` has returned the value ``kept``.

    Raises:
        InputError: if no result of this class has this JSON value.
    """
    made: Any = kind
    found: T = _form(made).read(kept)
    return found


@cache
def _form(kind: Any) -> Form:
    return _own_form(kind) or Form(doc.plain_at_once, lambda kept: parse(kept, kind, WHAT))


def _own_form(kind: Any) -> Form | None:
    """The form of a type that msgspec cannot read and write by itself; None if msgspec can."""
    origin, parts = get_origin(kind), get_args(kind)
    if origin is Annotated:
        return next((note for note in parts if isinstance(note, Form)), None) or _own_form(parts[0])
    if origin is Counter or (origin is dict and parts[0] is not str):
        items = _form(list[tuple[(*parts, int)[:2]]])  # type: ignore[misc]  # a type made of types
        return Form(
            lambda table: items.write([*table.items()]),
            lambda kept: origin(dict(items.read(kept))),
        )
    if origin is list and (one := _own_form(parts[0])):
        return Form(
            lambda values: [one.write(value) for value in values],
            lambda kept: [one.read(value) for value in parse(kept, list[Any], WHAT)],
        )
    if origin is tuple and any(map(_own_form, parts)):
        return _tuple(tuple(map(_form, parts)))
    if hasattr(kind, "from_json"):
        return Form(doc.plain, kind.from_json)
    if is_dataclass(kind) or (isinstance(kind, type) and issubclass(kind, Struct)):
        return _by_fields(kind)
    return None


def _tuple(forms: tuple[Form, ...]) -> Form:
    def read(kept: object) -> tuple[Any, ...]:
        values = parse(kept, list[Any], WHAT)
        if len(values) != len(forms):
            raise InputError(f"{WHAT}: {show(kept)} does not have {len(forms)} entries")
        return tuple(form.read(value) for form, value in zip(forms, values, strict=True))

    return Form(
        lambda values: [form.write(value) for form, value in zip(forms, values, strict=True)], read
    )


def _by_fields(kind: Any) -> Form | None:
    hints = get_type_hints(kind, include_extras=True)
    if not any(_own_form(hints[name]) for name in doc.names_of(kind)):
        return None
    forms = {name: _form(hints[name]) for name in doc.names_of(kind)}

    def read(kept: object) -> Any:
        values = parse(kept, dict[str, Any], WHAT)
        if values.keys() != forms.keys():
            raise InputError(f"{WHAT}: the keys are {', '.join(forms)}, not {show([*values])}")
        return kind(**{name: form.read(values[name]) for name, form in forms.items()})

    return Form(
        lambda value: {name: form.write(getattr(value, name)) for name, form in forms.items()}, read
    )
