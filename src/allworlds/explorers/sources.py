"""Explorers in requests, and the files of explorers.

In Python an explorer is given by a name or a function, on the command line by an argument or by
options.  This module finds the file that a mistyped name may mean, the digest of an explorer's
files, and the line where an explorer begins.  It runs no explorer.
"""

import ast
import hashlib
import os
import re
import shlex
import shutil
from collections.abc import Callable, Iterator, Sequence
from difflib import get_close_matches
from inspect import CO_GENERATOR
from itertools import pairwise
from pathlib import Path
from types import CodeType
from typing import Annotated, Any

from msgspec import Struct
from msgspec.structs import replace

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.loading import (
    EXEC,
    NATIVE,
    Subject,
    command_or_path,
    entry_point,
    innermost,
    is_library,
    is_program,
    wrapped,
)
from allworlds.explorers.program import Program
from allworlds.inputs.checks import (
    InputError,
    did_you_mean,
    is_loop_of_links,
    no_file,
    read_text,
    show,
)
from allworlds.inputs.requests import RARE_SCOPE, SCOPE, Argument, Option, OptionGroup, Request
from allworlds.protocol import importing, user_code

MOST_OF_A_COMMAND = 20
"""The number of characters to which a command is shortened in the head of a table's column, if no
other column then has the same head."""


# ---------------------------------------------------------------- names


def names_explorer(text: str) -> bool:
    """Whether a text has the form of an explorer's name; the explorer need not exist."""
    plain = text.partition("?")[0]
    if wrapped(text)[0] or plain in BUILT_IN or entry_point(plain) or plain.endswith(".py"):
        return True
    return bool(re.fullmatch(r"(.+\.py|[^\W\d]\w*(\.[^\W\d]\w*)*):[^\W\d][\w.]*", plain))


def whole_name(name: str) -> str:
    """The name of an explorer, completed if it is a mere file: ``FILE.py`` to ``FILE.py:FUNCTION``.

    FUNCTION is the only public generator function in the file, or else its only private one.  If
    the file defines no generator function, FUNCTION is ``explore``, because the file may import a
    function of this name.

    Raises:
        InputError: if the file has several such functions, is missing, or is no Python.
    """
    wrapper, inside = wrapped(name)
    if wrapper:
        return wrapper + whole_name(inside)
    if not name.endswith(".py") or ":" in name:
        return name
    if not Path(name).exists():
        raise InputError(no_file(name, _like_file(name)))
    text = read_text(name)
    try:
        code = compile(text, name, "exec", dont_inherit=True)
    except (SyntaxError, ValueError, RecursionError) as error:
        raise InputError(f"{show(name)} is no Python: {importing.said(error)}") from None
    found = explorers_in(code)
    explorers = [each for each in found if not each.startswith("_")] or found or ["explore"]
    if len(explorers) == 1:
        return f"{name}:{explorers[0]}"
    legal = ", ".join(f"{name}:{explorer}" for explorer in explorers)
    raise InputError(f"{show(name)} has several explorers; legal are {legal}")


def explorers_in(module: CodeType) -> list[str]:
    """The names of a module's generator functions, in the order in which they stand there."""
    functions = [code for code in module.co_consts if isinstance(code, CodeType)]
    # The names of lambdas and generator expressions are no identifiers.
    return [
        code.co_name
        for code in functions
        if code.co_flags & CO_GENERATOR and code.co_name.isidentifier()
    ]


def no_explorer(name: str, plain: str, known: Sequence[str]) -> str:
    """The message that ``name`` names no explorer, with the reason, and the legal forms of names.

    Args:
        name: the name, which has no ``:FUNCTION``; it may end with arguments, ``?key=value``.
        plain: the name without these arguments.
        known: all names without a colon that do name an explorer.
    """
    if os.path.isdir(plain):  # noqa: PTH112  # takes any text, as below
        return f"{show(plain)} is a directory; an explorer in it is {Path(plain)}/FILE.py:FUNCTION"
    if os.path.isfile(plain):  # noqa: PTH113
        if plain.endswith(".py"):
            arguments = name.removeprefix(plain)
            return f"{show(name)} names no function; legal is {plain}:FUNCTION{arguments}"
        return (
            f"{show(plain)} is a file, but no file.py with a function; a program runs with --exec, "
            f"a shared library with --native{_like_file(plain)}"
        )
    if os.sep in plain or is_loop_of_links(plain):
        return no_file(plain, _like_file(plain))
    return (
        f"explorer {show(name)} is not one of {', '.join(known)}, module:attribute or "
        f"path/to/file.py:attribute{_like_file(plain) or did_you_mean(name, known)}"
    )


