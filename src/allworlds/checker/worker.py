"""A process that examines units, and that its parent can kill.

It is a program of its own, so that nothing of the parent but its import path is inherited:
no threads, no half-imported main module.  It speaks pickles over a pipe; what the explorer
prints goes to stderr.
"""

from __future__ import annotations

import mmap
import os
import signal
import sys
import traceback
from collections.abc import Iterable, MutableSequence, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import TypeVar, cast

from allworlds.checker.examine import Examiner, examine_unit
from allworlds.checker.scope import Rules, Schedule, Scope, Work
from allworlds.checker.tally import Tally
from allworlds.episode import Answered, Episode, Fault, play
from allworlds.errors import InputError
from allworlds.protocol import Action, Choices, Kind, Percept, Schedules, Transcript
from allworlds.subjects import Subject, load
from allworlds.subjects.stderr import patient_stderr
from allworlds.world import IllegalAction, World

T = TypeVar("T")

BEAT_WORDS = 2
"""The shared memory: the number of the current run, and the turns of the explorer in it."""

NO_RUN = (1 << 64) - 1
"""The number of the current run before the first."""


@dataclass(frozen=True, slots=True)
class Setup:
    """What a worker must know before its first job."""

    explorer: str
    answer_timeout: float
    memory: int | None


@dataclass(frozen=True, slots=True)
class UnitJob:
    """Examine a unit from run ``start`` on, without the runs of ``skip``."""

    scope: Scope
    unit: Work
    keep: int
    start: int
    skip: frozenset[int]


@dataclass(frozen=True, slots=True)
class RunJob:
    """Play and judge one run."""

    rules: Rules
    world: World
    script: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class TraceJob:
    """Play one world and tell every step at once, because the process may not survive it.

    The schedules are all, or the policy's after the choices of ``script``.
    """

    rules: Rules
    world: World
    schedules: Schedule
    script: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class ReplayJob:
    """Play against recorded percepts alone, without a world."""

    rules: Rules
    budget: int
    told: int | None
    transcript: Transcript
    choices: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Part:
    """Answer to a :class:`UnitJob`: the tally of the runs before ``next_run``."""

    next_run: int
    tally: Tally
    last: bool


@dataclass(frozen=True, slots=True)
class Traced:
    """Answer to a :class:`TraceJob`: a new schedule (None), a choice, or a step."""

    what: int | tuple[Action, Percept] | None


@dataclass(frozen=True, slots=True)
class Ended:
    """The end of a trace or a replay: the actions taken, and how the run ended."""

    actions: tuple[Action, ...]
    ending: Answered | Fault


class HarnessError(RuntimeError):
    """A worker has failed, and no explorer is to blame."""


class Recorded:
    """In place of a world: answers every action with the next recorded percept."""

    def __init__(self, transcript: Transcript, told: int | None) -> None:
        self.start = 0
        self.first = transcript.first
        self.told = told
        self.percepts = [transcript.first, *(percept for _, percept in transcript.steps)]

    def step(self, state: int, _action: Action) -> tuple[int, Percept]:
        """The next percept; the 'dart' of a step is its number.

        Raises:
            IllegalAction: past the end of the record.
        """
        if state + 1 == len(self.percepts):
            raise IllegalAction("nothing: the record ends here")
        return state + 1, self.percepts[state + 1]


class _Told:
    """A world that tells each step before the explorer sees its outcome."""

    def __init__(self, world: World, connection: Connection) -> None:
        self._world, self._connection = world, connection
        self.start, self.first, self.told = world.start, world.first, world.told
        self.percepts = world.percepts

    def step(self, state: int, action: Action) -> tuple[int, Percept]:
        after, percept = self._world.step(state, action)
        self._connection.send(Traced((action, percept)))
        return after, percept


class _ToldChoices(Choices):
    """Choices that tell each pick."""

    def __init__(self, choices: Choices, connection: Connection) -> None:
        super().__init__()
        self._choices, self._connection = choices, connection
        self.record = choices.record

    def pick(self, options: Sequence[T], of: Kind, cost: Sequence[int] | None = None) -> T:
        picked = self._choices.pick(options, of, cost)
        self._connection.send(Traced(self.record[-1]))
        return picked


def replay_recorded(subject: Subject, job: ReplayJob, beat: MutableSequence[int]) -> Episode:
    """What the explorer does when it gets the recorded percepts again."""
    recorded = cast("World", Recorded(job.transcript, job.told))
    choices = job.rules.choices("", job.choices)
    return play(recorded, subject.player(), choices, job.budget, beat)


