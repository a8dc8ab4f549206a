"""The parts of the site of the documents; ``nox -s docs`` and CI build the site itself."""

import re
from pathlib import Path

import pytest

import allworlds
from allworlds import strategies, testing
from allworlds.verbs import VERBS
from docsite_modules import load

ROOT = Path(__file__).parents[2]
NAV = (ROOT / "mkdocs.yml").read_text(encoding="utf-8").partition("\nnav:\n")[2]


check = load("check")


def test_every_page_has_its_place_in_the_navigation():
    """A new page of ``docs`` stands in ``mkdocs.yml``, below ``nav``."""
    pages = {p.relative_to(ROOT / "docs").as_posix() for p in (ROOT / "docs").rglob("*.md")}
    pages = {page for page in pages if not page.startswith("decisions/")}
    named = set(re.findall(r"([\w/-]+\.md|[\w/-]+/)$", NAV, re.MULTILINE))
    folders = {name for name in named if name.endswith("/")}
    assert {page for page in pages if f"{Path(page).parent}/" not in folders} <= named
    made = {
        name
        for name in named
        if name.startswith(("reference/", "gallery/", "repository/")) or name == "documents.md"
    }
    assert named - made - folders <= pages


def test_the_names_of_pages_have_one_form_and_stand_on_the_pages():
    """Each names a thing: no sentence, no question; how-to and research pages begin with it."""
    titles = dict(re.findall(r"^ +- ([^:\n]+): ([\w/-]+\.md)$", NAV, re.MULTILINE))
    assert len(titles) > 20
    wrong = [title for title in titles if not re.fullmatch(r"[A-Z][\w ,]*|allworlds\.h", title)]
    assert wrong == []
    for title, name in titles.items():
        if name.startswith(("how-to/", "research/")):
            page = (ROOT / "docs" / name).read_text(encoding="utf-8")
            assert page.startswith(f"# {title}\n"), name


@pytest.mark.parametrize(
    "text",
    [
        '<script src="https://a.example/x.js"></script>',
        '<link rel="stylesheet" href="//a.example/x.css">',
        '<link rel="preconnect" href="https://a.example">',
        '<img src="http://a.example/x.png">',
        '<img srcset="x.png 1x, https://a.example/x.png 2x">',
        "<style>@import 'https://a.example/x.css';</style>",
        '<p style="background: url(https://a.example/x.png)">',
        '<iframe src="HTTPS://a.example"></iframe>',
        '<svg><image href="https://a.example/x.png"/></svg>',
    ],
)
def test_what_a_page_loads_from_another_host_is_seen(text, tmp_path):
    (tmp_path / "index.html").write_text(text)
    assert [line for line in check.faults(tmp_path) if "a.example" in line.lower()]


def test_a_page_that_loads_its_own_and_links_elsewhere_is_right_if_the_link_is_listed(tmp_path):
    page = '<script src="x.js"></script><link rel="canonical" href="https://b.example">'
    (tmp_path / "index.html").write_text(f'{page}<a href="https://a.example">a</a>')
    assert list(check.faults(tmp_path)) == [
        "index.html links to https://a.example, which reference/links.html does not list"
    ]
    (tmp_path / "reference").mkdir()
    (tmp_path / check.LISTED).write_text('<a href="https://a.example">a</a>')
    assert list(check.faults(tmp_path)) == []
    (tmp_path / "a.css").write_text("p { background: url('https://c.example/x.png') }")
    assert list(check.faults(tmp_path)) == ["a.css loads https://c.example/x.png"]


def test_a_folder_without_pages_is_no_site(tmp_path):
    assert list(check.faults(tmp_path)) == [f"{tmp_path} holds no page"]


def test_words_are_counted_without_bars_and_without_parts_that_a_program_writes():
    words = load("words")
    part = "<!-- t: written by p.py -->\n| no word |\n<!-- end of t -->\n"
    page = f"# One, two\n\n| three | 4 |\n|---|---|\n{part}```sh\nfive six\n```\n"
    assert words.words(page) == 7  # the block has its language, too
    assert words.prose(page) == 4
    by_hand = words.by_hand(ROOT)
    assert len(by_hand) <= 30
    assert sum(len(path.read_text(encoding="utf-8").split()) for path in by_hand) <= 25_000
    names = [path.relative_to(ROOT).as_posix() for path in by_hand]
    assert names[0] == "README.md"
    assert "docs/trust.md" in names


mkdocs = pytest.importorskip("mkdocs", reason="the extra docs is not installed")


def test_the_reference_of_the_command_line_has_every_verb_and_every_option():
    text = load("generated").command_line()
    for verb in VERBS:
        assert f"\n## {verb.name}\n" in text
    assert text.count("`--json`") >= len(VERBS)
    assert "`--edges M`" in text


def test_the_reference_of_the_package_has_every_name():
    text = load("generated").names()
    told = set(re.findall(r"^::: allworlds\.(\w+)$", text, re.MULTILINE))
    assert told | {
        "ambiguity",
        "claims",
        "maps",
        "robots",
        "strategies",
        "testing",
        "world",
        "__version__",
    } >= set(allworlds.__all__)
    whole = re.findall(r"^::: allworlds\.([\w.]+)$", text, re.MULTILINE)
    assert {f"testing.{name}" for name in testing.__all__} < {*whole}
    assert {f"strategies.{name}" for name in strategies.__all__} < {*whole}
    assert {"class_of", "census"} < {name.rpartition(".")[2] for name in whole}


def test_every_figure_that_a_page_asks_for_is_drawn_and_every_one_is_asked_for():
    pictures = load("pictures")
    pages = "".join(p.read_text(encoding="utf-8") for p in (ROOT / "docs").rglob("*.md"))
    assert set(pictures.FIGURE.findall(pages)) == set(pictures.FIGURES)
    for name in pictures.FIGURES:
        assert "<svg" in pictures.figure(name)
    with pytest.raises(Exception, match="figure 'x' is not one of map"):
        pictures.figure("x")


def test_a_link_out_of_the_folder_leads_to_a_page_of_the_site_or_is_a_name():
    links = load("links")

    def rewritten(text, page):
        return links.LINK.sub(lambda found: links._link(found, page), text)

    assert (
        rewritten("[p](../proofs/README.md#a)", "trust.md") == "[p](repository/proofs/README.md#a)"
    )
    assert (
        rewritten("[d](../docs/trust.md)", "repository/proofs/README.md") == "[d](../../trust.md)"
    )
    assert rewritten("[`t`](../tests/laws)", "trust.md") == "`t`"
    assert rewritten("[t](../tests/laws)", "trust.md") == "t (`tests/laws` in the repository)"
    assert rewritten("[o](live/x.html)", "gallery/walks.md") == "[o](live/x.html)"
    image = "![d](docs/assets/darts.svg)"
    assert rewritten(image, "repository/README.md") == "![d](../assets/darts.svg)"
    figure = "![f](figures/figure-1.svg)"
    assert rewritten(figure, "repository/papers/minimal_information/README.md") == figure
    assert rewritten("[x](../nowhere.md)", "trust.md") == "[x](../nowhere.md)"
    assert rewritten("[x](https://a.example)", "trust.md") == "[x](https://a.example)"
