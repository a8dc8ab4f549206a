"""The log of a run: the bytes that a player makes.  Only this module writes and reads logs.

The module imports nothing, so that a player starts fast.  A log is a sequence of entries.  Each
entry begins with a byte, which tells the kind of the entry; most kinds have a name:

    0..199              a motion by this number of darts
    200 SHOWN           a checkpoint: the number of darts, here, sigma, alpha
    201 ANSWERED        the answer, in the same form as a checkpoint
    202 OVER_BUDGET     one traversal more than the budget
    203 SHOWN_TOO_OFTEN one checkpoint more than is legal
    204 FAULT           the explorer breaks a law: the index of the law in LAWS below; whether the
                        machine may be the cause of the fault (1) or not (0); and three texts: the
                        expected, the observed, and more, such as a traceback
    205 BEYOND          an action that the player cannot follow: in the second play of a run the
                        player has only the percepts of the first play, and none is left
    206 FAR             a motion by 200 darts or more; the number of darts follows
    207 DROP, 208 PICK  a marker is dropped, or picked up
    209 WRITE           a number is written; the number follows
    210 CHOICE          a choice: the index of the option that was taken, and the number of options
                        (0: unknown)
    211 LONG_CHOICE     like 210, with numbers of any length
    212 LONG_SHOWN      like 200, with numbers of any length
    213 LONG_ANSWER     like 201, with numbers of any length
    214 QUOTIENT        the answer is a rooted quotient
    215 VALUE           the answer is a JSON text
    216 OVER            the task is done, and ends the run
    217 FREE_TOO_OFTEN  too many free actions (drop, pick, write)
    218 REFUSED         the last action is illegal; a walk of the log in the world shows why

The compiled judge reads only the entries with the bytes 0 to 204 and 210, and no values after 204;
it leaves a log with another entry to Python.  A compiled player writes 204 without values.  If it
cannot write an entry, it writes 205 in place of this entry; then Python plays the run again.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:  # the module of that name would have to be loaded
    from collections.abc import Sequence
    from typing import Any

LARGEST_MOTION = 199
SHOWN, ANSWERED, OVER_BUDGET, SHOWN_TOO_OFTEN, FAULT, BEYOND = range(200, 206)
FAR, DROP, PICK, WRITE, CHOICE, LONG_CHOICE, LONG_SHOWN, LONG_ANSWER = range(206, 214)
QUOTIENT, VALUE, OVER, FREE_TOO_OFTEN, REFUSED = range(214, 219)

ENDS = frozenset({OVER_BUDGET, SHOWN_TOO_OFTEN, BEYOND, OVER, FREE_TOO_OFTEN, REFUSED})
"""The bytes that end a log, and after which no value stands."""

LAWS = ("crash", "timeout", "illegal-action", "no-estimate")
"""The laws whose breach a player itself notices; a law's number is its index here."""

MOST_DARTS = 64
"""The largest number of darts in an entry in which each number is one byte."""

DROPPED, PICKED, WROTE = -1, -2, -3
"""The numbers of all actions other than motions; ``Write(k)`` has the number ``WROTE - k``."""


# ---------------------------------------------------------------- writing


def motion(k: int) -> bytes:
    """The entry of the motion ``Move(k)`` with ``k`` >= 0."""
    return bytes((k,)) if k <= LARGEST_MOTION else bytes((FAR,)) + _number(k)


def written(number: int) -> bytes:
    """The entry of an action that writes a number."""
    return bytes((WRITE,)) + _number(number)


def choice(index: int, options: int) -> bytes:
    """The entry of a choice: the option with this index, among ``options`` options."""
    if 0 <= index <= 255 and options <= 255:
        return bytes((CHOICE, index, options))
    return bytes((LONG_CHOICE,)) + _number(index) + _number(options)


def shown(sigma: Sequence[int], alpha: Sequence[int], here: int) -> bytes:
    """The entry of a checkpoint with these ``sigma``, ``alpha`` and ``here``."""
    return _short(SHOWN, sigma, alpha, here) or (
        bytes((LONG_SHOWN,)) + _numbers(sigma) + _numbers(alpha) + _number(here)
    )


