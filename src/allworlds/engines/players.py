"""The code by which an owner starts a player, gives it batches, hears logs, and notices a loss.

A player is a process with an explorer (:mod:`allworlds.engines.player`); its owner is the process
that has started it.  An explorer that no other process can import plays in :class:`PlayerHere`.
Owner and player share sixteen bytes of memory, which hold the number of the run in progress and the
number of the explorer's turn in that run.  So the owner notices silence, although the player sends
all logs of a batch in one message.
"""

import marshal
import mmap
import os
import select
import signal
import socket
import sys
import time
from array import array
from collections import deque
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext, suppress
from itertools import accumulate
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias
from weakref import finalize

from msgspec import Struct
from typing_extensions import override

from allworlds import outcome, words
from allworlds.engines import linux, player
from allworlds.engines.limits import POLL, Limits, check_deadline
from allworlds.engines.prints import Prints, printing_to
from allworlds.explorers.loading import HASH_SEED, Subject, is_library, is_program
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.nesting import PLAYER
from allworlds.log import fault
from allworlds.protocol.actions import Player as Explorer
from allworlds.protocol.playing import AN_ACTION

GRACE = 2.0
"""Seconds that the owner waits longer for a player whose explorer is a user's program.

The player itself notices that such a program is silent, and needs time to say so.  The owner also
waits this number of seconds for the end of a process, and for the last prints of a silent player.
"""

NATIVE_MEMORY = 2048
"""The number of MB by which the address space of a player may grow after it has loaded a shared
library, if the user sets no limit."""

RELAYED = 1 << 16
"""While an explorer is loaded, the user sees its prints, up to about this number of bytes."""

_BOOT = (
    "import gc, sys; gc.disable(); sys.path[:] = sys.argv[1:]; del sys.argv[1:]; "
    "from allworlds.engines.player import main; main({})"
)


class HarnessError(RuntimeError):
    """Raised if a process has failed by our own code, so that no explorer is at fault."""


class Unsettled(outcome.NoResult):
    """Raised if so many players or lanes are lost that there is no verdict on the explorer."""


class Lost(Exception):
    """Raised if a player has died, or was silent for too long.

    Attributes:
        law: the law that the explorer breaks by the loss, ``timeout`` or ``crash``.
        seen: the words for the loss, such as ``silent for 5 s``.
        machine: whether the machine, and not the explorer, may be the cause.
    """

    def __init__(self, law: str, seen: str, *, machine: bool) -> None:
        super().__init__(seen)
        self.law, self.seen, self.machine = law, seen, machine


class Description(NamedTuple):
    """A player's description of the explorer that it has loaded.

    Attributes:
        keywords: the keyword arguments that the explorer takes, such as ``told``.
        has_shield: whether the explorer is inside a shield, as by the name ``shield:NAME``.  A
            shield walks on until the map is known, and answers in place of the explorer.
    """

    keywords: frozenset[str]
    has_shield: bool


class Logs(Sequence[bytes]):
    """The logs of a batch, in one message; a log is cut out of the message when it is asked for.

    Args:
        message: the length of each log, as four bytes, and then the logs.
        runs: the number of the logs.
        at: the index in the message where the lengths begin.

    Raises:
        ValueError: if the message does not hold this number of logs.
    """

    def __init__(self, message: bytes | bytearray, runs: int, at: int = 0) -> None:
        self.message, begin = message, at + 4 * runs
        lengths = array("i", bytes(message[at:begin]))
        self.starts = [*accumulate(lengths, initial=begin)]
        if len(lengths) != runs or self.starts[-1] != len(message):
            raise ValueError(bytes(message[:16]))

    @classmethod
    def of(cls, logs: Sequence[bytes]) -> "Logs":
        """These logs as an object of this class."""
        return (
            logs if isinstance(logs, Logs) else cls(b"".join(player.logs_message(logs)), len(logs))
        )

    @override
    def __len__(self) -> int:
        return len(self.starts) - 1

    @override
    def __getitem__(self, index: Any) -> Any:
        return bytes(self.message[self.starts[index] : self.starts[index + 1]])


