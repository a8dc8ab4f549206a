"""The words in which documents are described: what narrows a type, and the narrowed types.

The metadata of ``Annotated`` say it: a text describes the value, :class:`Keywords` are those of
JSON Schema, and the others are told below.
"""

from typing import Annotated, Literal, NamedTuple

from allworlds.outcome import Exit


class Keywords:
    """Keywords of JSON Schema that narrow a type, such as ``minimum=0``."""

    def __init__(self, **given: object) -> None:
        self.given = given


class Named(NamedTuple):
    """One of the names of a table, which is given as ``module:name``."""

    table: str


class KindsOf(NamedTuple):
    """What ``to_json`` of an entry of a table writes, whose ``kind`` is the entry's name."""

    table: str


class Begins(NamedTuple):
    """The first entry of a list is of that one of its types, every other of another one."""

    first: type


Version = Annotated[Literal[1], "the version of the document"]
Natural = Annotated[int, Keywords(minimum=0)]
Positive = Annotated[int, Keywords(minimum=1)]
Dart = Annotated[int, Keywords(minimum=0)]
Seconds = Annotated[float, Keywords(minimum=0)]
Figure = Annotated[float, Keywords(minimum=0)]
Text = Annotated[str, Keywords(minLength=1)]
Numeral = Annotated[str, Keywords(pattern="^[0-9]+$")]
OfShard = Keywords(pattern="^[0-9]+/[0-9]+$")
Some = Keywords(minItems=1)
Two = Keywords(minItems=2, maxItems=2)
Different = Keywords(uniqueItems=True)

LawName = Annotated[str, Named("judging:PRECEDENCE")]
JudgedLaw = Annotated[str, Named("judging:LAWS")]
ClassName = Annotated[str, Named("maps:MapClass")]
VerdictName = Annotated[str, Named("outcome:Verdict")]
EngineName = Annotated[str, Named("engines:ENGINES")]


def code(*codes: Exit) -> Keywords:
    """One of these exit codes."""
    return Keywords(enum=[int(each) for each in codes])
