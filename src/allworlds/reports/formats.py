"""Results of verbs as texts and as files, and which name of a file means which.

A new format is a function and a line of the table.  What takes long to load is imported where it is
used, since the command line needs this module.
"""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Callable, Mapping
from typing import Any

from msgspec import Struct

from allworlds.inputs.checks import InputError, ensure_installed, show
from allworlds.notations.table import by_name, by_suffix, legal, to_write
from allworlds.reports.ci_formats import junit, markdown, runner_commands, sarif
from allworlds.reports.parts import ReportContent, rows_of
from allworlds.reports.plain_text import content_line, content_text
from allworlds.verbs import BY_NAME, CASES, FINDINGS, PAGE, ROWS, WORLD_FILE
from allworlds.words import escaped, harmless, harmless_json


def content_of(result: Any) -> ReportContent:
    """The content of the report of a verb's result."""
    return _maker(type(result))(result)


def _maker(kind: type) -> Callable[[Any], ReportContent]:
    """The function that makes it; of a report without words of its own keys and rows are shown."""
    match kind.__name__:  # which no other class of this package has
        case "CheckReport" | "TimeEstimate":
            from allworlds.reports.content.check import check_content

            return check_content
        case "SingleRun" | "WorldNames":
            from allworlds.reports.content.single_run import run_content

            return run_content
        case "Replay":
            from allworlds.reports.content.single_run import replay_content

            return replay_content
        case "Explanation":
            from allworlds.reports.content.single_run import explain_content

            return explain_content
        case "Skeleton" | "LedgerSkeleton" | "Header":
            from allworlds.reports.content.plain import init_content

            return init_content
        case "Play":
            from allworlds.reports.web.play import play_content

            return play_content
        case "Standing":
            from allworlds.reports.content.plain import status_content

            return status_content
        case "Comparison" | "Growth":
            from allworlds.reports.content.compare import compare_content

            return compare_content
        case "WorstReport":
            from allworlds.reports.content.sizes import worst_content

            return worst_content
        case "Census":
            from allworlds.reports.content.sizes import count_content

            return count_content
        case "ComparedWorlds":
            from allworlds.reports.content.ambiguity import twins_content

            return twins_content
        case "AmbiguityClass":
            from allworlds.reports.content.ambiguity import class_content

            return class_content
        case "AmbiguityCensus":
            from allworlds.reports.content.ambiguity import census_content

            return census_content
        case "SearchResult":
            from allworlds.reports.content.ambiguity import search_content

            return search_content
        case "LedgerReport":
            from allworlds.reports.content.ledger import ledger_content

            return ledger_content
    from allworlds.reports.content.plain import plain_content

    return plain_content


def text(result: Any, width: int) -> str:
    """The whole text of a verb's result, with so many columns."""
    return harmless(content_text(content_of(result), width))


def brief(result: Any, width: int) -> str:
    """The line that ``--quiet`` leaves."""
    return harmless(content_line(content_of(result), width))


class Format(Struct, frozen=True):
    """A file format of reports.

    Attributes:
        of_content: the content of the file, made of that of a report.
        suffix: the end of a file's name that means it; empty where only its own name does.
        shows: what a verb must have one of to be written so; empty where every verb is.
        library: without which the content cannot be made, as it is imported; the extra of this
            package that brings it; and what needs it, for a refusal.
        summary: the variable in which a CI service names a file to which the report is added
            without being asked for; empty where there is none.
        read_by: the variable that says that a CI service reads stderr for it, likewise.
    """

    of_content: Callable[[ReportContent], str | bytes]
    suffix: str
    shows: tuple[str, ...] = (ROWS,)
    library: tuple[str, str, str] | None = None
    summary: str = ""
    read_by: str = ""


def csv_rows(content: ReportContent) -> str:
    """The rows for programs; empty if there is none."""
    out, found = io.StringIO(), rows_of(content)
    if found.columns:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(found.columns)
        writer.writerows(found.rows)
    return out.getvalue()


