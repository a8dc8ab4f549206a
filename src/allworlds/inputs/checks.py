"""Checks of what comes from outside, and the error that is the user's to mend.

The exit code of the process is no matter of a model's: it would pass for a verdict.
"""

from __future__ import annotations

import errno
import json
import operator
import os
import re
import signal
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pathlib import Path


SHOWN = 200
"""The number of characters of a value that are shown."""

LARGEST_SIZE = 100_000
"""The largest number of edges, or of vertices, that is taken at all."""


class InputError(ValueError):
    """Bad input: one line that names the offending value and what would be legal."""


class NotInstalled(InputError):
    """Raised where a package is missing: the words say what needs it, and which extra has it."""


class OutOfTime(BaseException):
    """Raised if the time of a job is up: also in a model of the user's, which must let it pass."""


class NestedCheck(InputError):
    """Raised if a check begins because of another one, as it would again and again."""


INTERRUPTS = [each for each in signal.Signals if each.name in ("SIGINT", "SIGTERM", "SIGHUP")]
"""The signals that interrupt: from the keyboard, to terminate, of a terminal that is closed."""


def at_interrupts(act: Any) -> None:
    """Give these signals a handler, but for those that are to be ignored (``nohup``)."""
    for number in INTERRUPTS:
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, act)


@contextmanager
def interrupts_held() -> Iterator[None]:
    """A context in which none arrives; it does at the end."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, INTERRUPTS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


class _Interrupts:
    """Whether interrupts of this process are its owner's business."""

    of_owner = False


def leave_interrupts_to_owner() -> None:
    """Take no more notice of interrupts: only users' code raises KeyboardInterrupt from now on.

    A signal that is for this process alone ends it.
    """
    _Interrupts.of_owner = True
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    at_interrupts(signal.SIG_DFL)


def let_users_interrupt(error: BaseException) -> None:
    """Raise an interrupt again, unless interrupts are the business of this process's owner.

    A check that may not begin is the user's to mend, too, wherever it would have begun.
    """
    interrupt = isinstance(error, KeyboardInterrupt) and not _Interrupts.of_owner
    if interrupt or isinstance(error, NestedCheck | OutOfTime):
        raise error


def show(value: object) -> str:
    """A short text of one line for any object, also for one whose repr fails."""
    try:
        text = str.__str__(repr(value))
    except BaseException as error:  # noqa: BLE001  # repr may be anybody's code
        let_users_interrupt(error)
        return f"an object of type {type(value).__name__} whose repr fails"
    if not isinstance(value, str):
        text = re.sub(" at 0x[0-9a-f]+", "", text)  # an address is another one each time
        text = " ".join(text.splitlines())
    return text if len(text) <= SHOWN else text[: SHOWN - 3] + "..."


def did_you_mean(name: str, known: Iterable[str], also: Mapping[str, str] | None = None) -> str:
    """A hint such as ``; did you mean 'algorithm1'?``; empty if no name is similar.

    Of a form such as ``wheel:N`` the part before the colon is compared, and what stands behind it
    in the name is kept.  ``also`` has other words for names, such as ``grid`` for a lattice.
    """
    from difflib import get_close_matches  # which players do not need

    names = {re.sub(":[A-Z].*", "", each).lower(): each for each in known}
    names |= {word: names[meant] for word, meant in (also or {}).items() if meant in names}
    head, colon, argument = name.lower().partition(":")
    words = (name.lower(), head)
    close = (names[key] for word in words for key in get_close_matches(word, names, 1))
    if (nearest := next(close, None)) is None:
        return ""
    whole = re.sub(":[A-Z].*", f":{argument}", nearest) if colon else nearest
    return f"; did you mean {show(nearest if whole == name else whole)}?"