JobLogs: TypeAlias = tuple[Any, Sequence[bytes] | None]
"""A pair: the value ``job`` that the owner gave with a message, and the logs in the answer.

In place of the logs there is None if compiled code could not make the logs of the second play of a
shared library, for example because they do not fit into memory.
"""


class Setup(Struct, frozen=True):
    """An explorer with the limits under which it is played.

    Attributes:
        subject: the explorer.
        limits: the time-outs and the memory of its players.
        prints: whether the explorer's prints are recorded.
        deadline: the time on the monotonic clock after which nobody waits for a player; or None.
    """

    subject: Subject
    limits: Limits
    prints: bool = False
    deadline: float | None = None

    def message(self) -> dict[str, Any]:
        """The first message to a player: the explorer that the player must load, and limits."""
        source, limits = self.subject.source, self.limits
        return {
            "name": self.subject.name,
            "source": None if source is None else (source.path, source.text),
            "answer_timeout": limits.answer_timeout,
            "memory": limits.memory,
            "native_memory": NATIVE_MEMORY,
            "prints": self.prints,
        }

    @property
    def patience(self) -> float:
        """The number of seconds after which a silent player is given up."""
        return self.limits.answer_timeout + (GRACE if is_program(self.subject.name) else 0.0)


class PlayerProcess:
    """A player in a process of its own, as its owner sees it.

    Args:
        setup: the explorer, with the limits of its players.
        seed: the hash seed of the process.

    Attributes:
        jobs: the messages that have no answer yet, each in a pair ``(job, message)``.  Here ``job``
            is not the job of a command, but any value that the owner gives with a message, and gets
            back with the answer.
        beat: two numbers in shared memory: the number of the run in progress, or
            :data:`player.NO_RUN`; and the number of the explorer's turn in this run.
        part: the log so far of the run in progress, if the value of the message's key ``hear`` is
            True.  Then the message asks for one run, and the player sends the log turn by turn.
            For any other message ``part`` is empty.
        prints: the prints of the explorer, if they are recorded.
        description: the description of the explorer; None before the explorer is loaded.
    """

    def __init__(self, setup: Setup, seed: int) -> None:
        self.setup, self.seed, self.owner = setup, seed, os.getpid()
        self.jobs: deque[tuple[Any, dict[str, Any]]] = deque()
        self.description: Description | None = None
        self._tries = 0
        self._start()

    def _start(self) -> None:
        self._tries += 1
        self.part, self.prints = bytearray(), Prints()
        self._out, self._coming, self._relayed = bytearray(), bytearray(), bytearray()
        self._link, theirs = socket.socketpair()
        for end in (self._link, theirs):
            end.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 1 << 20)
        self._link.setblocking(False)  # noqa: FBT003  # of the library
        self._printed, printing = os.pipe()
        os.set_blocking(self._printed, False)
        memory, beat = _shared(16)
        self.beat = memoryview(memory).cast("q")
        self.beat[0] = player.NO_RUN
        self._token = os.urandom(8).hex()
        self.pid = _spawned(self.seed, self._token, theirs.fileno(), beat, printing)
        self._status: int | None = None
        theirs.close()
        os.close(beat)
        os.close(printing)
        self._seen: object = None
        self._since = self._began = time.monotonic()
        self._put(self.setup.message())

    @property
    def files(self) -> tuple[int, ...]:
        """The descriptors on which messages or prints come."""
        link = self._link.fileno()
        return (link,) if self.prints.ended else (link, self._printed)

    def give(self, job: Any, message: dict[str, Any]) -> None:
        """Give the player a message; :meth:`heard` returns the answer together with ``job``.

        The parameter ``job`` is any value by which the owner recognises the answer.
        """
        if not self.jobs:
            self._seen, self._since = None, time.monotonic()
        self.jobs.append((job, message))
        self._put(message)

    def _put(self, message: dict[str, Any]) -> None:
        if message.get("kind") in player.PICKLED:
            import pickle

            message = {**message, "content": pickle.dumps(message["content"])}
        data = marshal.dumps(message)
        self._out += len(data).to_bytes(4, "little") + data
        self._write()

    def _write(self) -> None:
        try:
            while self._out:
                del self._out[: self._link.send(self._out)]
        except BlockingIOError:
            pass
        except OSError:
            self._out.clear()  # then it is lost, which the next read notices

    def heard(self) -> list[JobLogs]:
        """The answers that have come since the previous call, each with the ``job`` of its message.

        This is the value that :meth:`give` has got with the message.

        Raises:
            Lost: if the player is silent for too long, or has died.
            InputError: if the explorer cannot be loaded, or if a lighthouse, task or condition of
                the user fails in the player.
            HarnessError: if the player itself has failed.
        """
        self._write()
        ended = self._read()
        self._hear_prints()
        answers = [answer for answer in map(self._message, self._messages()) if answer]
        if ended and not answers:
            self._hear_prints()
            raise self._died()
        if not answers and self._silent_for() > self.setup.patience:
            seen = f"silent for {self.setup.limits.answer_timeout:g} s"
            self._hear_stack()
            raise Lost("timeout", seen, machine=True)
        return answers

    def _hear_stack(self) -> None:
        """Let a silent player print its stack if prints are recorded; no verdict uses the stack."""
        name, deadline = self.setup.subject.name, time.monotonic() + GRACE
        if not self.setup.prints or is_program(name) or is_library(name):
            return
        with suppress(ProcessLookupError, PermissionError):
            os.kill(self.pid, player.STACK)
        poll = select.poll()
        poll.register(self._printed, select.POLLIN)
        while poll.poll(500) and time.monotonic() < deadline and not self.prints.ended:
            self._hear_prints()

    def _read(self) -> bool:
        """Read the bytes that the player has sent; return whether no more can come."""
        # A process that was forked by the explorer may hold the link open.
        ended = self._code() is not None
        try:
            while part := self._link.recv(1 << 20):
                self._coming += part
        except BlockingIOError:
            return ended
        except OSError:
            pass
        return True

    def _messages(self) -> Iterable[bytearray]:
        came = self._coming
        while len(came) >= 4 and len(came) >= (end := 4 + int.from_bytes(came[:4], "little")):
            yield came[4:end]
            del came[:end]

    def _message(self, message: bytearray) -> JobLogs | None:
        letter = message[0] if message else -1
        if letter == player.PART:
            self.part += message[1:]
            return None
        if letter == player.REFUSAL:
            raise InputError(message[1:].decode(errors="surrogatepass"))
        if letter == player.FAILURE:
            raise HarnessError(message[1:].decode(errors="replace"))
        try:
            if letter == player.READY and self.description is None:
                self._hear_prints()  # those before it are of the loading
                keywords, has_shield = marshal.loads(message[1:])  # noqa: S302  # honest
                self.description = Description(frozenset(keywords), has_shield)
                return None
            if letter in (player.LOGS, player.NO_ROOM) and self.jobs:
                job, asked = self.jobs[0]
                logs = None if letter == player.NO_ROOM else Logs(message, asked["runs"], at=1)
                self.jobs.popleft()
                self._seen, self._since = None, time.monotonic()
                return job, logs
        except (ValueError, TypeError, EOFError):
            pass
        raise Lost("crash", "what a player has said is none of its messages", machine=False)

    def _hear_prints(self) -> None:
        with suppress(OSError):
            while part := os.read(self._printed, 1 << 16):
                if self.description is not None:
                    self.prints.add(part)
                elif len(self._relayed) < RELAYED:
                    self._relayed += part
                    text = part.decode(errors="backslashreplace")
                    with suppress(OSError, ValueError):
                        sys.stderr.write(words.harmless(text))
                        sys.stderr.flush()
            self.prints.ended = True

    def _silent_for(self) -> float:
        """The seconds since the explorer's latest turn; 0 if no answer is due.

        Raises:
            InputError: if the explorer is not loaded within the limit.
        """
        now = time.monotonic()
        if self.description is None:
            limit = self.setup.limits.start_timeout
            if now - self._began > limit:
                name = self.setup.subject.name
                loads = "load" if is_library(name) else "import"
                raise InputError(f"{show(name)} does not {loads}: it was at it for {limit:g} s")
            return 0.0
        seen = self.beat[0], self.beat[1]
        if not self.jobs or seen[0] == player.NO_RUN or seen != self._seen:
            self._seen, self._since = seen, now
        return now - self._since

    def _died(self) -> Lost:
        """The loss of the player, after its process has ended.

        Raises:
            InputError: if the explorer has ended the process while it was loaded.
        """
        code = self._code(GRACE)
        how = "the end of the process's pipe"
        if code is not None:
            how = f"the end of the process ({words.ended_by(code)})"
        if self.description is None:
            if code is not None and code < 0 and self._tries == 1:  # perhaps from outside
                return Lost("crash", how, machine=True)
            limits, name = self.setup.limits, self.setup.subject.name
            limit = "" if limits.memory is None else f", with memory limited to {limits.memory} MB"
            loaded = "loaded" if is_library(name) else "imported"
            raise InputError(f"a process came to {how} when it {loaded} {show(name)}{limit}")
        return Lost("crash", how, machine=code is not None and code < 0)

    def _code(self, grace: float = 0.0) -> int | None:
        """The exit code of the process; None if it does not end within ``grace`` seconds."""
        if self._status is None:
            self._status = linux.ended_within(grace, self.pid)
        return self._status

    @property
    def lives(self) -> bool:
        """Whether the process has not ended."""
        return self._code() is None

    def again(self) -> None:
        """Replace the process by a new one, and give it the messages that have no answer yet."""
        self.close()
        if self.description is not None:
            self._tries, self.description = 0, None
        due, self.jobs = self.jobs, deque()
        self._start()
        for job, message in due:
            self.give(job, message)

    def loaded(self) -> Description:
        """Wait until the explorer is loaded; return its description.

        Raises:
            InputError: if the explorer cannot be loaded.
        """
        while self.description is None:
            wait([self], 0.1)
            try:
                self.heard()
            except Lost:
                self.again()
        return self.description

    def close(self) -> None:
        """End the process, and all processes that it has started."""
        below = linux.descendants(self.pid)
        self._link.close()
        if is_program(self.setup.subject.name):  # so that it ends its program
            if self.jobs and self.lives:  # it may be waiting for a silent program
                os.kill(self.pid, signal.SIGTERM)
            self._code(GRACE)
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(self.pid, signal.SIGKILL)
        for pid in below:
            with suppress(ProcessLookupError, PermissionError):
                os.kill(pid, signal.SIGKILL)
        while self.lives:
            time.sleep(0.001)
        for pid in below:  # adopted processes must be waited for
            with suppress(ChildProcessError):
                os.waitpid(pid, 0)
        self._hear_prints()
        os.close(self._printed)
        linux.end_adopted(self._token)


