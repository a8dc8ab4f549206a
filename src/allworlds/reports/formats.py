"""Results of verbs as texts and as files; the suffix of a file's name determines its format.

The files for CI services are Markdown, JUnit XML, commands of GitHub's runner, and SARIF.  A new
format is a function and a line of the table ``FORMATS``.  Slow imports are inside functions, since
the command line needs this module.
"""

import csv
import io
import json
import os
import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast
from urllib.parse import quote
from xml.etree import ElementTree as ET

from msgspec import Struct

from allworlds import verbs, words
from allworlds.explorers.sources import SourceLine, place_of_explorer
from allworlds.inputs.checks import InputError, did_you_mean, ensure_installed, show
from allworlds.judging.findings.finding import Finding
from allworlds.notations.table import by_suffix, legal, to_write
from allworlds.outcome import Verdict
from allworlds.reports import parts, plain_text
from allworlds.version import __version__

if TYPE_CHECKING:
    from allworlds.robots.team_finding import TeamFinding

WIDTH = 100


def markdown(content: parts.ReportContent) -> str:
    """A text in Markdown: the headline, then every section.

    A section with a picture, a walk or a run is shown as plain text.  Any other section is shown as
    follows: its tables stand in the text; its curves are left out; its paragraphs, lists and other
    texts are folded, and a click unfolds them.
    """
    head = [f"## {_plain(content.done)}: {_plain(content.subject)}"]
    if said := content.headline:
        named = content.done.partition(" ")[0]
        head = [f"## {named}: {said.word} {_plain(content.subject)}", _plain(said.text)]
    blocks = [block for section in content.sections for block in _section(section)]
    return "\n\n".join([*head, *blocks]) + "\n"


def _section(section: parts.Section) -> Iterator[str]:
    if any(
        isinstance(block, parts.ShownWalk | parts.ShownRun | parts.MapPictures)
        for block in section.blocks
    ):
        yield from [f"### {_plain(section.title)}"] if section.title else []
        yield fenced(plain_text.text_of([section], WIDTH))
        return
    for table in section.blocks:
        if isinstance(table, parts.Table) and table.rows:
            yield from [f"**{_plain(table.caption)}**"] if table.caption else []
            yield _table(table.header, table.texts, table.right)
    others = [b for b in section.blocks if not isinstance(b, parts.Table | parts.Curve)]
    if others:
        yield f"<details><summary>{_plain(section.title or 'More')}</summary>"
        for block in others:
            if isinstance(block, parts.FactList):
                yield _table(["", ""], block.entries, "ll")
            else:
                yield fenced(plain_text.text_of([parts.Section("", "", [block])], WIDTH))
        yield "</details>"


def _table(header: Sequence[str], rows: Sequence[Sequence[str]], right: str) -> str:
    rule = "| " + " | ".join("--:" if side == "r" else "---" for side in right) + " |"
    first, *lines = (f"| {' | '.join(_plain(cell) for cell in line)} |" for line in (header, *rows))
    return "\n".join([first, rule, *lines])


def fenced(text: str) -> str:
    """The text as a block of Markdown, in a fence that is longer than any fence in the text."""
    longest = max((len(run) for run in re.findall("`+", text)), default=0)
    fence = "`" * max(3, longest + 1)
    return f"{fence}text\n{text}\n{fence}"


def _plain(text: str) -> str:
    """The text in one line, with markup escaped."""
    one = words.escaped(re.sub(r"[\t\n\r]+", " ", text))
    one = one.replace("&", "&amp;").replace("<", "&lt;")
    return re.sub(r"([\\`*_|\[\]#~])", r"\\\1", one)


_FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def junit(content: parts.ReportContent) -> str:
    """A document with one suite, in the form of Jenkins's xUnit schema.

    The suite names the explorer's file, which the schema allows only there; the text of a failure
    begins with file and line.  The name of each case begins with the words of the command line,
    since services keep only one of two cases with the same name.
    """
    assert content.cases is not None
    cases, verb = content.cases(), content.done.removeprefix("allworlds ")
    results = Counter(case.result for case in cases)
    root, source = _project(getattr(content.result, "explorer", ""))
    name = source.named_from(root) if source else ""
    totals = {
        "tests": str(len(cases)),
        "failures": str(results["failure"]),
        "errors": str(results["error"]),
        "time": f"{sum(case.seconds for case in cases):.3f}",
    }
    made = ET.Element("testsuites", {"name": content.done, **totals})
    # The schema has these at a suite, and not at the root.
    more = {"skipped": str(results["skipped"]), **({"file": _legal(name)} if name else {})}
    suite = ET.SubElement(made, "testsuite", {"name": _legal(content.subject), **totals, **more})
    for case in cases:
        named = {
            "classname": f"allworlds.{verb}",
            "name": _legal(f"{content.command}: {case.name}"),
        }
        element = ET.SubElement(suite, "testcase", {**named, "time": f"{case.seconds:.3f}"})
        if case.result != "passed":
            kind = {} if case.result == "skipped" else {"type": case.kind}
            why = ET.SubElement(element, case.result, {"message": _legal(case.message), **kind})
            said = plain_text.text_of(case.sections, WIDTH)
            if source and case.result == "failure":
                said = f"{name}:{source.line}\n{said}"
            why.text = _legal(said) or None
    ET.indent(made)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ET.tostring(made, "unicode") + "\n"


def _legal(text: str) -> str:
    r"""The text in a form that XML allows.

    Each control character or invisible character becomes its number, such as ``\x1b``; any other
    character that is illegal in XML becomes U+FFFD.  Tabs and line ends stay.
    """
    return _FORBIDDEN.sub("\N{REPLACEMENT CHARACTER}", words.escaped(text))


LEVELS = {Verdict.ERROR: "error", Verdict.VACUOUS: "error", Verdict.INCONCLUSIVE: "warning"}
"""The level of the notification for a verdict without a finding; other verdicts have none."""


def runner_commands(content: parts.ReportContent) -> str:
    """Commands of GitHub's runner: one for each finding, at its line.

    Without a finding there is one command, for the verdict.
    """
    report: Any = content.result  # of a check
    head = content.headline
    assert head is not None
    root, source = _project(report.explorer)
    shown = [
        (*_texts(found, i), _at(found, source, root)) for i, found in enumerate(report.findings, 1)
    ]
    kind, commands = "error" if shown else LEVELS.get(report.verdict, "notice"), []
    verdict = f"allworlds: {head.word}", f"{report.explorer}: {head.text}", source
    for title, said, at in shown or [verdict]:
        where = {"file": at.named_from(root), "line": str(at.line)} if at else {}
        named = {**where, "title": title}.items()
        properties = ",".join(f"{name}={_escaped(value, ':,')}" for name, value in named)
        commands.append(f"::{kind} {properties}::{_escaped(said)}\n")
    return "".join(commands)


def _texts(finding: "Finding | TeamFinding", number: int) -> tuple[str, str]:
    """A finding as one line, and as a text with a picture.

    ``number`` is the number of the finding.  The title of the text with the picture shows this
    number.
    """
    if not isinstance(finding, Finding):
        from allworlds.reports.content import team

        section = team.finding_section(finding, number)
        return team.headline_of(finding), words.harmless(plain_text.text_of([section], WIDTH))
    from allworlds.reports.content.single_run import headline_of

    return headline_of(finding), plain_text.finding_in_words(finding, WIDTH, number)


def _at(
    finding: "Finding | TeamFinding", source: SourceLine | None, root: Path
) -> SourceLine | None:
    """The line of the user's code to which a finding belongs.

    If the finding is about one robot, the line is the one that caused the explorer's error; without
    an error it is the line that led to the first wrong step, or the line of the wrong checkpoint or
    answer.  If the finding is about a team, the line is the first line of the program that breaks
    the law, or of robot 0's program if no single program breaks the law.  If this line is unknown,
    or its file is not inside the folder ``root``, the line ``source`` is returned.
    """
    if not isinstance(finding, Finding):
        blamed = place_of_explorer(finding.programs[finding.robot or 0])
        return blamed if blamed and blamed.is_in(root) else source
    from allworlds.reports.content.single_run import wrong_line
    from allworlds.studies.explain import explained

    file, _, line = wrong_line(finding, explained(finding).step).rpartition(":")
    wrong = SourceLine(Path(file).resolve(), int(line)) if file else None
    return wrong if wrong and wrong.is_in(root) and wrong.file.is_file() else source


