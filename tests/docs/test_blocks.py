"""Every block of every page does what the page says."""

import doctest
import shutil
from importlib.util import find_spec
from pathlib import Path

import pytest

from page_blocks import blocks, commands, shows, write
from shells import shell_in

ROOT = Path(__file__).parents[2]
PAGES = ["README.md", *sorted(p.relative_to(ROOT).as_posix() for p in ROOT.glob("docs/**/*.md"))]

RUN = ("sh", "console", "python", "pycon", "js")
"""Languages of blocks that are run; what is in another one is to be read."""

PROGRAMS = {"README.md": "mine.py"}
"""The file that a page's program is, where its blocks have no title."""

SLOW = {
    "README.md",
    "docs/how-to/ci.md",
    "docs/how-to/rows.md",
    "docs/python.md",
    "docs/theory.md",
    "docs/tutorial.md",
}
"""Pages whose commands take more than some seconds, or a compiler."""

SLOWEST = {
    "docs/ambiguity.md",
    "docs/how-to/bound.md",
    "docs/how-to/building.md",
    "docs/how-to/certificate.md",
    "docs/how-to/languages.md",
    "docs/how-to/lighthouse.md",
    "docs/how-to/pytest.md",
    "docs/how-to/refuted.md",
    "docs/how-to/shield.md",
    "docs/research/class.md",
    "docs/research/cost.md",
    "docs/research/sensor.md",
    "docs/research/sequence.md",
    "docs/research/task.md",
    "docs/robots.md",
}
"""Pages that are left to ``nox -s full``."""

ELSEWHERE = {
    "README.md": ("sh", "tests/project/test_readme.py compares these lines with what CI runs"),
}
"""Languages of a page whose blocks others look after."""

EXPLORER = '''"""Algorithm 1, as an explorer of one's own."""

from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first, *, choices):
    return (yield from algorithm1(first, choices=choices))
'''


def own_blocks(page):
    """The blocks of a page that are to be run here."""
    language, _ = ELSEWHERE.get(page, ("", ""))
    found = blocks((ROOT / page).read_text(encoding="utf-8"), *RUN)
    return [block for block in found if not block.reason and block.language != language]


@pytest.fixture
def shell(tmp_path):
    """A shell in a folder like a clone."""
    clone = tmp_path / "clone"
    clone.mkdir()
    for folder in ("benchmarks", "examples", "papers", "proofs"):
        (clone / folder).symlink_to(ROOT / folder)
    (clone / "my_explorer.py").write_text(EXPLORER)
    shutil.copy(ROOT / "corpus/findings/mirror-image.json", clone / "finding.json")
    return shell_in(clone, tmp_path / "bin")


@pytest.mark.parametrize(
    "page", [page for page in PAGES if own_blocks(page) and page not in SLOW | SLOWEST]
)
def test_every_block_of_the_page_does_what_the_page_says(page, shell, tmp_path, monkeypatch):
    clone = tmp_path / "clone"
    monkeypatch.chdir(clone)
    missing, names = set(), {}
    for block in own_blocks(page):
        lacks = {need for need in block.needs if not (shutil.which(need) or find_spec(need))}
        missing |= lacks
        if lacks:
            continue
        file = block.title or (PROGRAMS.get(page, "") if block.language == "python" else "")
        if file:
            write(clone / file, block.body)
        elif block.language == "pycon":
            examples = doctest.DocTestParser().get_doctest(block.body, names, page, None, 0)
            told = []
            run = doctest.DocTestRunner().run(examples, out=told.append, clear_globs=False)
            assert run.failed == 0, told
            names |= examples.globs
        elif block.language == "console":
            for command, expected in commands(block.body):
                done = shell(command)
                where = f"$ {command}\n{done.stdout}{done.stderr}"
                assert shows(expected, done.stdout.splitlines()), where
        else:
            assert block.language == "sh", f"{page} does not say which file this is: {block.body}"
            done = shell(f"set -e\n{block.body}")
            assert done.returncode == 0, f"{block.body}{done.stdout}{done.stderr}"
    if missing:
        pytest.skip(f"all was run but what needs {', '.join(sorted(missing))}")


def test_what_is_not_run_says_why():
    pages = {page: (ROOT / page).read_text(encoding="utf-8") for page in PAGES}
    reasons = {block.reason for text in pages.values() for block in blocks(text) if block.reason}
    usual = {
        "needs a cluster",
        "takes hours",
        "takes minutes",
        "needs Coq",
        "installs a package",
        "is a gate",
        "goes on until it is stopped",
    }
    assert reasons <= usual
    for page, text in pages.items():
        known = text.count("<!-- not run: ")
        assert known == sum(1 for block in blocks(text) if block.reason), page
    assert set(ELSEWHERE) | SLOW | SLOWEST | set(PROGRAMS) <= set(PAGES)


def test_the_comparison_of_outputs_sees_a_difference():
    assert shows(["a", "...", "c"], ["a", "b", "b", "c"])
    assert not shows(["a", "...", "c"], ["a", "b", "d"])
    assert not shows(["a"], ["a", "b"])
    assert shows(["a: ..."], ["a: b"])
    assert not shows(["a: ..."], ["a, b"])


def test_a_block_has_its_language_its_file_and_its_reason():
    text = '<!-- not run: needs Coq -->\n```sh\nmake\n```\n\n```python title="a.py"\nx\n```\n'
    text += "<!-- needs: cc make -->\n```console\n$ make\n```\n"
    first, second, third = blocks(text)
    assert (first.needs, third.needs) == ((), ("cc", "make"))
    assert (first.reason, first.language, first.body) == ("needs Coq", "sh", "make\n")
    assert (second.reason, second.title, second.language) == ("", "a.py", "python")
    assert blocks(text, "python") == [second]


def test_a_block_that_begins_and_ends_with_lines_of_the_file_replaces_what_is_between(tmp_path):
    file = tmp_path / "a.py"
    write(file, "a\nb\nc")
    write(file, "b\nx\nc")
    assert file.read_text() == "a\nb\nx\nc\n"
