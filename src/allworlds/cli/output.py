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
"""For a line on stderr: its most characters, those kept of its end, and the sign for the rest."""


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
        """For each file that the user named, its format and its path."""
        return [formats.form_and_path(self.verb, name) for name in self.files or ()]


@cache
def output_of(verb: str) -> type[OutputGroup]:
    """The class of the options for a verb's output; their help names the files it can write."""
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
    """The number of words of the command that name the file with this path."""
    real = os.path.realpath(path)
    return sum(real in _files_in(word) for word in words_of_command())


def _files_in(word: str) -> set[str]:
    """The real paths that a word of the command may name.

    In a word such as ``--option=VALUE`` only the value is searched.  The path may be the whole
    text, may follow ``@``, or may be on either side of a colon.
    """
    value = word.partition("=")[2] if word.startswith("--") else word.removeprefix("-o")
    found = set()
    for name in (value, value.removeprefix("@"), *value.partition(":")[::2]):
        with suppress(ValueError):  # there is no file of such a name
            found.add(os.path.realpath(name))
    return found


def _write_files(result: Report, output: OutputGroup, document: Callable[[], str]) -> None:
    """Write the result into each file that the user named, and where a CI service expects it.

    If a file cannot be written, a line on stderr says so; the verdict is not lost.
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
    """Write a file; before the work began, a test found that it can be written.

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

    Texts may contain words of an explorer.  These must not give commands to a terminal, or to the
    runner of a CI service.
    """
    return words.harmless(text.replace("\r", r"\x0d"))


COLOURS = (
    dict.fromkeys(("HOLDS", "FIXED"), 32)
    | dict.fromkeys(("REFUTED", "REPRODUCED", "ERROR"), 31)
    | dict.fromkeys(("NOT REPRODUCED", "NOT-REFUTED", "INCONCLUSIVE", "VACUOUS", "EMPTY"), 33)
)
"""The colour on a terminal for the first word of the line that tells a verdict."""


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

    In a document, all values that can differ from run to run are under the key ``made_by``; the
    number of workers is there, too.

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
    """Print a text on which no verdict depends; a reader may close the pipe before the end."""
    try:
        print(text(), flush=True)
    except OSError as error:
        if error.errno not in (errno.EPIPE, errno.EBADF):
            raise
        abandon_stdout()


def answered(function: Callable[..., Answer], request: Any, output: OutputGroup) -> Answer:
    """Answer a request by a function of the package; show progress if the request names a listener.

    Raises:
        InputError: naming the option ``by``, if it is given and no file of CSV or Parquet is
            written.
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
    """Answer a request by a function of the package, write the answer, and return the exit code.

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
    """Send to stderr all that the user's code prints to stdout.

    If the user's code starts programs, their output to stdout is sent to stderr, too.
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
    """Redirect stdout to the null device, so that the rest of its buffer causes no second error."""
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

    A stream may have been closed before the start.  Then the next file that is opened takes its
    number: texts for stderr would appear on stdout, and reports for stdout in files.
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
"""The seconds without a finished world until the first line about the run in progress."""


class Progress(Listener):
    """A progress bar on stderr, with the exact total and the time left; only on a terminal.

    If no world is finished for long, a line on stderr tells of the run in progress.  The time until
    the next such line is doubled each time.
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
        """Begin the bar of a level: of all worlds with ``edges`` edges."""
        self.stage(f"edges {edges}", worlds, "worlds")

    def stage(self, name: str, total: int, of: str) -> None:
        """Begin a stage, which has its own line and bar."""
        self._name, self._done, self._total, self._of = name, 0, total, of
        if self._bar:
            self._task = self._bar.add_task(name, total=total, of=of)

    def progress(self, count: int) -> None:
        """Move the bar forward by ``count``."""
        self._done += count
        if count > 0:
            self._silent_since = self._clock()
        if self._bar:
            self._bar.advance(self._task, count)

    def walk(self, turns: int, budget: int) -> None:
        """Print a line about the run in progress, if no world was finished for long."""
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
        """Print the message as a line on stderr."""
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
    """Make the directory if it is missing.

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
