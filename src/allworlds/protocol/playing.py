"""The play of one run of an explorer to its end; its only result is a log.

A world answers the explorer's actions, or the recorded percepts of an earlier play do so.
"""

import json
import sys
import traceback
from collections.abc import Callable, Generator, Iterable, MutableSequence, Sequence
from itertools import islice
from operator import length_hint
from typing import Any, Protocol

from msgspec import Struct

from allworlds import log as entries
from allworlds.inputs import checks
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.protocol import actions
from allworlds.protocol.choices import Choices

FREE = 10
"""``FREE * (budget + 1)`` free actions (drop, pick, write) are legal in a run that may have
``budget`` traversals.  Without a limit an explorer could drop and pick for ever."""

LONGEST = 20_000
"""The largest number of characters of a traceback that are kept."""

FRAMES = 50
"""The number of innermost frames of a traceback that are kept.  An endless recursion would have a
thousand frames in each play of each run."""

MOST_DARTS = 2 * checks.LARGEST_SIZE
"""The largest number of darts in an answer, or twice the step budget if that is larger."""

AN_ESTIMATE = "Estimate(map, here) with a dart of the map"
"""The words in findings for a legal answer that is no quotient."""

A_QUOTIENT = "Ambiguous(sigma, alpha, degree, marks, here): a connected rooted quotient"
"""The words in findings for a legal answer that is a quotient."""

A_VALUE = "an Estimate, or an answer that JSON has"
"""The words in findings for a legal answer if the task allows any answer."""

NO_MAP, BUILT = "no map: ", "built "
"""The first words of two texts: about a map that cannot be built, and about the line of the
explorer that tried to build it."""

AN_ACTION = "an action, or an estimate at the end"

_OF_MAPS = sys.modules[CombinatorialMap.__module__].__file__.rpartition("combinatorial")[0]  # type: ignore[union-attr]
"""The folder of the modules that raise InvalidMap; a line of an explorer is in another folder."""


class Surroundings(Protocol):
    """The world in which an explorer plays, or recorded percepts in place of a world.

    Attributes:
        first: the percept before any action.
        told: the value that the lighthouse tells before the start, or None.
        over: whether the task is done, so that the run ends here.
    """

    @property
    def first(self) -> actions.Percept:
        """Return the percept before any action."""

    @property
    def told(self) -> actions.Told:
        """Return the value that the lighthouse tells before the start, or None."""

    @property
    def over(self) -> bool:
        """Return whether the task is done, so that the run ends here."""

    def move(self, k: int) -> actions.Percept:
        """Return a copy of the percept after a motion ``k``, which is below the degree."""

    def act(self, action: actions.Drop | actions.Pick | actions.Write) -> actions.Percept:
        """Return the percept after an action; raise IllegalAction if the action is illegal."""


def play_run(
    around: Surroundings,
    player: actions.Player,
    choices: Choices,
    budget: int,
    beat: MutableSequence[int],
    *,
    any_answer: bool = False,
    hear: Callable[[bytearray], None] | None = None,
) -> bytes:
    """Play one run to its end, and return its log.

    Args:
        around: the surroundings, which answer the actions.
        player: the explorer.
        choices: the choices, for an explorer that takes choices.
        budget: the largest legal number of traversals; ``budget + 1`` checkpoints are legal.
        beat: numbers that another process can read, to notice that the explorer is silent:
            ``beat[1]`` grows at each turn of the explorer, and is 0 after the run.
        any_answer: whether the task allows other answers than estimates.
        hear: a function that is called with the log so far before each turn, or None.

    Raises:
        InputError: if a user's model, such as a lighthouse, fails when it answers the explorer.

    Cost: linear in the number of steps, plus the explorer's own cost.
    """
    log = bytearray()
    told = around.told
    turns = _Turns(log, around, choices, budget, beat, hear)
    generator = None
    beat[1] = 1
    try:
        own = told if told is None or isinstance(told, int) else dict(told)
        generator = player(around.first, choices, own)
        turns.play(generator)
    except StopIteration as stop:
        turns.note_choices()
        most = max(MOST_DARTS, 2 * budget)
        log += any_answer_entry(stop.value, most) if any_answer else answer_entry(stop.value, most)
    except BaseException as error:
        if (
            isinstance(error, checks.InputError) and error is not turns.own
        ):  # of a model of the user's
            raise
        turns.note_choices()
        log += raised(error)
    finally:
        closed(generator)
        beat[1] = 0
    return bytes(log)