def _like_file(name: str) -> str:
    """A hint at a Python file with a name like the file ``name``, in its folder; empty if none."""
    given = Path(name)
    try:
        files = sorted(file.name for file in given.parent.glob("*.py"))
    except (OSError, ValueError):
        return ""
    close = get_close_matches(given.name, files, n=1)
    return f"; did you mean {show(name.removesuffix(given.name) + close[0])}?" if close else ""


def short_names(names: Sequence[str]) -> list[str]:
    """For each explorer's name its shortest end that no other name has, for heads of columns."""
    ends = [[*_ends(name)] for name in names]
    short = []
    for i, name in enumerate(names):
        others = {end for other in ends[:i] + ends[i + 1 :] for end in other}
        short.append(next((end for end in ends[i] if end not in others), name))
    return short


def _ends(name: str) -> Iterator[str]:
    """Yield ends of an explorer's name, shorter ones first, and then the name itself.

    The shortest end is the part behind the last colon; each longer end begins behind a ``/``.  So
    ``a/b/c.py:f`` has the ends ``f``, ``c.py:f`` and ``b/c.py:f``.  For a command
    (``exec:COMMAND``) the first :data:`MOST_OF_A_COMMAND` characters of the name are yielded
    instead.
    """
    if is_program(name):
        yield name[:MOST_OF_A_COMMAND]
    elif ":" in name:
        where, _, attribute = name.rpartition(":")
        yield attribute
        folders = where.split("/")
        yield from (f"{'/'.join(folders[-i:])}:{attribute}" for i in range(1, len(folders)))
    yield name


# ---------------------------------------------------------------- files


COMPILED = (".c", ".cc", ".cpp", ".cxx", ".d", ".f90", ".go", ".hs", ".ml", ".nim", ".rs", ".zig")
"""The suffixes of source files in languages that are compiled."""


class SourceLine(Struct, frozen=True):
    """A line of a file.

    Attributes:
        file: the absolute path.
        line: the number of the line, from 1.
    """

    file: Path
    line: int = 1

    def is_in(self, folder: Path) -> bool:
        """Whether the file is in ``folder``, and not in a folder of installed packages.

        ``folder`` is that of the user's project, which may contain a virtual environment.
        """
        return self.file.is_relative_to(folder) and "site-packages" not in self.file.parts

    def named_from(self, folder: Path) -> str:
        """The path of this line's file, relative to the folder ``folder``; the separator is ``/``.

        The file must be inside the folder.
        """
        return self.file.relative_to(folder).as_posix()


def files_of_explorer(name: str) -> list[Path]:
    """The existing files of a user's explorer; empty for a built-in explorer, or if unknown.

    The files of a Python explorer or a shared library are one file; those of an explorer that runs
    by a command (``exec:COMMAND``) are the files that the command names.
    """
    try:
        return [file for file in _files_named(innermost(name)) if file.is_file()]
    except (InputError, ValueError):
        return []


def place_of_explorer(name: str) -> SourceLine | None:
    """The line where a user's explorer begins; None for a built-in explorer, or if unknown.

    A Python explorer begins at the line of its function.  Any other explorer begins at the first
    line of a file: of the shared library; of the last file that the command names; or of the
    program, if the command names no file.  For a compiled file the line is that of its source in
    the same folder, such as explorer.c for explorer.so; None if there is no such source.
    """
    files, name = files_of_explorer(name), innermost(name)
    try:
        if is_program(name) and not files:
            files = [Path(shutil.which(shlex.split(command_or_path(name))[0]) or "")]
        if not files:
            return None
        file = files[-1]
        if is_program(name) or is_library(name):
            source = _source(file.resolve())
            return SourceLine(source) if source else None
        return SourceLine(file, _line(ast.parse(file.read_bytes()), _where(name)[1]))
    except (OSError, ValueError, SyntaxError, IndexError):
        return None


