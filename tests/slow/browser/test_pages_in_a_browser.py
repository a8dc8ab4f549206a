"""Pages as a reader has them: in Chromium, with keys, slider and play, on a desk and on a phone."""

import re
from pathlib import Path

import pytest

from allworlds import ledger, run, twins
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.maps import CombinatorialMap, family
from allworlds.reports.formats import file_of
from allworlds.studies.check.exhaustive import check
from allworlds.world import Directional, World, world_named
from small import slowest

axe = pytest.importorskip("axe_core_python.sync_playwright", reason="needs the extra 'browser'")


PAPER = Path(__file__).parents[3] / "papers" / "minimal_information"
DESK, PHONE = {"width": 1280, "height": 900}, {"width": 390, "height": 844}
GENUS_2 = CombinatorialMap((1, 2, 3, 4, 5, 6, 7, 0), (4, 5, 6, 7, 0, 1, 2, 3))


def told(map_):
    return file_of("html", run("algorithm1", World(map_, Directional(0), 0)))


def refuted(name):
    mutant = next(m for m in WRONG_EXPLORERS if m.name == name)
    return file_of("html", check(mutant.explorer(), edges=3))


PAGES = {
    "genus 0": lambda: told(world_named("k4", "directional").map),
    "genus 1": lambda: told(world_named("k4-torus", "directional").map),
    "genus 2": lambda: told(GENUS_2),
    "14 edges": lambda: told(family("random:14", holes=0, seed=1)),
    "a finding": lambda: refuted("wrong-entry-label"),
    "a check": lambda: file_of("html", check(edges=3)),
    "four findings": lambda: file_of(
        "html", check("algorithm1", lighthouse="position", edges=3, max_findings=4)
    ),
    "claims": lambda: file_of("html", ledger(PAPER, only=["cycles", "fig1"])),
    "twins": lambda: file_of(
        "html",
        twins(*(world_named(f"fig1-{side}", "position") for side in ("left", "right"))),
    ),
}


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    where = tmp_path_factory.mktemp("pages")
    made = {}
    for name, make in PAGES.items():
        made[name] = where / f"{name.replace(' ', '-')}.html"
        made[name].write_text(make(), encoding="utf-8")
    return made


@pytest.fixture
def shows(visit, files):
    """Opens a page."""
    return lambda name, size=DESK, **options: visit(files[name], size, **options)


def step(page):
    """The number of the step that is shown."""
    return int(re.match(r"Step (\d+) of", page.locator(".now").first.text_content())[1])


def robots(page):
    return page.eval_on_selector_all(
        ".viewer:first-of-type .here", "all => all.map((one) => one.dataset.dart)"
    )


@pytest.mark.slowest
def test_keys_step_along_the_walk_in_every_picture(shows):
    with shows("twins") as page:
        items = page.locator(".walk li")
        last = items.count() - 1
        assert step(page) == last
        page.locator(".viewer").focus()
        page.keyboard.press("Home")
        assert step(page) == 0
        for i in range(1, 5):
            page.keyboard.press("ArrowRight")
            item = items.nth(i)
            assert step(page) == i
            assert item.get_attribute("aria-current") == "step"
            assert robots(page) == [item.get_attribute(f"data-{w}") for w in ("robot", "b")]
            assert page.locator(".edge.last").count() == 2
        page.keyboard.press("ArrowLeft")
        assert step(page) == 3
        page.keyboard.press("End")
        assert step(page) == last


def test_buttons_the_slider_and_the_list_lead_to_a_step(shows):
    with shows("genus 1") as page:
        page.locator(".slider").fill("3")
        assert step(page) == 3
        page.get_by_role("button", name="Next").click()
        assert step(page) == 4
        page.get_by_role("button", name="First").click()
        assert step(page) == 0
        page.locator(".walk li .step").nth(2).click()
        assert step(page) == 2