def _escaped(text: str, more: str = "") -> str:
    """The text in the form that commands of GitHub's runner need.

    Per cent signs, line ends and the characters of ``more`` become their hexadecimal numbers, such
    as ``%25``.
    """
    return "".join(f"%{ord(sign):02X}" if sign in "%\r\n" + more else sign for sign in text)


SCHEMA = (
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
)

NO_FILE = "no file associated with this alert"
"""The location of a result without a file, since GitHub refuses a result without a location."""

HELP = (
    "\n\nThe message draws the smallest world in which the explorer breaks this law, and tells its "
    "walk. Keep the report, with `allworlds check ... --json > report.json`: then `allworlds "
    "explain report.json` says in words where belief and truth part, and `allworlds replay "
    "report.json` runs the explorer there again, after a change too."
)
"""The help of each rule, which follows the sentence of the law."""


def _rule(law: str, asked: str) -> dict[str, Any]:
    """A law as a rule of SARIF, with all keys that code scanning needs.

    ``asked`` is a sentence: the law's requirement on an explorer.
    """
    full = f"{asked} A result is the smallest world in which an explorer breaks this law."
    return {
        "id": law,
        "shortDescription": {"text": asked},
        "fullDescription": {"text": full},
        "help": {"text": asked + HELP, "markdown": asked + HELP},
        "defaultConfiguration": {"level": "error"},
    }


