"""Defaults of options from a user's file, and the key ``made_by`` of documents.

The file is ``allworlds.toml``, or the table ``[tool.allworlds]`` in a project's ``pyproject.toml``.
The key ``made_by`` of a document has all that may differ if the same command is given again:
version, host, time, speed.
"""

import tomllib
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from dataclasses import dataclass, field
from datetime import UTC, datetime
from functools import partial, reduce
from itertools import chain
from pathlib import Path
from time import perf_counter
from typing import Any

from allworlds.documents.report import MadeBy, Report
from allworlds.inputs.checks import InputError, did_you_mean, in_file, read_text, show
from allworlds.inputs.requests import GIVEN_IN_FILE
from allworlds.verbs import BY_NAME
from allworlds.version import __version__, host

OWN, PROJECT, TABLE = "allworlds.toml", "pyproject.toml", "tool.allworlds"


@dataclass
class Defaults:
    """The defaults that a file gives.

    Attributes:
        file: the path of the file; empty without a file.
        options: the defaults by the names of options; they apply to every verb that has such an
            option.  Under the name of a verb there is a table with defaults for this verb alone.
        used: the defaults that have taken effect in the command so far.
    """

    file: str = ""
    options: dict[str, Any] = field(default_factory=dict)
    used: dict[str, Any] = field(default_factory=dict)

    def map_for(self, root: Any, words: list[str]) -> dict[str, Any]:
        """The defaults of the verb that ``words`` name, in the form of click's ``default_map``.

        An example of this form is ``{"ambiguity": {"twins": {option: default}}}``: each word of the
        verb's name is the key of a dictionary.  The innermost dictionary leads from click's name of
        an option to a function that returns the default, and adds it to :attr:`used`.  The result
        is empty if the file gives no defaults.

        Args:
            root: the click command ``allworlds``, made by ``command_line``.  If the file gives any
                defaults, ``root`` must have the options of all verbs, because the keys of the file
                are compared with these options.
            words: the words of the command, without the program's name.

        Raises:
            InputError: naming a key that is no option of a verb, an unknown verb, or an illegal
                value.
        """
        if not self.options:
            return {}
        with in_file(self.file):
            every = {name: _options(_command(root, name)) for name in BY_NAME}
            tables = {key: value for key, value in self.options.items() if isinstance(value, dict)}
            everywhere = [key for key in self.options if key not in tables]
            _ensure_known(everywhere, "a verb", {*chain(*every.values())})
            for verb, table in tables.items():
                if verb not in every:
                    raise InputError(f"there is no verb {show(verb)}{did_you_mean(verb, every)}")
                _ensure_known(table, verb, every[verb])
            GIVEN_IN_FILE.set(frozenset(chain(everywhere, *tables.values())))
            plain = [word for word in words if not word.startswith("-")]
            name = next((n for n in (" ".join(plain[:2]), *plain[:1]) if n in every), "")
            given = {**self.options, **self.options.get(name, {})}
            if any(word.startswith(("--exec", "--native")) for word in words):
                given.pop("explorer", None)  # another one is named
            found: dict[str, Any] = {
                param.name: partial(self._use, key, _value(key, given[key], param), param)
                for key, param in every.get(name, {}).items()
                if key in given
            }
        for word in reversed(name.split()):
            found = {word: found}
        return found

    def _use(self, key: str, value: Any, param: Any) -> Any:
        self.used[key] = value
        return [value] if isinstance(value, str) and param.multiple else value


def defaults_here() -> Defaults:
    """The defaults that the nearest file with defaults gives.

    The file is searched in the current directory, and then in each directory above, the nearest
    first.  In each directory ``allworlds.toml`` is tried before ``pyproject.toml``.  If there is no
    such file, the result has no defaults.

    Raises:
        InputError: naming a file that is not TOML.
    """
    try:
        here = Path.cwd()
    except FileNotFoundError:  # this is told where the directory is needed
        return Defaults()
    for folder in (here, *here.parents):
        for name, table in ((OWN, ""), (PROJECT, TABLE)):
            file = folder / name
            if file.is_file() and table in (text := read_text(str(file))):
                found = _table(name, text, table)
                if found is not None:
                    return Defaults(str(file) if folder != here else name, found)
    return Defaults()


def _table(file: str, text: str, name: str) -> dict[str, Any] | None:
    """The entries of the table ``name`` in a TOML text; None if the text has no such table.

    An entry that has a verb's name is a table with the defaults for this verb alone.

    Args:
        file: the name of the file, for the error.
        text: the text of the file.
        name: the name of the table, such as ``tool.allworlds``; empty for the whole text.

    Raises:
        InputError: if the text is not TOML.
    """
    try:
        found: Any = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"file {show(file)} is not TOML: {error}") from None
    for part in filter(None, name.split(".")):
        if not isinstance(found := found.get(part), dict):
            return None
    return dict(_flat(found))


