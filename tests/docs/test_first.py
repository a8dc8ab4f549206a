"""The first explorers: README and tutorial print what is in ``examples/first``."""

from pathlib import Path

from page_blocks import blocks, write

ROOT = Path(__file__).parents[2]
FIRST = ROOT / "examples" / "first"


def page(name):
    return (ROOT / name).read_text(encoding="utf-8")


def test_the_readme_prints_the_first_explorer_and_what_is_mended_in_it():
    whole, mended = (block.body for block in blocks(page("README.md"), "python"))
    assert whole == page("examples/first/mine.py")
    comment, *_ = mended.splitlines(keepends=True)
    before, behind = whole.split(comment)
    rest = behind[behind.index("\n\n") + 1 :]
    assert before + mended + rest == page("examples/first/mended.py")


def test_the_tutorial_prints_the_second_explorer_and_how_it_is_mended(tmp_path):
    for block in blocks(page("docs/tutorial.md"), "python"):
        write(tmp_path / "robot.py", block.body)
    mended = (tmp_path / "robot.py").read_text(encoding="utf-8")
    assert mended.rstrip() == page("examples/first/robot.py").rstrip()


def test_the_landing_page_begins_with_two_sentences_and_the_picture_of_two_worlds():
    title, what, picture, *_ = page("docs/index.md").split("\n\n")
    assert title.startswith("# ")
    assert what.count(".") == 2
    assert "assets/refutation.svg" in picture
    assert all(f"examples/first/{name}.py" in page("docs/index.md") for name in ("mine", "mended"))
