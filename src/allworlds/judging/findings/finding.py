"""A refuting run as a value: enough to replay it with nothing else."""

from __future__ import annotations

import json
import shlex
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any, Final, Literal

from allworlds.document import Document, IfAny, Natural, Paged, about, read_by, taken
from allworlds.explorers import HASH_SEED, named_on_command_line, own_bound
from allworlds.inputs import InputError, parse_json, show
from allworlds.judging.findings.rules import RecordedRules, Rules
from allworlds.judging.findings.sense_of_rotation import Chirality
from allworlds.judging.laws.case import Value
from allworlds.judging.laws.law_table import PRECEDENCE, LawName
from allworlds.maps import Code, numbering, rooted_code
from allworlds.protocol import Estimate, Transcript
from allworlds.world import World

VERSION: Final = 1


@dataclass(frozen=True)
class Finding(Paged):
    """A world, an explorer, its run there, and the law that it broke.

    Attributes:
        explorer: its name.
        law: the broken law.
        world: in canonical numbering: the start is dart 0.
        place: the lighthouse's place among those of the rooted map.
        rules: the rules by which the run was played and judged.
        choices: the index taken at each choice.
        transcript: the log, up to the end of the run.
        expected, seen: estimates for map and pose, integers for bound, else a sentence.
        detail: a traceback, the tail of a program's stderr, or the permutations that are no map;
            may be empty.
        step: the number of steps before the checkpoint that breaks the law; None where none does.
        confirmed: whether a fresh process has repeated it from the recorded percepts alone.
        minimal: whether no smaller world of the scope is refuting.
        machine: whether the machine may be the cause.
        output: the explorer's prints when this run alone was played in a fresh process.
        traced: whether its walk is known; a run that has killed its worker is traced when reported.
        hash_seed: the ``PYTHONHASHSEED`` that reproduces it, if another makes a difference.
        chirality: the explorer's sense of rotation in a chiral world; None if not played in one.
    """

    explorer: str
    law: str
    world: World
    place: int
    rules: Rules
    choices: tuple[int, ...]
    transcript: Transcript
    expected: Value
    seen: Value
    detail: str = ""
    step: int | None = None
    confirmed: bool = False
    minimal: bool = False
    machine: bool = False
    traced: bool = True
    hash_seed: int | None = None
    output: str = ""
    chirality: Chirality | None = None

    @cached_property
    def key(self) -> tuple[int, int, Code, int, tuple[int, ...]]:
        """The order of findings: edges, vertices, canonical code, place, choices."""
        map_ = self.world.map
        code = rooted_code(map_.sigma, map_.alpha, self.world.start)
        return (map_.edge_count, map_.vertex_count, code, self.place, self.choices)

    @cached_property
    def kind(self) -> tuple[str, Code]:
        """The kind of the finding: the law, and the map, whatever its start."""
        map_ = self.world.map
        return self.law, min(rooted_code(map_.sigma, map_.alpha, dart) for dart in map_.darts)

    @property
    def reproduce(self) -> str:
        """A shell command that runs the explorer in this world again."""
        command = ["allworlds", "run", *named_on_command_line(self.explorer)]
        command += [json.dumps(self.world.to_json(), separators=(",", ":"))]
        line = shlex.join(command + self.rules.arguments(self.choices))
        return line if self.hash_seed is None else f"{HASH_SEED}={self.hash_seed} {line}"

    def to_json(self) -> dict[str, Any]:
        """The document :class:`FindingDocument`."""
        return FindingDocument(
            version=VERSION,
            explorer=self.explorer,
            law=self.law,
            world=self.world,
            options=self.rules.recorded,
            choices=self.choices,
            transcript=self.transcript,
            expected=self.expected,
            seen=self.seen,
            confirmed=self.confirmed,
            minimal=self.minimal,
            reproduce=self.reproduce,
            step=self.step,
            detail=self.detail,
            hash_seed=self.hash_seed,
            output=self.output,
        ).to_json()

    @classmethod
    def from_json(cls, document: str | Mapping[str, Any]) -> Finding:
        """The finding of :meth:`to_json`'s document, or of its text.

        Of a report of ``check`` it is the first finding, of a report of ``run`` its finding.

        Raises:
            InputError: naming the offending value and what would be legal.
        """
        if isinstance(document, str):
            document = parse_json(document)
        document = findings_of(document)[0]
        if isinstance(document, Mapping) and "sigma" in document:
            raise InputError("this is a world or a map, not a finding; see run")
        if not isinstance(document, Mapping):
            raise InputError(f"a finding is an object, not {show(document)}")
        if document.get("version") != VERSION:
            raise InputError(
                f"finding of version {show(document.get('version'))}; this program reads {VERSION}"
            )
        explorer, law = document.get("explorer"), document.get("law")
        if not isinstance(explorer, str):
            raise InputError(f"a finding names its explorer, not {show(explorer)}")
        if law not in PRECEDENCE:
            raise InputError(f"law {show(law)} is not one of {', '.join(PRECEDENCE)}")
        world = World.from_json(document.get("world", {}))
        read = taken(document, FindingDocument, "finding")
        own = own_bound(read.explorer, world.lighthouse.kind)
        return cls(
            read.explorer,
            read.law,
            world,
            place_of(world),
            read.options.rules(world, own),
            read.choices,
            _transcript(read.transcript),
            _value("expected", read.expected),
            _value("seen", read.seen),
            read.detail,
            read.step,
            confirmed=read.confirmed,
            minimal=read.minimal,
            hash_seed=read.hash_seed,
            output=read.output,
        )