def parquet_rows(content: ReportContent) -> bytes:
    """A file of Parquet with these rows, a column for each name and of its type."""
    from pyarrow import BufferOutputStream, Table, bool_, float64, int64, schema, string
    from pyarrow.parquet import write_table

    kinds = {int: int64(), float: float64(), str: string(), bool: bool_()}
    found, out = rows_of(content), BufferOutputStream()
    columns = schema([(name, kinds[kind]) for name, kind in found.columns.items()])
    write_table(Table.from_pylist(found.records, schema=columns), out)
    written: bytes = out.getvalue().to_pybytes()
    return written


def document_text(document: Mapping[str, Any]) -> str:
    """The document as a text."""
    return harmless_json(json.dumps(document, indent=2)) + "\n"


def html(content: ReportContent) -> str:
    """An HTML document that refers to no other file."""
    if content.page:
        return content.page()
    from allworlds.reports.web.frame import framed
    from allworlds.reports.web.sections import element

    said = content.headline
    document = content.result.to_json()
    return framed(
        (content.done, content.subject),
        (said.word, said.text, said.verdict or "open") if said else None,
        [element(section) for section in (*content.sections, *content.more())],
        {key: value for key, value in document.items() if key not in content.apart},
    )


FORMATS = {
    "html": Format(html, ".html", (ROWS, PAGE)),
    "markdown": Format(markdown, ".md", summary="GITHUB_STEP_SUMMARY"),
    "csv": Format(csv_rows, ".csv"),
    "json": Format(lambda content: document_text(content.result.to_json()), ".json", ()),
    "parquet": Format(parquet_rows, ".parquet", library=("pyarrow", "notebook", "a file .parquet")),
    "sarif": Format(sarif, ".sarif", (FINDINGS,)),
    "junit": Format(junit, ".xml", (CASES,)),
    "annotations": Format(runner_commands, "", (FINDINGS,), read_by="GITHUB_ACTIONS"),
}
"""Every format by its name."""


def formats_of(verb: str) -> dict[str, Format]:
    """The formats in which a verb's results can be written."""
    has = {*BY_NAME[verb].has}
    return {name: form for name, form in FORMATS.items() if not form.shows or has & {*form.shows}}


def legal_files(verb: str) -> str:
    """The names of files that a verb can write, in words."""
    forms = formats_of(verb)
    names = " ".join(form.suffix for form in forms.values() if form.suffix)
    told = f"{names}, or FORMAT:FILE ({', '.join(forms)})"
    if WORLD_FILE in BY_NAME[verb].has:
        return f"{legal(written=True)} are worlds; of the report {told}"
    return told


def names_world_file(verb: str, name: str) -> bool:
    """Whether a FILE is one of worlds, not of a report; a FORMAT before it says that of a report.

    A suffix that both have means worlds.
    """
    form = name.partition(":")[0]
    worlds = by_name(form) or (form not in FORMATS and by_suffix(name))
    return WORLD_FILE in BY_NAME[verb].has and bool(worlds)


def form_and_path(verb: str, name: str) -> tuple[str, str]:
    """The format and the path that a FILE means.

    Raises:
        InputError: if this verb writes no such file, or a library is not installed.
    """
    if names_world_file(verb, name):
        return to_write(name)[0].name, to_write(name)[1]
    forms = formats_of(verb)
    form, colon, path = name.partition(":")
    if not colon or not form.isalpha():
        named = (each for each, made in forms.items() if name.endswith(made.suffix or "\0"))
        form, path = next(named, ""), name
    if form not in forms:
        raise InputError(f"-o {show(name)} is no file that {verb} writes: {legal_files(verb)}")
    if library := forms[form].library:
        ensure_installed(*library)
    return form, path


def file_of(form: str, result: Any) -> Any:
    """The content of a file of that format: a text, or bytes if it is none."""
    format_ = FORMATS[form]
    made = format_.of_content(content_of(result))
    if isinstance(made, bytes):
        return made
    # UTF-8 has no halves of pairs: names of files and words of explorers may hold some.
    whole = re.sub("[\ud800-\udfff]", "\N{REPLACEMENT CHARACTER}", made).replace("\r", r"\x0d")
    # Lines that look like commands of a CI service are made harmless, but in a file of them.
    return escaped(whole) if format_.read_by else harmless(whole)