def sarif(content: parts.ReportContent) -> str:
    """The report as a SARIF log with one run.

    Every law becomes a rule of SARIF. Every finding becomes a result of SARIF, whose message has
    the picture and the walk.  The place of a result is the line that :func:`_at` finds.  If that
    line is in no file of the repository, the place is the line that :func:`_source_of_check` finds.
    Each remark of the report becomes a notification of SARIF, and so does the verdict if
    :data:`LEVELS` names it.
    """
    report: Any = content.result  # of a check
    head = content.headline
    assert head is not None
    rules = [_rule(law, asked) for law, asked in content.laws.items()]
    driver = {"name": "allworlds", "semanticVersion": __version__, "rules": rules}
    level = LEVELS.get(report.verdict)
    said = [(level, head.line)] if level else []
    said += [("note", remark) for remark in report.remarks]
    root, source = _project(report.explorer)
    invocation = {
        "executionSuccessful": report.verdict is not Verdict.ERROR and not report.interrupted,
        "exitCode": int(report.exit_code),
        "toolExecutionNotifications": [
            {"level": level, "message": {"text": text}} for level, text in said
        ],
    }
    run = {
        "tool": {"driver": driver},
        "invocations": [invocation],
        "originalUriBaseIds": {"SRCROOT": {"uri": root.as_uri() + "/"}},
        "results": [_result(*found, source, root) for found in enumerate(report.findings, 1)],
    }
    log = {"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}
    return words.harmless_json(json.dumps(log, indent=2)) + "\n"


def _result(
    number: int, finding: "Finding | TeamFinding", source: SourceLine | None, root: Path
) -> dict[str, Any]:
    source = _at(finding, source, root)
    head, text = _texts(finding, number)
    head += "."
    if source is None:
        head += " The explorer is no file of this repository, so this stands where it is checked."
        source = _source_of_check(root)
    at = source.line if source else 1
    uri = quote(os.fsencode(source.named_from(root)) if source else NO_FILE)
    where = {"uri": uri, **({"uriBaseId": "SRCROOT"} if source else {})}
    region = {"startLine": at, "startColumn": 1, "endLine": at, "endColumn": 2}
    return {
        "ruleId": finding.law,
        "level": "error",
        "message": {"text": f"{head}\n\n{text}", "markdown": f"{head}\n\n{fenced(text)}"},
        "locations": [{"physicalLocation": {"artifactLocation": where, "region": region}}],
        # The name of the finding's file holds a digest of all of it.
        "partialFingerprints": {"finding/v1": finding.file_name},
    }


def _source_of_check(root: Path) -> SourceLine | None:
    """A line of the repository that stands for the check: the first line that names ``allworlds``.

    The files in ``root`` that are searched are, in this order: the workflow that runs, all
    workflows, ``allworlds.toml`` and ``pyproject.toml``.  If none of them names ``allworlds``, the
    result is line 1 of the first of these files that exists.  If none of these files exists, the
    result is line 1 of the first file in ``root``.  If ``root`` has no file, the result is None.
    """
    running = os.environ.get("GITHUB_WORKFLOW_REF", "").partition("@")[0].split("/", 2)[2:]
    options = (root / "allworlds.toml", root / "pyproject.toml")
    flows = (*(root / path for path in running), *sorted(root.glob(".github/workflows/*.y*ml")))
    there = [file for file in (*flows, *options) if file.is_file()]
    for file in there:
        lines = file.read_text(encoding="utf-8", errors="replace").splitlines()
        naming = (number for number, line in enumerate(lines, 1) if "allworlds" in line)
        if line := next(naming, 0):
            return SourceLine(file, line)
    plain = (file for file in sorted(root.iterdir()) if file.name[0] != "." and file.is_file())
    return next((SourceLine(file) for file in (*there, *plain)), None)


def _project(explorer: str) -> tuple[Path, SourceLine | None]:
    """The root of the repository, and the line where the explorer begins.

    ``explorer`` is the explorer as the user named it.  The line is None if it is unknown, or if its
    file is not inside the root.

    The root is the folder of the git repository in which the current folder is, or else of the
    repository in which the explorer is. Without a repository it is the folder that a CI service
    names, or else the current folder.
    """
    here, source = Path.cwd().resolve(), place_of_explorer(explorer)
    above = (here, *here.parents, *(source.file.parents if source else ()))
    default = Path(os.environ.get("GITHUB_WORKSPACE") or here).resolve()
    root = next((folder for folder in above if (folder / ".git").exists()), default)
    return root, source if source and source.is_in(root) else None


def content_of(result: Any) -> parts.ReportContent:
    """The content of the report for a verb's result."""
    return _maker(type(result))(result)


MAKERS = {
    "check.check_content": ("CheckReport", "TimeEstimate"),
    "single_run.run_content": ("SingleRun", "WorldNames"),
    "single_run.replay_content": ("Replay",),
    "single_run.explain_content": ("Explanation",),
    "converted.convert_content": ("Convert",),
    "plain.init_content": ("Skeleton", "LedgerSkeleton", "Header"),
    "plain.status_content": ("Standing",),
    "compare.compare_content": ("Comparison", "Growth"),
    "sizes.worst_content": ("WorstReport",),
    "sizes.count_content": ("Census",),
    "team.team_content": ("TeamReport",),
    "team.team_replay_content": ("TeamReplay",),
    "team.team_explain_content": ("TeamExplanation",),
    "ambiguity.twins_content": ("ComparedWorlds",),
    "ambiguity.class_content": ("AmbiguityClass",),
    "ambiguity.census_content": ("AmbiguityCensus",),
    "ambiguity.search_content": ("SearchResult",),
    "sensors.sensors_content": ("AmbiguitySensors",),
    "sensors.weakest_content": ("AmbiguityWeakest",),
    "ledger.ledger_content": ("LedgerReport",),
}
"""The functions of ``content``, each with the names of the classes of reports that it takes."""


def _maker(kind: type) -> Callable[[Any], parts.ReportContent]:
    """The function that makes the content of a class of reports; by default ``plain_content``."""
    if kind.__name__ == "Play":
        from allworlds.reports.web.play import play_content

        return play_content
    found = (name for name, kinds in MAKERS.items() if kind.__name__ in kinds)
    module, _, function = next(found, "plain.plain_content").partition(".")
    made = getattr(import_module(f"allworlds.reports.content.{module}"), function)
    return cast("Callable[[Any], parts.ReportContent]", made)


def text(result: Any, width: int) -> str:
    """The whole text of a verb's result, with lines of ``width`` columns."""
    return words.harmless(plain_text.content_text(content_of(result), width))


def brief(result: Any, width: int) -> str:
    """The result in one line, for ``--quiet``."""
    return words.harmless(plain_text.content_line(content_of(result), width))


class Format(Struct, frozen=True):
    """A file format of reports.

    Attributes:
        of_content: the function that makes the file's content from the content of a report.
        suffix: the suffix of file names that means this format; empty if a user must write
            ``FORMAT:`` before the name.
        shows: the kinds of content that the format can show; the module ``verbs`` names them. A
            verb can write the format if its reports have one of these kinds; if ``shows`` is empty,
            all verbs can.
        library: None if no library is needed; else three texts about the library that the format
            needs: its import name; the extra of this package that installs it; and the words for
            such a file, such as ``a file of Parquet``, with which the error about a missing library
            begins.
        summary: the name of an environment variable. A CI service puts the name of a file into this
            variable, and expects the report in that file. Empty if there is no such variable.
        read_by: the name of an environment variable that a CI service sets if it reads this format
            on stderr; empty if there is none.
    """

    of_content: Callable[[parts.ReportContent], str | bytes]
    suffix: str
    shows: tuple[str, ...] = (verbs.ROWS,)
    library: tuple[str, str, str] | None = None
    summary: str = ""
    read_by: str = ""


def csv_rows(content: parts.ReportContent) -> str:
    """The report's rows as CSV; empty if there are no rows."""
    out, found = io.StringIO(), parts.rows_of(content)
    if found.columns:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(found.columns)
        writer.writerows(found.rows)
    return out.getvalue()


LATEX = {sign: f"\\{sign}" for sign in "&%$#_{}"}
LATEX |= {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"}
"""The characters that mean something to LaTeX, and how each of them is written."""


def latex_rows(content: parts.ReportContent) -> str:
    """The report's rows as a table of LaTeX that needs no package; empty if there are no rows."""
    found = parts.rows_of(content)
    if not found.columns:
        return ""
    shown = (("" if value is None else str(value) for value in row) for row in found.rows)
    lines = (
        " & ".join("".join(LATEX.get(sign, sign) for sign in cell) for cell in row) + r" \\"
        for row in (found.columns, *shown)
    )
    head, *rest = (words.escaped(" ".join(line.split())) for line in lines)
    sides = "".join("r" if kind in (int, float) else "l" for kind in found.columns.values())
    begin = rf"\begin{{tabular}}{{{sides}}}"
    return "\n".join([begin, r"\hline", head, r"\hline", *rest, r"\hline", r"\end{tabular}", ""])


def lone_picture(content: parts.ReportContent) -> str:
    """The picture of the report's only map as SVG; without a map, the report's first curve.

    A curve shows values by the size of maps.  If the report has no curve either, the picture is
    empty.

    Raises:
        InputError: if there are several maps.
    """
    from allworlds.reports.drawing.plot import SVG, plot
    from allworlds.reports.drawing.svg import drawing

    sections = (*content.sections, *content.whole)
    blocks = [block for section in sections for block in section.blocks]
    maps = [each for one in blocks if isinstance(one, parts.MapPictures) for each in one.entries]
    if len(maps) > 1:
        raise InputError(f"a file .svg holds one picture, and not {len(maps)}; .html holds all")
    for title, scene in maps:
        return drawing(scene, title).svg
    drawn = next((plot(block) for block in blocks if isinstance(block, parts.Curve)), None)
    return ET.tostring(ET.Element("svg", xmlns=SVG) if drawn is None else drawn, "unicode") + "\n"


def sequence_diagram(content: parts.ReportContent) -> str:
    """The run of the smallest finding of a team as a sequence diagram of PlantUML.

    Without a finding the diagram shows the run that the budget cuts off; if no run is cut off
    either, the diagram is empty.
    """
    from allworlds.reports.content.team import sequence_of

    report: Any = content.result
    found = next(iter(report.findings), report.unfinished)
    return sequence_of(found) if found else "@startuml\n@enduml\n"


def parquet_rows(content: parts.ReportContent) -> bytes:
    """The report's rows as a file of Parquet, in which each column has a name and a type."""
    from pyarrow import BufferOutputStream, Table, bool_, float64, int64, schema, string
    from pyarrow.parquet import write_table

    kinds = {int: int64(), float: float64(), str: string(), bool: bool_()}
    found, out = parts.rows_of(content), BufferOutputStream()
    columns = schema([(name, kinds[kind]) for name, kind in found.columns.items()])
    write_table(Table.from_pylist(found.records, schema=columns), out)
    written: bytes = out.getvalue().to_pybytes()
    return written


def document_text(document: Mapping[str, Any]) -> str:
    """The text of a JSON document."""
    return words.harmless_json(json.dumps(document, indent=2)) + "\n"


def html(content: parts.ReportContent) -> str:
    """The report as an HTML document that refers to no other file."""
    if content.page:
        return content.page()
    from allworlds.reports.web.sections import element, framed

    said = content.headline
    document = content.result.to_json()
    return framed(
        (content.done, content.subject),
        (said.word, said.text, said.verdict or "open") if said else None,
        [element(each) for each in (*content.sections, *content.whole, *content.more())],
        {key: value for key, value in document.items() if key not in content.apart},
    )


FORMATS = {
    "html": Format(html, ".html", (verbs.ROWS, verbs.PAGE)),
    "markdown": Format(markdown, ".md", summary="GITHUB_STEP_SUMMARY"),
    "csv": Format(csv_rows, ".csv"),
    "latex": Format(latex_rows, ".tex"),
    "svg": Format(lone_picture, ".svg", (verbs.CURVE, verbs.PICTURE)),
    "json": Format(lambda content: document_text(content.result.to_json()), ".json", ()),
    "parquet": Format(parquet_rows, ".parquet", library=("pyarrow", "notebook", "a file .parquet")),
    "sarif": Format(sarif, ".sarif", (verbs.FINDINGS,)),
    "junit": Format(junit, ".xml", (verbs.CASES,)),
    "plantuml": Format(sequence_diagram, ".puml", (verbs.RUNS,)),
    "annotations": Format(runner_commands, "", (verbs.FINDINGS,), read_by="GITHUB_ACTIONS"),
}
"""Every format of reports, by its name."""


def formats_of(verb: str) -> dict[str, Format]:
    """The formats in which a verb can write its results, by their names."""
    has = {*verbs.BY_NAME[verb].has}
    return {name: form for name, form in FORMATS.items() if not form.shows or has & {*form.shows}}


def legal_files(verb: str) -> str:
    """The file names that a verb accepts for its output, in words."""
    forms = formats_of(verb)
    names = " ".join(form.suffix for form in forms.values() if form.suffix)
    reports = f"{names}, or FORMAT:FILE ({', '.join(forms)})"
    if verbs.WORLD_FILE in verbs.BY_NAME[verb].has:
        return f"{legal(written=True)} are worlds; of the report {reports}"
    return reports


def names_world_file(verb: str, name: str) -> bool:
    """Whether the output ``name`` is a file of worlds; ``FORMAT:FILE`` never is.

    A suffix that both worlds and reports have means worlds.
    """
    writes = verbs.WORLD_FILE in verbs.BY_NAME[verb].has
    return writes and name.partition(":")[0] not in FORMATS and by_suffix(name) is not None


def form_and_path(verb: str, name: str) -> tuple[str, str]:
    """The format and the path of the file for an output that the user names.

    Raises:
        InputError: if this verb writes no file of this form, or a library is not installed.
    """
    if names_world_file(verb, name):
        return to_write(name).name, name
    forms = formats_of(verb)
    form, colon, path = name.partition(":")
    if not colon or not form.isalpha():
        named = (each for each, made in forms.items() if name.endswith(made.suffix or "\0"))
        form, path = next(named, ""), name
    if form not in forms:
        known = [*forms, *(each.suffix for each in forms.values())]
        legal_ones = legal_files(verb) + did_you_mean(form or Path(name).suffix, known)
        raise InputError(f"-o {show(name)} is no file that {verb} writes: {legal_ones}")
    if library := forms[form].library:
        ensure_installed(*library)
    return form, path


def file_of(form: str, result: Any) -> Any:
    """The content of a file of the format ``form`` for a verb's result: a text, or bytes."""
    format_ = FORMATS[form]
    made = format_.of_content(content_of(result))
    if isinstance(made, bytes):
        return made
    # UTF-8 has no halves of pairs: names of files and words of explorers may hold some.
    whole = re.sub("[\ud800-\udfff]", "\N{REPLACEMENT CHARACTER}", made).replace("\r", r"\x0d")
    # Lines that look like commands of a CI service are made harmless, but in a file of them.
    return words.escaped(whole) if format_.read_by else words.harmless(whole)
