import os
import re
import shutil
import subprocess
from importlib import import_module
from pathlib import Path

import pytest

from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.judging.laws.law_table import PRECEDENCE
from page_blocks import blocks

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
CI = ROOT / ".ci" / "run"


def test_ci_runs_the_commands_of_the_readme_word_for_word():
    script = [line.strip() for line in CI.read_text(encoding="utf-8").splitlines()]
    lines = [block.body.strip() for block in blocks(README, "sh")]
    assert [line.count("\n") for line in lines] == [0, 0]
    assert [line.rpartition("/")[2].partition(" ")[0] for line in lines] == ["allworlds", "pytest"]
    places = [script.index(line) for line in lines]  # a ValueError names the missing line
    assert places == sorted(places)


def test_the_environment_of_the_first_command_has_a_pip_of_its_own():
    (first, second) = (block.body.strip() for block in blocks(README, "sh"))
    assert " install pip . && " in first
    assert " install pip '.[test]' && " in second
    # Also where Debian leaves ensurepip out.
    assert "python3 -m venv --without-pip .venv && python3 -m pip --python" in first
    page = (ROOT / "docs/install.md").read_text(encoding="utf-8")
    assert first in page.splitlines()


def test_the_readme_is_read_in_a_few_minutes():
    assert README.count("\n") <= 240
    assert len(README.split()) <= 1100
    further = README.partition("## Where to read on")[2]
    assert 1 <= further.count("](") <= 8
    assert "![" in README


def test_ci_is_a_script_that_bash_understands():
    bash = shutil.which("bash")
    assert bash
    subprocess.run([bash, "-n", str(CI)], check=True)
    assert os.access(CI, os.X_OK)


def is_made(page):
    """Whether it is a page of the navigation that is made when the site is built."""
    name = page.relative_to(ROOT / "docs").as_posix()
    nav = (ROOT / "mkdocs.yml").read_text(encoding="utf-8").partition("\nnav:\n")[2]
    made = name.startswith(("reference/", "gallery/")) or name == "documents.md"
    return made and f": {name}\n" in nav


def test_the_links_of_the_pages_lead_to_files():
    pages = [
        ROOT / "README.md",
        *(ROOT / "docs").rglob("*.md"),
        *(ROOT / "benchmarks").glob("*.md"),
        *(ROOT / "papers").rglob("*.md"),
    ]
    assert len(pages) > 2
    for page in pages:
        for link in re.findall(r"\]\(([^)#:]+)\)", page.read_text(encoding="utf-8")):
            target = page.parent / link
            made = target.resolve().is_relative_to(ROOT / "docs") and is_made(target.resolve())
            assert target.exists() or made, f"{page.name} links to {link}"


PACKAGE = ROOT / "src" / "allworlds"
PAGES = [
    ROOT / "README.md",
    ROOT / "corpus" / "README.md",
    *(ROOT / "docs").rglob("*.md"),
    *(ROOT / "benchmarks").glob("*.md"),
    *(ROOT / "papers").rglob("*.md"),
]

# What looks like the path of a file, and is one only on the reader's machine, or none.
ELSEWHERE = {
    "rooms.py",
    "mine.py",
    "robot.py",
    "my_explorer.py",
    "test_explorer.py",
    "path/to/file.py",
    "explorer.py",
    "mine/explorer.py",
    "test_conformance.py",
    "own_kind.py",
    "parity.py",
    "FILE.py",
    "test_properties.py",
    "src/mine.py",
}
NO_PATHS = {"application/json", "build/site"}


def paths_in(text):
    """Files and folders that a page names: anywhere by their ending, else in backticks."""
    text = re.sub(
        r"^```.*?^```$|\]\([^)]*\)|https?://\S+", "", text, flags=re.MULTILINE | re.DOTALL
    )
    named = set(re.findall(r"(?<![\w./-])(?:[\w-]+/)*[\w-]+\.(?:py|md|v)\b", text))
    for words in re.findall(r"`([^`]+)`", text):
        named |= {word for word in words.split() if re.fullmatch(r"([a-z_]+/)+([a-z_-]+)?", word)}
    return named - ELSEWHERE - NO_PATHS


NOT_MODULES = {"allworlds.h", "allworlds.toml"}


def modules_in(text):
    """Parts of the package that a page names, each with its full dotted path."""
    return set(re.findall(r"`(allworlds(?:\.[a-z_]\w*)+)", text)) - NOT_MODULES


def is_there(name):
    """Whether a name with dots can be imported, or is an attribute of what can."""
    module, _, attribute = name.rpartition(".")
    try:
        import_module(name)
    except ImportError:
        return bool(module) and is_there(module) and hasattr(found(module), attribute)
    return True


def found(name):
    """A module, or an attribute of one, by its name with dots."""
    module, _, attribute = name.rpartition(".")
    try:
        return import_module(name)
    except ImportError:
        return getattr(found(module), attribute)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_every_file_and_module_that_a_page_names_exists(page):
    text = page.read_text(encoding="utf-8")
    homes = (ROOT, PACKAGE, PACKAGE.parent, page.parent)
    missing = [name for name in paths_in(text) if not any((home / name).exists() for home in homes)]
    assert not missing, f"{page.name} names {', '.join(sorted(missing))}"
    missing = [name for name in modules_in(text) if not is_there(name)]
    assert not missing, f"{page.name} names {', '.join(sorted(missing))}"


def test_the_reader_of_paths_sees_stale_ones():
    text = "in (checker/pool.py), `judge/laws.py`, `reports/html` and `work/`, `0/1`, `mine.py`"
    assert paths_in(text) == {"checker/pool.py", "judge/laws.py", "reports/html", "work/"}
    assert modules_in("`allworlds.maps.x(...)`, `allworlds check`") == {"allworlds.maps.x"}
    assert is_there("allworlds.maps.counting.rooted_maps")
    assert not is_there("allworlds.studies.check.pool")
    assert not is_there("allworlds.pool.x")


def test_the_page_of_verdicts_lists_every_law_in_the_order_of_precedence():
    page = (ROOT / "docs" / "verdicts.md").read_text(encoding="utf-8")
    laws = page.partition("## Laws")[2].partition("##")[0]
    assert tuple(re.findall(r"^- `([a-z0-9-]+)`: ", laws, re.MULTILINE)) == PRECEDENCE


@pytest.mark.parametrize("page", ["protocol.md", "verdicts.md"])
def test_no_cell_of_a_table_is_a_paragraph(page):
    lines = (ROOT / "docs" / page).read_text(encoding="utf-8").splitlines()
    cells = [cell for line in lines if line.startswith("|") for cell in line.split("|")]
    assert [cell for cell in cells if len(cell.split()) > 24] == []


def test_the_page_of_verdicts_names_every_witness_that_is_required():
    page = (ROOT / "docs" / "verdicts.md").read_text(encoding="utf-8")
    witnesses = page.partition("## Witnesses")[2].partition("##")[0]
    named = set(re.findall(r"^- `([a-z0-9A-Z-]+)`: ", witnesses, re.MULTILINE))
    assert named == {"loop-edge", "parallel-edge", *BUILT_IN["algorithm1"].witnesses}
