"""The options that write a report into a file: -o and --corpus."""

import json
import re
import resource
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from allworlds.cli.defaults import Defaults, begin
from allworlds.cli.output import emit, output_of
from allworlds.reports.formats import file_of
from allworlds.studies.check.exhaustive import check
from allworlds.studies.fuzz.sample_sweep import fuzz

WRONG = f"{Path(__file__).parents[1] / 'recorded' / 'explorers.py'}:first_edge"


def junit(report):
    return file_of("junit", report)


def page(report):
    return file_of("html", report)


pytestmark = pytest.mark.usefixtures("without_workers")


def untimed(text):
    """The text without the seconds that each case took."""
    return re.sub(r' time="[0-9.]+"', "", text)


QUICK = ["check", "--edges", "1", "--workers", "1", "-q"]
WRITERS = pytest.mark.parametrize(("option", "written"), [("junit", junit), ("html", page)])
OPTIONS = pytest.mark.parametrize("option", ["junit", "html"])


@WRITERS
def test_the_file_holds_the_report(option, written, tmp_path, cli):
    file = tmp_path / "report"
    code, out, _ = cli(*QUICK, "-o", f"{option}:{file}")
    assert code == 0
    assert untimed(file.read_text(encoding="utf-8")) == untimed(written(check(edges=1)))
    assert "HOLDS" in out


@WRITERS
def test_an_older_file_is_replaced_whole(option, written, tmp_path, cli):
    file = tmp_path / "report"
    file.write_text("x" * 100_000)
    assert cli(*QUICK, "-o", f"{option}:{file}")[0] == 0
    assert untimed(file.read_text(encoding="utf-8")) == untimed(written(check(edges=1)))


def test_both_are_written_of_one_check(tmp_path, cli):
    files = [tmp_path / "junit.xml", tmp_path / "page.html"]
    assert cli(*QUICK, "-o", files[0], "-o", files[1])[0] == 0
    assert ET.parse(files[0]).getroot().tag == "testsuites"
    assert files[1].read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


def test_a_document_is_written_as_it_is_printed(tmp_path, cli):
    _, out, _ = cli("check", "--edges", 1, "--json", "-o", (file := tmp_path / "report.json"))
    printed, written = json.loads(out), json.loads(file.read_text(encoding="utf-8"))
    assert written.pop("made_by")["command"] == printed.pop("made_by")["command"]
    assert written == printed


@OPTIONS
def test_a_refuted_check_is_written_too(option, tmp_path, cli):
    file = tmp_path / "report"
    explorer = tmp_path / "answers_nothing.py"
    explorer.write_text("def explore(first):\n    return None\n    yield\n")
    code, out, _ = cli(*QUICK, f"{explorer}:explore", "-o", f"{option}:{file}")
    assert code == 1
    assert "no-estimate" in file.read_text(encoding="utf-8")
    assert "no-estimate" in out


@WRITERS
def test_fuzz_writes_them_too(option, written, tmp_path, cli):
    file = tmp_path / "report"
    sample = ["--edges", "4", "--runs", "3", "--workers", "1", "-q"]
    code, out, _ = cli("fuzz", *sample, "-o", f"{option}:{file}")
    assert code == 0
    assert untimed(file.read_text(encoding="utf-8")) == untimed(written(fuzz(edges=4, runs=3)))
    assert "NOT-REFUTED" in out


@OPTIONS
@pytest.mark.parametrize("name", ["no/such/directory", "", ".", "\0", "a\ud800"])
def test_a_file_that_cannot_be_written_is_refused_before_the_run(
    option, name, tmp_path, monkeypatch, refused
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(
        "allworlds.studies.check.exhaustive.check", lambda *_args, **_options: 1 / 0
    )
    assert "cannot be written" in refused(*QUICK, "-o", f"{option}:{name}")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            "check -o mine.py",
            "-o 'mine.py' is no file that check writes: .html .md .csv .tex .json",
        ),
        ("check -o pdf:mine.html", "-o 'pdf:mine.html' is no file that check writes: .html .md"),
        ("check -o svg:mine", "-o 'svg:mine' is no file that check writes"),
        ("run theta -o mine.xml", "-o 'mine.xml' is no file that run writes: .html .md .csv"),
        ("check -o -q", "-o '-q' is no file"),
        ("check -o one.xml -o html:./one.xml", "-o 'one.xml' is a file that two reports"),
        ("explain found.json -o found.json", "-o 'found.json' is a file that is read"),
        ("explain found.json -o./found.json", "-o './found.json' is a file that is read"),
        ("run algorithm1 @world.json -o world.json", "-o 'world.json' is a file that is read"),
        ("check mine -o csv:mine", "-o 'csv:mine' is a file that is read"),
        ("check --native mine -o csv:mine", "-o 'csv:mine' is a file that is read"),
        ("check mine:explore -o csv:mine", "-o 'csv:mine' is a file that is read"),
        ("check --html mine.html", "No such option: --html"),
    ],
)
def test_what_is_read_and_what_is_no_report_is_not_written(
    words, said, tmp_path, monkeypatch, refused
):
    monkeypatch.chdir(tmp_path)
    texts = dict.fromkeys(("mine.py", "mine", "found.json", "world.json"), "kept")
    for name, text in texts.items():
        Path(name).write_text(text)
    assert said in refused(*words.split())
    assert {file.name: file.read_text() for file in tmp_path.iterdir()} == texts


