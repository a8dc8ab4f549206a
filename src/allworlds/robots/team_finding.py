"""The finding of a search: a shortest run that breaks a law, with all data to play it again."""

from __future__ import annotations

import json
import shlex
from collections.abc import Mapping
from functools import cached_property
from typing import Annotated, Any, Literal

from allworlds.documents import document as doc
from allworlds.documents.reading import parse
from allworlds.explorers.loading import named_on_command_line
from allworlds.inputs.checks import InputError, show
from allworlds.judging.findings.finding import digest_of
from allworlds.maps.combinatorial import Alpha, Code, CombinatorialMap, Dart, Sigma, rooted_code
from allworlds.protocol.actions import Percept
from allworlds.protocol.turns import Sensed, percept_of
from allworlds.robots.configurations import Search
from allworlds.robots.events import Event, Turn, events_of
from allworlds.robots.graph import Broken
from allworlds.robots.minds import ProgramFault
from allworlds.robots.model import Places, Scheduler
from allworlds.robots.schedulers import Timing

LAWS: dict[str, str] = {
    "crash": "A program raises no error, and its process does not end.",
    "timeout": "A program answers in time.",
    "illegal-action": "A program yields only actions of this world.",
    "no-estimate": "A program returns only what can be an answer.",
    "nondeterministic": "A program does the same after the same percepts.",
    "never": "What must never happen does not happen.",
    "deadlock": "When no robot will ever act again, and one still waits, nothing is wrong.",
    "answer": "When all robots have ended, nothing is wrong.",
    "progress": (
        "A fair run that never ends must reach the goal again and again, or reach it and then keep "
        "it, as the model asks; in a fair run no robot that can act is left out for ever."
    ),
    "budget": "The goal is reached within the activations that were asked for.",
}
"""Every law of teams by its name, with a sentence that says what it demands."""


class Turned(doc.Document, forbid_unknown_fields=False):
    """The turn of one robot in an event, or a part of this turn."""

    robot: Annotated[doc.Natural, doc.about("its number")]
    phase: Annotated[
        Literal["look", "move", "whole"],
        doc.about("`look`: the move comes later; `move`: this later move; `whole`: both at once"),
    ]
    sensed: Annotated[Any, doc.about("the robot's percept; null: the robot only moves")]
    did: Annotated[str, doc.about("the robot's action, or how its program ended, in words")]


class EventRow(doc.Document, forbid_unknown_fields=False):
    """An event: some robots act at the same time, and the adversary makes a choice."""

    robots: Annotated[tuple[Turned, ...], doc.about("the robots that are activated")]
    adversary: Annotated[doc.Natural, doc.about("the index of the adversary's choice, from 0 on")]
    world: Annotated[str, doc.about("the adversary's choice in words; may be empty")]
    written: Annotated[str, doc.about("the event as in `--schedule`, such as `0L` or `0M+1L:2`")]
    darts: Annotated[
        tuple[Dart | None, ...], doc.about("each robot's dart after the event; null: it is gone")
    ]
    vertices: Annotated[
        doc.IfAny[dict[str, str]], doc.about("texts about vertices after the event, by vertex")
    ]
    edges: Annotated[
        doc.IfAny[dict[str, str]], doc.about("texts about edges after the event, by smaller dart")
    ]


class TimeDocument(doc.Document, forbid_unknown_fields=False):
    """The schedules that are tried."""

    scheduler: Annotated[Scheduler, doc.about("which robots are activated at the same time")]
    budget: Annotated[doc.Natural, doc.about("the largest number of activations of a robot")]
    lead: Annotated[
        doc.IfAny[doc.Natural | None], doc.about("by how many activations a robot may be ahead")
    ] = None
    start_delay: Annotated[
        doc.IfAny[doc.Natural], doc.about("by how many rounds robot 1 may begin later")
    ] = 0
    within: Annotated[doc.IfAny[bool], doc.about("whether more activations break a law")] = False

    @classmethod
    def of(cls, timing: Timing) -> TimeDocument:
        """The document about the schedules of a search."""
        return cls(
            scheduler=timing.scheduler,
            budget=timing.budget,
            lead=timing.lead,
            start_delay=timing.start_delay,
            within=timing.within,
        )

    @property
    def arguments(self) -> list[str]:
        """The arguments of the command line that choose these schedules."""
        words = ["--scheduler", self.scheduler]
        words += ["--within" if self.within else "--budget", str(self.budget)]
        words += [] if self.lead is None else ["--lead", str(self.lead)]
        words += ["--start-delay", str(self.start_delay)] if self.start_delay else []
        return words


