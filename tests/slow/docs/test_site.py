"""The parts of the site of the documents; ``nox -s docs`` and CI build the site itself."""

import pytest

from docsite_modules import load


def test_every_live_page_has_a_name_of_its_own_and_is_written_and_linked(tmp_path):
    pictures = load("pictures")
    names = [live.name for live in [*pictures.lives(), *pictures.walks()]]
    assert len(names) == len(set(names))
    text = pictures._walks(pictures.walks())
    for live in pictures.walks()[:3]:
        pictures._made(live, tmp_path)
        page = tmp_path / f"{live.name}.html"
        assert page.stat().st_size <= pictures.LARGEST
        assert "<svg" in page.read_text(encoding="utf-8")
        assert f"](live/{live.name}.html)" in text
    wrong = pictures.Live("x", "run no-world", "")
    with pytest.raises(Exception, match="run no-world ends with 2"):
        pictures._made(wrong, tmp_path)
