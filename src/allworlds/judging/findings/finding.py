"""A refuting run as a value: enough to replay it with nothing else."""

from __future__ import annotations

import json
import shlex
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final

from allworlds.explorers import named_on_command_line, own_bound
from allworlds.inputs import InputError, parse_json, show
from allworlds.judging.findings.rules import Rules
from allworlds.judging.laws.law_table import PRECEDENCE
from allworlds.maps import Code, numbering, rooted_code
from allworlds.protocol import Transcript
from allworlds.world import World

if TYPE_CHECKING:
    from allworlds import documents

VERSION: Final = 1


@dataclass(frozen=True)
class Finding:
    """A world, an explorer, what it did there, and the law that it broke.

    Attributes:
        explorer: its name.
        law: the broken law.
        world: in canonical numbering: the start is dart 0.
        place: the lighthouse's place among those of the rooted map.
        rules: how the run was played and judged.
        choices: the index taken at each choice.
        transcript: the log, up to the end of the run.
        expected, seen: rooted maps for map and pose, integers for bound, else a sentence.
        detail: a traceback or the tail of a program's stderr; may be empty.
        step: the number of steps before the checkpoint that breaks the law; None where none does.
        confirmed: a fresh process has repeated it from the recorded percepts alone.
        minimal: no smaller world of the scope is refuting.
        machine: what was seen may be the machine's doing.
        traced: its walk is known; a run that has killed its worker is traced when it is reported.
    """

    explorer: str
    law: str
    world: World
    place: int
    rules: Rules
    choices: tuple[int, ...]
    transcript: Transcript
    expected: documents.Value
    seen: documents.Value
    detail: str = ""
    step: int | None = None
    confirmed: bool = False
    minimal: bool = False
    machine: bool = False
    traced: bool = True

    @cached_property
    def key(self) -> tuple[int, int, Code, int, tuple[int, ...]]:
        """The order of findings: edges, vertices, canonical code, place, choices."""
        map_ = self.world.map
        code = rooted_code(map_.sigma, map_.alpha, self.world.start)
        return (map_.edge_count, map_.vertex_count, code, self.place, self.choices)

    @cached_property
    def kind(self) -> tuple[str, Code]:
        """What findings of one kind share: the law, and the map, whatever its start."""
        map_ = self.world.map
        return self.law, min(rooted_code(map_.sigma, map_.alpha, dart) for dart in map_.darts)

    @property
    def reproduce(self) -> str:
        """A shell command that runs the explorer in this world again."""
        command = ["allworlds", "run", *named_on_command_line(self.explorer)]
        command += [json.dumps(self.world.to_json(), separators=(",", ":"))]
        return shlex.join(command + self.rules.arguments(self.choices))

    def to_json(self) -> documents.FindingDocument:
        """The document of a finding."""
        document: documents.FindingDocument = {
            "version": VERSION,
            "explorer": self.explorer,
            "law": self.law,
            "world": self.world.to_json(),
            "options": self.rules.to_json(),
            "choices": list(self.choices),
            "transcript": self.transcript.to_json(),
            "expected": self.expected,
            "seen": self.seen,
            "confirmed": self.confirmed,
            "minimal": self.minimal,
            "reproduce": self.reproduce,
        }
        if self.step is not None:
            document["step"] = self.step
        if self.detail:
            document["detail"] = self.detail
        return document

    @classmethod
    def from_json(cls, document: str | Mapping[str, Any]) -> Finding:
        """The finding of :meth:`to_json`'s document, or of its text.

        Of a report of ``check`` it is the first finding, of a report of ``run`` its finding.

        Raises:
            InputError: naming the offending value and what would be legal.
        """
        if isinstance(document, str):
            document = parse_json(document)
        document = _of_report(document)
        if isinstance(document, Mapping) and "sigma" in document:
            raise InputError("this is a world or a map, not a finding; see run")
        if not isinstance(document, Mapping):
            raise InputError(f"a finding is an object, not {show(document)}")
        if document.get("version") != VERSION:
            raise InputError(
                f"finding of version {show(document.get('version'))}; this program reads {VERSION}"
            )
        explorer, law = _explorer_and_law(document)
        world = World.from_json(document.get("world", {}))
        return cls(
            explorer,
            law,
            world,
            place_of(world),
            _rules(document, explorer, world),
            _choices(document),
            _transcript(document),
            _value(document.get("expected")),
            _value(document.get("seen")),
            _detail(document),
            _step(document),
            confirmed=document.get("confirmed") is True,
            minimal=document.get("minimal") is True,
        )


def _explorer_and_law(document: Mapping[str, Any]) -> tuple[str, str]:
    explorer, law = document.get("explorer"), document.get("law")
    if not isinstance(explorer, str):
        raise InputError(f"a finding names its explorer, not {show(explorer)}")
    if law not in PRECEDENCE:
        raise InputError(f"law {show(law)} is not one of {', '.join(PRECEDENCE)}")
    return explorer, law


def _rules(document: Mapping[str, Any], explorer: str, world: World) -> Rules:
    options = document.get("options", {})
    if not isinstance(options, Mapping):
        raise InputError(f"options must be an object, not {show(options)}")
    return Rules.from_json(options, world, own_bound(explorer, world.lighthouse.kind))


def _choices(document: Mapping[str, Any]) -> tuple[int, ...]:
    choices = document.get("choices", [])
    if not isinstance(choices, list) or not all(type(i) is int and i >= 0 for i in choices):
        raise InputError(f"choices must be a list of integers from 0 on, not {show(choices)}")
    return tuple(choices)


def _transcript(document: Mapping[str, Any]) -> Transcript:
    try:
        return Transcript.from_json(document.get("transcript"))
    except ValueError as error:
        raise InputError(str(error)) from None


def _detail(document: Mapping[str, Any]) -> str:
    detail = document.get("detail", "")
    if not isinstance(detail, str):
        raise InputError(f"detail must be a text, not {show(detail)}")
    return detail


def _step(document: Mapping[str, Any]) -> int | None:
    step = document.get("step")
    if step is not None and (type(step) is not int or step < 0):
        raise InputError(f"step must be an integer from 0 on, not {show(step)}")
    return step


def _value(given: Any) -> documents.Value:
    """What is told of what was expected, or seen; a finding may leave it out."""
    if given is None:
        return "not recorded"
    if isinstance(given, Mapping | str) or type(given) is int:
        return given  # type: ignore[return-value]  # whoever tells it looks at the map
    raise InputError(f"expected and seen are a rooted map, an integer or a text, not {show(given)}")


def _of_report(document: Any) -> Any:
    """The finding inside a report; anything else as it is."""
    match document:
        case {"schema": 1, "findings": [first, *_]}:
            return first
        case {"schema": 1, "finding": {} as finding}:
            return finding
        case {"schema": 1, "verdict": verdict}:
            raise InputError(f"the report, with the verdict {show(verdict)}, holds no finding")
        case _:
            return document


def place_of(world: World) -> int:
    """The number of the lighthouse's place among those of the rooted map."""
    return world.lighthouse.number(world.map, world.start)


def canonical_world(world: World) -> World:
    """The same world in canonical numbering: its start is dart 0."""
    names = [0] * len(world.map.sigma)
    for number, dart in enumerate(numbering(world.map.sigma, world.map.alpha, world.start)):
        names[dart] = number
    return world.relabelled(names)
