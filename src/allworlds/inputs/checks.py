"""Checks of values from outside, and the error about bad input.

The judge calls functions of users.  The module also prevents these functions from setting the exit
code of the process, because the caller of ``allworlds`` would take this number for a verdict.

Many functions have a parameter ``name`` or ``what``: the words for the value in an error's message.
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
"""The largest number of characters of a value that messages show."""

LARGEST_SIZE = 100_000
"""The largest legal number of edges, or of vertices."""


class InputError(ValueError):
    """The error about bad input; its message is one line: the offending value, and legal values."""


class NotInstalled(InputError):
    """Raised if a Python package is missing.

    The message names the use of the package, and the extra of allworlds that installs the package.
    """


class OutOfTime(BaseException):
    """Raised when the time of a job is up.

    The error can be raised while a user's model runs, such as a lighthouse, and the code that calls
    the model must not catch it.
    """


class NestedCheck(InputError):
    """Raised if code in a check begins another check; else checks would begin without end."""


INTERRUPTS = [each for each in signal.Signals if each.name in ("SIGINT", "SIGTERM", "SIGHUP")]
"""The signals that interrupt a job: Ctrl-C, a request to terminate, and a closed terminal."""


def at_interrupts(act: Any) -> None:
    """Set ``act``, as :func:`signal.signal` takes it, as the handler of all :data:`INTERRUPTS`.

    Signals that this process ignores, for example under ``nohup``, stay ignored.
    """
    for number in INTERRUPTS:
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, act)


@contextmanager
def interrupts_held() -> Iterator[None]:
    """A context in which no interrupt arrives; interrupts meanwhile arrive at the context's end."""
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
    """Raise ``error`` again if it must not be ignored.

    Code that ignores errors of users' code calls this function first.  Two errors are always raised
    again: NestedCheck and OutOfTime.  A KeyboardInterrupt is raised again, too, because it comes
    from the user who interrupts the job.  But in a process that leaves interrupts to its owner it
    can only come from users' code (see :func:`leave_interrupts_to_owner`), and is not raised again.
    """
    interrupt = isinstance(error, KeyboardInterrupt) and not _Interrupts.of_owner
    if interrupt or isinstance(error, NestedCheck | OutOfTime):
        raise error


def show(value: object) -> str:
    """A text of one line for any object, of :data:`SHOWN` characters at most.

    If the object's ``repr`` fails, the text names the type of the object.
    """
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
    """A hint such as ``; did you mean 'algorithm1'?``; empty if no known name is similar.

    Args:
        name: the given name.
        known: the known names.  Of a form such as ``wheel:N`` only the part before the colon is
            compared, and the hint keeps the rest of the given name.
        also: for words that are not known names the known name that is meant, in small letters and
            without the colon: ``{"grid": "lattice"}`` hints at ``lattice:RxC`` for ``grid``.
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
    """The error about a value that is none of the known names, with a hint at a similar name.

    Args:
        what: the words for the value in the message.
        given: the value.
        known: the known names.
        more: further words in the message, behind the known names.
        also: for words that are not known names the known name that is meant, such as
            ``{"grid": "lattice"}``; see :func:`did_you_mean`.
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
    """``value`` as an ``int``.

    Raises:
        InputError: with ``name``, if the value is no integer; a boolean counts as no integer.
    """
    try:
        return integer(value)
    except TypeError:
        raise InputError(f"{name} = {show(value)} is not an integer") from None


def a_word(name: str, words: Sequence[str]) -> Callable[[object], Any]:
    """Return a function that returns its argument if this is one of ``words``.

    For any other argument the function raises InputError; ``name`` names the argument in its
    message.
    """

    def taken(given: object) -> object:
        if given not in words:
            raise not_one_of(name, given, words)
        return given

    return taken


def at_most(name: str, value: float, most: int) -> None:
    """Refuse a value above ``most``: a job of such a size could not be finished, or even printed.

    Raises:
        InputError: with ``name``, if the value is above ``most``.
    """
    if value > most:
        raise InputError(f"{name} = {show(value)} is too big; at most {most:,} is legal")


