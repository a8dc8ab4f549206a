"""The referee's side of the players: asked, heard, replaced where they are lost."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Generator, Iterator, Sequence
from dataclasses import dataclass, field, replace
from random import Random
from typing import Protocol, runtime_checkable

from allworlds.engines.isolation.jobs import (
    Casting,
    Described,
    HarnessError,
    Played,
    PlayRecords,
    PlayRuns,
    PlayStretch,
    Stretched,
)
from allworlds.engines.isolation.process import GRACE, NO_RUN, Garbled, Guardian, Process, close_all
from allworlds.engines.python.play import Record
from allworlds.engines.python.python_engine import PartwiseEngine, PythonEngine
from allworlds.engines.python.runs_of_unit import UnitOfRuns
from allworlds.engines.python.second_play import Earlier
from allworlds.engines.units.effort import POLL
from allworlds.explorers import EXEC
from allworlds.inputs import InputError, show
from allworlds.judging import Fault, Log, LostRun

IMPORT_TIMEOUT = 60.0
"""Seconds that an explorer's module may take to be imported."""

ANSWER = "an action, or an estimate at the end"


MOST_LOSSES = 20
"""So many lost players that no fresh one has followed are put down to the machine."""


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
        """In place of the log of the run."""
        return Log((), (), kind(self.law, ANSWER, self.seen, "", self.machine))


def started(guardian: Guardian, casting: Casting) -> tuple[Process, Described]:
    """A player with its explorer loaded.

    Raises:
        InputError: if the explorer cannot be loaded.
    """
    process = Process(guardian, "player", casting)
    try:
        return process, _described(process, casting)
    except BaseException:
        process.close()
        raise


def _described(process: Process, casting: Casting) -> Described:
    deadline = time.monotonic() + IMPORT_TIMEOUT
    while not process.connection.poll(POLL):
        if process.has_ended():
            raise _not_imported(process, casting)
        if time.monotonic() > deadline:
            raise InputError(
                f"{show(casting.name)} does not import: it was at it for {IMPORT_TIMEOUT:g} s"
            )
    try:
        described = process.receive()
    except EOFError:
        raise _not_imported(process, casting) from None
    assert isinstance(described, Described)
    return described


def _not_imported(process: Process, casting: Casting) -> InputError:
    limit = "" if casting.memory is None else f", with memory limited to {casting.memory} MB"
    return InputError(
        f"a process came to {process.death()[0]} when it imported {show(casting.name)}{limit}"
    )


def hear(process: Process, casting: Casting, alive: Callable[[], None] = lambda: None) -> object:
    """A player's next message.

    ``alive`` is called while there is none.

    Raises:
        PlayerLost: if it is silent for too long, or has died.
    """
    patience = casting.answer_timeout + (GRACE if casting.name.startswith(EXEC) else 0.0)
    while True:
        told = process.connection.poll(POLL)
        # What it has told before it fell silent is still heard; but it may tell choices for ever.
        if process.silent_for() > patience + (GRACE if told else 0.0):
            seen = f"silent for {casting.answer_timeout:g} s"
            raise PlayerLost("timeout", seen, _number(process), machine=True)
        if told:
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
    """A player has failed where the explorer has no turn; a signal of it may have come then."""
    last = (str(error).strip().splitlines() or ["an error"])[-1]
    return PlayerLost("crash", f"{last}, out of its turn", _number(process), machine=True)


def _number(process: Process) -> int | None:
    number = process.beat[0]
    return None if number == NO_RUN else number


