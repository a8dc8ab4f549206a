"""The program of a player process, which loads the user's code: it plays, and does not judge.

    python -P -c "...; main(PARENT)" PATH...       (descriptor 3: the link; 4: the beat)

The owner is the process that has started this program; PARENT is its process id.  Each PATH is a
folder in which Python looks for modules.  The link is the socket to the owner.  The beat is memory
that the owner can read: the number of the run in progress, and the number of the explorer's turn in
this run.

The program gets the name of an explorer and then batches of runs, until the link is closed.  A
message consists of its length and of bytes that marshal has written.  The reply to a message
consists of its length, a letter that names the kind of the reply, and bytes.  The user's code in
this process may do anything.  So a verdict uses only those replies that are logs, and the judge
follows each log in the world.

The program loads only the modules of the package that it needs, so that it starts in some 50 ms if
the explorer is in Python and makes no choices.
"""

from __future__ import annotations

import gc
import marshal
import mmap
import os
import signal
import sys
from array import array
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

# All modules are loaded before users' code, which may spoil the import path.
from allworlds.engines.linux import address_space, end_with_parent, limit_memory
from allworlds.inputs.checks import InputError, NestedCheck, leave_interrupts_to_owner
from allworlds.log import BEYOND
from allworlds.protocol import actions, choices, playing

if TYPE_CHECKING:
    from allworlds.engines.kernel.library_player import LibraryPlayer
    from allworlds.explorers.loading import Subject
    from allworlds.explorers.program import Program
    from allworlds.protocol.actions import Player
    from allworlds.protocol.code_lines import TracedPlay
    from allworlds.protocol.turns import Turns
    from allworlds.world.world import World

LINK, BEAT = 3, 4
"""The descriptors of the link and of the beat in a player process."""

READY, LOGS, PART, REFUSAL, FAILURE, NO_ROOM = b"RLPEFN"
"""The letters of the answers: the explorer is loaded; the logs of a batch; a further part of a log;
bad input; an error of our code; compiled code could not make the logs of a shared library's second
play, for example because they do not fit into memory."""

TURNS = "turns", "histories"
"""The kinds of messages that ask an explorer for single turns, or for the turns of whole histories.

In a turn the explorer gets one percept, and replies with its next action.  A history is the value
that the robot is told before the start, and all percepts since then.
"""

PICKLED = ("model", "maps", "walk")
"""The kinds of messages whose content, such as worlds, is pickled; the player unpickles it."""

NO_RUN = -1
"""The number that stands for no run in progress."""

STACK = signal.SIGUSR1
"""The signal upon which a silent player prints its stack, if its prints are recorded."""

TIMERS = (signal.ITIMER_REAL, signal.ITIMER_VIRTUAL, signal.ITIMER_PROF)
"""The timers that are cleared after a batch, so that no timer of an explorer goes off later."""


def main(parent: int) -> None:
    """Serve the owner, which is the process ``parent``, until the owner closes the link."""
    end_with_parent(parent)
    leave_interrupts_to_owner()
    setup = _read()
    beat = memoryview(mmap.mmap(BEAT, 16)).cast("q")
    os.close(BEAT)
    own = os.getpid()
    try:
        subject = _loaded(setup)
    except InputError as error:
        reason = str(error)
        unrelated = "memory" in reason or isinstance(error, NestedCheck)
        if setup["memory"] is not None and not unrelated:
            reason = f"memory {setup['memory']} MB is probably too small: {reason}"
        _answer(REFUSAL, reason.encode(errors="surrogatepass"))
        return
    if os.getpid() != own:
        os._exit(0)  # this is a copy that the explorer has forked during its import
    if program := subject.program:  # here is no user's code, and it must end, too
        signal.signal(signal.SIGTERM, lambda *_: _leave(program))
        end_with_parent(parent, signal.SIGTERM)
    _flush()
    if not setup["prints"]:
        with suppress(OSError):  # users' code may have limited what can be opened
            nothing = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nothing, 1)
            os.dup2(nothing, 2)
            os.close(nothing)
    elif not program and not subject.native:
        import faulthandler

        faulthandler.register(STACK, all_threads=False)
    shield = type(subject.explore).__name__ == "Shield"  # without loading it
    _answer(READY, marshal.dumps([sorted(subject.keywords), shield]))
    with subject.running():
        server = _Server(subject, beat)
        while (batch := _read()) is not None:
            server.serve(batch)
            _flush()


def _loaded(setup: dict[str, Any]) -> Subject:
    """Load the explorer that ``setup``, the first message, names; return the explorer.

    Raises:
        InputError: if the explorer cannot be loaded.
    """
    from allworlds.protocol.importing import SourceText

    if setup["memory"] is not None:
        limit_memory(setup["memory"])
    source = None if setup["source"] is None else SourceText(*setup["source"])
    from allworlds.explorers.loading import load

    gc.enable()  # it was of no use while modules were loaded
    subject = load(setup["name"], setup["answer_timeout"], source)
    native = subject.native
    if native is not None:
        native.library.print_line_by_line()
        if setup["memory"] is None:
            limit_memory(address_space() + setup["native_memory"])
    return subject