def a_text(name: str, value: object) -> str:
    """``value``, which must be a text.

    Raises:
        InputError: with ``name``, if the value is no text.
    """
    if not isinstance(value, str):
        raise InputError(f"{name} = {show(value)} is not a text")
    return value


def a_path(name: str, value: object) -> Path:
    """``value`` as a path.

    Raises:
        InputError: with ``name``, if the value is no path.  An empty text is refused, too, because
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
    """The absolute path of the file at the path ``value``; None if there is no file.

    Raises:
        InputError: with ``name``, if ``value`` is no path, or its folder cannot be read.
    """
    # Unlike Path.resolve, this accepts a loop of links, which leads to no file.
    path = a_path(name, value)
    file = type(path)(os.path.realpath(path))
    try:
        return file if file.is_file() else None
    except OSError as error:
        raise InputError(f"{name} {show(value)} cannot be read: {error.strerror}") from None


def is_loop_of_links(path: str | Path) -> bool:
    """Whether the symbolic links at ``path`` form a loop, which leads to no file."""
    try:
        os.stat(path)  # noqa: PTH116  # takes any text
    except ValueError:
        return False
    except OSError as error:
        return error.errno == errno.ELOOP
    return False


def no_file(path: str, hint: str = "") -> str:
    """The message that there is no file at ``path``.

    ``hint`` is added to the message, except if symbolic links form a loop there.
    """
    if is_loop_of_links(path):
        return f"{show(path)} is a loop of links"
    return f"there is no file {show(path)}{hint}"


INSTALL = "in a clone of allworlds, pip install '.[{}]'"
"""The instruction for the installation of an extra, whose name replaces ``{}``."""


def ensure_installed(package: str, extra: str, what: str) -> None:
    """Raise NotInstalled unless the package can be imported.

    Args:
        package: the name of the Python package.
        extra: the extra of allworlds that installs the package.
        what: the words for the use of the package, such as an option.

    Raises:
        NotInstalled: if the package is missing; the message contains ``what``, ``package`` and
            ``extra``.
    """
    if lack := lack_of(package, extra):
        raise NotInstalled(f"{what} {lack}")


def lack_of(package: str, extra: str) -> str:
    """The words that a package is missing, and that ``extra`` installs it; empty if it is there."""
    return "" if find_spec(package) else f"needs {package}: {INSTALL.format(extra)}"


def parse_json(text: str, kind: type[InputError] = InputError, file: str = "") -> Any:
    """The value of a JSON text.

    Args:
        text: the text.
        kind: the class of errors.
        file: the name of the file with the text, for the message; empty if there is no file.

    Raises:
        InputError: of the class ``kind``, if the text is no JSON, or if an object has a key twice,
            so that the value of this key is ambiguous.
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
    """A context in which each InputError names the file ``name``; if this is empty, no file."""
    try:
        yield
    except InputError as error:
        raise type(error)(f"file {show(name)}: {error}" if name else str(error)) from None


def read_text(path: str) -> str:
    """The text of the file at ``path``, which a user has given; ``-`` stands for stdin.

    Raises:
        InputError: with the path, and the reason why the file cannot be read.
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
    """The integer that a text such as ``-12`` stands for.

    Unlike ``int``, this function refuses ``1_0``, and digits other than 0 to 9.

    Raises:
        ValueError: if the text is no integer; users can understand the message.
    """
    if re.fullmatch(r"[+-]?[0-9]{1,4000}", text):
        return int(text)
    raise ValueError(f"{show(text)} is not an integer")


def seconds_of(text: str) -> float:
    """The number of seconds that a text such as ``1.5`` or ``inf`` stands for.

    Raises:
        ValueError: if the text is no number; users can understand the message.
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
    """The holder of ``process``, the id of the process whose exit code users' code cannot set.

    In the process with this id the functions in :data:`ENDINGS`, such as ``os._exit``, raise
    SystemExit instead of ending the process.  In a forked process, which has another id, these
    functions do what they always do.  If there is no such process, the id is 0.
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
