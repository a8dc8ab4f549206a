"""The words of ``--exec``: the program, and the script that an interpreter is to run."""

from __future__ import annotations

import errno
import os
import re
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from allworlds.inputs import is_loop_of_links, show

SECONDS = 5
"""The time after which a program that is asked for its errors of syntax is left alone."""


class Interpreter(NamedTuple):
    """The command line of an interpreter.

    Attributes:
        language: in words.
        letters: options after which no file is run, such as ``-c CODE``, each by its letter.
        words: the same, written out.
        values: options with a value in the next word.
        endings: of a file's name that may be left out.
        looks: the options with which it reads a file and does not run it; none if there are none.
    """

    language: str
    letters: str = "e"
    words: tuple[str, ...] = ()
    values: tuple[str, ...] = ()
    endings: tuple[str, ...] = ()
    looks: tuple[str, ...] = ()


INTERPRETERS = {
    r"python[0-9.]*|pypy3?": Interpreter(
        "Python",
        "cm",
        values=("-W", "-X", "--check-hash-based-pycs"),
        looks=("-c", "import sys; f = sys.argv[1]; compile(open(f, 'rb').read(), f, 'exec')"),
    ),
    r"node|nodejs": Interpreter(
        "JavaScript",
        "epi",
        ("--eval", "--print", "--interactive", "--run", "--test"),
        ("-r", "--require", "--import", "--loader", "--experimental-loader", "-C", "--conditions"),
        (".js", ".json"),
        ("--check",),
    ),
    r"(da|ba|k|z)?sh": Interpreter("shell script", "cs", values=("-o", "-O"), looks=("-n",)),
    r"ruby": Interpreter("Ruby", values=("-I", "-r", "-C")),
    r"perl": Interpreter("Perl", "eEx", values=("-I",)),
    r"lua[0-9.]*": Interpreter("Lua", "ei", values=("-l",)),
    r"php[0-9.]*": Interpreter("PHP", "rBRES", values=("-d", "-c", "-f")),
}
"""Programs that run a file, by patterns for their names."""

ERROR = r"^.*?\b(\w*(?:Syntax|Indentation|Tab) ?[Ee]rror\b.*)$"
"""The line of an error of syntax on stderr."""


def missing_script(words: Sequence[str]) -> str:
    """The reason why an interpreter cannot open its script; empty if it can, or if unknown."""
    call = _call(words)
    if call is None:
        return ""
    # Where an option may have a value, the script is one of the other words.
    scripts = call.files[:1] if call.sure else call.files
    endings = ("", *call.interpreter.endings)
    if any(Path(script + ending).exists() for script in scripts for ending in endings):
        return ""
    name = Path(call.program).name
    if is_loop_of_links(call.files[0]):
        return f"{name} cannot open {show(call.files[0])}: it is a loop of links"
    return f"{name} cannot open {show(call.files[0])}: there is no such file"


def syntax_error(words: Sequence[str]) -> str:
    """The reason why an interpreter cannot read its script; empty if it can, or if unknown.

    A script that seems to have an error is run without any input: its interpreter must say so.
    """
    call = _call(words)
    if call is None or not call.interpreter.looks:
        return ""
    script, language = call.files[0], call.interpreter.language
    if not _said([call.program, *call.interpreter.looks, script]):
        return ""
    said = _said(words)
    message = re.search(ERROR, said, re.MULTILINE)
    if message is None:
        return ""
    line = re.search(rf"{re.escape(script)}\D{{1,10}}([0-9]+)", said)
    where = f", line {line[1]}" if line else ""
    return f"{show(script)}{where} is no {language}: {message[1]}"


def _said(words: Sequence[str]) -> str:
    """The text on stderr of a command without an input; empty if it does not fail at once."""
    try:
        ended = subprocess.run(  # noqa: S603  # running it is what was asked for
            words, stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return ended.stderr.decode(errors="replace") if ended.returncode else ""


class _Call(NamedTuple):
    """A call of an interpreter.

    Attributes:
        program, interpreter: the word that names it, and its entry in the table.
        files: the script and its arguments.
        sure: whether the first of these is the script.
    """

    program: str
    interpreter: Interpreter
    files: list[str]
    sure: bool


def _call(words: Sequence[str]) -> _Call | None:
    """The call of an interpreter that runs a file; None for any other command."""
    rest = _without_env(words)
    program = rest.pop(0) if rest else ""
    name = Path(program).name
    interpreter = next((i for names, i in INTERPRETERS.items() if re.fullmatch(names, name)), None)
    if interpreter is None:
        return None
    sure = True
    while rest and rest[0].startswith("-"):
        option = rest.pop(0)
        if option == "--":
            break
        if _runs_no_file(option, interpreter):
            return None
        if option in interpreter.values:
            del rest[:1]
        elif option.startswith("--") and "=" not in option:
            sure = False
    return _Call(program, interpreter, rest, sure) if rest else None


def _without_env(words: Sequence[str]) -> list[str]:
    """The words of a command behind ``env`` and its options."""
    rest = [*words]
    if Path(rest[0]).name == "env":
        rest.pop(0)
        while rest and (rest[0].startswith("-") or "=" in rest[0]):
            if rest.pop(0) in ENV_VALUES:
                del rest[:1]
    return rest


ENV_VALUES = ("-u", "-C", "--unset", "--chdir")
"""The options of ``env`` with a value in the next word."""


def _runs_no_file(option: str, interpreter: Interpreter) -> bool:
    if option.startswith("--"):
        return option.partition("=")[0] in interpreter.words
    return option == "-" or any(letter in interpreter.letters for letter in option[1:])


def obstacle(name: str) -> str:
    """The reason why a command cannot be run."""
    path = Path(name)
    if is_loop_of_links(name):
        return f"{show(name)} is a loop of links"
    try:
        path.stat()
    except OSError as error:
        if error.errno != errno.ENOENT:
            return f"{show(name)}: {error.strerror}"
    except ValueError:
        return f"there is no program {show(name)}: no file can be named so"
    if path.is_dir():
        return f"{show(name)} is a directory, not a program"
    if path.is_file():
        if os.sep in name:
            return (
                f"the file {show(name)} is not executable; chmod +x, or name its interpreter first"
            )
        return f"there is no program {show(name)}; for the file here write './{name}'"
    return f"there is no program {show(name)}"
