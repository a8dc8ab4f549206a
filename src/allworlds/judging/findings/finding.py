"""The finding: the record of a run that breaks a law.

The finding also records the results of later plays of this run: for example, whether a new process
did the same, and whether earlier runs in the same process or the hash seed change the result.
"""

import hashlib
import json
import shlex
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property, partial
from typing import Annotated, Any, Final, Literal

from allworlds.documents import document as doc
from allworlds.documents.reading import parse
from allworlds.documents.report import SCHEMA
from allworlds.documents.shown import Paged
from allworlds.explorers.loading import HASH_SEED, named_on_command_line, own_bound
from allworlds.inputs.checks import InputError, parse_json, show
from allworlds.judging.laws.law_table import PRECEDENCE, LawName, Value
from allworlds.judging.rules import RecordedRules, Rules
from allworlds.maps.combinatorial import Code, Dart, numbering, rooted_code
from allworlds.protocol import actions
from allworlds.protocol.actions import Transcript
from allworlds.world.world import World

VERSION: Final = 2

NOT_RECORDED = "not recorded"

REPLAY = "allworlds replay FILE  # with this finding, as JSON, in FILE"
"""The command that plays the run of a finding again, after the earlier runs that the finding
names."""


def _value(name: str, given: Any) -> Value:
    """The estimate that ``given`` holds, the JSON value of the key ``expected`` or ``seen``.

    These are keys of a finding.  An integer or a text needs no conversion, so the function is not
    called for these values.

    Raises:
        InputError: if ``given`` is no estimate.  The message begins with ``name``, the name of the
            key.
    """
    if isinstance(given, Mapping):
        try:
            return actions.Estimate.from_json(given)
        except InputError as error:
            raise InputError(f"{name}.{error}") from None
    raise InputError(f"{name} is a rooted map, an integer or a text, not {show(given)}")


EXPECTED, SEEN = (doc.read_by(Value, partial(_value, name)) for name in ("expected", "seen"))
"""The readers of the keys ``expected`` and ``seen``."""


class Believed(doc.Document, forbid_unknown_fields=False):
    """Believed.

    A checkpoint of a refuting run: S, with the explorer's own numbers of the darts.
    """

    number: Annotated[doc.Natural, doc.about("the number of the checkpoint in its run, from 0 on")]
    step: Annotated[doc.Natural, doc.about("how many steps of the run came before it")]
    sigma: Annotated[tuple[Dart, ...], doc.about("for each dart the next one clockwise")]
    alpha: Annotated[tuple[Dart, ...], doc.about("the edge's other end; the same dart: unexplored")]
    here: Annotated[Dart, doc.about("the robot's dart")]


class CodeLines(doc.Document, forbid_unknown_fields=False, kw_only=True):
    """Lines of code.

    Lines of the user's Python code that ran in a refuting run, each as ``FILE:LINE``. ``steps`` and
    ``checkpoints`` hold one line for each action and each checkpoint of the run, in order; after
    the actions, ``steps`` may also hold the line where the explorer ended. An empty text stands for
    a line of other code.
    """

    steps: Annotated[
        tuple[str, ...],
        doc.about("each action's line; after them the line where the explorer ended, if it did"),
    ]
    checkpoints: Annotated[doc.IfAny[tuple[str, ...]], doc.about("lines of the checkpoints")] = ()
    alone: Annotated[
        doc.IfAny[tuple[str, ...]], doc.about("lines that ran here, but in none of the right runs")
    ] = ()
    right: Annotated[doc.Natural, doc.about("the number of right runs that were compared")]
    busy: Annotated[
        doc.IfAny[tuple[str, ...]],
        doc.about("in a run without an end: the lines that ran most in its last 1000 turns"),
    ] = ()
    sources: Annotated[tuple[str, ...], doc.about("all these lines, as `FILE:LINE: TEXT`")]

    def source(self, where: str) -> str:
        """The line of code ``where``, a text ``FILE:LINE``, with the text of this line.

        If the text of the line is unknown, the result is ``where`` alone.
        """
        return next((line for line in self.sources if line.startswith(f"{where}: ")), where)


class EarlierRun(doc.Document, forbid_unknown_fields=False):
    """Earlier run.

    A run that changes the result of a later run in the same process: in a fresh process, without
    the earlier run, the later run would have another result.
    """

    world: Annotated[doc.FromJson[World], doc.about("its world, in canonical numbering")]