def _flat(table: Mapping[str, Any], group: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the entries of a table of defaults, as pairs of a name and a value.

    An entry for a group of verbs, such as ``{"ambiguity": {"twins": defaults}}``, is replaced by
    one pair for each verb of the group: ``("ambiguity twins", defaults)``.

    Args:
        table: the table.
        group: the text to put before each name; the function sets it when it calls itself for the
            verbs of a group.
    """
    for key, value in table.items():
        inner = isinstance(value, dict) and any(isinstance(each, dict) for each in value.values())
        if inner:
            yield from _flat(value, f"{key} ")
        else:
            yield group + key, value


def _command(root: Any, name: str) -> Any:
    """The click command of the verb ``name``, such as ``check`` or ``ambiguity twins``.

    ``root`` is the click command ``allworlds``, which holds all verbs.
    """
    return reduce(lambda home, word: home.commands[word], name.split(), root)


def _options(command: Any) -> dict[str, Any]:
    """The options and arguments of a click command, by the names that a user's file has for them.

    The name of an option is its longest name on the command line, without the dashes at the
    beginning, in small letters.  The name of an argument is its own name in small letters.
    """
    return {
        max(param.opts, key=len).lstrip("-").lower(): param
        for param in command.params
        if not param.is_eager and param.name != "arguments"
    }


def _ensure_known(keys: Iterable[str], owner: str, known: Collection[str]) -> None:
    """Raise InputError for a key that is not among the known options.

    The message says that the key is no option of ``owner``: the name of a verb, or the words
    ``a verb``.
    """
    for key in keys:
        if key not in known:
            raise InputError(f"{key} is no option of {owner}{did_you_mean(key, known)}")


def _value(key: str, value: object, param: Any) -> Any:
    """The default ``value`` from the user's file, in the form of a value on the command line.

    That form is a text, or a list of texts; for a flag it is True or False.

    Args:
        key: the name of the option in the file.
        value: the value that the file gives.
        param: the click option.

    Raises:
        InputError: if the value has no such form.
    """
    if getattr(param, "is_flag", False):
        if isinstance(value, bool):
            return value
        raise InputError(f"{key} = {show(value)} is not true or false")
    if isinstance(value, list) and param.callback.asked.repeated:
        return [_text(f"{key}[{i}]", each) for i, each in enumerate(value)]
    return _text(key, value)


def _text(key: str, value: object) -> str:
    if isinstance(value, str | int | float) and not isinstance(value, bool):
        return str(value)
    raise InputError(f"{key} = {show(value)} is neither a text nor a number")


@dataclass(frozen=True, slots=True)
class _BegunCommand:
    """A command that has begun.

    Attributes:
        command: the words of the command, without the program's name.
        defaults: the defaults from the user's file.
        started: the date and the time of day of the start, in UTC.
        clock: the reading of the clock ``perf_counter`` at the start, in seconds, to measure how
            long the command takes.
    """

    command: tuple[str, ...]
    defaults: Defaults
    started: datetime
    clock: float


_COMMAND: ContextVar[_BegunCommand] = ContextVar("command")


def begin(command: Sequence[str], defaults: Defaults) -> None:
    """Note that a command begins now; the functions below tell of this command.

    Args:
        command: the words of the command, without the program's name.
        defaults: the defaults from the user's file.
    """
    _COMMAND.set(_BegunCommand(tuple(command), defaults, datetime.now(UTC), perf_counter()))


def words_of_command() -> tuple[str, ...]:
    """The words of the command that has begun, without the program's name.

    The result is empty if no command has begun.
    """
    begun = _COMMAND.get(None)
    return begun.command if begun else ()


def defaults_used() -> dict[str, dict[str, Any]]:
    """A dictionary from the path of the user's file to the defaults that the command took from it.

    The dictionary is empty if the command took no defaults from a file.
    """
    begun = _COMMAND.get(None)
    used = begun.defaults if begun else None
    return {used.file: used.used} if used and used.used else {}


def made_by(report: Report, workers: int | None = None) -> MadeBy:
    """The value of the key ``made_by`` in the document of a report.

    The value names the version, the command and the machine.  It also has the seconds from the
    beginning of the command until now, and the seconds of each part of the job, such as a level.

    Args:
        report: the report, which knows the seconds of each part.
        workers: the number of processes or threads; None for a verb without workers.
    """
    parts: dict[str, Any] = {
        name: tuple(round(each, 3) for each in seconds)
        for name, seconds in report.seconds_by_part.items()
    }
    if used := defaults_used():
        parts["defaults"] = used
    begun = _COMMAND.get()
    return MadeBy(
        version=__version__,
        command=begun.command,
        workers=workers,
        host=host(),
        started=begun.started.strftime("%Y-%m-%dT%H:%M:%SZ"),
        seconds=round(perf_counter() - begun.clock, 3),
        **parts,
    )
