"""Output: results go to stdout and into files, all other texts go to stderr."""

import errno
import io
import os
import re
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, make_dataclass
from functools import cache, cached_property
from pathlib import Path
from tempfile import TemporaryFile
from typing import Annotated, Any, ClassVar, Self, TypeVar

from allworlds import outcome, verbs, words
from allworlds.cli import drop_closed_terminals
from allworlds.cli.defaults import defaults_used, made_by, words_of_command
from allworlds.documents import document as doc
from allworlds.documents.report import Report
from allworlds.engines import prints
from allworlds.engines.listeners import Listener
from allworlds.inputs.checks import InputError, a_path, show
from allworlds.inputs.requests import OUTPUT, Option, answer
from allworlds.reports import formats, plain_text
from allworlds.studies.options import ListenerOptions

Answer = TypeVar("Answer", bound=outcome.Result)

NARROWEST = 40

LONGEST, KEPT_END, CUT = 300, 120, " [...] "
"""Three values for lines on stderr: the largest number of characters of a line; for a longer line
the number of characters that are kept at its end, and the text in place of the characters that are
left out."""


@dataclass(frozen=True)
class OutputGroup:
    """The options for a verb's output: files, and the form of the answer.

    Each verb has its own subclass, made by :func:`output_of`.

    Raises:
        InputError: naming a file that cannot be written, and the reason.
    """

    verb: ClassVar[str]
    files: Annotated[list[str] | None, "one option, with a help for each verb"] = None
    as_json: Annotated[bool, Option(OUTPUT, "", "One JSON document on stdout.", "json")] = False
    quiet: Annotated[
        bool, Option(OUTPUT, "", "Show no progress; answer in one line.", "quiet", "q")
    ] = False
    verbose: Annotated[bool, "an option where a text is shortened"] = True

    def __post_init__(self) -> None:
        for _, path in self.named:
            ensure_writable(path)
        paths = [os.path.realpath(path) for _, path in self.named]
        for name, (_, path) in zip(self.files or (), self.named, strict=True):
            if paths.count(os.path.realpath(path)) > 1:
                raise InputError(f"-o {show(name)} is a file that two reports are to be written to")
            if Path(path).exists() and _times_named(path) > 1:
                raise InputError(f"-o {show(name)} is a file that is read; name another one")

    @cached_property
    def named(self) -> list[tuple[str, str]]:
        """A list with the format and the path of each file that the user has named by ``-o``."""
        return [formats.form_and_path(self.verb, name) for name in self.files or ()]


@cache
def output_of(verb: str) -> type[OutputGroup]:
    """The subclass of :class:`OutputGroup` for a verb.

    The help of its option ``-o`` names the kinds of files that the verb can write.
    """
    help_ = f"Also write this file; its ending says what: {formats.legal_files(verb)}. Repeatable."
    asked = Annotated[list[str] | None, Option(OUTPUT, "FILE", help_, short="o", repeated=True)]
    options: list[tuple[str, Any, Any]] = [("files", asked, field(default=None))]
    if {verbs.FINDINGS, verbs.PICTURE} & {*verbs.BY_NAME[verb].has}:
        whole = Option(OUTPUT, "", "Tell all: tables, walks, every count.", "verbose", "v")
        options.append(("verbose", Annotated[bool, whole], field(default=False)))
    return make_dataclass(
        "Output", options, bases=(OutputGroup,), frozen=True, namespace={"verb": verb}
    )


def _times_named(path: str) -> int:
    """The number of words of the command that name the file with this path.

    If an existing file is named as output and by a second word, it is an input, too, which the
    output would destroy.
    """
    real = os.path.realpath(path)
    return sum(real in _files_in(word) for word in words_of_command())


def _files_in(word: str) -> set[str]:
    """The real paths of the files that a word of the command may name.

    In a word such as ``--option=VALUE`` only VALUE may name a file.  The name of the file may be
    the whole text, the text after ``@``, the text before a colon, or the text after a colon.
    """
    value = word.partition("=")[2] if word.startswith("--") else word.removeprefix("-o")
    found = set()
    for name in (value, value.removeprefix("@"), *value.partition(":")[::2]):
        with suppress(ValueError):  # there is no file of such a name
            found.add(os.path.realpath(name))
    return found