class Finding(doc.Document, Paged, forbid_unknown_fields=False, kw_only=True):
    """Finding.

    A run that breaks a law, with all data to play it again. When a finding is read, unknown keys
    are ignored; but an unknown key of its world is refused.

    The last three fields are not in the document. ``at`` is the number of the lighthouse's place.
    If ``at`` is None, ``place`` computes this number from the world. ``under`` holds the rules of
    the run. If ``under`` is None, ``rules`` makes the rules from the world and ``options``.
    ``machine`` tells whether the machine, not the explorer, may be the cause of the broken law.
    """

    version: Annotated[Literal[2], doc.about("the version of findings")]
    explorer: Annotated[str, doc.about("the name of the explorer")]
    law: Annotated[LawName, doc.about("the broken law")]
    world: Annotated[
        doc.FromJson[World],
        doc.about("in canonical numbering: the start is dart 0; any numbering where it is read"),
    ]
    options: Annotated[RecordedRules, doc.about("how the run was played and judged")] = (
        RecordedRules()
    )
    choices: Annotated[
        tuple[doc.Natural, ...],
        doc.about("the index taken at each choice; of a turn that never ended, the first 1000"),
    ] = ()
    transcript: Annotated[
        doc.FromJson[Transcript], doc.about("the log, which must be a walk in the world")
    ]
    expected: Annotated[
        Any,
        EXPECTED,
        doc.about("a rooted map for `map` and `pose`, an integer for `bound`, else a sentence"),
    ] = NOT_RECORDED
    seen: Annotated[Any, SEEN, doc.about("what was found instead")] = NOT_RECORDED
    confirmed: Annotated[
        bool, doc.about("whether a new process, given only the recorded percepts, did the same")
    ] = False
    minimal: Annotated[bool, doc.about("whether no smaller world of the scope refutes")] = False
    step: Annotated[
        doc.IfAny[doc.Natural | None],
        doc.about(
            "how many steps came before the checkpoint that breaks the law; in a run without an "
            "answer, before the first wrong checkpoint"
        ),
    ] = None
    wrong_checkpoint: Annotated[
        doc.IfAny[str], doc.about("what is wrong with that checkpoint, in a run without an answer")
    ] = ""
    detail: Annotated[
        doc.IfAny[str],
        doc.about(
            "a traceback, the end of a program's stderr, two plays that differ, side by side, "
            "or the permutations that are no map"
        ),
    ] = ""
    hash_seed: Annotated[
        doc.IfAny[doc.Natural | None],
        doc.about("the `PYTHONHASHSEED` of the run; left out if the run does not depend on it"),
    ] = None
    after: Annotated[
        doc.IfAny[tuple[EarlierRun, ...]],
        doc.about(
            "earlier runs in the same process, in this order: without them this run would be "
            "different; left out if there are none"
        ),
    ] = ()
    output: Annotated[
        doc.IfAny[str],
        doc.about(
            "what the explorer printed in this run, to stdout and stderr, with control characters "
            "escaped; if it is more than 4 KiB, only the beginning and the end"
        ),
    ] = ""
    believed: Annotated[
        doc.IfAny[Believed | None],
        doc.about("the first wrong checkpoint, or else the last one; left out without checkpoints"),
    ] = None
    code: Annotated[
        doc.IfAny[CodeLines | None],
        doc.about("lines of the explorer's code, if it is in Python and a second run was the same"),
    ] = None
    tried: Annotated[
        doc.IfAny[str], doc.about("options with which the check was tried and broke no law")
    ] = ""
    at: doc.NotInDocument[int | None] = None
    under: doc.NotInDocument[Rules | None] = None
    machine: doc.NotInDocument[bool] = False

    __repr__ = Paged.__repr__

    @doc.computed
    def reproduce(self) -> str:
        """A shell command that repeats the run, or a line of Python if no command can do so.

        The line of Python is for an explorer that the command line cannot name: a function from
        ``__main__``, a lambda, or a function inside another function.
        """
        if self.after:
            return REPLAY
        module, _, name = self.explorer.partition(":")
        if "<" not in name and module != "__main__":
            return self.command
        arguments = [repr(self._world_text), *self.rules.keywords(self.choices)]
        return f"allworlds.run({name.rpartition('.')[2].strip('<>')}, {', '.join(arguments)})"

    @cached_property
    def rules(self) -> Rules:
        """The rules by which the run was played and judged.

        Raises:
            InputError: naming an option of the finding that is illegal in its world.
        """
        if self.under is not None:
            return self.under
        own = own_bound(self.explorer, self.world.lighthouse.kind)
        return self.options.rules(self.world, own)

    @cached_property
    def place(self) -> int:
        """The number of the lighthouse's place among its places in the rooted map, from 0 on."""
        return place_of(self.world) if self.at is None else self.at

    @cached_property
    def key(self) -> tuple[int, int, Code, int, tuple[int, ...]]:
        """The run as a tuple by which runs are ordered, those in small worlds first.

        The tuple holds the numbers of edges and vertices, the code of the rooted map, the number of
        the lighthouse's place, and the choices.  All findings of one run have the same tuple.
        """
        map_ = self.world.map
        code = rooted_code(map_.sigma, map_.alpha, self.world.start)
        return (map_.edge_count, map_.vertex_count, code, self.place, self.choices)

    @property
    def earlier(self) -> list[World]:
        """The worlds of the earlier runs in the same process (``after``), in their order."""
        return [run.world for run in self.after]

    @property
    def rank(self) -> tuple[Any, ...]:
        """The tuple by which the findings of a check are sorted; it begins with :attr:`key`.

        Of several findings of one run, those that name earlier runs (``after``) come first, then
        those whose result depends on the hash seed, then all others.
        """
        return self.key, not self.after, self.hash_seed is None, self.hash_seed or 0

    @cached_property
    def kind(self) -> tuple[str, Code]:
        """The kind of the finding: the broken law, and the map without its start.

        The map is given by a code that does not depend on the start: the least of its codes, of
        which there is one for each start.
        """
        map_ = self.world.map
        return self.law, min(rooted_code(map_.sigma, map_.alpha, dart) for dart in map_.darts)

    @property
    def command(self) -> str:
        """The command ``allworlds run`` for this explorer in this world, as a line for a shell.

        The line tells the rules and the choices of the run, and the hash seed if the run depends on
        it.  The line does not repeat the run in two cases, in which :attr:`reproduce` is another
        line.  First: the run depends on earlier runs (``after``).  Second: the command line cannot
        name the explorer.
        """
        command = ["allworlds", "run", *named_on_command_line(self.explorer)]
        command.append(self._world_text)
        line = shlex.join(command + self.rules.arguments(self.choices))
        return line if self.hash_seed is None else f"{HASH_SEED}={self.hash_seed} {line}"

    @property
    def _world_text(self) -> str:
        return json.dumps(self.world.to_json(), separators=(",", ":"))

    @property
    def text(self) -> str:
        """The text of the finding's file."""
        return json.dumps(self.to_json(), indent=1) + "\n"

    @property
    def file_name(self) -> str:
        """The name of the finding's file: ``LAW-mMnN-DIGEST.json``, with M edges and N vertices."""
        map_ = self.world.map
        size = f"m{map_.edge_count}n{map_.vertex_count}"
        return f"{self.law}-{size}-{digest_of(self.text)}.json"

    @classmethod
    def from_json(cls, document: str | Mapping[str, Any]) -> "Finding":
        """The finding in a JSON document, or in the text of one, as :meth:`to_json` writes it.

        The document may also be a report with findings.  A report of ``check`` may hold several
        findings, of which the first is returned; a report of ``run`` holds at most one.

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
        if (law := document.get("law")) not in PRECEDENCE:
            raise InputError(f"law {show(law)} is not one of {', '.join(PRECEDENCE)}")
        found = parse(document, cls, "finding")
        found.rules  # noqa: B018  # so that wrong options are refused here, before their use
        return found


def findings_of(document: Any) -> Sequence[Any]:
    """The JSON values of all findings in a report.

    If ``document`` is no report, the result holds ``document`` alone.

    Raises:
        InputError: if the report holds no finding, or is of another version.
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
    """The number of the lighthouse's place among its places in the rooted map; the first is 0."""
    return world.lighthouse.number(world.map, world.start)


def canonical_world(world: World) -> World:
    """Return the world with its darts renumbered from the start, which gets the number 0.

    Isomorphic worlds become equal in this *canonical* numbering.
    """
    names = [0] * len(world.map.sigma)
    for number, dart in enumerate(numbering(world.map.sigma, world.map.alpha, world.start)):
        names[dart] = number
    return world.relabelled(names)


def labelled(world: World, given: Iterable[World]) -> World:
    """The world with the labels of the first of the given worlds that is isomorphic to it.

    ``world`` is in canonical numbering; the given worlds may have any numbering.  If none of them
    is isomorphic to ``world``, the result is ``world`` itself.
    """
    sized = (one for one in given if one.map.edge_count == world.map.edge_count)
    return next((one for one in map(canonical_world, sized) if one == world), world)


DIGITS = 12
"""The number of hexadecimal digits of the digest in a file's name."""


def digest_of(text: str) -> str:
    """The digest of the text of a finding's file, which is a part of the file's name."""
    return hashlib.sha256(text.encode()).hexdigest()[:DIGITS]