class Worker:
    """One worker's life: a setup, then jobs until the pipe is closed."""

    def __init__(self, connection: Connection, beat: MutableSequence[int]) -> None:
        self._connection = connection
        self._beat = beat
        self._pid = os.getpid()

    def run(self) -> None:
        """Serve until the parent hangs up."""
        setup: Setup = self._connection.recv()
        try:
            if setup.memory is not None:
                _limit_memory(setup.memory)
            subject = load(setup.explorer, setup.answer_timeout)
        except InputError as error:
            if setup.memory is not None:
                # The parent has loaded it, without a limit.
                error = InputError(f"memory {setup.memory} MB is probably too small: {error}")
            self._connection.send(error)
            return
        signal.signal(signal.SIGTERM, lambda *_: _leave(subject))
        with subject.running():
            self._serve(subject)

    def _serve(self, subject: Subject) -> None:
        while True:
            try:
                job = self._connection.recv()
            except EOFError:
                return
            try:
                self._do(subject, job)
            except OSError:
                raise
            except InputError as error:  # a bound without a value for some world
                self._connection.send(error)
            except Exception:  # noqa: BLE001  # explorers' errors never get here: it is ours
                self._connection.send(HarnessError(traceback.format_exc()))

    def _do(self, subject: Subject, job: UnitJob | RunJob | TraceJob | ReplayJob) -> None:
        match job:
            case UnitJob():
                self._examine(subject, job)
            case RunJob():
                self._run(subject, job)
            case TraceJob():
                self._trace(subject, job)
            case ReplayJob():
                self._end(replay_recorded(subject, job, self._beat))

    def _examine(self, subject: Subject, job: UnitJob) -> None:
        examiner = Examiner(subject, job.scope.rules, self._beat, self._intact)
        parts = examine_unit(
            examiner, job.scope, job.unit, job.keep, self._beat, job.start, job.skip
        )
        for part, last in _with_last(parts):
            self._connection.send(Part(*part, last))

    def _intact(self) -> None:
        """Leave, if the explorer has forked this process or closed its pipe."""
        if os.getpid() != self._pid:
            # The original goes on with the work; its copy must not do it a second time.
            os._exit(0)
        os.fstat(self._connection.fileno())

    def _run(self, subject: Subject, job: RunJob) -> None:
        examiner = Examiner(subject, job.rules, self._beat, self._intact)
        name = examiner.name_run(job.world)
        choices = job.rules.choices(name, job.script)
        self._connection.send(examiner.examine(job.world, choices, name))

    def _trace(self, subject: Subject, job: TraceJob) -> None:
        rules = job.rules
        name = Examiner(subject, rules).name_run(job.world)
        every = job.schedules == "all"
        told_world = cast("World", _Told(job.world, self._connection))
        for choices in Schedules() if every else [rules.choices(name, job.script)]:
            self._connection.send(Traced(None))
            told = _ToldChoices(choices, self._connection)
            episode = play(
                told_world,
                subject.player(),
                told,
                rules.budget(job.world.map),
                self._beat,
            )
            self._intact()
        self._end(episode)

    def _end(self, episode: Episode) -> None:
        actions = tuple(action for action, _ in episode.transcript.steps)
        self._connection.send(Ended(actions, episode.ending))


def _with_last(items: Iterable[T]) -> Iterable[tuple[T, bool]]:
    """Each item with whether it is the last one."""
    iterator = iter(items)
    item = next(iterator)
    for following in iterator:
        yield item, False
        item = following
    yield item, True


def _limit_memory(megabytes: int) -> None:
    """Bound the address space of this process.

    Raises:
        InputError: if it is larger already; it would go on for as long as it needs no more.
    """
    import resource

    _, most = resource.getrlimit(resource.RLIMIT_AS)
    size = min(megabytes << 20, sys.maxsize if most == resource.RLIM_INFINITY else most)
    resource.setrlimit(resource.RLIMIT_AS, (size, size))
    try:
        mmap.mmap(-1, mmap.PAGESIZE).close()
    except OSError:
        raise InputError("a worker is larger before it has loaded an explorer") from None


def _leave(subject: Subject) -> None:
    """End this process now, but not without the foreign program behind the explorer."""
    if subject.program:
        subject.program.close()
    os._exit(0)


def main(arguments: Sequence[str]) -> None:
    """Entry of the process: the file descriptors of its pipe and of the shared memory."""
    pipe, memory = map(int, arguments)
    # Interrupts are the parent's business; and nothing an explorer prints may be lost in,
    # or get into, what the parent reads.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.dup2(2, 1)
    sys.stdout = sys.stderr = patient_stderr()
    with mmap.mmap(memory, 8 * BEAT_WORDS) as shared, Connection(pipe) as connection:
        beat = memoryview(shared).cast("Q")
        try:
            Worker(connection, cast("MutableSequence[int]", beat)).run()
        except OSError:
            # The parent has gone, or the explorer has closed the pipe: there is nobody to
            # report to, and the parent sees the end of the pipe.
            os._exit(1)
        finally:
            beat.release()