def not_one_of(
    what: str,
    given: object,
    known: Iterable[str],
    more: str = "",
    also: Mapping[str, str] | None = None,
) -> InputError:
    """The refusal of a value that is none of some names, with the one that may be meant."""
    names = [str(each) for each in known]  # of an enumeration, too
    hint = did_you_mean(given, names, also) if isinstance(given, str) else ""
    return InputError(f"{what} {show(given)} is not one of {', '.join(names)}{more}{hint}")


def integer(value: object) -> int:
    """``value`` as a plain ``int`` if it is an integer and no boolean.

    Raises:
        TypeError: for booleans, floats, strings and everything else.
    """
    if type(value) is int:
        return value
    if isinstance(value, bool):
        raise TypeError(f"{show(value)} is a boolean, not an integer")
    index = operator.index(value)  # type: ignore[arg-type]  # refuses what is no integer
    return int.__index__(index)  # also for a subclass with operators of its own


def are_plain(values: Sequence[object]) -> bool:
    """Whether all are of the type ``int`` itself, as nearly always; then none need be converted."""
    return [*map(type, values)].count(int) == len(values)


def an_integer(name: str, value: object) -> int:
    """The value as an ``int``.

    Raises:
        InputError: naming it, for booleans and everything else that is no integer.
    """
    try:
        return integer(value)
    except TypeError:
        raise InputError(f"{name} = {show(value)} is not an integer") from None


def a_word(name: str, words: Sequence[str]) -> Callable[[object], Any]:
    """Return what takes one of these words, and raises InputError, naming it, for anything else."""

    def taken(given: object) -> object:
        if given not in words:
            raise not_one_of(name, given, words)
        return given

    return taken


def at_most(name: str, value: float, most: int) -> None:
    """Refuse a value that is larger.

    What follows from larger ones could not be counted, printed or waited for.

    Raises:
        InputError: naming it.
    """
    if value > most:
        raise InputError(f"{name} = {show(value)} is too big; at most {most:,} is legal")


def a_text(name: str, value: object) -> str:
    """The value, if it is a text.

    Raises:
        InputError: naming it.
    """
    if not isinstance(value, str):
        raise InputError(f"{name} = {show(value)} is not a text")
    return value


def a_path(name: str, value: object) -> Path:
    """The value as a path.

    Raises:
        InputError: naming it, for what is no path, and for an empty text, which Python would
            take for the current directory.
    """
    if value == "" or not isinstance(value, str | os.PathLike):
        raise InputError(f"{name} = {show(value)} is no path, not even of the current directory")
    try:
        nameable = b"\0" not in os.fsencode(value)
    except UnicodeEncodeError:
        nameable = False
    if not nameable:
        raise InputError(f"{name} = {show(value)} is no path: no file can be named so")
    from pathlib import Path  # which players do not need

    return Path(value)


def existing_file(name: str, value: str) -> Path | None:
    """The file at that path, made absolute; None if there is none.

    Raises:
        InputError: if it is no path, or its folder cannot be read.
    """
    # Unlike Path.resolve, it takes a loop of links, in which there is no file.
    path = a_path(name, value)
    file = type(path)(os.path.realpath(path))
    try:
        return file if file.is_file() else None
    except OSError as error:
        raise InputError(f"{name} {show(value)} cannot be read: {error.strerror}") from None


def is_loop_of_links(path: str | Path) -> bool:
    """Whether links at that path lead to themselves, and so to no file."""
    try:
        os.stat(path)  # noqa: PTH116  # takes any text
    except ValueError:
        return False
    except OSError as error:
        return error.errno == errno.ELOOP
    return False


def no_file(path: str, hint: str = "") -> str:
    """The reason why there is no file at that path; the hint follows, unless it is a loop."""
    if is_loop_of_links(path):
        return f"{show(path)} is a loop of links"
    return f"there is no file {show(path)}{hint}"


INSTALL = "in a clone of allworlds, pip install '.[{}]'"
"""How an extra is installed."""