def _source(file: Path) -> Path | None:
    """The file itself if it is a text; if it is compiled, its source in the same folder.

    The source has the same name, perhaps without ``lib`` in front, and a suffix of
    :data:`COMPILED`.  The result is None if there is no such file.
    """
    with file.open("rb") as opened:
        if b"\0" not in opened.read(4096):
            return file
    stems = {file.stem, file.stem.removeprefix("lib")}
    beside = (each for each in sorted(file.parent.iterdir()) if each.stem in stems)
    return next((each for each in beside if each.suffix in COMPILED), None)


def _files_named(name: str) -> list[Path]:
    """The paths of the files that an explorer's name can mean; there may be no file at a path.

    ``name`` has no wrappers.  In a command each word can mean the file with this path; a module
    ``a.b`` after ``-m`` can mean ``a/b.py`` or ``a/b/__main__.py``.

    Raises:
        InputError: if the name contains a module, and there is no such module.
        ValueError: if a command cannot be split into words.
    """
    if name in BUILT_IN:
        return []
    if is_program(name):
        words = shlex.split(command_or_path(name))
        modules = [module.replace(".", "/") for option, module in pairwise(words) if option == "-m"]
        ends = (".py", "/__main__.py")  # of python -m
        return [Path(word) for word in (*words, *(each + end for each in modules for end in ends))]
    if is_library(name):
        return [Path(command_or_path(name))]
    where, _ = _where(name)
    file = Path(where) if where.endswith(".py") else user_code.module_file(where)
    return [Path(os.path.realpath(file))]


def _where(name: str) -> tuple[str, list[str]]:
    """The two parts of a Python explorer's name: the file or module, and the dotted name in it."""
    plain = name.partition("?")[0]
    point = entry_point(plain)
    where, colon, attribute = (point.value if point else plain).rpartition(":")
    # The name of a file with one explorer needs no function.
    return (where, attribute.split(".")) if colon else (attribute, [])


def _line(tree: ast.Module, names: list[str]) -> int:
    """The number of the line where a function or class begins; 1 if there is none of its name.

    ``tree`` is the syntax tree of the file, and ``names`` are the parts of the dotted name.
    """
    body: list[ast.stmt] = tree.body
    line = 1
    for name in names:
        found = next((node for node in body if getattr(node, "name", "") == name), None)
        if found is None:
            break
        line, body = found.lineno, getattr(found, "body", [])
    return line


# ---------------------------------------------------------------- the same text elsewhere


OURS = "built-in"
"""The text in place of a digest for built-in explorers, which change only with the version of this
program."""


def content_digest(subject: Subject) -> str:
    """The digest of an explorer's files; it shows whether two processes have the same explorer.

    The result is SHA-256, in hexadecimal.  If the subject has the text of its file (``source``), it
    is the digest of this text.  Otherwise the digests of the explorer's files, one after the other,
    form a text, and the result is the digest of this text.  If the explorer runs by a command, its
    files are the command's program and the files that the command names.  For a module only its own
    file counts, not the modules that it imports.

    For a built-in explorer the result is :data:`OURS`.  An explorer in a wrapper has the digest of
    the explorer inside: the wrapper is a part of allworlds, as a built-in explorer is.

    Raises:
        InputError: if the explorer exists only in this process, or its file cannot be found.
    """
    name = innermost(subject.name)
    if name in BUILT_IN:
        return OURS
    if subject.source:
        return subject.source.digest
    if not subject.importable:
        raise InputError(
            f"explorer {show(subject.name)} lives in this process alone, so that no other can go "
            "on with it; put it into a file of its own"
        )
    files = _files_named(name)
    if is_program(name):
        program = shutil.which(shlex.split(command_or_path(name))[0])
        arguments = [file for file in files[1:] if file.is_file()]
        files = [Path(program), *arguments] if program else arguments
    return hashlib.sha256("".join(map(user_code.digest_of_file, files)).encode()).hexdigest()


def with_content(subject: Subject) -> Subject:
    """The subject with the text of its file (``source``), for other machines.

    The subject is returned unchanged if it has the text already, or if the text would not be
    enough: if the explorer is not one Python file, or if its module belongs to a package.  Then the
    other machine must have all that the explorer needs.
    """
    name = innermost(subject.name)
    where = name.partition("?")[0].rpartition(":")[0]
    if subject.source or not where or "." in where or is_program(name) or is_library(name):
        return subject
    file = user_code.module_file(where)
    if file.suffix != ".py" or file.name == "__init__.py":
        return subject
    return replace(subject, source=importing.SourceText(str(file), read_text(str(file))))


