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
from allworlds.engines.python.players import SEEDS, Seeds
from allworlds.engines.python.run_counter import RunCounter
from allworlds.engines.python.runs_of_unit import UnitOfRuns
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
        seeds: the hash seeds of both; a library has none, and the guardian forks both its players.
        in_stretches: whether compiled code judges, so that runs are played in shared memory, those
            of a library in compiled code, too.  Only the guardian has loaded compiled code.
    """

    guardian: Guardian
    setup: PlayerSetup
    random: Random
    alive: Callable[[], None] = lambda: None
    remark: Callable[[str], None] = lambda _: None
    seeds: Seeds = SEEDS
    in_stretches: bool = False
    _processes: dict[tuple[str, int | None], Process] = field(default_factory=dict)
    _losses: int = 0
    _sent: PlayRecords = field(default_factory=lambda: PlayRecords((), "fifo", 0))

    def __post_init__(self) -> None:
        if is_library(self.setup.name):
            self.seeds = None, None

    @property
    def answer_timeout(self) -> float:
        """The seconds after which a silent run is given up."""
        return self.setup.answer_timeout

    def close(self) -> None:
        """End all processes."""
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
        key = which, self._seed(which)
        if key not in self._processes:
            self._processes[key] = self._start(which)
        return self._processes[key]

    def _seed(self, which: str) -> int | None:
        first, second = self.seeds
        return first if which == "first" else second

    def _start(self, which: str) -> Process:
        seed = self._seed(which)
        if self.in_stretches and seed is not None and not is_program(self.setup.name):
            self.guardian.nursery(seed).prepare(GENERATORS, "load")
        player, _ = start_player(self.guardian, self.setup, seed, in_worlds=which == "first")
        return player

    def _end(self, which: str) -> None:
        process = self._processes.pop((which, self._seed(which)), None)
        if process is not None:
            process.close()