def _write_files(result: Report, output: OutputGroup, document: Callable[[], str]) -> None:
    """Write the result into each file that the user has named.

    If environment variables show that a CI service runs this command, a result with findings is
    also written to stderr, or to a file of the service, in the form that the service reads.  If a
    file cannot be written, a line on stderr says so; the verdict is not lost.

    Args:
        result: the result.
        output: the options for the output, which name the files.
        document: the function that returns the text of the result's JSON document.
    """
    for form, path in output.named:
        made = document() if form == "json" else formats.file_of(form, result)
        write_file(path, made if isinstance(made, bytes) else made.encode())
    if not hasattr(result, "findings"):
        return
    for form, format_ in formats.formats_of(output.verb).items():
        if os.environ.get(format_.read_by) == "true":
            print(formats.file_of(form, result), end="", file=sys.stderr)
        if summary := os.environ.get(format_.summary):
            try:
                with Path(summary).open("a", encoding="utf-8") as file:
                    file.write(formats.file_of(form, result))
            except OSError as error:
                complain(f"the file of {format_.summary} cannot be written: {error.strerror}")


def write_file(path: str, content: bytes) -> None:
    """Write a file that :func:`ensure_writable` has found to be writable before the work began.

    If the file cannot be written any more, for example on a full disk, a line on stderr says so;
    the report and its verdict are not lost.
    """
    try:
        Path(path).write_bytes(content)
    except OSError as error:
        complain(f"{_refusal(path, error)}; the report is on stdout only")
        with suppress(OSError):  # half a report is none
            if Path(path).is_file():
                Path(path).unlink()


def ensure_writable(path: str) -> None:
    """Raise InputError if a file cannot be written.

    The test keeps the content of an existing file, and leaves no new file.

    Raises:
        InputError: naming the file and the reason.
    """
    try:
        file = a_path("file", path)
        existed = file.exists()
        file.open("a", encoding="utf-8").close()
        if not existed:
            file.unlink()
    except (OSError, ValueError) as error:
        raise _refusal(path, error) from None


def _refusal(path: str, error: Exception) -> InputError:
    reason = error.strerror if isinstance(error, OSError) else error
    return InputError(f"file {show(path)} cannot be written: {reason}")


def width() -> int:
    """The number of columns of the terminal, but at least 40; without a terminal 100."""
    return max(NARROWEST, shutil.get_terminal_size((100, 24)).columns)


def printable(text: str) -> str:
    """The text with control characters written as numbers; only line ends and tabs stay.

    A text may contain words of an explorer.  Such words must not give commands to a terminal, or to
    the runner of a CI service.
    """
    return words.harmless(text.replace("\r", r"\x0d"))


COLOURS = (
    dict.fromkeys(("HOLDS", "FIXED"), 32)
    | dict.fromkeys(("REFUTED", "REPRODUCED", "ERROR"), 31)
    | dict.fromkeys(("NOT REPRODUCED", "NOT-REFUTED", "INCONCLUSIVE", "VACUOUS", "EMPTY"), 33)
)
"""The first words of lines that tell a verdict, each with the ANSI number of its colour."""


def coloured(text: str) -> str:
    """The text with its verdicts in colour, if stdout is a terminal and the user allows colours.

    The environment variable ``NO_COLOR`` forbids colours.
    """
    if not sys.stdout.isatty() or os.environ.get("NO_COLOR"):
        return text
    return re.sub(
        rf"^({'|'.join(COLOURS)})(?=[ :])",
        lambda word: f"\x1b[1;{COLOURS[word[0]]}m{word[0]}\x1b[0m",
        text,
        flags=re.MULTILINE,
    )


def emit(result: Report, output: OutputGroup, workers: int | None = None) -> int:
    """Write a verb's result in the forms that the user asked for, and return its exit code.

    Args:
        result: the result.
        output: the options for the output.
        workers: the number of workers, which a JSON document has under the key ``made_by``; None
            for a verb without workers.

    Raises:
        OSError: saying that stdout cannot be written.
    """

    def document() -> str:
        return formats.document_text(
            result.to_json() | {"made_by": made_by(result, workers).to_json()}
        )

    _write_files(result, output, document)
    try:
        if output.as_json:
            print(document(), end="")
        else:
            content, columns = formats.content_of(result), width()
            said = (
                plain_text.content_line(content, columns)
                if output.quiet
                else plain_text.on_terminal(content, columns, whole=output.verbose)
            )
            for file, options in {} if output.quiet else defaults_used().items():
                text = ", ".join(f"{key} = {value}" for key, value in options.items())
                print(printable(f"defaults from {file}: {text}"))
            print(coloured(printable(said)))
        sys.stdout.flush()
    except BrokenPipeError:
        # The reader has gone (a pipe to head); the exit code is still to be told.
        abandon_stdout()
    except OSError as error:
        raise OSError(error.errno, f"stdout cannot be written: {error.strerror}") from None
    if result.exit_code == outcome.Exit.INTERRUPTED:
        complain("interrupted; the report tells what was finished")
    return result.exit_code