def test_a_new_file_may_have_the_name_of_an_explorer_or_a_world(tmp_path, monkeypatch, cli):
    monkeypatch.chdir(tmp_path)
    assert cli("run", "folding", "theta", "-o", "csv:theta")[0] == 0
    assert (tmp_path / "theta").exists()


def test_asking_whether_a_file_can_be_written_leaves_it_as_it_is(tmp_path):
    there, not_there = tmp_path / "there", tmp_path / "not-there"
    there.write_text("kept")
    output_of("check")(files=[f"junit:{there}", f"html:{not_there}"])
    assert there.read_text() == "kept"
    assert not not_there.exists()


def test_without_a_file_nothing_is_written(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    begin([], Defaults())
    emit(check(edges=1), output_of("check")())
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
@OPTIONS
def test_a_disk_that_fills_up_loses_the_file_and_not_the_report(cli, monkeypatch, option):
    monkeypatch.setattr("allworlds.cli.output.ensure_writable", lambda _: None)
    code, out, err = cli("check", "--edges", 1, "--json", "-o", f"{option}:/dev/full")
    assert (code, json.loads(out)["verdict"]) == (0, "holds")
    assert err.count("\n") == 1
    assert "'/dev/full' cannot be written: No space left on device" in err


def test_half_a_file_is_no_file(tmp_path, monkeypatch, capsys):
    def full(path, content):
        with path.open("wb") as file:
            file.write(content[:5])
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    begin([], Defaults())
    emit(check(edges=1), output_of("check")(files=[str(tmp_path / "report.xml")]))
    assert [*tmp_path.iterdir()] == []
    assert capsys.readouterr().err.count("\n") == 1


def test_a_corpus_that_is_full_loses_the_finding_and_not_the_report(cli, monkeypatch, tmp_path):
    def full(*_, **__):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_text", full)
    code, out, err = cli("check", WRONG, "--edges", 1, "--json", "--corpus", tmp_path / "corpus")
    document = json.loads(out)
    assert (code, document["verdict"], document["corpus"]["written"]) == (1, "refuted", [])
    (remark,) = document["remarks"]
    assert "could not take" in remark
    assert remark in err
    assert [*(tmp_path / "corpus").iterdir()] == []


@pytest.mark.processes
@pytest.mark.parametrize(
    ("explorer", "said"),
    [
        ("algorithm1", "run directory 'kept' cannot be used: disk I/O error"),
        (WRONG, "no 16 bytes can be shared with an explorer: File too large; legal is 'ulimit -f'"),
    ],
)
def test_where_no_file_may_be_written_a_check_with_a_run_directory_is_refused(
    explorer, said, tmp_path
):
    def nothing():
        resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))

    words = ["-m", "allworlds", "check", explorer, "--edges", "1", "--run", "kept"]
    done = subprocess.run(
        [sys.executable, *words],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=nothing,  # it sets a limit alone
    )
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert said in done.stderr


def test_a_file_with_a_byte_order_mark_is_read(cli, tmp_path, monkeypatch):
    """Some editors and shells write one before the text."""
    monkeypatch.chdir(tmp_path)
    _, report, _ = cli("check", WRONG, "--edges", 2, "-q", "--json", "--corpus", "past")
    (kept,) = (tmp_path / "past").iterdir()
    for name, text in {
        "report.json": report,
        "world.json": '{"sigma": [1, 0], "alpha": [1, 0]}',
        "allworlds.toml": "[check]\nedges = 2\n",
        f"past/{kept.name}": kept.read_text(),
        "marked.py": Path(WRONG.partition(":")[0]).read_text(),
    }.items():
        (tmp_path / name).write_text(text, encoding="utf-8-sig")
    assert cli("replay", "report.json", "-q")[1].startswith("REPRODUCED")
    assert cli("explain", "report.json", "-q")[0] == 0
    assert cli("run", "@world.json", "-q")[1].startswith("HOLDS")
    code, out, err = cli("check", "marked.py:first_edge", "-q", "--corpus", "past")
    assert (code, out.partition(":")[0], err) == (1, "REFUTED", "")


def test_a_file_whose_library_is_missing_is_refused_before_the_check(
    refused, monkeypatch, tmp_path
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("allworlds.inputs.checks.find_spec", lambda _: None)
    said = refused("check", "--edges", 1, "-o", "rows.parquet")
    assert "needs pyarrow: in a clone of allworlds, pip install" in said
