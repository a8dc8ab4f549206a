"""The search of the site of the documents, from the disk: small pages under its settings."""

import shutil

import pytest

from docs.test_site import ROOT

pytest.importorskip("mkdocs", reason="the extra docs is not installed")


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    from mkdocs.commands.build import build
    from mkdocs.config import load_config

    where = tmp_path_factory.mktemp("site")
    shutil.copytree(ROOT / "docs" / "assets", where / "docs" / "assets")
    for name, text in (("index", "Nothing."), ("lighthouses", "The keeper sees a walrus.")):
        (where / "docs" / f"{name}.md").write_text(f"# The page of {name}\n\n{text}\n")
    changed = {"docs_dir": str(where / "docs"), "site_dir": str(where / "built"), "hooks": []}
    config = load_config(str(ROOT / "mkdocs.yml"), **changed)
    config.nav = None
    build(config)
    return where / "built"


@pytest.mark.slowest
def test_a_word_is_found_from_the_disk(site, visit):
    with visit(site / "index.html") as page:
        page.locator("input.md-search__input").click()
        page.locator("input.md-search__input").press_sequentially("walrus")
        found = page.locator("a.md-search-result__link").first
        found.wait_for()
        assert "The page of lighthouses" in found.inner_text()
        found.click()
        page.wait_for_url("**/lighthouses.html*")