def say(text: Callable[[], str]) -> None:
    """Print a text on which no verdict depends, such as a help.

    If the reader of stdout has gone (as in ``allworlds --help | head -1``), or if stdout is closed,
    the rest of the text is dropped without an error.

    Args:
        text: the function that returns the text.
    """
    try:
        print(text(), flush=True)
    except OSError as error:
        if error.errno not in (errno.EPIPE, errno.EBADF):
            raise
        abandon_stdout()


def answered(function: Callable[..., Answer], request: Any, output: OutputGroup) -> Answer:
    """Call a function of the package with a request, and return the result of the function.

    If the request has an option for a listener, a progress bar is shown on stderr, and prints of
    the user's code go to stderr.

    Args:
        function: a function such as :func:`allworlds.check`.
        request: the values of the function's arguments, as one object.
        output: the options for the output.

    Raises:
        InputError: if the user has given the option ``by``, but no CSV or Parquet file is to be
            written: the option only chooses what a row of such a file is about.
    """
    from allworlds.studies.swept import RowOptions

    by = request.by if isinstance(request, RowOptions) else None
    if by is not None and not {"csv", "parquet"} & {form for form, _ in output.named}:
        raise InputError(f"by {by} has no effect without -o FILE.csv")
    if not isinstance(request, ListenerOptions):
        return answer(function, request)
    with Progress(quiet=output.quiet) as listener, stdout_on_stderr():
        return answer(function, doc.replace(request, listener=listener))


def respond(function: Callable[..., Any], request: Any, output: OutputGroup) -> int:
    """Call a function of the package with a request, write its result, and return the exit code.

    The arguments are those of :func:`answered`.

    Raises:
        InputError: naming a corpus that cannot be written, or for the reason of :func:`answered`.
    """
    from allworlds.engines.limits import WorkerOptions
    from allworlds.studies.user_corpus import CorpusOptions

    if isinstance(request, CorpusOptions):
        ensure_directory(request.corpus)
    workers = request.workers if isinstance(request, WorkerOptions) else None
    return emit(answered(function, request, output), output, workers)


@contextmanager
def stdout_on_stderr() -> Iterator[None]:
    """A context in which all that the user's code prints to stdout goes to stderr.

    The output of programs that the user's code starts goes to stderr, too.
    """
    printed, stdout = sys.stdout, os.dup(1)
    os.dup2(2, 1)
    try:
        yield
    finally:
        printed.flush()
        os.dup2(stdout, 1)
        os.close(stdout)
        drop_closed_terminals()


def abandon_stdout() -> None:
    """Redirect stdout to the null device after an error.

    So the rest of the buffer of stdout, which is written at the end, causes no second error.
    """
    with suppress(io.UnsupportedOperation):  # it may be a stand-in without a file
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def complain(text: str) -> None:
    """Print one line of at most :data:`LONGEST` characters on stderr, whatever the text contains.

    A longer line is cut in its middle: its beginning says what is wrong, its end what is legal.
    """
    line = f"allworlds: {printable(' '.join(text.split()))}"
    # What stderr cannot show it shows by numbers, which are longer.
    encoding = getattr(sys.stderr, "encoding", None) or "utf-8"
    line = line.encode(encoding, "backslashreplace").decode(encoding)
    if len(line) > LONGEST:
        line = line[: LONGEST - KEPT_END - len(CUT)] + CUT + line[-KEPT_END:]
    print(line, file=sys.stderr)