@dataclass(slots=True)
class Cast:
    """Two processes with one explorer: the one plays in worlds, the other against records.

    Attributes:
        guardian: starts and ends them.
        casting: the explorer.
        random: from which every order is drawn.
        alive: called while a player is waited for.
        remark: takes what happened and refutes nothing.
    """

    guardian: Guardian
    casting: Casting
    random: Random
    alive: Callable[[], None] = lambda: None
    remark: Callable[[str], None] = lambda _: None
    _processes: dict[str, Process] = field(default_factory=dict)
    _losses: int = 0
    _asked: PlayRecords = field(default_factory=lambda: PlayRecords((), "fifo", 0))

    def close(self) -> None:
        """End both."""
        close_all(*self._processes.values())
        self._processes.clear()

    def renew(self) -> None:
        """Go on in fresh processes."""
        self.close()

    def first(
        self,
        examination: PythonEngine,
        unit: UnitOfRuns,
        numbers: Sequence[int],
        script: tuple[int, ...] | None = None,
    ) -> Iterator[list[tuple[int, Log]]]:
        """The logs of these runs, as they come; of a run that is lost twice there is one more.

        Raises:
            Unsettled: if processes are lost again and again, and no fresh one repeats it.
            HarnessError: if a player fails otherwise than by what an explorer does in its turn,
                and a fresh one does so, too.
        """
        left, told = list(numbers), Counter[int]()
        while left:
            job = PlayRuns(examination, unit, tuple(left), self.random.getrandbits(64), script)
            lost = yield from self._attempt(job, left, told)
            if lost is None:
                return
            # If it is not known in which run, the first that is left may be the one.
            number = lost.number if lost.number in left else next(iter(left), None)
            again = None
            if number is not None:
                # Once more by itself, so that it can be put down to nobody else.
                alone = replace(job, numbers=(number,))
                again = yield from self._attempt(alone, left, told, last=True)
            if again is None:
                self._note(lost)
            elif number in left:
                left.remove(number)
                yield [(number, again.log(LostRun))]

    def _attempt(
        self, job: PlayRuns, left: list[int], told: Counter[int], *, last: bool = False
    ) -> Generator[list[tuple[int, Log]], None, PlayerLost | None]:
        """The logs of a job that have not been told before; how it was lost, if it was.

        What has no more logs is taken out of ``left``.
        """
        before = Counter(told)
        player = None
        try:
            player = self._player("first")
            player.beat[0] = NO_RUN
            player.send(job)
            waiting = len(job.numbers)
            while waiting:
                played = hear(player, self.casting, self.alive)
                assert isinstance(played, Played)
                fresh = []
                for number, log in played.logs:
                    if before[number]:
                        before[number] -= 1
                    else:
                        told[number] += 1
                        fresh.append((number, log))
                waiting -= len(played.done)
                for number in played.done:
                    left.remove(number)
                if fresh:
                    yield fresh
        except PlayerLost as lost:
            self._dismiss("first")
            return lost
        except HarnessError as error:
            if last or player is None:
                raise
            interfered = _interfered(player, error)
            self._dismiss("first")
            return interfered
        return None

    def stretch(self, which: str, job: PlayStretch) -> Stretched | None:
        """What the first or the second player says of a stretch; None if it was lost over it."""
        try:
            player = self._player(which)
            player.send(job)
            said = hear(player, self.casting, self.alive)
        except (PlayerLost, HarnessError):
            self._dismiss(which)
            return None
        if isinstance(said, Stretched):
            return said
        self._dismiss(which)
        return None

    def send_records(self, records: Sequence[Record], policy: str) -> None:
        """Begin to play these once more."""
        self._asked = PlayRecords(tuple(records), policy, self.random.getrandbits(64))
        if records:
            self._player("second").send(self._asked)

    def receive_logs(self) -> list[Log]:
        """The logs of what was asked for, in the order of the records."""
        if not self._asked.records:
            return []
        try:
            logs = hear(self._player("second"), self.casting, self.alive)
        except PlayerLost as lost:
            self._dismiss("second")
            return self._one_by_one(lost)
        except HarnessError as error:
            interfered = _interfered(self._player("second"), error)
            self._dismiss("second")
            return self._one_by_one(interfered)
        assert isinstance(logs, list)
        return logs

    def _one_by_one(self, lost: PlayerLost) -> list[Log]:
        """The same, where one of the records has cost the player its life."""
        logs = []
        repeated = False
        for record in self._asked.records:
            try:
                player = self._player("second")
                player.send(PlayRecords((record,), self._asked.policy, 0))
                told = hear(player, self.casting, self.alive)
                assert isinstance(told, list)
                log: Log = told[0]
            except PlayerLost as again:
                self._dismiss("second")
                repeated = True
                log = again.log(Fault)
            logs.append(log)
        if not repeated:
            self._note(lost)
        return logs

    def _note(self, lost: PlayerLost) -> None:
        """A loss that a fresh process has not repeated refutes nothing."""
        self.remark(f"a player was lost ({lost.seen}), and a fresh one was not: no refutation")
        self._losses += 1
        if self._losses > MOST_LOSSES:
            raise Unsettled(
                f"{self._losses} players were lost, the last by {lost.seen}, and each time a fresh "
                "one was not"
            )

    def _player(self, which: str) -> Process:
        if which not in self._processes:
            self._processes[which], _ = started(self.guardian, self.casting)
        return self._processes[which]

    def _dismiss(self, which: str) -> None:
        process = self._processes.pop(which, None)
        if process is not None:
            process.close()


@runtime_checkable
class UserEngine(Protocol):
    """What is done with a unit by means of its own, where the explorer is foreign."""

    def for_user(self, explorer: str, cast: Cast, earlier: Earlier) -> PartwiseEngine:
        """It, with an explorer of that name in these two processes."""
