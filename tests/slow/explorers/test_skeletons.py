"""Every skeleton is built, run and refuted, until it is filled in.  Nothing is overwritten."""

import json
import re
import shutil

import pytest

from allworlds.explorers.languages import LANGUAGES
from allworlds.studies.check.exhaustive import check
from allworlds.studies.init import init
from explorers import test_skeletons as quick
from native_libraries import FOR_TESTS, HEADER, built

shell = quick.shell


@pytest.mark.slowest
@pytest.mark.parametrize("lang", [lang for lang in LANGUAGES if lang != "python"])
def test_the_test_of_a_skeleton_fails_with_the_picture(lang, shell, tmp_path):
    ready(lang)
    init(tmp_path / "mine", lang=lang)
    command = LANGUAGES[lang].test
    if command == "npm test":  # which comes with Node, but not everywhere
        command = json.loads((tmp_path / "mine" / "package.json").read_text())["scripts"]["test"]
    tested = shell(command, tmp_path / "mine")
    assert tested.returncode in (1, 2), tested.stderr
    assert "breaks the law 'map'" in tested.stdout


def ready(lang):
    """Skip where a program is missing that the language needs."""
    for program in LANGUAGES[lang].needs:
        if shutil.which(program) is None:
            pytest.skip(f"there is no {program}")


@pytest.mark.slowest
@pytest.mark.parametrize("lang", ["python", "c", "javascript", "rust"])
def test_a_skeleton_builds_and_is_refuted_in_a_picture(lang, shell, tmp_path):
    ready(lang)
    made = shell(f"allworlds init mine --lang {lang}")
    assert made.returncode == 0, made.stderr
    command = next(line for line in made.stdout.splitlines() if line.startswith("  cd mine && "))
    checked = shell(command)
    assert checked.returncode == 1, checked.stdout + checked.stderr
    assert "breaks the law 'map' in a world with 1 edge and 1 vertex" in checked.stdout
    assert " ╭─╮\n(0 1)\n" in checked.stdout
    if lang == "c":
        assert "warning" not in checked.stderr


OVERRUN = {
    "c": ("robot->edges = 0;", "{} int *lent = malloc(8); free(lent); robot->edges = lent[1];"),
    "rust": (
        "fn start(&mut self, first: &Percept) -> Next {",
        "{} let lent = vec![1u8; 8]; std::hint::black_box(unsafe {{ *lent.as_ptr().add(8) }});",
    ),
}
"""A line of each skeleton, and what stands beside it in one that reads what is not its own."""

UNSET = {
    "c": (
        OVERRUN["c"][0],
        "{} int *lent = malloc(8); if (lent[1] > 7) robot->degree++; free(lent);",
    ),
    "rust": (
        OVERRUN["rust"][0],
        "{} let v = Vec::<u8>::with_capacity(9); if unsafe {{ *v.as_ptr() }} > 7 {{ loop {{}} }}",
    ),
}
"""Likewise, of one that uses a value which was never set."""


@pytest.mark.slowest
@pytest.mark.parametrize("lang", ["c", "rust"])
@pytest.mark.parametrize(
    ("target", "slip", "said"),
    [
        ("asan", OVERRUN, "AddressSanitizer: heap"),
        ("valgrind", UNSET, "uninitialised value"),
    ],
)
def test_a_slip_with_memory_is_found_by_a_tool_in_its_line(
    target, slip, said, lang, shell, tmp_path
):
    ready(lang)
    if shutil.which("valgrind") is None and target == "valgrind":
        pytest.skip("there is no valgrind")
    init(tmp_path / "mine", lang=lang)
    file = tmp_path / "mine" / LANGUAGES[lang].explorer
    text, (line, slipped) = file.read_text(), slip[lang]
    assert text.count(line) == 1
    file.write_text(text.replace(line, slipped.format(line)))
    number = text[: text.index(line)].count("\n") + 1
    found = shell(f"make {target} EDGES=1", tmp_path / "mine")
    assert "breaks the law 'crash'" in " ".join(found.stdout.split()), found.stderr
    assert said in found.stdout
    assert re.search(rf"{file.name}:{number}\b", found.stdout)


@pytest.mark.slowest
@pytest.mark.parametrize("lang", ["c", "rust"])
@pytest.mark.parametrize("target", ["test", "asan", "valgrind"])
def test_the_blocking_explorer_is_refuted_in_the_same_world(target, lang, shell, tmp_path):
    ready(lang)
    if shutil.which("valgrind") is None and target == "valgrind":
        pytest.skip("there is no valgrind")
    init(tmp_path / "mine", lang=lang)
    done = shell(f"make {target} EXPLORER=blocking EDGES=2", tmp_path / "mine")
    said = " ".join(done.stdout.split())
    assert "breaks the law 'map' in a world with 1 edge and 1 vertex" in said, done.stderr
    assert "warning" not in done.stderr


@pytest.mark.slowest
def test_a_blocking_explorer_keeps_its_stack_from_step_to_step(tmp_path):
    """It is recursive, and right; and a run that is given up does not harm the next one."""
    init(tmp_path, lang="c")
    shutil.copy(HEADER / "allworlds.h", tmp_path)
    (tmp_path / "blocking.h").rename(tmp_path / "blocking.copy")
    library = built(FOR_TESTS / "blocking.c", "-include", str(tmp_path / "blocking.copy"))
    asked = {"lighthouse": "labels", "edges": 3}
    assert check(f"native:{library}", **asked).verdict == "holds"
    stopped = check(f"native:{library}", **asked, step_budget=3, max_findings=9)
    assert {finding.law for finding in stopped.findings} == {"budget"}