class _Server:
    """Answers the messages of the owner with the loaded explorer.

    Args:
        subject: the explorer.
        beat: the memory that the owner can read, with the numbers of the run and of the turn.
    """

    def __init__(self, subject: Subject, beat: Any) -> None:
        self._subject, self._beat, self._pid = subject, beat, os.getpid()
        self._player: Player = subject.player()
        self._library: LibraryPlayer | None = None
        self._turns: Turns | None = None

    def serve(self, batch: dict[str, Any]) -> None:
        """Do the work that the message ``batch`` asks for, such as to play runs; send an answer."""
        self._beat[0] = NO_RUN
        try:
            if batch["kind"] == "native":
                self._native(batch)
            elif batch["kind"] in TURNS:
                self._take_turns(batch)
            else:
                self._play(batch)
        except InputError as error:  # a model of the user's
            _answer(REFUSAL, str(error).encode(errors="surrogatepass"))
        except OSError:
            raise
        except Exception:  # noqa: BLE001  # it is our error: explorers' errors are caught elsewhere
            import traceback

            _answer(FAILURE, traceback.format_exc().encode(errors="replace"))
        self._beat[1] = 0

    def _play(self, batch: dict[str, Any]) -> None:
        if batch["kind"] in PICKLED:
            import pickle

            batch["content"] = pickle.loads(batch["content"])  # noqa: S301  # our own process
        if batch["kind"] == "maps":
            _answer(LOGS, *logs_message(maps_made(batch)))
            return
        if batch["kind"] == "walk":
            _answer(LOGS, *logs_message([senses(*batch["content"])]))
            return
        logs = played(batch, self._player, self._beat, _sender() if batch["hear"] else None)
        for timer in TIMERS:
            signal.setitimer(timer, 0)
        _answer(LOGS, *logs_message(logs))

    def _take_turns(self, batch: dict[str, Any]) -> None:
        subject = self._subject
        if self._turns is None or batch.get("anew"):
            self._turns = turns_of(subject, self._player, self._beat)
        said = turns_taken(self._turns, batch)
        if os.getpid() != self._pid:
            os._exit(0)
        for timer in TIMERS:
            signal.setitimer(timer, 0)
        _answer(LOGS, *logs_message(said))

    def _native(self, batch: dict[str, Any]) -> None:
        from allworlds.engines.kernel.library_player import LibraryPlayer

        native = self._subject.native
        assert native is not None
        try:
            self._library = self._library or LibraryPlayer(native, self._beat)
            logs = self._library.play(batch)
        except actions.ExplorerFault:  # each run will report it
            logs = None
        if os.getpid() != self._pid:
            os._exit(0)
        if logs is None and not batch["again"]:
            logs = logs_message([bytes((BEYOND,))] * batch["runs"])  # so that Python plays
        _answer(NO_ROOM) if logs is None else _answer(LOGS, *logs)


def played(
    batch: dict[str, Any],
    player: Player,
    beat: Any,
    hear: Callable[[bytearray], None] | None = None,
) -> list[bytes]:
    """Play the runs of a batch in Python; return the log of run i as item i.

    If the batch asks for lines of code, the last item is not a log: it holds the lines of the
    explorer that were executed.

    Args:
        batch: the message that asks for the plays: its parts by their names.
        player: the explorer.
        beat: gets the number of the run in progress, and that of the explorer's turn in the run.
        hear: the function that is called before each turn, with the log so far; or None.
    """
    own, explorer = os.getpid(), player
    logs: list[bytes] = [b""] * batch["runs"]
    traced = list["TracedPlay"]()
    if batch["lines"]:
        from allworlds.protocol.code_lines import ONCE, LinesPlay, TracedPlay, written
    for number in batch["order"]:
        world, told, over, budget, name, script = batch["content"][number]
        beat[0] = number
        around, choices = _around(batch["kind"], world, told, over), _choices(batch, name, script)
        if batch["lines"]:
            traced.append(LinesPlay() if batch["lines"] == ONCE else TracedPlay())
            explorer = traced[-1].player(player)
        logs[number] = playing.play_run(
            around, explorer, choices, budget, beat, any_answer=batch["any_answer"], hear=hear
        )
        if os.getpid() != own:
            # The explorer has forked this process; its copy must not go on with the work.
            os._exit(0)
    if traced:
        logs[-1] = written(traced)
    return logs


def turns_of(subject: Subject, player: Player, beat: Any) -> Turns:
    """A new :class:`Turns`, by which the explorer can be asked for one turn at a time.

    Args:
        subject: the explorer, with its name.
        player: the same explorer as a function that begins a run.
        beat: gets the number of the turn in progress.
    """
    from allworlds.protocol.turns import Turns

    if subject.program:
        subject.program.stays = True
    return Turns(subject.explore, player, beat, keeps=not subject.program)