def answer(sigma: Sequence[int], alpha: Sequence[int], here: int) -> bytes:
    """The entry of an answer that is an estimate: a map, and its dart ``here``."""
    return _short(ANSWERED, sigma, alpha, here) or (
        bytes((LONG_ANSWER,)) + _numbers(sigma) + _numbers(alpha) + _number(here)
    )


def quotient(lists: Sequence[Sequence[int]], here: int) -> bytes:
    """The entry of an answer that is a rooted quotient.

    ``lists`` holds the quotient's sigma, alpha, degrees and marks; ``here`` is the class of the
    robot's dart.
    """
    return bytes((QUOTIENT,)) + b"".join(map(_numbers, lists)) + _number(here)


def value(text: str) -> bytes:
    """The entry of an answer that is a JSON text."""
    return bytes((VALUE,)) + _text(text)


def fault(law: str, expected: str, seen: str, detail: str = "", *, machine: bool = False) -> bytes:
    """The entry of a fault, by which a run breaks a law.

    Args:
        law: the name of the law.
        expected: what the law demands, in words.
        seen: what was observed instead, in words.
        detail: a further text, such as a traceback.
        machine: whether the machine may be the cause of the fault, not the explorer.
    """
    words = b"".join(map(_text, (expected, seen, detail)))
    return bytes((FAULT, LAWS.index(law), machine)) + words


def _short(code: int, sigma: Sequence[int], alpha: Sequence[int], here: int) -> bytes:
    """The entry of a checkpoint or an answer in which each number is one byte.

    ``code`` is the first byte: SHOWN or ANSWERED.  The result is empty if such an entry is
    impossible: if a number does not fit into a byte, if sigma and alpha have different lengths, or
    if there is no dart, or more than :data:`MOST_DARTS` darts.
    """
    darts = len(sigma)
    if not (darts == len(alpha) and 1 <= darts <= MOST_DARTS):
        return b""
    try:
        return bytes((code, darts, here, *sigma, *alpha))
    except ValueError:
        return b""


def _number(number: int) -> bytes:
    size = number.bit_length() // 8 + 1
    return size.to_bytes(4, "little") + number.to_bytes(size, "little", signed=True)


def _numbers(numbers: Sequence[int]) -> bytes:
    return len(numbers).to_bytes(4, "little") + b"".join(map(_number, numbers))


def _text(text: str) -> bytes:
    data = text.encode(errors="surrogatepass")
    return len(data).to_bytes(4, "little") + data


# ---------------------------------------------------------------- reading


