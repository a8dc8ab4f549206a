"""Every kind of page: what it shows is the result's, and it keeps within its bounds."""

import json
import re

import pytest

from allworlds import Estimate, Move, explain, replay, run, search, twins, worst
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.maps import named_map
from allworlds.reports.content.ambiguity import letters
from allworlds.reports.formats import file_of
from allworlds.reports.web import sections as frame
from allworlds.reports.web.sections import LONGEST
from allworlds.studies.ambiguity import class_of, projection_of
from allworlds.studies.check.exhaustive import check
from allworlds.studies.check.report import most_expensive_runs
from allworlds.studies.compare.comparison import compare
from allworlds.world import Directional, World, world_named
from html_tree import read

pytestmark = pytest.mark.usefixtures("compiled")  # for worst

WALKS = [
    *("check", "fuzz", "run", "replay", "explain", "compare", "worst"),
    *("ambiguity twins", "ambiguity class", "ambiguity search"),
]
"""The verbs whose pages have walks to be stepped along."""


def mutant(name):
    return next(m for m in WRONG_EXPLORERS if m.name == name).explorer()


@pytest.fixture(scope="module")
def finding():
    (found,) = check(mutant("wrong-entry-label"), edges=2).findings
    return found


@pytest.fixture(scope="module")
def results(finding, tmp_path_factory):
    """A result of each kind of page."""
    figure_1 = [world_named(name, "position") for name in ("fig1-left", "fig1-right")]
    report = check(edges=2)
    return {
        "check": report,
        "fuzz": report,
        "run": run("algorithm1", "theta-torus"),
        "replay": replay(finding, mutant("wrong-entry-label")),
        "explain": explain(finding),
        "ambiguity twins": twins(*figure_1),
        "ambiguity class": class_of(world_named("k4", "position")),
        "ambiguity search": search(
            lighthouse="position",
            map_class="simple",
            vertices=4,
            edges=6,
            out=str(tmp_path_factory.mktemp("search")),
        ),
        "worst": worst(edges=2),
        "compare": compare("algorithm1", "folding", edges=2),
    }


@pytest.fixture(scope="module")
def pages(results):
    return {verb: file_of("html", result) for verb, result in results.items()}


def test_the_pages_document_is_the_results(results, pages):
    for verb in ("ambiguity twins", "ambiguity search", "worst", "explain"):
        held = json.loads(read(pages[verb]).one(id="report-json").text)
        assert held == results[verb].to_json()


def test_twins_are_walked_in_step_along_every_edge_of_both(results, pages):
    root = read(pages["ambiguity twins"])
    worlds = results["ambiguity twins"].worlds
    items = [*root.one("ol").all("li")]
    for world, follows in zip(worlds, ("data-robot", "data-b"), strict=True):
        trail = [int(item.attributes[follows]) for item in items]
        met = {*trail[1:], *(world.map.alpha[dart] for dart in trail[1:])}
        assert met == {*world.map.darts}
        shown = [str(world.percepts[dart]) for dart in trail]
        assert [item.one(class_="sensed").text for item in items] == [f"sensed: {s}" for s in shown]


def test_darts_have_the_same_letter_if_and_only_if_they_are_of_one_class(results, pages):
    root, worlds = read(pages["ambiguity twins"]), results["ambiguity twins"].worlds
    letter_of = {}
    for i in range(len(worlds)):
        for group in root.one(id=f"walk-1-{letters(i)}").all("g"):
            if "data-dart" in group.attributes:
                dart = int(group.attributes["data-dart"])
                colour = re.search(r"class-\d+", group.attributes["class"])[0]
                letter_of[i, dart] = group.one("tspan").text, colour
    for (i, dart), found in letter_of.items():
        for (j, other), shown in letter_of.items():
            classes = [projection_of(worlds[k]).classes[d] for k, d in ((i, dart), (j, other))]
            assert (classes[0] == classes[1]) == (found == shown)


