"""The verbs ``run``, ``replay`` and ``play`` on the command line.

The user can watch a run in Python's debugger; ``play`` can ask for each action in the terminal.
"""

import re
import sys
from collections.abc import Generator, Iterator
from functools import partial
from types import FrameType
from typing import Annotated, Any

import allworlds
from allworlds import Drop, Move, Percept, Pick, Write
from allworlds.cli.output import OutputGroup, complain, emit, printable
from allworlds.documents import document as doc
from allworlds.engines.single import SingleRun
from allworlds.explorers import loading
from allworlds.explorers.sources import ProgramWords, names_explorer
from allworlds.inputs.checks import InputError, integer_of, show
from allworlds.inputs.requests import OUTPUT, RARE_SCOPE, SCOPE, Argument, Option, answer, values_of
from allworlds.judging.findings.finding import canonical_world
from allworlds.judging.referee import Examiner, name_run
from allworlds.studies.run import PlayRequest, ReplayRequest, RunOptions, RunRequest, WorldNames
from allworlds.world.named import names_of_worlds, world_named


class RunWords(ProgramWords):
    """The options and arguments of ``run`` that :func:`allworlds.run` takes in another form.

    The explorer and the world are words on the command line, but objects in Python.  Other options,
    such as ``--pdb``, exist only on the command line.
    """

    arguments: Annotated[
        list[str] | None,
        Argument(
            "",
            "[EXPLORER] WORLD",
            "EXPLORER as in check, also shield:EXPLORER (default: algorithm1). WORLD: inline JSON, "
            "@file, a code of -o FILE.csv, or a name such as k4, wheel:4, cycle:5; left out with "
            "--family.",
            repeated=True,
        ),
    ] = None
    listed: Annotated[
        bool,
        Option(SCOPE, "", "List the names that a WORLD can have, and run no explorer.", "list"),
    ] = False
    without_walk: Annotated[
        bool,
        Option(
            OUTPUT,
            "",
            "Leave out the walk: in the JSON, and in the text unless a law is broken.",
            "no-walk",
        ),
    ] = False
    pdb: Annotated[
        bool, Option(RARE_SCOPE, "", "After the report repeat the run in the debugger; see --step.")
    ] = False
    step: Annotated[
        int,
        Option(
            RARE_SCOPE,
            "N",
            "With --pdb: stop where the explorer begins to choose step N.",
            parse=integer_of,
        ),
    ] = 1

    def request(self, asked: RunOptions) -> RunRequest:
        """The request for one run; the user has named the explorer and the world of the run.

        ``asked`` holds the other options of the run.

        Raises:
            InputError: if the user has not named an explorer and a world, if pdb cannot stop in the
                explorer, or if ``--step`` is given without ``--pdb``.
        """
        explorer, world = explorer_and_world(
            list(self.arguments or []),
            family=asked.family is not None,
            program=self.named(None) is not None,
        )
        name = self.named_or_default(explorer)
        if self.pdb:
            ensure_debuggable(name)
        elif self.step != 1:
            raise InputError(f"--step {self.step} is where --pdb stops; give both")
        return RunRequest(name, world, **values_of(RunOptions, asked))


def run(words: RunWords, *, asked: RunOptions, output: OutputGroup) -> int:
    """Example: allworlds run algorithm1 theta

    Run an explorer once in one world, tell it step by step, and judge it.
    """
    names: Any = names_of_worlds() if words.listed else None
    told = WorldNames(**names) if names else answer(allworlds.run, words.request(asked))
    if isinstance(told, WorldNames):
        return emit(told, output)
    if words.pdb:
        ensure_step(told, words.step)
    code = emit(doc.replace(told, shows_walk=not words.without_walk), output)
    if words.pdb:
        debug(told, words.step)
    return code


# ---------------------------------------------------------------- the debugger

GDB = (
    "gdb -ex 'set breakpoint pending on' -ex 'set follow-fork-mode child' -ex 'break FUNCTION' "
    "-ex run --args python -m allworlds run ..."
)
"""The command by which gdb stops in an explorer that is a program or a library.

Such an explorer runs in another process.
"""


def ensure_debuggable(name: str) -> None:
    """Raise InputError unless pdb can stop in the explorer of this name.

    It can stop in a user's explorer in Python that has no shield around it.
    """
    if loading.is_program(name) or loading.is_library(name):
        raise InputError(f"--pdb is for Python; a compiled explorer: {GDB}")
    if loading.entry_of(name) or loading.has_shield(name):
        raise InputError(f"--pdb stops in an explorer of yours alone, not in {name}")


def ensure_step(run: SingleRun, step: int) -> None:
    """Raise InputError if the run has no step with this number; the first step is number 1.

    The step after the last action is the explorer's answer.
    """
    last = len(run.outcome.episode.transcript.steps) + 1
    if not 1 <= step <= last:
        raise InputError(f"--step {step} is not from 1 to {last}, where this run ends")


