"""Output for GitHub's runner: Markdown, and commands on stderr."""

import json
import re
from types import SimpleNamespace

import pytest

from allworlds.documents.document import replace
from allworlds.outcome import Completed, Interrupted, Stopped
from allworlds.reports.content.single_run import wrong_line
from allworlds.reports.formats import file_of, formats_of
from allworlds.reports.plain_text import finding_in_words as finding_text
from allworlds.studies.check.exhaustive import check

TEXTS = [form for form in formats_of("check") if form != "parquet"]
pytestmark = pytest.mark.usefixtures("without_workers")


def read(line):
    """A command as the runner reads it: kind, properties and message."""
    kind, properties, message = re.fullmatch(r"::(\w+) (.*?)::(.*)", line).groups()

    def plain(text):
        for sign, code in ((":", "%3A"), (",", "%2C"), ("\r", "%0D"), ("\n", "%0A"), ("%", "%25")):
            text = text.replace(code, sign)
        return text

    told = dict(part.split("=", 1) for part in properties.split(","))
    return kind, {name: plain(value) for name, value in told.items()}, plain(message)


def markdown(report):
    return file_of("markdown", report)


def runner_commands(report):
    return file_of("annotations", report)


RAISES = """
def explore(first):
    if not first.degree:
        yield
    raise ValueError("ends with \\udcff \\x1b[31m \\0 and a bell \\a")
"""


@pytest.mark.parametrize("form", TEXTS)
def test_what_an_explorer_says_or_is_called_fits_into_every_file(form, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    try:
        (tmp_path / "q\udcff.py").write_text(RAISES)
    except OSError:
        pytest.skip("names of files are UTF-8 here")
    text = file_of(form, check("q\udcff.py:explore", edges=1))
    assert text.encode()
    assert not re.search(r"[\x00-\x08\x0b-\x1f\x7f]", text)
    rows = form in ("csv", "latex")  # which are numbers
    assert rows or "ends with" in text
    assert rows or r"x1b[31m" in text or r"u001b[31m" in text


COMMANDS = """
def explore(first):
    print("::error::printed\\n##[error]printed")
    if not first.degree:
        yield
    raise ValueError("ends with\\n::error::told\\n \\t::error::told ##[error]told \\u200b \\u202e")
"""


@pytest.mark.parametrize("form", TEXTS)
def test_no_line_of_a_file_is_a_command_because_of_an_explorer(form, tmp_path):
    file = tmp_path / "commands.py"
    file.write_text(COMMANDS)
    report = check(f"{file}:explore", edges=1)
    for text in (str(report), finding_text(report.findings[0], 80)):
        assert not re.search(r"\n\s*::|##\[|\u200b", text)
    lines = file_of(form, report).splitlines()
    ours = len(report.findings) if form == "annotations" else 0
    assert sum(line.lstrip().startswith("::") for line in lines) == ours
    if not ours:
        assert not any("##[" in line for line in lines)
    assert not any({"\u200b", "\u202e"} & {*line} for line in lines)


def test_a_finding_is_an_error_at_its_first_wrong_line(refuted, line):
    lines = runner_commands(refuted).splitlines()
    assert len(lines) == 2
    results = json.loads(file_of("sarif", refuted))["runs"][0]["results"]
    places = [result["locations"][0]["physicalLocation"]["region"] for result in results]
    told = [int(read(each)[1]["line"]) for each in lines]
    assert told == [place["startLine"] for place in places] == [line + 3, line]
    for i, (told, finding) in enumerate(zip(lines, refuted.findings, strict=True), 1):
        kind, properties, message = read(told)
        assert (kind, properties["file"]) == ("error", "mine.py")
        assert properties["title"].startswith(
            f"mine.py:explore breaks the law '{finding.law}' in a world"
        )
        assert message == finding_text(finding, 100, i)


@pytest.mark.parametrize(
    ("ending", "kind", "word"),
    [
        (Completed(), "notice", "HOLDS"),
        (Completed(("never",)), "error", "VACUOUS"),
        (Stopped("100% of the time,\nall of it: over"), "warning", "INCONCLUSIVE"),
        (Interrupted(), "warning", "INCONCLUSIVE"),
    ],
    ids=["holds", "vacuous", "stopped", "interrupted"],
)
def test_a_verdict_without_a_finding_is_told_once(ending, kind, word):
    (line,) = runner_commands(replace(check(edges=1), ending=ending)).splitlines()
    told, properties, message = read(line)
    assert (told, properties) == (kind, {"title": f"allworlds: {word}"})
    assert message.startswith("algorithm1: ")
    assert ending.reason in message


def test_the_page_of_a_job_shows_verdict_picture_and_counts(refuted):
    page = markdown(refuted)
    assert page.startswith("## allworlds: REFUTED mine.py:explore\n\nlaw map is broken; ")
    for i, finding in enumerate(refuted.findings, 1):
        assert f"```text\n{finding_text(finding, 100, i)}\n```" in page
    assert "| edges | vertices | worlds |" in page
    assert page.count("<details>") == page.count("</details>") == 1


def test_what_an_explorer_says_cannot_end_its_block(refuted):
    first = refuted.findings[0]
    hostile = replace(first, detail="```\n# not a heading\n````")
    page = markdown(replace(refuted, tally=replace(refuted.tally, findings=[hostile])))
    assert "\n`````text\nFinding 1" in page
    assert page.count("`````") == 2


def test_what_is_no_picture_is_no_markup(refuted):
    page = markdown(replace(refuted, explorer="a|b*c_<script>.py:explore"))
    assert r"REFUTED a\|b\*c\_&lt;script>.py:explore" in page


def test_a_service_gets_the_report_without_being_asked(refuted, cli, monkeypatch, tmp_path):
    summary = tmp_path / "summary.md"
    summary.write_text("before\n")
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    monkeypatch.setenv("GITHUB_STEP_SUMMARY", str(summary))
    code, out, err = cli("check", "mine.py:explore", "--edges", 2, "-q", "--max-findings", 2)
    assert code == 1
    assert out.startswith("REFUTED")
    assert err == runner_commands(refuted)
    assert summary.read_text(encoding="utf-8") == "before\n" + markdown(refuted)


def test_elsewhere_nothing_is_told_to_a_service(refuted, cli):
    assert refuted
    assert cli("check", "mine.py:explore", "--edges", 2, "-q")[2] == ""


def test_a_page_that_cannot_be_written_is_lost_with_a_word(cli, monkeypatch, tmp_path):
    monkeypatch.setenv("GITHUB_STEP_SUMMARY", str(tmp_path))
    code, _, err = cli("check", "--edges", 1, "-q")
    assert (code, err.count("\n")) == (0, 1)
    assert "GITHUB_STEP_SUMMARY cannot be written: Is a directory" in err


@pytest.mark.parametrize(
    ("law", "step", "shown", "told"),
    [
        ("invariant-1", 3, 1, "a.py:8"),
        ("invariant-1", 3, 2, "a.py:3"),
        ("map", None, None, "a.py:3"),
        ("budget", None, None, "a.py:3"),
        ("bound", None, None, ""),
    ],
)
def test_the_first_wrong_line_is_that_of_the_checkpoint_or_of_the_step(law, step, shown, told):
    code = SimpleNamespace(steps=("a.py:1", "a.py:2", "a.py:3"), checkpoints=("a.py:7", "a.py:8"))
    believed = None if shown is None else SimpleNamespace(number=shown)
    finding = SimpleNamespace(code=code, believed=believed, step=step, law=law)
    assert wrong_line(finding, step) == told