def test_worlds_that_are_told_apart_are_walked_to_where_they_differ():
    pair = [world_named(name, "position") for name in ("k4", "k4-torus")]
    result = twins(*pair)
    root = read(file_of("html", result))
    assert "TOLD APART" in root.one("header").text
    items = [*root.one("ol").all("li")]
    assert len(items) == len(result.motions) + 1
    signs = [[*item.all(class_="misfits")] for item in items]
    assert [bool(sign) for sign in signs] == [False] * (len(items) - 1) + [True]


def test_a_search_without_twins_has_a_page_that_says_so(tmp_path):
    found = search(lighthouse="directional", vertices=2, edges=1, out=str(tmp_path))
    root = read(file_of("html", found))
    assert root.one(class_="verdict holds").text.startswith("NONE")
    assert not [*root.all(class_="viewer")]


def test_of_a_large_class_some_worlds_are_drawn():
    found = class_of(world_named("k4", "position"), map_class="maps")
    root = read(file_of("html", found))
    assert len([*root.all("figure")]) == min(6, found.size)
    assert (found.size > 6) == ("more worlds" in root.text)


def test_a_finding_that_is_mended_is_replayed_beside_what_was_recorded(finding):
    root = read(file_of("html", replay(finding, "algorithm1")))
    assert root.one(class_="verdict holds").text.startswith("FIXED")
    assert len([*root.all(class_="viewer")]) == 2


def test_of_a_check_that_holds_the_most_expensive_run_is_shown():
    for engine in ("python", "kernel"):
        report = check(edges=3, engine=engine)
        root = read(file_of("html", report))
        (viewer,) = root.one(id="most-expensive").all(class_="viewer")
        moves = [i for i in viewer.all("li") if "data-moved" in i.attributes]
        assert len(moves) == max(row.max_cost for row in report.rows)


def test_the_most_expensive_run_is_played_again_at_its_cost_whatever_counted():
    def most_expensive(engine):
        report = check(edges=3, engine=engine)
        return [
            (r.world.map.edge_count, r.world.map.vertex_count, r.outcome.cost)
            for r in most_expensive_runs(report)
        ]

    by_python = most_expensive("python")
    assert by_python == most_expensive("kernel")
    assert by_python == [(row.edges, row.vertices, row.max_cost) for row in check(edges=3).rows]


def test_an_explorer_that_no_name_leads_to_has_a_page_without_the_most_expensive_run():
    def explore(first):
        answer = yield from mutant("walks-too-much")(first)
        return answer

    root = read(file_of("html", check(explore, edges=1, bound="none")))
    assert not [*root.all(id="most-expensive")]


def test_a_page_that_would_be_too_large_leaves_its_document_out(monkeypatch):
    told = run("algorithm1", "theta")
    whole = len(file_of("html", told).encode())
    for room, held in ((whole, 1), (whole - 1, 0)):
        monkeypatch.setattr(frame, "LARGEST", room)
        root = read(file_of("html", told))
        assert len([*root.all(id="report-json")]) == held
    assert "--json prints it" in root.one("footer").text


def test_of_a_long_walk_the_first_steps_are_told():
    def explore(first):
        for _ in range(LONGEST + 10):
            yield Move(0)
        return Estimate(named_map("edge"), 0)

    told = run(explore, World(named_map("edge"), Directional(0), 0), step_budget=5000, bound="none")
    root = read(file_of("html", told))
    assert len([*root.one("ol").all("li")]) == LONGEST
    assert f"of {LONGEST + 10:,} steps" in root.text


def test_letters_go_on_after_z():
    assert [letters(n) for n in (0, 25, 26, 27, 26 + 26 * 26)] == ["a", "z", "aa", "ab", "aaa"]


def test_a_walk_of_one_move_is_shown_in_its_picture():
    told = run("algorithm1", "edge")
    assert told.outcome.cost == 1
    keys = [
        key.attributes["class"]
        for key in next(read(file_of("html", told)).all("p", class_="legend")).all("span")
    ]
    assert [key.removeprefix("key ").removesuffix("-key") for key in keys] == [
        *("turn", "robot", "walked", "trail", "last", "marked", "pointed", "start"),
    ]
