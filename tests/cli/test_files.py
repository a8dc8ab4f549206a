"""The options that write a report into a file: --junit, --html and --corpus."""

import json
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from allworlds.cli.files import files_of
from allworlds.reports.format_table import file_of
from allworlds.studies.check.exhaustive import check
from allworlds.studies.fuzz.drive import fuzz

WRONG = f"{Path(__file__).parents[1] / 'recorded' / 'explorers.py'}:first_edge"


def junit(report):
    return file_of("check", "junit", report)


def page(report):
    return file_of("check", "html", report)


pytestmark = pytest.mark.usefixtures("without_workers")

QUICK = ["check", "--edges", "1", "--workers", "1", "-q"]
WRITERS = pytest.mark.parametrize(("option", "written"), [("--junit", junit), ("--html", page)])
OPTIONS = pytest.mark.parametrize("option", ["--junit", "--html"])


@WRITERS
def test_the_file_holds_the_report(option, written, tmp_path, cli):
    file = tmp_path / "report"
    code, out, _ = cli(*QUICK, option, file)
    assert code == 0
    assert file.read_text(encoding="utf-8") == written(check(edges=1))
    assert "HOLDS" in out


@WRITERS
def test_an_older_file_is_replaced_whole(option, written, tmp_path, cli):
    file = tmp_path / "report"
    file.write_text("x" * 100_000)
    assert cli(*QUICK, option, file)[0] == 0
    assert file.read_text(encoding="utf-8") == written(check(edges=1))


def test_both_are_written_of_one_check(tmp_path, cli):
    files = [tmp_path / "junit.xml", tmp_path / "page.html"]
    assert cli(*QUICK, "--junit", files[0], "--html", files[1])[0] == 0
    assert ET.parse(files[0]).getroot().tag == "testsuites"
    assert files[1].read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


@OPTIONS
def test_a_refuted_check_is_written_too(option, tmp_path, cli):
    file = tmp_path / "report"
    explorer = tmp_path / "answers_nothing.py"
    explorer.write_text("def explore(first):\n    return None\n    yield\n")
    code, out, _ = cli(*QUICK, f"{explorer}:explore", option, file)
    assert code == 1
    assert "no-estimate" in file.read_text(encoding="utf-8")
    assert "no-estimate" in out


@pytest.mark.no_cover
@WRITERS
def test_fuzz_writes_them_too(option, written, tmp_path, cli):
    file = tmp_path / "report"
    sample = ["--edges", "4", "--runs", "3", "--workers", "1", "-q"]
    code, out, _ = cli("fuzz", *sample, option, file)
    assert code == 0
    assert file.read_text(encoding="utf-8") == written(fuzz(edges=4, runs=3))
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
    assert "cannot be written" in refused(*QUICK, option, name)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("check --html mine.py", "html 'mine.py' is a source or a library"),
        ("check --html -q", "html lacks its FILE: '-q'"),
        ("check --junit one --html ./one", "html and junit are both to be written into"),
        ("explain found.json --html found.json", "html 'found.json' is a file that is read"),
        ("explain found.json --html=./found.json", "html './found.json' is a file that is read"),
        ("run algorithm1 @world.json --csv world.json", "csv 'world.json' is a file that is read"),
        ("check mine --csv mine", "csv 'mine' is a file that is read"),
        ("check --native mine --csv mine", "csv 'mine' is a file that is read"),
        ("check mine:explore --csv mine", "csv 'mine' is a file that is read"),
    ],
)
def test_what_is_read_and_what_is_a_source_is_not_written(
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
    assert cli("run", "folding", "theta", "--csv", "theta")[0] == 0
    assert (tmp_path / "theta").exists()


def test_asking_whether_a_file_can_be_written_leaves_it_as_it_is(tmp_path):
    there, not_there = tmp_path / "there", tmp_path / "not-there"
    there.write_text("kept")
    files_of("check")(junit=str(there), html=str(not_there))
    assert there.read_text() == "kept"
    assert not not_there.exists()


def test_without_a_file_nothing_is_written(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    files_of("check")().write("check", check(edges=1))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
@pytest.mark.parametrize("named", [("/dev/full", None), (None, "/dev/full")])
def test_a_disk_that_fills_up_loses_the_file_and_not_the_report(cli, monkeypatch, named):
    option = "--junit" if named[0] else "--html"
    monkeypatch.setattr("allworlds.cli.files.ensure_writable", lambda _: None)
    code, out, err = cli("check", "--edges", 1, "--json", option, "/dev/full")
    assert (code, json.loads(out)["verdict"]) == (0, "holds")
    assert err.count("\n") == 1
    assert "'/dev/full' cannot be written: No space left on device" in err


def test_half_a_file_is_no_file(tmp_path, monkeypatch, capsys):
    def full(path, content):
        with path.open("wb") as file:
            file.write(content[:5])
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    files_of("check")(junit=str(tmp_path / "report.xml")).write("check", check(edges=1))
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