class PlayerHere:
    """An explorer that plays in this process, where nobody can stop it if it is silent.

    Args:
        explorer: the explorer.
        of_user: whether the explorer is a user's; then its prints do not reach stdout or stderr.
        prints: whether the prints of a user's explorer are recorded.
        subject: the explorer with its name; needed only if a message asks for single turns.

    Attributes:
        jobs: as in :class:`PlayerProcess`.
        beat: the numbers of the run and of the turn, as in :class:`PlayerProcess`, but in a list.
        description: a description without keywords and without a shield, whatever the explorer is.
        files, part: always empty, because no messages are sent.
        prints: the explorer's prints since the player was made; empty unless they are recorded.
    """

    description = Description(frozenset(), has_shield=False)
    files: tuple[int, ...] = ()
    seed = None

    def __init__(
        self,
        explorer: Explorer,
        *,
        of_user: bool = True,
        prints: bool = False,
        subject: Subject | None = None,
    ) -> None:
        self._explorer, self._of_user, self._recorded = explorer, of_user, prints
        self._subject = subject
        self._turns: Any = None
        self.jobs: deque[tuple[Any, dict[str, Any]]] = deque()
        self.beat, self.part = [player.NO_RUN, 0], bytearray()
        self.prints = Prints()

    def give(self, job: Any, message: dict[str, Any]) -> None:
        """Add a message to the waiting ones; each call of :meth:`heard` answers the oldest one.

        The parameter ``job`` is any value by which the owner recognises the answer.
        """
        self.jobs.append((job, message))

    def heard(self) -> list[JobLogs]:
        """Answer the oldest message; return a list of one pair: its value ``job``, and the logs.

        Return an empty list if there is no message.
        """
        if not self.jobs:
            return []
        job, message = self.jobs[0]
        sink = self.prints if self._recorded else Prints()
        with printing_to(sink) if self._of_user else nullcontext():
            logs = self._logs(message)
        self.jobs.popleft()
        return [(job, logs)]

    def _logs(self, message: dict[str, Any]) -> list[bytes]:
        if message["kind"] not in player.TURNS:
            return player.played(message, self._explorer, self.beat)
        if self._turns is None or message.get("anew"):
            assert self._subject is not None
            self._turns = player.turns_of(self._subject, self._explorer, self.beat)
        return player.turns_taken(self._turns, message)

    def again(self) -> None:
        """Do nothing, because this process cannot be replaced."""

    def close(self) -> None:
        """Do nothing, because this process must not end."""