class Log:
    """The content of a log.

    Attributes:
        actions: for each action its number: k for a motion ``Move(k)``; for another action
            ``DROPPED``, ``PICKED`` or, for ``Write(k)``, ``WROTE - k``.
        checkpoints: for each checkpoint four values: the number of actions before the checkpoint,
            sigma, alpha, here.
        choices: for each choice the index of the option that was taken.
        widths: for each choice the number of options (0: unknown).
        ending: the first byte of the last entry, and the values of this entry.  For FAULT the
            values are the name of the law, the three texts, and whether the machine may be the
            cause.
    """

    __slots__ = ("actions", "checkpoints", "choices", "ending", "widths")

    def __init__(self, log: bytes) -> None:
        """Read the log whose bytes are ``log``.

        Raises:
            ValueError: if the bytes are no log; if the last entry is not one that ends a log (an
                answer, or a reason for which the run is over); or if bytes follow the entry that
                ends the log.
        """
        self.actions: list[int] = []
        self.checkpoints: list[tuple[int, tuple[int, ...], tuple[int, ...], int]] = []
        self.choices: list[int] = []
        self.widths: list[int] = []
        self.ending: tuple[Any, ...] = ()
        try:
            self._read(log)
        except IndexError:
            raise ValueError("the log has no end") from None

    def _read(self, log: bytes) -> None:
        at, actions = 0, self.actions
        while True:
            code = log[at]
            at += 1
            if code <= LARGEST_MOTION:
                actions.append(code)
            elif code in (SHOWN, ANSWERED):
                darts, here = log[at], log[at + 1]
                at += 2
                sigma, alpha = log[at : at + darts], log[at + darts : at + 2 * darts]
                if len(alpha) != darts:
                    raise IndexError
                at += 2 * darts
                published = tuple(sigma), tuple(alpha), here
                if code == ANSWERED:
                    return self._ends(log, at, code, *published)
                self.checkpoints.append((len(actions), *published))
            elif code == CHOICE:
                self.choices.append(log[at])
                self.widths.append(log[at + 1])
                at += 2
            elif code in _ACTIONS:
                actions.append(_ACTIONS[code])
            elif code in ENDS:
                return self._ends(log, at, code)
            else:
                end = self._long(log, at, code)
                if end < 0:
                    return None
                at = end

    def _long(self, log: bytes, at: int, code: int) -> int:
        """Read an entry with numbers of any length or with texts.

        ``code`` is the first byte of the entry, and ``at`` the index after this byte.  Return the
        index after the entry, or -1 if the entry ends the log.
        """
        if code == FAR:
            at, number = _number_at(log, at)
            self.actions.append(number)
        elif code == WRITE:
            at, number = _number_at(log, at)
            self.actions.append(WROTE - number)
        elif code == LONG_CHOICE:
            at, index = _number_at(log, at)
            at, options = _number_at(log, at)
            self.choices.append(index)
            self.widths.append(options)
        elif code in _LISTS:
            parts: list[tuple[int, ...]] = []
            for _ in range(_LISTS[code]):
                at, numbers = _numbers_at(log, at)
                parts.append(numbers)
            at, here = _number_at(log, at)
            if code != LONG_SHOWN:
                self._ends(log, at, code, *parts, here)
                return -1
            self.checkpoints.append((len(self.actions), parts[0], parts[1], here))
        elif code == VALUE:
            at, text = _text_at(log, at)
            self._ends(log, at, code, text)
            return -1
        elif code == FAULT and at == len(log):  # compiled code writes no texts
            self._ends(log, at, code, *_WITHOUT_WORDS)
            return -1
        elif code == FAULT:
            law, machine = log[at], log[at + 1]
            at += 2
            texts = []
            for _ in range(3):
                at, text = _text_at(log, at)
                texts.append(text)
            if law >= len(LAWS):
                raise ValueError(f"no law has the number {law}")
            self._ends(log, at, code, LAWS[law], *texts, bool(machine))
            return -1
        else:
            raise ValueError(f"the byte {code} begins no entry")
        return at

    def _ends(self, log: bytes, at: int, *end: object) -> None:
        if at != len(log):
            raise ValueError("the log goes on behind its end")
        self.ending = end


_WITHOUT_WORDS = "illegal-action", "", "", "", False
_ACTIONS = {DROP: DROPPED, PICK: PICKED}
_LISTS = {LONG_SHOWN: 2, LONG_ANSWER: 2, QUOTIENT: 4}


def _number_at(log: bytes, at: int) -> tuple[int, int]:
    """The index after the number that begins at index ``at`` of ``log``; and this number."""
    size = _size_at(log, at)
    return at + 4 + size, int.from_bytes(log[at + 4 : at + 4 + size], "little", signed=True)


def _numbers_at(log: bytes, at: int) -> tuple[int, tuple[int, ...]]:
    length, numbers = int.from_bytes(log[at : at + 4], "little"), []
    at += 4
    for _ in range(length):
        at, number = _number_at(log, at)
        numbers.append(number)
    return at, tuple(numbers)


def _text_at(log: bytes, at: int) -> tuple[int, str]:
    size = _size_at(log, at)
    return at + 4 + size, log[at + 4 : at + 4 + size].decode(errors="surrogatepass")


def _size_at(log: bytes, at: int) -> int:
    """The length in bytes of the number or text at index ``at`` of ``log``.

    The length stands in the 4 bytes from ``at`` on; the number or text follows.  Raise IndexError
    if fewer bytes follow than the length says.
    """
    size = int.from_bytes(log[at : at + 4], "little")
    if len(log) < at + 4 + size:
        raise IndexError
    return size
