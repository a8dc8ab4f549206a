"""Every kind of page: what it shows is the result's, and it keeps within its bounds."""

import pytest

from html_tree import read
from reports.web import test_kinds as quick
from reports.web.test_kinds import WALKS

finding = quick.finding
pages = quick.pages
results = quick.results

pytestmark = pytest.mark.usefixtures("compiled")  # for worst


@pytest.mark.parametrize("verb", WALKS)
def test_a_page_is_one_small_file_with_a_walk_to_step_along(verb, pages):
    page = pages[verb]
    assert len(page.encode()) < 1_000_000
    root = read(page)
    assert root.one("h1").text.startswith(f"allworlds {'check' if verb == 'fuzz' else verb}: ")
    assert [*root.all(class_="viewer")]
    ids = [node.attributes["id"] for node in root.all() if "id" in node.attributes]
    assert len(ids) == len(set(ids))
    for node in root.all():
        for name, value in node.attributes.items():
            assert name == "xmlns" or "//" not in value


@pytest.mark.parametrize("verb", WALKS)
def test_every_step_of_every_walk_is_at_a_dart_of_each_picture(verb, pages):
    for viewer in read(pages[verb]).all(class_="viewer"):
        frames = [n for n in viewer.all("div") if "data-follows" in n.attributes]
        assert frames
        for drawn in frames:
            darts = {
                g.attributes["data-dart"] for g in drawn.all("g") if "data-dart" in g.attributes
            }
            for item in viewer.all("li"):
                assert item.attributes[f"data-{drawn.attributes['data-follows']}"] in darts