_spare: list[PlayerProcess] = []
"""Players that have loaded an explorer and have not played yet."""


def keep(player: PlayerProcess, subject: Subject) -> None:
    """Keep a player that has not played yet, until :func:`fresh` needs such a player.

    A player that is never needed ends when the object ``subject``, its explorer, is deleted.
    """
    _spare.append(player)
    finalize(subject, _let_go, player)


def fresh(setup: Setup, seed: int) -> PlayerProcess:
    """A player with this hash seed that has not played yet: a kept player or a new player."""
    wanted = os.getpid(), seed, setup.message()
    for spare in [*_spare]:
        if (spare.owner, spare.seed, spare.setup.message()) == wanted:
            _spare.remove(spare)
            if spare.lives:
                return spare
            spare.close()
    return PlayerProcess(setup, seed)


def _let_go(player: PlayerProcess) -> None:
    if player in _spare and player.owner == os.getpid():
        _spare.remove(player)
        player.close()


def wait(
    players: Sequence[PlayerProcess | PlayerHere], seconds: float, others: Sequence[int] = ()
) -> bool:
    """Wait until a player or a descriptor of ``others`` can be read, or these seconds are over.

    Return whether a descriptor of ``others`` can be read.
    """
    poll = select.poll()
    for one in players:
        if isinstance(one, PlayerHere):
            seconds = 0 if one.jobs else seconds
        for file in one.files:
            poll.register(file, select.POLLIN)
        if isinstance(one, PlayerProcess) and one._out:  # noqa: SLF001  # this module's
            poll.register(one.files[0], select.POLLIN | select.POLLOUT)
    for file in others:
        poll.register(file, select.POLLIN)
    ready = {file for file, _ in poll.poll(1000 * seconds)}
    return any(file in ready for file in others)


