"""Checks of values from outside, and the error about bad input.

The judge calls functions of users.  The module also prevents these functions from setting the exit
code of the process, because a caller would take this number for a verdict.
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
"""The largest number of characters of a value that are shown."""

LARGEST_SIZE = 100_000
"""The largest legal number of edges, or of vertices."""


class InputError(ValueError):
    """Bad input: one line that names the offending value and what would be legal."""


class NotInstalled(InputError):
    """Raised if a package is missing.

    The message names the use of the package, and the extra that installs the package.
    """


class OutOfTime(BaseException):
    """Raised when the time of a job is up.

    This error can be raised inside a user's model, such as a lighthouse, and must not be caught
    there.
    """


class NestedCheck(InputError):
    """Raised if a check causes another check to begin; else checks would begin without end."""


INTERRUPTS = [each for each in signal.Signals if each.name in ("SIGINT", "SIGTERM", "SIGHUP")]
"""The signals that interrupt a job: Ctrl-C, a request to terminate, and a closed terminal."""


def at_interrupts(act: Any) -> None:
    """Set ``act`` as the handler of each signal in :data:`INTERRUPTS`.

    Signals that this process ignores, for example under ``nohup``, stay ignored.
    """
    for number in INTERRUPTS:
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, act)


@contextmanager
def interrupts_held() -> Iterator[None]:
    """A context in which no interrupt arrives; pending interrupts arrive at its end."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, INTERRUPTS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


class _Interrupts:
    """The holder of ``of_owner``: whether this process leaves interrupts to its owner.

    The owner is the process that has started this one.
    """

    of_owner = False


def leave_interrupts_to_owner() -> None:
    """Leave interrupts to the owner of this process, the process that has started it.

    From now on SIGINT is ignored, so a KeyboardInterrupt can only come from users' code.  SIGTERM
    or SIGHUP ends this process, even if the owner does not get the signal.
    """
    _Interrupts.of_owner = True
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    at_interrupts(signal.SIG_DFL)


def let_users_interrupt(error: BaseException) -> None:
    """Raise ``error`` again if no caller may ignore it.

    No caller may ignore the refusal of a nested check, the end of a job's time, or an interrupt by
    the user.  If this process leaves interrupts to its owner, a KeyboardInterrupt may be ignored.
    """
    interrupt = isinstance(error, KeyboardInterrupt) and not _Interrupts.of_owner
    if interrupt or isinstance(error, NestedCheck | OutOfTime):
        raise error


def show(value: object) -> str:
    """A short text of one line for any object, even if its repr fails."""
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

    Of a known form such as ``wheel:N`` only the part before the colon is compared; the hint keeps
    the rest of the given name.  ``also`` holds other words for known names, such as ``grid`` for
    ``lattice``.
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
    """The error for a value that is none of the known names, with a hint at a similar name.

    Args:
        what: the words for the value in the message.
        given: the value.
        known: the known names.
        more: further words in the message, behind the known names.
        also: other words for known names, see :func:`did_you_mean`.
    """
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
    """Whether all values have the type ``int`` itself, so that no value needs a conversion."""
    return [*map(type, values)].count(int) == len(values)


def an_integer(name: str, value: object) -> int:
    """The value as an ``int``.

    Raises:
        InputError: naming the value, if it is no integer; a boolean counts as no integer.
    """
    try:
        return integer(value)
    except TypeError:
        raise InputError(f"{name} = {show(value)} is not an integer") from None


def a_word(name: str, words: Sequence[str]) -> Callable[[object], Any]:
    """Return a function that returns its argument if it is one of these words.

    For other values the function raises InputError.
    """

    def taken(given: object) -> object:
        if given not in words:
            raise not_one_of(name, given, words)
        return given

    return taken


def at_most(name: str, value: float, most: int) -> None:
    """Refuse a value above ``most``; a job of such a size could not be finished, or even printed.

    Raises:
        InputError: naming the value.
    """
    if value > most:
        raise InputError(f"{name} = {show(value)} is too big; at most {most:,} is legal")


def a_text(name: str, value: object) -> str:
    """The value, if it is a text.

    Raises:
        InputError: naming the value.
    """
    if not isinstance(value, str):
        raise InputError(f"{name} = {show(value)} is not a text")
    return value