def test_play_goes_on_by_itself_to_the_end_and_can_be_paused(shows, sync_api):
    with shows("genus 0") as page:
        page.locator(".slider").fill("0")
        page.locator(".speed").select_option("fast")
        play = page.locator(".play")
        play.click()
        assert play.text_content() == "Pause"
        now = page.locator(".now").first
        sync_api.expect(now).to_have_text(re.compile(r"^Step ([2-9]|\d\d) of"), timeout=60_000)
        play.click()
        assert play.text_content() == "Play"
        page.locator(".slider").fill(str(page.locator(".walk li").count() - 3))
        play.click()
        sync_api.expect(play).to_have_text("Play", timeout=60_000)
        assert step(page) == page.locator(".walk li").count() - 1


def test_what_the_explorer_knows_grows(shows):
    with shows("genus 1") as page:
        seen = []
        for at in (0, 10, 10_000):
            page.locator(".slider").fill(str(min(at, page.locator(".walk li").count() - 1)))
            seen.append(page.locator("#walk-1-known .edge:not(.later)").count())
        assert seen[0] == 0 < seen[1] < seen[2] == 6


def heights(page):
    """Of every number and name in a picture that is shown, in pixels of the screen."""
    return page.eval_on_selector_all(
        ".map text",
        """all => all.filter((one) => one.getClientRects().length)
           .map((one) => parseFloat(getComputedStyle(one).fontSize) * one.getScreenCTM().a)""",
    )


@pytest.mark.parametrize("size", [DESK, PHONE], ids=["desk", "phone"])
@pytest.mark.parametrize("name", ["genus 0", slowest("genus 1"), slowest("genus 2"), "14 edges"])
def test_what_is_written_in_pictures_is_large_enough_at_every_zoom(name, size, shows):
    with shows(name, size) as page:
        at_first = heights(page)
        assert len(at_first) > 8
        assert min(at_first) >= 11 - 0.01
        wide = page.locator(".map").first.bounding_box()["width"]
        for _ in range(3):
            page.get_by_role("button", name="Zoom in").click()
        assert page.locator(".map").first.bounding_box()["width"] > wide
        assert min(heights(page)) >= 11 - 0.01
        assert max(heights(page)) <= 12 + 0.01


def test_on_a_phone_there_is_one_picture_at_a_time_and_nothing_is_wider(shows):
    with shows("a finding", PHONE) as page:
        shown = page.locator(".viewer:first-of-type figure:visible")
        assert shown.count() == 1
        assert "The world" in shown.text_content()
        page.get_by_role("button", name="The answer").click()
        assert shown.count() == 1
        assert "The answer" in shown.text_content()
        assert page.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]
    with shows("a finding") as page:
        assert page.locator(".viewer:first-of-type figure:visible").count() == 2


def test_on_a_phone_the_picture_comes_before_what_is_told_of_it_and_is_seen_at_once(shows):
    with shows("a finding", PHONE) as page:
        picture = page.locator(".viewer:first-of-type .map:visible").first.bounding_box()
        buttons = page.locator(".controls").first.bounding_box()
        assert picture["y"] + picture["height"] <= buttons["y"]
        assert page.locator(".story").first.bounding_box()["y"] > buttons["y"]
    with shows("a finding") as page:
        story = page.locator(".story").first.bounding_box()
        for picture in page.locator(".viewer:first-of-type .map").all():
            box = picture.bounding_box()
            assert story["y"] < box["y"]
            assert box["y"] + box["height"] <= page.locator(".controls").first.bounding_box()["y"]


