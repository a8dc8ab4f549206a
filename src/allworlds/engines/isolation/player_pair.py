"""The referee's side of its two players: jobs out, logs in, lost players replaced."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Generator, Iterator, MutableSequence, Sequence
from dataclasses import dataclass, field, replace
from random import Random
from typing import Any, Protocol, TypeVar

from allworlds.engines.isolation.jobs import (
    HarnessError,
    PlayerSetup,
    PlayRecords,
    PlayRuns,
    PlayStretch,
)
from allworlds.engines.isolation.messages import (
    ExplorerDescription,
    RecordLogs,
    RunLogs,
    StretchResult,
)
from allworlds.engines.isolation.process import GRACE, NO_RUN, Garbled, Guardian, Process, close_all
from allworlds.engines.python.play import Record
from allworlds.engines.python.run_counter import PartwiseEngine, RunCounter
from allworlds.engines.python.runs_of_unit import UnitOfRuns
from allworlds.engines.python.second_play import EarlierPlays
from allworlds.engines.units.effort import POLL
from allworlds.explorers import Subject, is_program
from allworlds.inputs import InputError, show
from allworlds.judging import Fault, Log, LostRun

IMPORT_TIMEOUT = 60.0
"""Seconds that an explorer's module may take to be imported."""

ANSWER = "an action, or an estimate at the end"

MOST_LOSSES = 20
"""The number of losses that are put down to the machine, if no fresh player repeats them."""

M = TypeVar("M")


class Unsettled(Exception):
    """Processes are lost again and again, and nothing can be said of the explorer."""


class PlayerLost(Exception):
    """A player was silent for too long, or has died.

    Attributes:
        law: ``timeout`` or ``crash``.
        seen: how, as a sentence.
        machine: it may be the machine's doing.
        number: of the run that it was in; None if it was in none.
    """

    def __init__(self, law: str, seen: str, number: int | None, *, machine: bool) -> None:
        super().__init__(seen)
        self.law, self.seen, self.number, self.machine = law, seen, number, machine

    def log(self, kind: type[Fault]) -> Log:
        """The log that stands for that of the lost run."""
        return Log((), (), kind(self.law, ANSWER, self.seen, "", self.machine))


def start_player(guardian: Guardian, setup: PlayerSetup) -> tuple[Process, ExplorerDescription]:
    """A player with its explorer loaded.

    Raises:
        InputError: if the explorer cannot be loaded.
    """
    process = Process(guardian, "player", setup)
    try:
        return process, _description(process, setup)
    except BaseException:
        process.close()
        raise


def _description(process: Process, setup: PlayerSetup) -> ExplorerDescription:
    deadline = time.monotonic() + IMPORT_TIMEOUT
    while not process.connection.poll(POLL):
        if process.has_ended():
            raise _not_imported(process, setup)
        if time.monotonic() > deadline:
            raise InputError(
                f"{show(setup.name)} does not import: it was at it for {IMPORT_TIMEOUT:g} s"
            )
    try:
        description = process.receive()
    except EOFError:
        raise _not_imported(process, setup) from None
    assert isinstance(description, ExplorerDescription)
    return description


def _not_imported(process: Process, setup: PlayerSetup) -> InputError:
    limit = "" if setup.memory is None else f", with memory limited to {setup.memory} MB"
    return InputError(
        f"a process came to {process.death()[0]} when it imported {show(setup.name)}{limit}"
    )


def receive(
    process: Process, setup: PlayerSetup, alive: Callable[[], None] = lambda: None
) -> object:
    """A player's next message.

    ``alive`` is called while there is none.

    Raises:
        PlayerLost: if it is silent for too long, or has died.
    """
    patience = setup.answer_timeout + (GRACE if is_program(setup.name) else 0.0)
    while True:
        ready = process.connection.poll(POLL)
        # A message sent before the silence is still read; but a player may send choices for ever.
        if process.silent_for() > patience + (GRACE if ready else 0.0):
            seen = f"silent for {setup.answer_timeout:g} s"
            raise PlayerLost("timeout", seen, _number(process), machine=True)
        if ready:
            break
        if process.has_ended():
            raise _died(process)
        alive()
    try:
        return process.receive()
    except Garbled as error:
        raise PlayerLost("crash", str(error), _number(process), machine=False) from None
    except EOFError:
        raise _died(process) from None


def _died(process: Process) -> PlayerLost:
    seen, machine = process.death()
    return PlayerLost("crash", seen, _number(process), machine=machine)


def _interfered(process: Process, error: HarnessError) -> PlayerLost:
    """The loss of a player that failed out of the explorer's turn, perhaps by a signal of its."""
    last = (str(error).strip().splitlines() or ["an error"])[-1]
    return PlayerLost("crash", f"{last}, out of its turn", _number(process), machine=True)


def _number(process: Process) -> int | None:
    number = process.beat[0]
    return None if number == NO_RUN else number