class _Turns(Struct):
    """The play of one run, turn by turn: each message of the explorer gets an entry in the log.

    Attributes:
        log: the log so far.
        around: the surroundings, which answer the actions.
        choices, budget, beat, hear: the arguments of :func:`play_run`.
        own: the InputError that the explorer's generator has raised, or None; :func:`play_run`
            tells it from an InputError of a user's model.
        _noted: the number of choices that are in the log already.
        _shown: the number of checkpoints so far.
    """

    log: bytearray
    around: Surroundings
    choices: Choices
    budget: int
    beat: MutableSequence[int]
    hear: Callable[[bytearray], None] | None
    own: checks.InputError | None = None  # the explorer's
    _noted: int = 0
    _shown: int = 0

    def note_choices(self) -> None:
        """Write the choices since the last call of this method to the log."""
        record, widths = self.choices.record, self.choices.widths
        for i in range(self._noted, len(record)):
            self.log += entries.choice(record[i], widths[i] if i < len(widths) else 0)
        self._noted = len(record)

    def play(self, generator: Generator[Any, Any, Any]) -> None:
        """Play until a fault, or until the task is done.

        If the explorer answers, its generator ends, and this method raises StopIteration.
        """
        around, log, beat, record = self.around, self.log, self.beat, self.choices.record
        send, move, add, hear = generator.send, around.move, log.append, self.hear
        left, free, turn = self.budget, FREE * (self.budget + 1), 1
        degree, reply = around.first.degree, None
        while not around.over:
            if hear is not None:
                hear(log)
            try:
                message = send(reply)
            except checks.InputError as error:
                self.own = error
                raise
            turn += 1
            beat[1] = turn
            if len(record) != self._noted:
                self.note_choices()
            if type(message) is actions.Move:
                k: Any = message.k
                if type(k) is not int and (k := self._integer(message)) is None:
                    return None
                if not left:
                    return add(entries.OVER_BUDGET)
                left -= 1
                k %= degree
                if k <= entries.LARGEST_MOTION:
                    add(k)
                else:
                    log += entries.motion(k)
                try:
                    reply = move(k)
                except actions.BeyondRecord:
                    return add(entries.BEYOND)
                degree = reply.degree
            elif type(message) is actions.Checkpoint:
                if not self._publish(message):
                    return None
                reply = None
            elif type(message) in (actions.Drop, actions.Pick, actions.Write):
                reply = self._act(message, free)
                if reply is None:
                    return None
                free -= 1
                degree = reply.degree
            else:
                legal = "a Move, Drop, Pick, Write or Checkpoint"
                such = f", such as Move({checks.show(message)})" if type(message) is int else ""
                log += illegal(legal + such, message)
                return None
        add(entries.OVER)
        return None

    def _integer(self, message: actions.Move | actions.Write) -> int | None:
        """The number ``k`` of the action ``message``.

        If ``k`` is no integer, the result is None, and an entry in the log says so.
        """
        try:
            return checks.integer(message.k)
        except BaseException as error:  # noqa: BLE001  # __index__ is the explorer's code
            checks.let_users_interrupt(error)
            name = type(message).__name__
            self.log += illegal(f"{name}(k) with an integer k", message)
            return None

    def _act(
        self, action: actions.Drop | actions.Pick | actions.Write, free: int
    ) -> actions.Percept | None:
        """The percept after a drop, pick or write; None if the run ends here.

        The run ends if the action is illegal, if it is one action of these kinds too many (see
        :data:`FREE`), or if there is no recorded percept any more; an entry in the log says which.
        ``free`` is the number of such actions that the run may still have, this one included.
        """
        log = self.log
        if type(action) is actions.Write:
            number = self._integer(action)
            if number is None:
                return None
            if number < 0:
                log += illegal("Write(k) with k from 0 on", action)
                return None
            action = actions.Write(number)
            log += entries.written(number)
        else:
            log.append(entries.DROP if type(action) is actions.Drop else entries.PICK)
        if not free:
            log.append(entries.FREE_TOO_OFTEN)
            return None
        try:
            return self.around.act(action)
        except actions.IllegalAction:
            log.append(entries.REFUSED)
        except actions.BeyondRecord:
            log.append(entries.BEYOND)
        return None

    def _publish(self, message: actions.Checkpoint) -> bool:
        """Write a checkpoint to the log, and return True.

        If the checkpoint is malformed, or one too many, write this fault, which ends the run, and
        return False.
        """
        if self._shown > self.budget:
            self.log.append(entries.SHOWN_TOO_OFTEN)
            return False
        self._shown += 1
        most = max(MOST_DARTS, 2 * self.budget)
        try:
            sigma, alpha = integers(message.sigma, most), integers(message.alpha, most)
            self.log += entries.shown(sigma, alpha, checks.integer(message.here))
        except TooManyDarts as error:
            walked = "a checkpoint of what has been walked along"
            self.log += entries.fault("illegal-action", walked, str(error))
            return False
        except BaseException as error:  # noqa: BLE001  # the parts are the explorer's code
            checks.let_users_interrupt(error)
            self.log += illegal("a checkpoint of two sequences of integers and an integer", message)
            return False
        return True