def test_pictures_without_a_walk_fit_their_boxes_and_sentences_are_flushed_left(shows):
    with shows("claims", {"width": 1200, "height": 900}) as page:
        frames = page.locator("figure .frame")
        assert frames.count() == 4
        for frame in frames.all():
            room, picture = frame.bounding_box(), frame.locator("svg").bounding_box()
            assert room["x"] <= picture["x"]
            assert picture["x"] + picture["width"] <= room["x"] + room["width"] + 1  # of rounding
        aligned = "all => all.map((cell) => getComputedStyle(cell).textAlign)"
        assert set(page.eval_on_selector_all("td, th", aligned)) == {"left"}
    with shows("a check") as page:
        assert set(page.eval_on_selector_all("td, th", aligned)) == {"right"}


def test_one_can_go_another_way_and_come_back(shows):
    with shows("a finding") as page:
        page.locator(".another summary").first.click()
        page.locator(".slider").first.fill("1")
        viewer = page.locator(".viewer").first
        offered = viewer.locator(".another button")
        at_first = robots(page)
        assert [text for text in offered.all_text_contents() if text.endswith("(as it did)")]
        other = next(b for b in offered.all() if not b.text_content().endswith("(as it did)"))
        gone = other.text_content()
        other.focus()
        page.keyboard.press("Enter")
        said = viewer.locator(".now").text_content()
        item = viewer.locator(".another li")
        assert said.startswith(f"Another way, step 2: {gone}; at v")
        assert item.count() == 1
        assert item.locator(".sensed").text_content() in said
        # The robot has gone in the picture of the world, and not in that of the answer.
        assert robots(page) == [item.get_attribute("data-robot"), *at_first[1:]]
        assert page.evaluate("document.activeElement.matches('.another button')")
        page.get_by_role("button", name="Back to step 1").click()
        assert step(page) == 1
        assert robots(page) == at_first
        assert viewer.locator(".another li").count() == 0


def test_to_go_as_the_explorer_did_leads_to_what_it_has_sensed(shows):
    with shows("genus 1") as page:
        page.locator(".slider").fill("0")
        page.locator(".another summary").click()
        for at in range(1, min(page.locator(".viewer > .walk li").count(), 16)):
            item = page.locator(".viewer > .walk li").nth(at)
            name = item.locator(".motion").text_content()
            page.get_by_role("button", name=re.compile(rf"^{name}\b")).first.click()
            other = page.locator(".another li").last
            for part in (".motion", ".place", ".sensed"):
                assert other.locator(part).text_content() == item.locator(part).text_content()
            assert other.get_attribute("data-robot") == item.get_attribute("data-robot")


def test_on_a_phone_another_way_is_gone_in_the_picture_of_the_world(shows):
    with shows("a finding", PHONE) as page:
        page.get_by_role("button", name="The answer").first.click()
        page.locator(".another summary").first.click()
        for _ in range(6):
            page.locator(".another button").first.click()
        figure = page.locator(".viewer:first-of-type figure:visible")
        assert "The world" in figure.text_content()
        assert page.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]


@pytest.mark.parametrize("name", PAGES)
@pytest.mark.parametrize("colours", ["light", slowest("dark")])
def test_contrast_and_roles_are_as_the_guidelines_ask(name, colours, shows):
    with shows(name, color_scheme=colours, bypass_csp=True) as page:
        for another in page.locator(".another summary").all():
            another.click()
            page.locator(".another button:visible").first.click()
        found = axe.Axe().run(page)["violations"]
        told = [(rule["id"], rule["nodes"][0]["html"][:200]) for rule in found]
        assert told == []


@pytest.mark.parametrize("name", PAGES)
def test_without_a_script_everything_is_there_to_be_read(name, shows):
    with shows(name, java_script_enabled=False) as page:
        for figure in page.locator("details[open] figure, section.finding > .viewer figure").all():
            assert figure.is_visible()
        assert name == "claims" or page.locator(".walk li").first.text_content()
        assert not page.locator(".controls:visible").count()


def test_on_paper_every_picture_is_there_and_no_button(shows):
    with shows("a finding") as page:
        page.emulate_media(media="print")
        assert page.locator(".viewer:first-of-type figure:visible").count() == 2
        assert not page.locator("button:visible").count()
