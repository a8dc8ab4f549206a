"""The game as a reader plays it: walk by clicks and keys, conclude, claim, uncover the world."""

import pytest

from allworlds.reports.web.play import game as game_page
from allworlds.studies.run import play

# A leaf, where the marker is, and a vertex with two loops that cross.
WORLD = (
    '{"sigma":[0,2,3,4,5,1],"alpha":[1,0,4,5,2,3],"start":0,'
    '"lighthouse":{"kind":"directional","dart":0}}'
)


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    made = tmp_path_factory.mktemp("play") / "play.html"
    made.write_text(game_page(play(WORLD)), encoding="utf-8")
    return made


@pytest.fixture
def game(visit, file):
    with visit(file) as page:
        yield page


def button(page, name):
    return page.get_by_role("button", name=name, exact=True)


def told(page, name):
    return page.locator(f"#{name}").text_content()


def conclude(page, one, other):
    """Two darts of the notes are one."""
    for place, dart in (one, other):
        button(page, f"place {place}, dart {dart}").locator("circle").click()


def test_keys_and_clicks_on_darts_walk(game):
    assert told(game, "sensed-words") == "You sense: degree 1, marked, bearing 0."
    game.keyboard.press("0")
    assert told(game, "sensed-words") == "You sense: degree 5."
    button(game, "move 1").locator("circle").click()
    button(game, "move 0: back").focus()
    game.keyboard.press("Enter")
    assert game.locator("#log li").all_text_contents() == [
        "start: degree 1, marked, bearing 0",
        "move 0: degree 5",
        "move 1: degree 5",
        "move 0: degree 5",
    ]
    assert told(game, "cost") == "Traversals so far: 3."
    game.keyboard.press("5")  # there are only five darts
    assert game.locator("#log li").count() == 4


def test_what_cannot_be_is_told_and_can_be_taken_back(game):
    game.keyboard.press("0")
    assert game.locator("#undo").is_disabled()
    conclude(game, (0, 0), (1, 0))
    assert "degrees 1 and 5" in told(game, "notes-words")
    assert game.locator("#claim").is_disabled()
    game.locator("#undo").click()
    assert "4 darts are open" in told(game, "notes-words")


DIRECTIONS = """
() => {
  const middle = (of) => {
    const { x, y, width, height } = of.getBoundingClientRect();
    return [x + width / 2, y + height / 2];
  };
  const angles = (darts, centre) => darts.map((dart) => {
    const [x, y] = middle(dart.querySelector("circle"));
    return Math.round((180 / Math.PI) * Math.atan2(y - centre[1], x - centre[0]));
  });
  const sensed = document.querySelector("#sensed svg");
  const here = document.querySelector(".note-dart.robot-here").getAttribute("aria-label");
  const [, place, back] = here.match(/place (\\d+), dart (\\d+)/).map(Number);
  const mine = [...document.querySelectorAll(`.note-dart[aria-label^="place ${place},"]`)];
  const disc = [...document.querySelectorAll("#notes .vertex")]
    .find((one) => one.textContent === String(place));
  const notes = angles(mine, middle(disc.querySelector("circle")));
  const exits = [...sensed.querySelectorAll(".exit")];
  const own = angles(exits, middle(sensed.querySelector(".vertex circle")));
  return own.map((angle, k) => [angle, notes[(back + k) % notes.length]]);
}
"""
"""Of each dart where the robot stands the direction in what is sensed, and that in the notes."""


def test_both_panels_have_one_orientation(game):
    def turned():
        return [abs((one - other + 180) % 360 - 180) for one, other in game.evaluate(DIRECTIONS)]

    assert max(turned()) <= 2
    for key in "0121":
        game.keyboard.press(key)
        assert max(turned()) <= 2
    conclude(game, (3, 0), (1, 3))
    assert max(turned()) <= 2


def walked_loops(game):
    for key in "011":
        game.keyboard.press(key)


def test_a_wrong_conclusion_that_fits_is_a_guess(game):
    walked_loops(game)
    conclude(game, (2, 0), (1, 2))
    conclude(game, (3, 0), (1, 4))
    assert "your map is complete" in told(game, "notes-words")
    game.locator("#claim").click()
    assert "it is another world: you have guessed" in told(game, "outcome")


def test_the_right_conclusion_is_right_and_tells_what_it_cost(game):
    walked_loops(game)
    conclude(game, (2, 0), (1, 3))
    assert game.locator("#claim").is_disabled()
    conclude(game, (3, 0), (1, 2))
    game.locator("#claim").click()
    assert told(game, "outcome").startswith("Right: this is the world")
    assert told_costs(game)["you"] == "3"
    # Whoever walks on has not claimed what comes then.
    game.keyboard.press("0")
    assert not game.locator("#costs").is_visible()


def told_costs(page):
    """The table of costs, once it is seen."""
    assert page.locator("#costs").is_visible()
    rows = page.locator("#cost-rows tr").all()
    return dict(row.locator("td").all_text_contents() for row in rows)