def a_path(name: str, value: object) -> Path:
    """The value as a path.

    Raises:
        InputError: naming the value, if it is no path.  An empty text is refused, too, because
            Python would take it for the current directory.
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
    """The file at that path, made absolute; None if there is no file.

    Raises:
        InputError: if the value is no path, or its folder cannot be read.
    """
    # Unlike Path.resolve, this accepts a loop of links, which leads to no file.
    path = a_path(name, value)
    file = type(path)(os.path.realpath(path))
    try:
        return file if file.is_file() else None
    except OSError as error:
        raise InputError(f"{name} {show(value)} cannot be read: {error.strerror}") from None


def is_loop_of_links(path: str | Path) -> bool:
    """Whether the links at that path form a loop, which leads to no file."""
    try:
        os.stat(path)  # noqa: PTH116  # takes any text
    except ValueError:
        return False
    except OSError as error:
        return error.errno == errno.ELOOP
    return False


def no_file(path: str, hint: str = "") -> str:
    """The reason why there is no file at that path.

    ``hint`` is added to the reason, unless the reason is a loop of links.
    """
    if is_loop_of_links(path):
        return f"{show(path)} is a loop of links"
    return f"there is no file {show(path)}{hint}"


INSTALL = "in a clone of allworlds, pip install '.[{}]'"
"""The instruction for the installation of an extra."""


def ensure_installed(package: str, extra: str, what: str) -> None:
    """Raise NotInstalled unless the package can be imported.

    Raises:
        NotInstalled: naming ``what``, which is the use of the package, and the extra that installs
            the package.
    """
    if lack := lack_of(package, extra):
        raise NotInstalled(f"{what} {lack}")


def lack_of(package: str, extra: str) -> str:
    """A text that names a missing package and the extra for it; empty if it is installed."""
    return "" if find_spec(package) else f"needs {package}: {INSTALL.format(extra)}"


def parse_json(text: str, kind: type[InputError] = InputError, file: str = "") -> Any:
    """The value of a JSON text; ``file`` names its file in errors.

    Raises:
        InputError: of class ``kind``, if the text is no JSON, or if an object has a key twice, so
            that its value is ambiguous.
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
    """A context in which errors about bad input name the file, unless the name is empty."""
    try:
        yield
    except InputError as error:
        raise type(error)(f"file {show(name)}: {error}" if name else str(error)) from None


def read_text(path: str) -> str:
    """The text of a file that the user names; ``-`` stands for stdin.

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
    """The integer in a text such as ``-12``.

    Unlike ``int``, this function refuses ``1_0``, and digits of other scripts.

    Raises:
        ValueError: if the text is no integer; the message is fit for users.
    """
    if re.fullmatch(r"[+-]?[0-9]{1,4000}", text):
        return int(text)
    raise ValueError(f"{show(text)} is not an integer")


def seconds_of(text: str) -> float:
    """The number of seconds in a text such as ``1.5`` or ``inf``.

    Raises:
        ValueError: if the text is no number; the message is fit for users.
    """
    if re.fullmatch(r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?|-?inf|nan", text):
        return float(text)
    raise ValueError(f"{show(text)} is not a number of seconds")


def one_of(names: Iterable[str]) -> str:
    """The names in one text, in the form ``a, b or c``."""
    *others, last = names
    return f"{', '.join(others)} or {last}"


ENDINGS = {name: getattr(os, name) for name in ("_exit", "execv", "execve")}
"""The functions of ``os`` that end a process, or replace its program, at once; the other functions
``os.exec...`` call them."""


class _Kept:
    """The holder of ``process``: the id of the process that refuses functions which would end it.

    In this process the functions in :data:`ENDINGS`, such as ``os._exit``, raise SystemExit.  In a
    forked process, which has another id, they do what they always do.  The id is 0 if no process
    refuses them.
    """

    process = 0


def keep_exit_code() -> None:
    """Let ``os._exit`` and ``os.exec...`` raise SystemExit in this process from now on.

    In forked processes these functions do what they always do.
    """
    _Kept.process = os.getpid()
    vars(os).update(_REFUSALS)


@contextmanager
def exit_code_kept() -> Iterator[None]:
    """A context in which ``os._exit`` and ``os.exec...`` raise SystemExit in this process.

    So a user's function that is called in the context cannot choose the exit code of the process.
    """
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
