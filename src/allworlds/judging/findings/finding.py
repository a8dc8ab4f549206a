"""The finding: a refuting run, with what further plays have shown of it."""

from __future__ import annotations

import hashlib
import json
import shlex
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property, partial
from typing import Annotated, Any, Final, Literal, NamedTuple

from allworlds.document.reading import parse
from allworlds.document.report import SCHEMA, Paged
from allworlds.document.struct import (
    Document,
    FromJson,
    IfAny,
    Natural,
    NotInDocument,
    about,
    computed,
    read_by,
)
from allworlds.explorers.loading import HASH_SEED, named_on_command_line, own_bound
from allworlds.inputs.checks import InputError, in_file, integer_of, parse_json, read_text, show
from allworlds.inputs.requests import SCOPE, Argument, Option, OptionGroup, Request
from allworlds.judging.findings.rules import RecordedRules, Rules
from allworlds.judging.laws.finished_run import Value
from allworlds.judging.laws.law_table import PRECEDENCE, LawName
from allworlds.maps.canonical import Code, numbering, rooted_code
from allworlds.protocol.answers import Estimate
from allworlds.protocol.transcript import Transcript
from allworlds.world.world import World

VERSION: Final = 2

NOT_RECORDED = "not recorded"


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


EXPECTED, SEEN = (read_by(Value, partial(_value, name)) for name in ("expected", "seen"))
"""How the values of two keys are read."""


class Finding(Document, Paged, forbid_unknown_fields=False, kw_only=True):
    """Finding.

    A refuting run, as it is written: enough to replay it with nothing else. Where one is read,
    other keys are ignored, but not in its world.

    ``at`` holds the place and ``under`` the rules, where they need not be made of the world and the
    options. The ``machine`` may be the cause.
    """

    version: Annotated[Literal[2], about("the version of findings")]
    explorer: Annotated[str, about("its name")]
    law: Annotated[LawName, about("the broken law")]
    world: Annotated[
        FromJson[World],
        about("in canonical numbering: the start is dart 0; any numbering where it is read"),
    ]
    options: Annotated[RecordedRules, about("how the run was played and judged")] = RecordedRules()
    choices: Annotated[
        tuple[Natural, ...],
        about("the index taken at each choice; of a turn that never ended the first 1000"),
    ] = ()
    transcript: Annotated[FromJson[Transcript], about("the log, which must be a walk in the world")]
    expected: Annotated[
        Any,
        EXPECTED,
        about("a rooted map for `map` and `pose`, an integer for `bound`, else a sentence"),
    ] = NOT_RECORDED
    seen: Annotated[
        Any,
        SEEN,
        about("the same of what was found"),
    ] = NOT_RECORDED
    confirmed: Annotated[
        bool, about("a fresh process did the same, from the recorded percepts alone")
    ] = False
    minimal: Annotated[bool, about("no smaller world of the scope refutes")] = False
    step: Annotated[
        IfAny[Natural | None],
        about(
            "how many steps came before the checkpoint that breaks the law; in a run without an "
            "answer, before the first wrong checkpoint"
        ),
    ] = None
    wrong_checkpoint: Annotated[
        IfAny[str], about("what is wrong with that checkpoint, in a run without an answer")
    ] = ""
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
    at: NotInDocument[int | None] = None
    under: NotInDocument[Rules | None] = None
    machine: NotInDocument[bool] = False

    @computed
    def reproduce(self) -> str:
        """A shell command that runs it again."""
        return self.command

    @cached_property
    def rules(self) -> Rules:
        """The rules by which the run was played and judged.

        Raises:
            InputError: naming an option that is none in this world.
        """
        if self.under is not None:
            return self.under
        own = own_bound(self.explorer, self.world.lighthouse.kind)
        return self.options.rules(self.world, own)

    @cached_property
    def place(self) -> int:
        """The number of the lighthouse's place among those of the rooted map."""
        return place_of(self.world) if self.at is None else self.at

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
    def command(self) -> str:
        """A shell command that runs the explorer in this world again."""
        command = ["allworlds", "run", *named_on_command_line(self.explorer)]
        command += [json.dumps(self.world.to_json(), separators=(",", ":"))]
        line = shlex.join(command + self.rules.arguments(self.choices))
        return line if self.hash_seed is None else f"{HASH_SEED}={self.hash_seed} {line}"

    @property
    def text(self) -> str:
        """The text of its file."""
        return json.dumps(self.to_json(), indent=1) + "\n"

    @property
    def file_name(self) -> str:
        """The name of its file: ``LAW-mMnN-DIGEST.json``."""
        map_ = self.world.map
        size = f"m{map_.edge_count}n{map_.vertex_count}"
        return f"{self.law}-{size}-{digest_of(self.text)}.json"

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
        if "version" not in document:
            raise InputError("this is no finding and no report of one: it has no 'version'")
        if document["version"] != VERSION:
            raise InputError(
                f"finding of version {show(document['version'])}; this program reads {VERSION}"
            )
        explorer, law = document.get("explorer"), document.get("law")
        if not isinstance(explorer, str):
            raise InputError(f"a finding names its explorer, not {show(explorer)}")
        if law not in PRECEDENCE:
            raise InputError(f"law {show(law)} is not one of {', '.join(PRECEDENCE)}")
        found = parse(document, cls, "finding")
        found.rules  # noqa: B018  # wrong options are refused here, and not where they are used
        return found