class FindingDocument(Document, forbid_unknown_fields=False):
    """Finding.

    A refuting run, as it is written: enough to replay it with nothing else. Where one is read,
    other keys are ignored, but not in its world.
    """

    version: Annotated[Literal[1], about("the version of findings")]
    explorer: Annotated[str, about("its name")]
    law: Annotated[LawName, about("the broken law")]
    world: Annotated[
        Any,
        read_by(World),
        about("in canonical numbering: the start is dart 0; any numbering where it is read"),
    ]
    options: Annotated[RecordedRules, about("how the run was played and judged")] = RecordedRules()
    choices: Annotated[
        tuple[Natural, ...],
        about("the index taken at each choice; of a turn that never ended the first 1000"),
    ] = ()
    transcript: Annotated[
        Any, read_by(Transcript), about("the log, which must be a walk in the world")
    ]
    expected: Annotated[
        Any,
        read_by(Value),
        about("a rooted map for `map` and `pose`, an integer for `bound`, else a sentence"),
    ] = "not recorded"
    seen: Annotated[Any, read_by(Value), about("the same of what was found")] = "not recorded"
    confirmed: Annotated[
        bool, about("a fresh process did the same, from the recorded percepts alone")
    ] = False
    minimal: Annotated[bool, about("no smaller world of the scope refutes")] = False
    reproduce: Annotated[str, about("a shell command that runs it again")] = ""
    step: Annotated[
        IfAny[Natural | None],
        about("how many steps came before the checkpoint that breaks the law"),
    ] = None
    detail: Annotated[
        IfAny[str],
        about(
            "a traceback, the end of a program's stderr, two plays that differ, side by side, "
            "or the permutations that are no map"
        ),
    ] = ""
    hash_seed: Annotated[
        IfAny[Natural | None],
        about("the `PYTHONHASHSEED` with which it is so, where another one makes a difference"),
    ] = None
    output: Annotated[
        IfAny[str],
        about(
            "what the explorer printed in this run, to stdout and stderr; at most 4 KiB, of more "
            "the first and the last half, with control characters escaped"
        ),
    ] = ""


def _transcript(rows: object) -> Transcript:
    try:
        return Transcript.from_json(rows)
    except ValueError as error:
        raise InputError(str(error)) from None


def _value(name: str, given: Any) -> Value:
    """The recorded expectation, or observation, as a value."""
    if isinstance(given, Mapping):
        try:
            return Estimate.from_json(given)
        except InputError as error:
            raise InputError(f"{name}.{error}") from None
    if isinstance(given, str) or type(given) is int:
        return given
    raise InputError(f"{name} is a rooted map, an integer or a text, not {show(given)}")


def findings_of(document: Any) -> Sequence[Any]:
    """The documents of the findings of a report; any other document by itself.

    Raises:
        InputError: if the report holds none.
    """
    match document:
        case {"schema": 1, "findings": [_, *_]}:
            findings: Sequence[Any] = document["findings"]
            return findings
        case {"schema": 1, "finding": {} as finding}:
            return [finding]
        case {"schema": 1, "verdict": verdict}:
            raise InputError(f"the report, with the verdict {show(verdict)}, holds no finding")
        case _:
            return [document]


def place_of(world: World) -> int:
    """The number of the lighthouse's place among those of the rooted map."""
    return world.lighthouse.number(world.map, world.start)


def canonical_world(world: World) -> World:
    """Return the world in canonical numbering: its start is dart 0."""
    names = [0] * len(world.map.sigma)
    for number, dart in enumerate(numbering(world.map.sigma, world.map.alpha, world.start)):
        names[dart] = number
    return world.relabelled(names)