def started(setup: Setup, seed: int, notice: Any = None) -> PlayerProcess | PlayerHere:
    """A player of an explorer, with the hash seed ``seed`` if the player is another process.

    A user's explorer plays in a process of its own, if another process can load the explorer.  Any
    other explorer plays in this process.

    Args:
        setup: the explorer, with the limits of its players.
        seed: the hash seed of the process.
        notice: the function that a built-in explorer calls with the name of each event, such as a
            case of Algorithm 1; None if the events are not counted.
    """
    subject = setup.subject
    if subject.from_user and subject.importable:
        return fresh(setup, seed)
    explorer = subject.player(notice) if notice and not subject.from_user else subject.player()
    of_user, prints = subject.from_user, setup.prints
    return PlayerHere(explorer, of_user=of_user, prints=prints, subject=subject)


def answered(player: PlayerProcess | PlayerHere, message: dict[str, Any]) -> Sequence[bytes]:
    """Give a message to a player that has no other message; return the logs in its answer.

    Raises:
        Lost: if the player is lost.
        TimeIsUp: after the deadline.
    """
    if isinstance(player, PlayerProcess) and player.setup.prints:
        player.loaded()  # what is printed then is not of the run
    player.give(None, message)
    return logs_from(player)


def logs_from(player: PlayerProcess | PlayerHere) -> Sequence[bytes]:
    """The logs with which a player answers its only message.

    This raises the exceptions that :func:`answered` raises.
    """
    while True:
        wait([player], POLL)
        if isinstance(player, PlayerProcess):
            check_deadline(player.setup.deadline)
        try:
            for _, logs in player.heard():
                assert logs is not None
                return logs
        except Lost:
            if not (isinstance(player, PlayerProcess) and player.description is None):
                raise
            player.again()  # it was lost while it loaded the explorer