def turns_taken(turns: Turns, batch: dict[str, Any]) -> list[bytes]:
    """The explorer's replies, as bytes, to the turns or the histories in a batch.

    In a turn the explorer gets one percept, and replies with its next action; the result has one
    item for each turn.  A history is all percepts of one run so far; the result has one item for
    each history, which holds the replies to all its percepts.
    """
    if batch["kind"] == "histories":
        return turns.plays(batch["content"])
    return turns.replies(batch["content"], known=batch["known"])


def maps_made(batch: dict[str, Any]) -> list[bytes]:
    """The digest of each unit of a batch, made of the unit's maps that meet the user's condition.

    If two processes make the same maps of a unit, their digests are equal.
    """
    import hashlib

    from allworlds.world.lighthouses.composed import Nothing

    made: list[bytes] = [b""] * batch["runs"]
    extent, units = batch["content"]
    for number in batch["order"]:
        unit = getattr(units[number], "unit", units[number])  # perhaps of one of several explorers
        codes = [(map_.sigma, map_.alpha) for map_, _ in unit.placed(extent, Nothing)]
        made[number] = hashlib.sha256(repr(codes).encode()).digest()
    return made


def senses(world: World, made: Sequence[actions.Action]) -> bytes:
    """Walk in a copy of a world; return as bytes the value that is told, and the transcript.

    The walk consists of the actions ``made``.  The value is the one that the lighthouse tells the
    robot before the start.  If an action is illegal, return the text of the error, as bytes,
    instead.  The owner compares the bytes from several processes, to see whether a user's
    lighthouse always senses the same.
    """
    from allworlds.judging.walk import Walk

    anew = type(world)(world.map, world.lighthouse, world.start)
    try:
        return in_bytes(anew.told, Walk.of(anew, made).transcript)
    except actions.IllegalAction as error:
        return str(error).encode()


def in_bytes(told: actions.Told, transcript: actions.Transcript) -> bytes:
    """The value that a robot is told, and its transcript, as bytes.

    Equal values and transcripts give equal bytes.
    """
    return repr((told, transcript.to_json())).encode()


def _around(kind: str, world: Any, told: Any, over: bool) -> Any:
    """The surroundings of the explorer in a run: the object that answers each action by a percept.

    Args:
        kind: the kind of the batch.  For ``table`` the percepts are looked up in a table; for
            ``record`` they are those of an earlier play; for any other kind an
            :class:`AroundExplorer` computes them.
        world: for ``table`` the table of the world; for ``record`` the recorded percepts; for any
            other kind a pair: the world, and the task's function that says whether the task is
            done.
        told: the value that the robot is told before the start; not used by an AroundExplorer,
            which asks the world.
        over: for ``record`` whether the task is done after the last recorded percept, so that the
            run ends there.  If not, the run goes on until the explorer answers; an action after the
            last percept ends the log with the byte BEYOND.
    """
    if kind == "table":
        return playing.TableWorld(world, told)
    if kind == "record":
        return playing.Record(world, told, over)
    from allworlds.judging.episode import AroundExplorer

    return AroundExplorer(*world)


def _choices(batch: dict[str, Any], name: str, script: tuple[int, ...]) -> choices.Choices:
    if batch["every"]:
        return choices.ScheduledChoices(script)
    return choices.Choices(choices.policy_named(batch["policy"], name), script)


def _sender() -> Callable[[bytearray], None]:
    """A function that gets the log of a run so far, and sends its new bytes to the owner."""
    sent = 0

    def send(log: bytearray) -> None:
        nonlocal sent
        _answer(PART, bytes(log[sent:]))
        sent = len(log)

    return send


def logs_message(logs: Sequence[bytes]) -> tuple[bytes, bytes]:
    """Two byte strings: the lengths of the logs, four bytes for each, and the logs themselves."""
    return array("i", map(len, logs)).tobytes(), b"".join(logs)


def _read() -> Any:
    """Wait for the next message from the owner; return None if the owner has closed the link."""
    head = _bytes(4)
    return marshal.loads(_bytes(int.from_bytes(head, "little"))) if head else None  # noqa: S302


def _bytes(size: int) -> bytes:
    parts = []
    while size:
        part = os.read(LINK, min(size, 1 << 20))
        if not part:
            return b""
        parts.append(part)
        size -= len(part)
    return b"".join(parts)


def _answer(letter: int, *parts: Any) -> None:
    size = sum(map(len, parts)) + 1
    for part in (size.to_bytes(4, "little") + bytes((letter,)), *parts):
        data = memoryview(part)
        while data:
            data = data[os.write(LINK, data) :]


def _flush() -> None:
    """Flush the explorer's prints so far."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(Exception):  # whatever an explorer has made of it
            stream.flush()


def _leave(program: Program) -> None:
    """End the user's program, and then this process, as SIGTERM does without a handler."""
    program.close()
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    signal.raise_signal(signal.SIGTERM)