@dataclass(slots=True)
class PlayerPair:
    """Two processes with one explorer: the first plays in worlds, the second against records.

    Attributes:
        guardian: starts and ends them.
        setup: the explorer.
        random: from which every order is drawn.
        alive: called while a player is waited for.
        remark: takes the text of an event that refutes nothing.
    """

    guardian: Guardian
    setup: PlayerSetup
    random: Random
    alive: Callable[[], None] = lambda: None
    remark: Callable[[str], None] = lambda _: None
    _processes: dict[str, Process] = field(default_factory=dict)
    _losses: int = 0
    _sent: PlayRecords = field(default_factory=lambda: PlayRecords((), "fifo", 0))

    def close(self) -> None:
        """End both processes."""
        close_all(*self._processes.values())
        self._processes.clear()

    def restart(self) -> None:
        """Go on in fresh processes."""
        self.close()

    def play_runs(
        self,
        engine: RunCounter,
        unit: UnitOfRuns,
        numbers: Sequence[int],
        script: tuple[int, ...] | None = None,
    ) -> Iterator[list[tuple[int, Log]]]:
        """The logs of these runs, as they come; of a run that is lost twice there is one more.

        Raises:
            Unsettled: if processes are lost again and again, and no fresh one repeats it.
            HarnessError: if a player fails otherwise than by the explorer's acts in its turn, and
                a fresh one does so, too.
        """
        # All that a player has loaded when a foreign explorer is: it may load no more then.
        counter = RunCounter(engine.scope, engine.keep)
        left, received = list(numbers), Counter[int]()
        while left:
            job = PlayRuns(counter, unit, tuple(left), self.random.getrandbits(64), script)
            lost = yield from self._attempt(job, left, received)
            if lost is None:
                return
            # If it is not known in which run, the first that is left may be the one.
            number = lost.number if lost.number in left else next(iter(left), None)
            again = None
            if number is not None:
                # Once more by itself, so that it can be put down to nobody else.
                alone = replace(job, numbers=(number,))
                again = yield from self._attempt(alone, left, received, last=True)
            if again is None:
                self._note(lost)
            elif number in left:
                left.remove(number)
                yield [(number, again.log(LostRun))]

    def _attempt(
        self, job: PlayRuns, left: list[int], received: Counter[int], *, last: bool = False
    ) -> Generator[list[tuple[int, Log]], None, PlayerLost | None]:
        """Yield the logs of a job that were not received before; return how it was lost, if it was.

        Runs that have no more logs are taken out of ``left``.
        """
        before = Counter(received)
        player = None
        try:
            player = self._player("first")
            player.beat[0] = NO_RUN
            player.send(job)
            waiting = len(job.numbers)
            while waiting:
                message = self._receive(player, RunLogs)
                fresh = []
                for number, log in message.logs:
                    if before[number]:
                        before[number] -= 1
                    else:
                        received[number] += 1
                        fresh.append((number, log))
                waiting -= len(message.finished)
                for number in message.finished:
                    left.remove(number)
                if fresh:
                    yield fresh
        except PlayerLost as lost:
            self._end("first")
            return lost
        except HarnessError as error:
            if last or player is None:
                raise
            interfered = _interfered(player, error)
            self._end("first")
            return interfered
        return None

    def play_stretch(self, which: str, job: PlayStretch) -> StretchResult | None:
        """Have the first or the second player play a stretch; None if it was lost over it."""
        try:
            player = self._player(which)
            player.send(job)
            message = receive(player, self.setup, self.alive)
        except (PlayerLost, HarnessError):
            self._end(which)
            return None
        if isinstance(message, StretchResult):
            return message
        self._end(which)
        return None

    def send_records(self, records: Sequence[Record], policy: str) -> None:
        """Begin to play these once more."""
        self._sent = PlayRecords(tuple(records), policy, self.random.getrandbits(64))
        if records:
            self._player("second").send(self._sent)

    def receive_logs(self) -> list[Log]:
        """The logs of the records that were sent, in their order."""
        if not self._sent.records:
            return []
        try:
            return self._receive(self._player("second"), RecordLogs).logs
        except PlayerLost as lost:
            self._end("second")
            return self._one_by_one(lost)
        except HarnessError as error:
            interfered = _interfered(self._player("second"), error)
            self._end("second")
            return self._one_by_one(interfered)

    def _one_by_one(self, lost: PlayerLost) -> list[Log]:
        """Play each record by itself, and log the one that has killed the player as lost."""
        logs = []
        repeated = False
        for record in self._sent.records:
            try:
                player = self._player("second")
                player.send(PlayRecords((record,), self._sent.policy, 0))
                (log,) = self._receive(player, RecordLogs).logs
            except PlayerLost as again:
                self._end("second")
                repeated = True
                log = again.log(Fault)
            logs.append(log)
        if not repeated:
            self._note(lost)
        return logs

    def _receive(self, player: Process, kind: type[M]) -> M:
        message = receive(player, self.setup, self.alive)
        assert isinstance(message, kind)
        return message

    def _note(self, lost: PlayerLost) -> None:
        """Remark on a loss that a fresh process has not repeated: it refutes nothing.

        Raises:
            Unsettled: if there are too many of them.
        """
        self.remark(f"a player was lost ({lost.seen}), and a fresh one was not: no refutation")
        self._losses += 1
        if self._losses > MOST_LOSSES:
            raise Unsettled(
                f"{self._losses} players were lost, the last by {lost.seen}, and each time a fresh "
                "one was not"
            )

    def _player(self, which: str) -> Process:
        if which not in self._processes:
            self._processes[which], _ = start_player(self.guardian, self.setup)
        return self._processes[which]

    def _end(self, which: str) -> None:
        process = self._processes.pop(which, None)
        if process is not None:
            process.close()


class WorkerEngine(Protocol):
    """An engine that workers can use: it is sent to their referees."""

    @property
    def keep(self) -> int:
        """The number of findings that are kept."""

    def for_built_in(
        self, subject: Subject, beat: MutableSequence[int] | None = None
    ) -> PartwiseEngine:
        """The engine with an explorer of ours, which is played where this is called.

        Args:
            subject: the explorer.
            beat: see :func:`allworlds.judging.episode.play`.
        """

    def for_foreign(
        self, explorer: str, players: PlayerPair, earlier: EarlierPlays[Any]
    ) -> PartwiseEngine:
        """The engine with a foreign explorer, of that name, in these two processes."""