def illegal(expected: str, message: object) -> bytes:
    """The entry in the log about a message that is no legal action.

    ``expected`` says in words which message would be legal.
    """
    return entries.fault("illegal-action", expected, checks.show(message))


# ---------------------------------------------------------------- answers


class TooManyDarts(ValueError):
    """Raised for a map with more darts than the robot can have walked along."""


def answer_entry(answer: object, most: int = MOST_DARTS) -> bytes:
    """The entry in the log about the explorer's answer, an estimate or a rooted quotient.

    Args:
        answer: the answer; any value is accepted, and for a wrong one the entry tells the fault.
        most: the largest legal number of darts; for an answer with more darts the entry is the
            fault ``no-estimate``.
    """
    expected = A_QUOTIENT if type(answer) is actions.Ambiguous else AN_ESTIMATE
    try:
        if type(answer) is actions.Ambiguous:
            lists = answer.sigma, answer.alpha, answer.degree, answer.marks
            sequences = [integers(each, most) for each in lists]
            return entries.quotient(sequences, checks.integer(answer.here))
        if type(answer) is actions.Estimate:
            claimed: object = answer.map
            if not isinstance(claimed, CombinatorialMap):
                said = f"a map that is {checks.show(claimed)}"
                return entries.fault("no-estimate", expected, said)
            sigma, alpha = integers(claimed.sigma, most), integers(claimed.alpha, most)
            return entries.answer(sigma, alpha, checks.integer(answer.here))
    except TooManyDarts as error:
        return entries.fault("no-estimate", expected, str(error))
    except BaseException as error:  # noqa: BLE001  # the parts are the explorer's code
        checks.let_users_interrupt(error)
    return entries.fault("no-estimate", expected, checks.show(answer))


def any_answer_entry(answer: object, most: int = MOST_DARTS) -> bytes:
    """The entry in the log about an answer that may be an estimate, a quotient or a JSON value.

    ``most`` is the largest legal number of darts of an estimate or a quotient, see
    :func:`answer_entry`.
    """
    if type(answer) in (actions.Estimate, actions.Ambiguous):
        return answer_entry(answer, most)
    try:
        text = json.dumps(answer, allow_nan=False, default=checks.integer)
    except BaseException as error:  # noqa: BLE001  # the parts are the explorer's code
        checks.let_users_interrupt(error)
        return entries.fault("no-estimate", A_VALUE, checks.show(answer))
    return entries.value(text)


def integers(values: Iterable[object], most: int = MOST_DARTS) -> tuple[int, ...]:
    """The values of a sequence as integers; the sequence may be endless.

    Raises:
        TypeError: if a value is no integer.
        TooManyDarts: if there are more than ``most``; later values are not read.
    """
    kept = values if type(values) is tuple else tuple(islice(values, most + 1))
    if len(kept) > most:
        raise TooManyDarts(f"more than {most:,} darts")
    if checks.are_plain(kept):
        return kept  # type: ignore[return-value]
    return tuple([checks.integer(value) for value in kept])


# ---------------------------------------------------------------- faults


def raised(error: BaseException, own: int = 2) -> bytes:
    """The entry in the log about an exception that the explorer has raised.

    The first ``own`` frames of the traceback belong to this program, and are left out.
    """
    checks.let_users_interrupt(error)
    if type(error) is actions.ExplorerFault and error.law in entries.LAWS:
        words = AN_ACTION, error.seen, error.detail
        return entries.fault(error.law, *words, machine=error.machine)
    name = type(error).__name__
    try:
        if isinstance(error, InvalidMap):
            return _no_map(error)
        frames = error.__traceback__
        for _ in range(own):
            frames = frames and frames.tb_next
        message = str.__str__(str(error))[: checks.SHOWN]
        error.__cause__ = error.__context__ = None  # each has a traceback of its own
        detail = "".join(traceback.format_exception(type(error), error, frames, limit=-FRAMES))
    except BaseException as another:  # noqa: BLE001  # an exception may not even be printable
        checks.let_users_interrupt(another)
        return entries.fault("crash", AN_ACTION, f"{name}, which cannot be shown")
    seen = f"{name}: {message}" if message else name
    machine = isinstance(error, MemoryError)
    return entries.fault("crash", AN_ACTION, seen, detail[-LONGEST:], machine=machine)