class TeamFinding(doc.Document, forbid_unknown_fields=False, kw_only=True):
    """Finding of a team.

    A shortest run that breaks a law, in the smallest world that has such a run.
    """

    version: Annotated[Literal[1], doc.about("the version of findings of teams")] = 1
    law: Annotated[str, doc.about("the broken law")]
    seen: Annotated[str, doc.about("how the law is broken, in words")]
    sigma: Sigma
    alpha: Alpha
    starts: Annotated[tuple[Dart, ...], doc.about("the dart of each robot at the start")]
    model: Annotated[str, doc.about("the name of the model of the world")]
    model_digest: Annotated[
        doc.IfAny[str], doc.about("the SHA-256 of the file of a model of one's own")
    ] = ""
    programs: Annotated[tuple[str, ...], doc.about("the program of each robot")]
    time: Annotated[TimeDocument, doc.about("the schedules that were tried")]
    first: Annotated[doc.Natural, doc.about("the index of the start state in the model")] = 0
    events: Annotated[tuple[EventRow, ...], doc.about("the events from the start on")]
    loop: Annotated[
        doc.Natural, doc.about("how many of the last events repeat for ever; 0: the run ends")
    ] = 0
    robot: Annotated[
        doc.IfAny[doc.Natural | None], doc.about("the robot whose program broke the law, if any")
    ] = None
    detail: Annotated[
        doc.IfAny[str], doc.about("a traceback, or the end of a program's stderr")
    ] = ""
    minimal: Annotated[bool, doc.about("no smaller world of the scope refutes")] = False

    @doc.computed
    def schedule(self) -> str:
        """The schedule of the events, as the option `--schedule` takes it."""
        return " ".join(event.written for event in self.events)

    @doc.computed
    def reproduce(self) -> str:
        """A shell command that searches this world again."""
        named = [word for name in self.team for word in named_on_command_line(name)]
        world = json.dumps({"sigma": self.sigma, "alpha": self.alpha}, separators=(",", ":"))
        words = ["allworlds", "team", *named, "--model", self.model]
        words += ["--robots", str(len(self.starts)), *self.time.arguments, "--world", world]
        words += ["--starts", ",".join(map(str, self.starts))]
        return shlex.join(words)

    @property
    def team(self) -> tuple[str, ...]:
        """The programs as a user names them: one name if all robots have the same program."""
        return self.programs[:1] if len({*self.programs}) == 1 else self.programs

    @cached_property
    def map(self) -> CombinatorialMap:
        """The map of the finding."""
        return CombinatorialMap(self.sigma, self.alpha)

    @cached_property
    def key(self) -> tuple[int, int, Code, tuple[int, ...]]:
        """The key by which findings are ordered: edges, vertices, canonical code, starts."""
        map_ = self.map
        return map_.edge_count, map_.vertex_count, rooted_code(*self._code, 0), self.starts

    @property
    def rank(self) -> tuple[Any, ...]:
        """The key by which all findings are sorted: :attr:`key`, and then the law.

        Two findings in the same world with the same starts have the same :attr:`key`; of these, the
        finding comes first whose law comes first in :data:`LAWS`.
        """
        return self.key, [*LAWS].index(self.law)

    @cached_property
    def kind(self) -> tuple[str, Code]:
        """The kind of the finding: the law, and the map without a root.

        The map is given by the least of its canonical codes, one for each root.
        """
        return self.law, min(rooted_code(*self._code, dart) for dart in self.map.darts)

    @property
    def _code(self) -> tuple[tuple[int, ...], tuple[int, ...]]:
        return self.map.sigma, self.map.alpha

    @property
    def text(self) -> str:
        """The text of the finding's file, which is JSON."""
        return json.dumps(self.to_json(), indent=1) + "\n"

    @property
    def file_name(self) -> str:
        """The name of the finding's file: ``LAW-mMnN-DIGEST.json``."""
        size = f"m{self.map.edge_count}n{self.map.vertex_count}"
        return f"{self.law}-{size}-{digest_of(self.text)}.json"

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> TeamFinding:
        """The finding with this document, which :meth:`to_json` has written.

        Raises:
            InputError: for an illegal value; the error names the value and what would be legal.
        """
        if (law := document.get("law")) not in LAWS:
            raise InputError(f"law {show(law)} is not one of {', '.join(LAWS)}")
        if document.get("version") != 1:
            version = show(document.get("version"))
            raise InputError(f"finding of a team of version {version}; this program reads 1")
        return parse(document, cls, "finding")


def is_of_team(document: object) -> bool:
    """Whether a document is the finding of a team."""
    return isinstance(document, Mapping) and "model" in document and "starts" in document


def finding_of(
    search: Search, broken: Broken, model: str, digest: str, programs: tuple[str, ...]
) -> TeamFinding:
    """The finding of a search in which a law is broken.

    ``model`` and ``digest`` are the model's name and the digest of its file; ``programs`` has the
    name of each robot's program.
    """
    map_, first = search.world.map, search.way(broken.at)[0]
    fault = None
    events = [*events_of(search, broken)]
    if events and broken.robot is not None:
        fault = next((t.did for t in events[-1].turns if type(t.did) is ProgramFault), None)
    return TeamFinding(
        law=broken.law,
        seen=broken.seen,
        sigma=map_.sigma,
        alpha=map_.alpha,
        starts=tuple(search.starts),
        model=model,
        model_digest=digest,
        programs=programs,
        time=TimeDocument.of(search.timing),
        first=search.graph.discovery(first).adversary,
        events=tuple(event_row(search, event) for event in events),
        loop=len(broken.cycle),
        robot=broken.robot,
        detail=fault.detail if fault else "",
    )


def event_row(search: Search, event: Event) -> EventRow:
    """The document of an event, which a finding contains."""
    shown = search.world.places(event.state)
    return EventRow(
        robots=tuple(map(_turned, event.turns)),
        adversary=event.adversary,
        world=event.world,
        written=event.written,
        darts=shown.darts,
        vertices={str(vertex): words for vertex, words in shown.vertices.items()},
        edges={str(edge): words for edge, words in shown.edges.items()},
    )


PHASES = {"L": "look", "M": "move", "": "whole"}
"""The phase of a turn in a finding, by the letter of the phase in a schedule."""


def _turned(turn: Turn) -> Turned:
    phase: Any = PHASES[turn.phase]
    return Turned(
        robot=turn.robot, phase=phase, sensed=_sensed_json(turn.sensed), did=str(turn.did)
    )


def _sensed_json(sensed: Sensed | None) -> Any:
    if sensed is None:
        return None
    percept = percept_of(sensed)
    return percept.to_json() if isinstance(percept, Percept) else percept


def places_of(row: EventRow) -> Places:
    """The content of a picture of the state after an event."""
    vertices = {int(vertex): words for vertex, words in row.vertices.items()}
    edges = {int(edge): words for edge, words in row.edges.items()}
    return Places(row.darts, vertices, edges)