def lost_log(part: bytes, lost: Lost) -> bytes:
    """The log of a run in which a player was lost: the known part of the log, then the loss.

    ``part`` is the known part; it is empty if the player has not sent the log turn by turn.
    """
    return part + fault(lost.law, AN_ACTION, lost.seen, machine=lost.machine)


# ---------------------------------------------------------------- starting


def _shared(size: int) -> tuple[mmap.mmap, int]:
    """New memory of this size that other processes can share, and the descriptor of this memory."""
    if hasattr(os, "memfd_create"):
        file = os.memfd_create("allworlds")
    else:
        import tempfile

        with tempfile.TemporaryFile() as named:
            file = os.dup(named.fileno())
    try:
        os.truncate(file, size)
    except OSError as error:  # files may have a limit, which holds for this memory, too
        why = f"{error.strerror}; legal is 'ulimit -f' of 1 or more"
        raise InputError(f"no {size} bytes can be shared with an explorer: {why}") from None
    return mmap.mmap(file, size), file


_spawners: list[tuple[int, ThreadPoolExecutor]] = []
"""At most one pair: the number of this process, and the one thread that starts all its players.

The system ends the players when that thread ends.
"""


def _in_thread(act: Callable[[], int]) -> int:
    """Call ``act``, which starts a player, in the thread of :data:`_spawners`; return its result.

    One thread starts all players, because the system ends a player when the thread that has started
    it ends.

    Raises:
        HarnessError: if the system cannot start a process.
    """
    if not _spawners or _spawners[0][0] != os.getpid():
        _spawners[:] = [(os.getpid(), ThreadPoolExecutor(1, initializer=linux.adopt))]
    try:
        return _spawners[0][1].submit(act).result()
    except OSError as error:
        raise HarnessError(f"no process could be started: {error.strerror}") from None


def _spawned(seed: int, token: str, link: int, beat: int, printing: int) -> int:
    """Start a player; return the number of its process.

    Args:
        seed: the hash seed.
        token: a text in the environment of the process and of all its descendants.
        link: the descriptor, in this process, of the player's end of the socket.
        beat: the descriptor of the shared memory.
        printing: the descriptor to which the player prints.
    """
    environment = {**os.environ, HASH_SEED: str(seed), PLAYER: token}
    places = (link, 3), (beat, 4), (printing, 1), (printing, 2)
    # Whatever these descriptors are here, they are copied out of the way first.
    moved = [*enumerate(places, max(link, beat, printing, 4) + 1)]
    actions = [
        *((os.POSIX_SPAWN_DUP2, here, high) for high, (here, _) in moved),
        (os.POSIX_SPAWN_OPEN, 0, os.devnull, os.O_RDONLY, 0),
        *((os.POSIX_SPAWN_DUP2, high, there) for high, (_, there) in moved),
        *((os.POSIX_SPAWN_CLOSE, high) for high, _ in moved),
    ]
    command = [sys.executable, "-P", "-c", _BOOT.format(os.getpid()), *child_path()]
    return _in_thread(
        lambda: os.posix_spawn(command[0], command, environment, file_actions=actions, setsid=True)
    )


def child_path() -> list[str]:
    """The import path of a player, in which the folders of the user's files come last.

    So no file of the user hides a module of this package or of a library.
    """
    users = {"", str(Path.cwd())}
    main = getattr(sys.modules.get("__main__"), "__file__", None)
    if main:
        users.add(str(Path(main).resolve().parent))
    ours = [entry for entry in sys.path if entry not in users]
    return [*ours, *(entry for entry in sys.path if entry in users and entry)]