def _no_map(error: InvalidMap) -> bytes:
    """The entry in the log if the explorer raised InvalidMap: the fault ``no-estimate``.

    InvalidMap is raised if the explorer makes a map from a sigma and an alpha that are no map.  The
    entry also has this sigma and alpha, if the exception has them, and the line of the explorer
    that made the map.
    """
    built = [
        f"{BUILT}in {frame.filename}, line {frame.lineno}, in {frame.name}: {frame.line}"
        for frame in traceback.extract_tb(error.__traceback__)
        if not frame.filename.startswith(_OF_MAPS)
    ]
    detail = "\n\n".join(filter(None, (error.tried, *built[-1:])))
    said = f"{NO_MAP}{str.__str__(str(error))[: checks.SHOWN]}"
    return entries.fault("no-estimate", AN_ESTIMATE, said, detail[:LONGEST])


def closed(generator: Generator[Any, Any, Any] | None) -> None:
    """Close the generator, if there is one, and ignore each exception that it then raises."""
    try:
        if generator is not None:
            generator.close()
    except BaseException as error:  # noqa: BLE001  # the run is already decided
        checks.let_users_interrupt(error)


# ---------------------------------------------------------------- what an explorer walks in


class TableWorld:
    """A world as a table of numbers, for lighthouses whose percepts never change.

    The darts of a vertex have consecutive numbers, clockwise.  Each dart has five numbers in the
    table: the first dart of its vertex; the other dart of its edge; and for its percept the degree,
    the marks, and the bearing plus 1, or 0 without a bearing.

    Args:
        table: the numbers, as bytes if no number is above 255; the start is dart 0.
        told: the value that is told before the start.
    """

    over = False

    def __init__(self, table: bytes | tuple[int, ...], told: actions.Told) -> None:
        percepts = _along(table)
        self.told, self.first, self.move = told, next(percepts), percepts.send

    def act(self, _action: object) -> actions.Percept:
        """Raise IllegalAction, because in such a world only motions are legal."""
        raise actions.IllegalAction


def _along(table: bytes | tuple[int, ...]) -> Generator[actions.Percept, int, None]:
    """Yield the percept at dart 0, and then the percept after each motion that is sent."""
    here = 0
    while True:
        degree = table[here + 2]
        leaving = here + 5 * (yield percept_of(degree, table[here + 3], table[here + 4]))
        if leaving >= 5 * (table[here] + degree):
            leaving -= 5 * degree
        here = 5 * table[leaving + 1]


class Record:
    """The percepts of an earlier play, in place of a world.

    Args:
        sensed: three numbers for each percept: degree, marks, and the bearing plus 1, or 0 without
            a bearing.
        told: the value that is told before the start.
        over: whether the task ends the run after the last percept.
    """

    def __init__(
        self, sensed: bytes | tuple[int, ...], told: actions.Told, over: bool = False
    ) -> None:
        self._left = iter([*map(percept_of, sensed[::3], sensed[1::3], sensed[2::3])])
        percepts = _recorded(self._left)
        self._ends, self.told, self.first = over, told, next(percepts)
        self.move = self.act = percepts.send

    @property
    def over(self) -> bool:
        """Whether the explorer has got the last percept, and the task ends the run there."""
        return self._ends and not length_hint(self._left)


def _recorded(percepts: Iterable[actions.Percept]) -> Generator[actions.Percept, Any, None]:
    """Yield the first percept, and then the next percept after each action that is sent.

    Raises:
        BeyondRecord: for an action after the last percept.
    """
    for percept in percepts:  # noqa: UP028  # a list takes no actions
        yield percept
    raise actions.BeyondRecord


def percept_of(degree: int, marks: int, bearing: int) -> actions.Percept:
    """The percept of three numbers; the third is the bearing plus 1, or 0 without a bearing.

    Each call makes a new object, so if an explorer changes its percept, no other percept changes.
    """
    return actions.Percept(degree, marks, bearing - 1 if bearing else None)


def numbers_of(percepts: Iterable[actions.Percept]) -> bytes | tuple[int, ...]:
    """The numbers of several percepts in a row: for each the three of :func:`percept_of`."""
    numbers = [
        number
        for p in percepts
        for number in (p.degree, p.marks, 0 if p.bearing is None else p.bearing + 1)
    ]
    return packed(numbers)


def packed(numbers: Sequence[int]) -> bytes | tuple[int, ...]:
    """The numbers, as bytes if all are from 0 to 255, else as a tuple."""
    try:
        return bytes(numbers)
    except ValueError:
        return tuple(numbers)
