"""The referee's side of its two players: jobs out, logs in, lost players replaced."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Generator, Iterator, Sequence
from random import Random
from typing import TypeVar

from msgspec import Struct, field

from allworlds.document import replace
from allworlds.engines.isolation.failures import HarnessError, Unsettled
from allworlds.engines.isolation.jobs import (
    PlayerSetup,
    PlayRecords,
    PlayRuns,
    PlayStretch,
)
from allworlds.engines.isolation.messages import (
    RecordLogs,
    RunLogs,
    StretchResult,
)
from allworlds.engines.isolation.one_player import (
    STOPPED,
    PlayerLost,
    interference,
    receive,
    start_player,
)
from allworlds.engines.isolation.process import NO_RUN, Guardian, Process, close_all
from allworlds.engines.python.play import Record
from allworlds.engines.python.run_counter import RunCounter
from allworlds.engines.python.runs_of_unit import UnitOfRuns
from allworlds.engines.python.tour import BEHIND, Tour
from allworlds.explorers import is_library, is_program
from allworlds.judging import Fault, Log, LostRun

GENERATORS = "allworlds.engines.isolation.generator_player"
"""The module by which a process without compiled code plays stretches."""

MOST_LOSSES = 20
"""The number of losses that are put down to the machine, if no fresh player repeats them."""

M = TypeVar("M")


class PlayerPair(Struct):
    """Two processes with one explorer: the first plays in worlds, the second against records.

    Attributes:
        guardian: starts and ends them.
        setup: the explorer.
        random: from which every order is drawn.
        alive: called while a player is waited for.
        remark: takes the text of an event that refutes nothing.
        tour: the places of both.
        in_stretches: whether compiled code judges, so that runs are played in shared memory, those
            of a library in compiled code, too.  Only the guardian has loaded compiled code, and in
            the end one more process.
    """

    guardian: Guardian
    setup: PlayerSetup
    random: Random
    alive: Callable[[], None] = lambda: None
    remark: Callable[[str], None] = lambda _: None
    tour: Tour = field(default_factory=Tour)
    in_stretches: bool = False
    _processes: dict[str, Process] = field(default_factory=dict)
    _losses: int = 0
    _sent: PlayRecords = field(default_factory=lambda: PlayRecords((), "fifo", 0))

    @property
    def answer_timeout(self) -> float:
        """The seconds after which a silent run is given up."""
        return self.setup.answer_timeout

    def close(self) -> None:
        """End both processes."""
        close_all(*self._processes.values())
        self._processes.clear()

    def restart(self) -> None:
        """Go on in fresh processes."""
        self.close()

    def take_places(self, seed: int, turn: int, *, alike: bool) -> None:
        """Go on in fresh processes; see the attributes of :class:`Tour`."""
        self.close()
        self.tour.seed, self.tour.turn, self.tour.alike = seed, turn, alike
        self.tour.hold()

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
            HarnessError: if a player, and then a fresh one, fails in another way than by the
                explorer's acts in its turn.
        """
        # All that a player has loaded when a user's explorer is: it may load no more then.
        counter = RunCounter(engine.scope, engine.keep)
        left, received = list(numbers), Counter[int]()
        while left:
            job = PlayRuns(counter, unit, tuple(left), self.random.getrandbits(64), script)
            lost = yield from self._attempt(job, left, received)
            if lost is None:
                return
            # If it is not known in which run, the first that is left may be the one.
            number = lost.number if lost.number in left else next(iter(left), None)
            again, alone = None, list[tuple[int, Log]]()
            if number is not None:
                # Once more by itself, so that it can be put down to nobody else.
                again = self._by_itself(replace(job, numbers=(number,)), alone, received)
                if again is None:
                    again = yield from self._after_others(job, number, left, received)
            if again is None:
                self._note(lost)
            if number in left:
                left.remove(number)
                yield alone if again is None else [(number, again.log(LostRun))]

    def _by_itself(
        self, job: PlayRuns, logs: list[tuple[int, Log]], received: Counter[int]
    ) -> PlayerLost | None:
        """Play one run in a fresh process; add its logs, or return the loss of the player."""
        attempt = self._attempt(job, [*job.numbers], Counter(received), last=True)
        while True:
            try:
                logs += next(attempt)
            except StopIteration as end:
                lost: PlayerLost | None = end.value
                return lost

    def _after_others(
        self, job: PlayRuns, number: int, left: list[int], received: Counter[int]
    ) -> Generator[list[tuple[int, Log]], None, PlayerLost | None]:
        """Yield the logs of a job that is played once more in a fresh process, in its order.

        Return how it was lost, if it was lost in that run, which by itself was not lost.
        """
        self._end("first")
        lost = yield from self._attempt(job, left, received)
        if lost is None or lost.number != number:
            return None
        lost.seen += " when it was played after others, twice; by itself it was not"
        lost.machine = False
        return lost

    def _attempt(
        self, job: PlayRuns, left: list[int], received: Counter[int], *, last: bool = False
    ) -> Generator[list[tuple[int, Log]], None, PlayerLost | None]:
        """Yield the logs of a job that were not received before; return how it was lost, if it was.

        Runs that have no more logs are taken out of ``left``.
        """
        before, done = Counter(received), {*job.numbers} - {*left}
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
                    if number in done:
                        done.remove(number)
                    else:
                        left.remove(number)
                if fresh:
                    yield fresh
        except PlayerLost as lost:
            self._end("first")
            return lost
        except HarnessError as error:
            if last or player is None:
                raise
            interfered = interference(player, error)
            self._end("first")
            return interfered
        return None

    def play_stretch(self, which: str, job: PlayStretch) -> StretchResult | None:
        """Let a player, ``first`` or ``second``, play a stretch; return None if it was lost."""
        if which == "second":
            self._change_second(job.runs, may_visit=True)
        try:
            player = self._player(which)
            home = self._has_compiled_code(*self._place(which))
            player.send(replace(job, compiled=home))
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
            self._change_second(len(records))
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
            interfered = interference(self._player("second"), error)
            self._end("second")
            return self._one_by_one(interfered)

    def _one_by_one(self, lost: PlayerLost) -> list[Log]:
        """Play each record by itself, and log the one that has killed the player as lost."""
        logs = []
        repeated = False
        for record in self._sent.records:
            try:
                player = self._player("second")
                player.send(replace(self._sent, records=(record,), order=0))
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
        try:
            message = receive(player, self.setup, self.alive)
        except PlayerLost as lost:
            if lost.stopped:
                raise Unsettled(STOPPED) from None
            raise
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
            place, in_worlds = self._place(which), which == "first"
            self._processes[which] = self._start(*place, in_worlds=in_worlds)
        return self._processes[which]

    def _place(self, which: str) -> tuple[int, int]:
        """The hash seed of a player, and the number of the process with that seed that forks it."""
        first, second = self.tour.places
        return first if which == "first" else second

    @staticmethod
    def _has_compiled_code(seed: int, copy: int) -> bool:
        """Whether the process at a place has loaded compiled code, if any has."""
        return seed == 0 and copy in (0, BEHIND)

    def _start(self, seed: int, copy: int, *, in_worlds: bool) -> Process:
        if self.in_stretches and not is_program(self.setup.name):
            if not self._has_compiled_code(seed, copy):
                self.guardian.nursery(seed, copy).prepare(GENERATORS, "load")
            elif copy:
                self.guardian.nursery(seed, copy, alike=True)
        player, _ = start_player(self.guardian, self.setup, seed, copy, in_worlds=in_worlds)
        return player

    def _change_second(self, plays: int, *, may_visit: bool = False) -> None:
        """Count plays of the second player, and replace it if it is time for that."""
        tour = self.tour
        tour.at_home = self.in_stretches and is_library(self.setup.name)
        place, changed = tour.places[1], tour.change(plays, may_visit=may_visit)
        tour.count(plays)
        if changed or tour.places[1] != place:
            self._end("second")
        if tour.upcoming is not None and not is_program(self.setup.name):
            self.guardian.nursery(*tour.upcoming)

    def _end(self, which: str) -> None:
        process = self._processes.pop(which, None)
        if process is not None:
            process.close()