def not_alike(subject: Subject, digest: str, answer_timeout: float) -> str:
    """The reason why this process cannot find the explorer with this digest; empty if it can.

    Args:
        subject: the explorer.
        digest: the digest that :func:`content_digest` has returned in another process.
        answer_timeout: the seconds of silence after which a program outside Python is killed.
    """
    try:
        if is_program(subject.name):
            Program(command_or_path(subject.name), answer_timeout)
        same = content_digest(subject) == digest
    except InputError as error:
        return str(error)
    return "" if same else f"the explorer {show(subject.name)} has another text here"


DEFAULT_EXPLORER = "algorithm1"


class ProgramWords(Request):
    """The options of the command line that name an explorer outside Python."""

    command: Annotated[
        str | None,
        Option(SCOPE, "COMMAND", "The explorer: a program that speaks JSON lines.", "exec"),
    ] = None
    native: Annotated[
        str | None,
        Option(
            RARE_SCOPE,
            "PATH",
            "The explorer: a shared library with the functions of allworlds.h.",
        ),
    ] = None

    def named(self, explorer: str | None) -> str | None:
        """The name of the explorer that the command line gives; None if it gives none.

        ``explorer`` is the argument of the command line; None if there is no argument.

        Raises:
            InputError: if several explorers are given.
        """
        given = {
            f"EXPLORER {show(explorer)}": explorer,
            f"--exec {show(self.command)}": None if self.command is None else EXEC + self.command,
            f"--native {show(self.native)}": None if self.native is None else NATIVE + self.native,
        }
        named = {option: name for option, name in given.items() if name is not None}
        if len(named) > 1:
            raise InputError(f"give {' or '.join(named)}, not both")
        return next(iter(named.values()), None)

    def named_or_default(self, explorer: str | None) -> str:
        """The name that :meth:`named` returns; :data:`DEFAULT_EXPLORER` if this is None."""
        name = self.named(explorer)
        return DEFAULT_EXPLORER if name is None else name


class ExplorerWords(ProgramWords):
    """The argument and options of the command line that name an explorer."""

    explorer: Annotated[
        str | None,
        Argument(
            "",
            "[EXPLORER]",
            "A built-in name, module:attribute, path/to/file.py:attribute or an entry point "
            "(default: algorithm1); shield:EXPLORER makes any of them right under the directional "
            "lighthouse; elsewhere:EXPLORER first looks for v0, within 100,000 traversals (with "
            "--lighthouse directional:start=any). If the file has one generator function, "
            "path/to/file.py is enough.",
        ),
    ] = None

    def value(self) -> str:
        """The explorer's name; :data:`DEFAULT_EXPLORER` if none is given."""
        return self.named_or_default(self.explorer)


class ExplorersWords(Request):
    """The arguments and options of the command line that name several explorers."""

    explorers: Annotated[
        list[str] | None,
        Argument(
            "",
            "[EXPLORER...]",
            "Built-in names, module:attribute, path/to/file.py:attribute or entry points, each "
            "also as shield:EXPLORER, and with a lighthouse of its own as EXPLORER@KIND; those of "
            "--exec and --native come after them.",
            repeated=True,
        ),
    ] = None
    command: Annotated[
        list[str] | None,
        Option(
            RARE_SCOPE,
            "COMMAND",
            "An explorer too: a program that speaks JSON lines; repeatable.",
            "exec",
            repeated=True,
        ),
    ] = None
    native: Annotated[
        list[str] | None,
        Option(
            RARE_SCOPE,
            "PATH",
            "An explorer too: a shared library with the functions of allworlds.h; repeatable.",
            repeated=True,
        ),
    ] = None

    def value(self) -> tuple[str, ...]:
        """The names of all given explorers."""
        return (
            *(self.explorers or ()),
            *(EXEC + command for command in self.command or ()),
            *(NATIVE + path for path in self.native or ()),
        )


class ExplorerOptions(Request, kw_only=False):
    """The part of a request that names the explorer."""

    explore: Annotated[
        str | Callable[..., Any],
        OptionGroup(
            ExplorerWords,
            "a name, as on the command line, or a generator function (see "
            ":func:`allworlds.explorers.loading.load`)",
        ),
    ] = DEFAULT_EXPLORER