def test_the_costs_stand_beside_ones_own_when_the_world_is_uncovered(game):
    assert not game.locator("#costs").is_visible()
    walked_loops(game)
    assert not game.locator("#costs").is_visible()
    game.locator("#uncover").click()
    made = play(WORLD)
    others = {"Algorithm 1": str(made.algorithm1), "the bound of this world": "17"}
    assert told_costs(game) == {"you": "3", **others}
    game.keyboard.press("0")
    assert told_costs(game)["you"] == "4"
    game.locator("#restart").click()
    assert not game.locator("#costs").is_visible()


def middles(page):
    """Where the places of the notes are in the drawing, by their numbers."""
    return page.eval_on_selector_all(
        "#notes .vertex",
        "all => Object.fromEntries(all.map((one) => {"
        " const disc = one.querySelector('circle');"
        " return [one.textContent, [disc.getAttribute('cx'), disc.getAttribute('cy')]]; }))",
    )


def in_frame(page, selector):
    """How many of these are seen whole in the frame of the notes, and how many there are."""
    room = page.locator("#notes").bounding_box()
    boxes = [one.bounding_box() for one in page.locator(selector).all()]
    seen = [
        room["x"] <= box["x"]
        and box["x"] + box["width"] <= room["x"] + room["width"]
        and room["y"] <= box["y"]
        and box["y"] + box["height"] <= room["y"] + room["height"]
        for box in boxes
    ]
    return sum(seen), len(seen)


@pytest.mark.slowest
def test_places_stay_where_they_are_and_fifteen_are_seen_at_once(visit, tmp_path):
    page_file = tmp_path / "play.html"
    page_file.write_text(game_page(play("torus:4x4", seed=3)), encoding="utf-8")
    with visit(page_file) as page:
        before = middles(page)
        for key in "12312312312312":
            page.keyboard.press(key)
            now = middles(page)
            assert {name: now[name] for name in before} == before
            before = now
        assert len(before) == 15
        assert in_frame(page, "#notes .vertex circle") == (15, 15)
        for key in "123" * 20:
            page.keyboard.press(key)
        # Larger notes stay readable, and the robot is seen in them.
        (size,) = page.eval_on_selector_all(
            "#notes svg", "all => all.map((one) => one.clientWidth / one.viewBox.baseVal.width)"
        )
        assert size >= 0.54
        assert in_frame(page, "#notes .robot-here circle") == (1, 1)


def test_the_world_is_seen_when_it_is_uncovered_and_not_before(game):
    assert not game.locator("#played").is_visible()
    walked_loops(game)
    game.locator("#uncover").click()
    picture, room = game.locator("#played"), game.locator("#world .frame").first
    assert picture.is_visible()
    assert not game.locator("#uncover").is_visible()
    assert picture.bounding_box()["width"] <= room.bounding_box()["width"]
    assert game.locator("#played .edge.walked").count() == 3
    here = game.locator("#played .here")
    assert [here.count(), here.get_attribute("data-dart")] == [1, "3"]
    seen = "all => all.filter((one) => getComputedStyle(one).display !== 'none').length"
    assert game.eval_on_selector_all("#played .robot", seen) == 1
    stroke = "one => getComputedStyle(one).stroke"
    walked = game.eval_on_selector("#played .edge.walked", stroke)
    game.locator("#restart").click()
    assert not picture.is_visible()
    assert game.locator("#log li").count() == 1
    assert told(game, "cost") == "Traversals so far: 0."
    game.locator("#uncover").click()
    assert game.eval_on_selector("#played .edge", stroke) != walked
    assert game.locator("#played .here").get_attribute("data-dart") == "0"


def test_nothing_is_wider_than_a_phone(visit, file):
    with visit(file, {"width": 390, "height": 844}) as page:
        walked_loops(page)
        page.locator("#uncover").click()
        assert page.evaluate("document.documentElement.scrollWidth") <= 390


def test_a_number_is_written_where_there_is_room_and_typed_digits_are_no_motions(visit, tmp_path):
    made = tmp_path / "board.html"
    made.write_text(game_page(play("theta", lighthouse="whiteboard:states=3")), encoding="utf-8")
    with visit(made) as page:
        number = page.get_by_label("The number to write")
        number.press("2")
        assert page.locator("#log li").count() == 1
        number.fill("2")
        button(page, "Write").click()
        number.fill("3")
        button(page, "Write").click()
        assert told(page, "outcome") == "That is not possible: the numbers are 0 to 2."
        assert page.locator("#log li").all_text_contents() == [
            "start: degree 3",
            "write 2: degree 3, marks 2",
        ]
        assert button(page, "Drop a marker").is_hidden()
    with visit(file_of(tmp_path, "directional")) as page:
        assert page.locator("#number").is_hidden()


def file_of(folder, kind):
    made = folder / f"{kind}.html"
    made.write_text(game_page(play("theta", lighthouse=kind)), encoding="utf-8")
    return made