class _Stopping:
    """An explorer's generator with a debugger that stops in it.

    Args:
        walk: the generator of the explorer.
        left: the number of percepts that the explorer gets, after the first percept, until the
            debugger stops; 0 for a stop at the beginning.
    """

    def __init__(self, walk: Generator[Any, Any, Any], left: int) -> None:
        self._walk, self._left, self.close = walk, left, walk.close

    def send(self, reply: Any) -> Any:
        """Send a reply to the explorer, and return the explorer's next message.

        The reply is a percept; it is None at the beginning, and after a checkpoint.  When ``left``
        further percepts have been sent (at the beginning if ``left`` is 0), the debugger stops in
        the explorer, which has just got the reply.
        """
        self._left -= reply is not None
        if not self._left:
            from pdb import Pdb  # which takes long

            self._left = -1
            debugger = Pdb(skip=["allworlds", "allworlds.*"])
            debugger.reset()
            for frame in self._waiting():
                frame.f_trace = debugger.trace_dispatch
                debugger.set_next(frame)  # the last one is where it stops
            sys.settrace(debugger.trace_dispatch)
        return self._walk.send(reply)

    def _waiting(self) -> Iterator[FrameType]:
        """Yield the frames of the user's generators that wait for the next reply.

        The first frame is that of the explorer.  Each further frame is that of a generator to which
        the generator of the previous frame has passed control by ``yield from``.
        """
        walk: Any = self._walk
        while frame := getattr(walk, "gi_frame", None):
            if frame.f_globals.get("__name__", "").partition(".")[0] != "allworlds":
                yield frame
            walk = walk.gi_yieldfrom


def debug(run: SingleRun, step: int) -> None:
    """Play a run again, in this process and in the debugger.

    The debugger stops where the explorer begins to choose the step number ``step``, counted from 1.
    The report of the run does not change, even if the explorer now does something else.
    """
    subject = loading.load(run.explorer)
    explore: Any = subject.explore

    def stopping(first: Percept, **offered: Any) -> Any:
        return _Stopping(explore(first, **offered), step - 1)

    world = canonical_world(run.world)
    choices = run.rules.choices(name_run(run.rules, world), run.choices)
    try:
        Examiner(doc.replace(subject, explore=stopping), run.rules).examine(world, choices)
    finally:
        sys.settrace(None)


# ---------------------------------------------------------------- words

_WORLDS = "a WORLD is inline JSON, @file, or a name such as k4, wheel:4, theta-torus"


def explorer_and_world(
    words: list[str], *, family: bool, program: bool
) -> tuple[str | None, str | None]:
    """The EXPLORER and the WORLD among the words of ``run``; None for one that is not given.

    Args:
        words: the words of the command that are no options.
        family: whether ``--family`` names the world; then the words must not name a WORLD.
        program: whether ``--exec`` or ``--native`` names the explorer; then the words must not name
            an EXPLORER.

    Raises:
        InputError: if there are too few or too many words, or if an explorer stands in the place of
            the WORLD.
    """
    wanted = 0 if family else 1
    if not wanted <= len(words) <= wanted + (not program):
        given = f"not {show(' '.join(words))}" if words else "and nothing is given"
        raise InputError(f"run takes [EXPLORER] and a WORLD or --family, {given}")
    explorer = words[0] if len(words) > wanted else None
    world = None if family else words[-1]
    if world is not None and names_explorer(world):
        if explorer is None:
            raise InputError(f"WORLD is missing: {show(world)} is an explorer; {_WORLDS}")
        if not names_explorer(explorer):
            raise InputError(
                f"{show(world)} is an explorer and stands in the place of WORLD; EXPLORER comes "
                "first, then WORLD"
            )
    return explorer, world


def replay(request: ReplayRequest, *, output: OutputGroup) -> int:
    """Example: allworlds replay finding.json --explorer mended.py:explore

    Run a recorded finding again.  Exit code 0: reproduced (a law is broken again), 5: fixed, 3: not
    decided.  The result is not decided if the finding says that the explorer is nondeterministic,
    and no new run breaks a law: a further run might still break one.  The recorded explorer takes
    the recorded choices again; if such a choice is no longer possible, the policy chooses.
    """
    replayed = answer(allworlds.replay, request)
    if replayed.notice:
        complain(replayed.notice)
    return emit(replayed, output)


def play(request: PlayRequest, *, output: OutputGroup) -> int:
    """Example: allworlds play theta-torus -o play.html

    Be the robot, in a web page or in the terminal. In the terminal each line is an action: a number
    leaves by that dart, counted clockwise from the dart by which you came; drop or pick moves a
    marker; write 3 writes the number 3; an empty line ends the walk and shows the world. At the end
    your cost is shown beside the cost of Algorithm 1.
    """
    page = dict(output.named).get("html")
    world = world_named(request.world, request.lighthouse, request.seed, request.holes)
    labels = world.lighthouse.labels_vertices
    asked = request if page else doc.replace(request, player=partial(_asked, labels))
    return emit(doc.replace(answer(allworlds.play, asked), path=page), output)


LEGAL = "a number, drop, pick, write K with a number K, or an empty line to end"


def _asked(labels: bool, percept: Percept, refused: str) -> Drop | Move | Pick | Write | None:
    """Ask the user for the robot's next action; return None if the user ends the walk.

    The question goes to stderr, and the answer is read from stdin.  An empty line, or the end of
    stdin, ends the walk.  The question is repeated until the answer is legal.

    Args:
        labels: whether the marks of a percept are the label of a room, and not markers.
        percept: the percept at the robot's place.
        refused: the reason why the last action was illegal; empty if it was legal.
    """
    sensed = f"you sense: {percept.in_words(labels=labels)}"
    _say(f"that cannot be done: {refused}\n" if refused else f"{sensed}\n")
    while True:
        _say("> ")
        line = sys.stdin.readline().strip()
        if re.fullmatch(r"-?[0-9]{1,9}", line):
            return Move(int(line) % percept.degree)
        if written := re.fullmatch(r"write +([0-9]{1,9})", line):
            return Write(int(written[1]))
        if line in ("", "drop", "pick"):
            return {"": None, "drop": Drop(), "pick": Pick()}[line]
        _say(f"{printable(line)[:40]!r} is not one of {LEGAL}\n")


def _say(text: str) -> None:
    print(text, end="", file=sys.stderr, flush=True)