def ensure_installed(package: str, extra: str, what: str) -> None:
    """Raise NotInstalled unless the package can be imported.

    Raises:
        NotInstalled: saying what needs it, and which extra brings it.
    """
    if lack := lack_of(package, extra):
        raise NotInstalled(f"{what} {lack}")


def lack_of(package: str, extra: str) -> str:
    """The words that a package is needed, and which extra brings it; empty if it is installed."""
    return "" if find_spec(package) else f"needs {package}: {INSTALL.format(extra)}"


def parse_json(text: str, kind: type[InputError] = InputError, file: str = "") -> Any:
    """The value of a JSON text, which was read from a file perhaps.

    Raises:
        InputError: of the kind that was asked for, if it is none, or if an object has a key
            twice: which value is meant cannot be told.
    """

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        found = dict(pairs)
        if len(found) < len(pairs):
            keys = [key for key, _ in pairs]
            twice = next(key for key in keys if keys.count(key) > 1)
            raise kind(f"the key {show(twice)} stands twice in one object")
        return found

    try:
        return json.loads(text, object_pairs_hook=once)
    except InputError:
        raise
    except (ValueError, RecursionError) as error:
        of = f"file {show(file)} is " if file else ""
        raise kind(f"{of}not JSON: {show(str(error))[1:-1]}") from None


@contextmanager
def in_file(name: str) -> Iterator[None]:
    """Name the file in what is told of bad input in it; an empty name is no file."""
    try:
        yield
    except InputError as error:
        raise type(error)(f"file {show(name)}: {error}" if name else str(error)) from None


def read_text(path: str) -> str:
    """The text of a file that the user has named; of stdin for ``-``.

    Raises:
        InputError: naming the file and the reason why it cannot be read.
    """
    try:
        if path == "-":
            return sys.stdin.read().removeprefix("\ufeff")
        return a_path("file", path).read_text(encoding="utf-8-sig")
    except (OSError, UnicodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is no text"
        raise InputError(f"file {show(path)} cannot be read: {reason}") from None


# ---------------------------------------------------------------- texts that become values


def integer_of(text: str) -> int:
    """The integer of a text; unlike ``int`` without 1_0 and other scripts.

    Raises:
        ValueError: saying what the text is not; so do all that read the text of an option.
    """
    if re.fullmatch(r"[+-]?[0-9]{1,4000}", text):
        return int(text)
    raise ValueError(f"{show(text)} is not an integer")


def seconds_of(text: str) -> float:
    """The number of a text."""
    if re.fullmatch(r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?|-?inf|nan", text):
        return float(text)
    raise ValueError(f"{show(text)} is not a number of seconds")


def one_of(names: Iterable[str]) -> str:
    """The names of a table, as a help says them: ``a, b or c``."""
    *others, last = names
    return f"{', '.join(others)} or {last}"


ENDINGS = {name: getattr(os, name) for name in ("_exit", "execv", "execve")}
"""The functions of ``os`` that end a process, or its program, at once; others call these."""


class _Kept:
    """The process in which they are refused; 0 if they are refused nowhere."""

    process = 0


def keep_exit_code() -> None:
    """Refuse ``os._exit`` and ``os.exec...`` in this process, and not in those that are forked."""
    _Kept.process = os.getpid()
    vars(os).update(_REFUSALS)


@contextmanager
def exit_code_kept() -> Iterator[None]:
    """A context in which these are refused in this process."""
    process, functions = _Kept.process, {name: getattr(os, name) for name in ENDINGS}
    keep_exit_code()
    try:
        yield
    finally:
        _Kept.process = process
        vars(os).update(functions)


def _refuse(name: str, *values: Any, **keywords: Any) -> Any:
    if _Kept.process == os.getpid():
        first = next(iter((*values, *keywords.values())), "")
        raise SystemExit(f"os.{name}({show(first)}) would end the process")
    return ENDINGS[name](*values, **keywords)


_REFUSALS = {name: partial(_refuse, name) for name in ENDINGS}