def prepare_streams() -> None:
    """Make sure that this process and the processes that it starts have all three standard streams.

    The caller may have closed a stream before the start.  The next file that is opened would then
    get the number of this stream, and texts for the stream would go into that file.  So the null
    device is opened in place of a closed stream.  In place of stderr it is opened for writing, and
    texts are dropped.  In place of stdout it is opened for reading only, so that writing a report
    that nobody would get raises an error.
    """
    for number, stream in enumerate((sys.stdin, sys.stdout, sys.stderr)):
        if stream is None:
            # Nobody reads stderr then; but that nobody gets the report on stdout is an error.
            mode = os.O_WRONLY if number == 2 else os.O_RDONLY
            opened = os.open(os.devnull, mode)
            if opened != number:
                os.dup2(opened, number)
                os.close(opened)
            os.set_inheritable(number, True)  # noqa: FBT003  # it takes no keyword
    if sys.stdout is None:
        sys.stdout = open(1, "w", encoding="utf-8")  # noqa: SIM115  # it lives as long as we
    if isinstance(sys.stdout, io.TextIOWrapper):
        # A terminal that cannot show a character shows its number.
        sys.stdout.reconfigure(errors="backslashreplace")
    sys.stderr = prints.patient_stderr()


SILENCE = 10.0
"""The seconds without a finished item, such as a world, until the first line about the run in
progress."""


class Progress(Listener):
    """A listener that shows the progress of a job on stderr.

    On a terminal there is a bar for each stage of the job, with the exact total and the time left.
    A *stage* is a level of worlds, or another part of a job that is counted by items, such as the
    claims of a ledger.  If no item is finished for :data:`SILENCE` seconds, a line tells of the run
    in progress; each further line comes after twice the time.

    Args:
        quiet: whether nothing is shown: no bar, and no line.
        clock: the function that returns the present time in seconds.
    """

    def __init__(self, *, quiet: bool, clock: Callable[[], float] = time.monotonic) -> None:
        self._quiet, self._clock = quiet, clock
        self._name, self._done, self._total, self._of = "", 0, 0, ""
        self._silent_since, self._patience = clock(), SILENCE
        self._bar: Any = None
        if not quiet and sys.stderr.isatty():
            self._bar = _bar()

    def __enter__(self) -> Self:
        if self._bar:
            self._bar.start()
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar:
            self._bar.stop()

    def level(self, edges: int, worlds: int) -> None:
        """Begin the bar of a level, which is all worlds with ``edges`` edges.

        ``worlds`` is the number of these worlds.  In a shard, which does only a part of the level,
        ``worlds`` is an estimate of the number of worlds in this part.
        """
        self.stage(f"edges {edges}", worlds, "worlds")

    def stage(self, name: str, total: int, of: str) -> None:
        """Begin the bar of a stage of the job, on a line of its own.

        Args:
            name: the text before the bar.
            total: the number of items of the stage.
            of: the word for these items, such as ``worlds`` or ``claims``.
        """
        self._name, self._done, self._total, self._of = name, 0, total, of
        if self._bar:
            self._task = self._bar.add_task(name, total=total, of=of)

    def progress(self, count: int) -> None:
        """Move the bar forward by ``count`` items that are done; back if ``count`` is negative."""
        self._done += count
        if count > 0:
            self._silent_since = self._clock()
        if self._bar:
            self._bar.advance(self._task, count)

    def walk(self, turns: int, budget: int) -> None:
        """Print a line about the run in progress, if no item of the stage was finished for long.

        Args:
            turns: the number of the explorer's turns in this run so far.
            budget: the step budget of this run, in traversals.
        """
        now = self._clock()
        if now - self._silent_since < self._patience:
            return
        self._silent_since = now
        self._patience *= 2
        self.notice(
            f"{self._name}, {self._done:,} of {self._total:,} {self._of} done: the run in progress "
            f"is at turn {turns:,} of the explorer; its step budget is {budget:,} traversals"
        )

    def notice(self, text: str) -> None:
        """Print the message as a line on stderr, unless the user has asked for ``--quiet``."""
        if not self._quiet:
            complain(text)


def _bar() -> Any:
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress as RichProgress,
        TextColumn,
        TimeRemainingColumn,
    )

    return RichProgress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[of]}"),
        TimeRemainingColumn(),
        TextColumn("left"),
        console=Console(stderr=True),
    )


def ensure_directory(name: str | Path | None) -> None:
    """Make the directory of the user's corpus if it is missing.

    Args:
        name: the path of the directory; if it is None, there is no corpus, and nothing is done.

    Raises:
        InputError: if no file can be written in the directory.
    """
    if name is None:
        return
    path = a_path("corpus", name)
    try:
        path.mkdir(parents=True, exist_ok=True)
        with TemporaryFile(dir=path):
            pass
    except OSError as error:
        raise InputError(f"corpus {show(name)} cannot be written: {error.strerror}") from None