def findings_of(document: Any) -> Sequence[Any]:
    """The documents of the findings of a report; any other document by itself.

    Raises:
        InputError: if the report holds none, or is of another version.
    """
    match document:
        case {"schema": schema} if schema != SCHEMA:
            raise InputError(f"report of schema {show(schema)}; this program reads {SCHEMA}")
        case {"schema": _, "findings": [_, *_]}:
            findings: Sequence[Any] = document["findings"]
            return findings
        case {"schema": _, "finding": {} as finding}:
            return [finding]
        case {"schema": _, "verdict": verdict}:
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


def labelled(world: World, given: Iterable[World]) -> World:
    """The canonical world with the labels of the first given one that is the same world."""
    for one in given:
        if one.map.edge_count == world.map.edge_count and canonical_world(one) == world:
            return canonical_world(one)
    return world


DIGITS = 12
"""The hexadecimal digits of the digest in a file's name."""


def digest_of(text: str) -> str:
    """The digest of the text of a file, as in its name."""
    return hashlib.sha256(text.encode()).hexdigest()[:DIGITS]


class ChosenFinding(NamedTuple):
    """A finding, its number in its report, from 1 on, and the number of findings there."""

    finding: Finding
    number: int = 1
    findings: int = 1


class FindingWords(Request):
    """The argument and options of the command line that name a finding."""

    file: Annotated[str, Argument("", "FILE", "A finding, or a check's report; - for stdin.")]
    number: Annotated[
        int,
        Option(
            SCOPE,
            "K",
            "Which finding of a report: 1 is the smallest.",
            "finding",
            parse=integer_of,
        ),
    ] = 1

    def chosen(self) -> ChosenFinding:
        """The finding of that number in the file.

        Raises:
            InputError: naming the file, the offending value in it, or the number.
        """
        document = parse_json(read_text(self.file), file=self.file)
        with in_file(self.file):
            found = findings_of(document)
        if not 1 <= self.number <= len(found):
            holds = f"findings 1 to {len(found)}" if len(found) > 1 else "1 finding"
            raise InputError(f"finding = {self.number} is not there: the file holds {holds}")
        with in_file(self.file):
            finding = Finding.from_json(found[self.number - 1])
        return ChosenFinding(finding, self.number, len(found))

    def value(self) -> Finding:
        """The chosen finding alone, without its number."""
        return self.chosen().finding


class FindingOptions(Request, kw_only=False):
    """The part of a request that names a finding."""

    finding: Annotated[Finding, OptionGroup(FindingWords, "the finding")]
