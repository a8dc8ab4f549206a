"""Types of keys, and the notes beside them: meaning, range, and whether a key may be missing."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple, TypeAlias, TypeVar

from msgspec import Meta

from allworlds.outcome import Exit

T = TypeVar("T")

ASIDE = Meta(extra={"aside": True})
Aside: TypeAlias = Annotated[T, ASIDE]
"""A field that is no key of the document."""

IF_ANY = Meta(extra={"if any": True})
IfAny: TypeAlias = Annotated[T, IF_ANY]
"""A key that is left out where its value is None or empty."""


class ReadBy(NamedTuple):
    """The type of a value, and how it is read from JSON."""

    type: Any
    read: Callable[[Any], Any]


def read_by(kind: Any, read: Callable[[Any], Any] | None = None) -> Meta:
    """Values of a type that msgspec does not read, in a field of the type Any.

    Args:
        kind: the type.
        read: makes a value of what a parser of JSON hands back; None where none is read.
    """
    return Meta(extra={"kind": kind, "read": read and ReadBy(kind, read)})


if TYPE_CHECKING:
    FromJson: TypeAlias = Annotated[T, "read by its from_json"]
    """A field of a class that reads its values by itself."""
else:

    class FromJson:
        """The annotation of such a field, which msgspec need not know."""

        def __class_getitem__(cls, kind: Any) -> Any:
            return Annotated[Any, read_by(kind, kind.from_json)]


def about(meaning: str) -> Meta:
    """A one-line meaning of a field."""
    return Meta(description=meaning)


def narrowed(**keywords: Any) -> Meta:
    """Keywords of JSON Schema that narrow a type which needs no words."""
    return Meta(extra_json_schema=keywords)


def one_of(*values: object) -> Meta:
    """One of these values of a wider type."""
    return narrowed(enum=[*values])


Natural = Annotated[int, Meta(ge=0)]
Positive = Annotated[int, Meta(ge=1)]
Seconds = Annotated[float, Meta(ge=0)]
Figure = Annotated[float, Meta(ge=0)]
Text = Annotated[str, Meta(min_length=1)]
ShardText = Annotated[str, Meta(pattern="^[0-9]+/[0-9]+$")]
Entries: TypeAlias = Annotated[Sequence[T], Meta(min_length=1)]
Permutation: TypeAlias = Annotated[tuple[Natural, ...], Meta(min_length=2)]
Pair: TypeAlias = Annotated[tuple[T, ...], Meta(min_length=2, max_length=2)]
Some: TypeAlias = Annotated[tuple[T, ...], Meta(min_length=1)]
Different: TypeAlias = Annotated[tuple[T, ...], narrowed(uniqueItems=True)]


AllRows = Annotated[
    bool, about("whether every row is there; false: stopped, or interrupted by the user")
]
Why = Annotated[
    IfAny[str | None],
    about("why rows are missing; left out: none is missing, or the user interrupted"),
]
Edges = Annotated[Positive, about("the number of edges")]
Vertices = Annotated[Positive, about("the number of vertices")]
ExitCode = Annotated[Exit, about("the exit code of the command")]
Bounded = Annotated[Positive | None, about("at most so many; null: not bounded")]
WhichShard = Annotated[ShardText, about("`K/N`; `0/1` is the whole")]
