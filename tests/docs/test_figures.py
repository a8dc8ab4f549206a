"""The figure of the words: what it draws is true of its world, and the file is what is drawn."""

import csv
import importlib.util
import re
from cmath import phase
from math import isclose, tau
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

import allworlds
from allworlds.reports.drawing.layout import layout

ROOT = Path(__file__).parents[2]
PAPER = ROOT / "papers" / "minimal_information"


def beside(name, folder=ROOT / "docs"):
    """The module of a figure."""
    spec = importlib.util.spec_from_file_location(name, folder / "figures" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def darts():
    return beside("darts")


def test_its_arcs_go_clockwise_round_v0_from_the_robots_dart(darts):
    world, drawn = darts.WORLD, layout(darts.WORLD.map, darts.WORLD.start)
    centre = drawn.ways[0][0]
    arcs = {
        path.get("class").split()[1]: path
        for path in darts.figure().iter("path")
        if path.get("data-turn")
    }
    assert arcs["sigma"].get("data-turn") == f"0 {world.map.sigma[0]}"
    assert arcs["bearing"].get("data-turn") == f"0 {world.map.turn(0, world.first.bearing)}"
    for arc in arcs.values():
        x, y, _, _, _, large, sweep, u, v = map(float, re.findall(r"-?[\d.]+", arc.get("d")))
        begin, end = (phase(complex(*point) - centre) for point in ((x, y), (u, v)))
        start, goal = map(int, arc.get("data-turn").split())
        wanted = (darts.direction(drawn, goal) - darts.direction(drawn, start)) % tau
        assert sweep == 1  # with y downwards that is clockwise
        assert isclose((end - begin) % tau, wanted - 0.34, abs_tol=0.01)
        assert large == (wanted - 0.34 > tau / 2)


def test_its_sentences_are_true_of_its_world(darts):
    world, told = darts.WORLD, dict(darts.TOLD)
    assert f"here 0 to {world.map.darts[-1]}" in told["dart"]
    assert f"stands at dart {world.start}" in told["dart"]
    assert f"sigma(0) = {world.map.sigma[0]}" in told["sigma"]
    assert f"alpha(0) = {world.map.alpha[0]}" in told["alpha"]
    assert f"to v{world.map.vertex_of[world.map.alpha[0]]}" in told["alpha"]
    assert f"bearing {world.first.bearing}" in told["bearing"]


def test_the_file_says_what_the_command_draws(darts):
    drawn, file = darts.figure(), ET.parse(darts.FILE).getroot()
    assert ["".join(text.itertext()) for text in drawn.iter("text")] == [
        "".join(text.itertext()) for text in file.iter("{http://www.w3.org/2000/svg}text")
    ]
    assert "assets/darts.svg" in (ROOT / "docs/protocol.md").read_text(encoding="utf-8")


EXPLORERS = {
    "Algorithm 1, first in, first out": "algorithm1, fifo",
    "Algorithm 1, last in, first out": "algorithm1, lifo",
    "Algorithm 1, nearest": "algorithm1, nearest",
    "`dudek91`, a marker that can be carried": "dudek91, fifo",
    "`remembering`": "remembering, fifo",
    "`prudent`": "prudent",
    "`greedy`": "greedy",
}
"""The lines of the table of figure 3, and what the data call them."""


def test_the_table_of_figure_3_is_that_of_its_data():
    page = (PAPER / "README.md").read_text(encoding="utf-8").partition("### Fig. 3")[2]
    told = {
        name.strip(): [cell.strip(" *") for cell in cells]
        for name, *cells in re.findall(r"^\| (.*?) \| (.*?) \| (.*?) \|$", page, re.MULTILINE)
    }
    with (PAPER / "figures/figure-3-means.csv").open(encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["edges"] in ("238", "248")]
    assert [row["family"] for row in rows] == ["lattice"] * 7 + ["dense"] * 7
    means = {}
    for row in rows:
        mean, low, high = (f"{float(row[name]):,.0f}" for name in ("mean", "low", "high"))
        means.setdefault(row["explorer"], []).append(f"{mean} ({low}..{high})")
    assert {EXPLORERS[name]: told[name] for name in EXPLORERS} == means
    assert told["(1)+(2)"] == [f"{int(rows[i]['bound_1_plus_2']):,}" for i in (0, 7)]
    assert told["2m"] == [rows[i]["twice_the_edges"] for i in (0, 7)]


def test_means_are_of_all_runs_of_a_size():
    same = {"family": "f", "vertices": "2", "edges": "3", "bound_1_plus_2": "9"}
    runs = [
        {**same, "explorer": who, "world": world, "twice_the_edges": "6", "traversals": cost}
        for who, world, cost in (("a", "1", "1"), ("b", "1", "7"), ("a", "2", "3"), ("a", "2", "4"))
    ]
    means = beside("means", PAPER).means
    header, *lines = means(runs)
    assert lines == [
        ["f", "2", "3", "a", 2, 3, "2.25", "", "", "9", "6"],
        ["f", "2", "3", "b", 1, 1, "7.00", "", "", "9", "6"],
    ]
    many = [{**runs[0], "world": str(i), "traversals": str(10 + i % 4)} for i in range(20)]
    _, (*_, mean, low, high, _, _) = means(many)
    assert mean == "11.50"
    assert 10.8 < float(low) < 11.5 < float(high) < 12.2
    assert len(header) == 11


def texts(picture):
    """All texts of a picture, with those that only a screen reader says."""
    return ["".join(part.itertext()) for part in picture.iter() if part.tag.endswith(TEXTS)]


TEXTS = ("title", "desc", "text")


def test_the_picture_of_the_readme_is_the_finding_of_its_explorer():
    refutation = beside("refutation")
    finding = refutation.found()
    assert texts(refutation.figure(finding)) == texts(ET.parse(refutation.FILE).getroot())
    assert finding.law == "map"
    assert finding.minimal
    assert "docs/assets/refutation.svg" in (ROOT / "README.md").read_text(encoding="utf-8")


def test_in_the_picture_of_the_readme_an_edge_has_a_gap_where_another_crosses_it():
    file = (ROOT / "docs/assets/refutation.svg").read_text(encoding="utf-8")
    assert file.count('class="bridge"') == 2
    rules = {
        name: (re.search(r"stroke: (#\w+)", rule), re.search(r"stroke-width: (\d+)", rule))
        for name, rule in re.findall(r"^\.(bridge|edge) \{(.*)\}$", file, re.MULTILINE)
    }
    paper = re.search(r"rect\.paper \{ fill: (#\w+)", file)
    assert rules["bridge"][0][1] == paper[1] != rules["edge"][0][1]
    assert int(rules["bridge"][1][1]) > 3 * int(rules["edge"][1][1])


def test_another_finding_makes_another_picture():
    refutation = beside("refutation")
    found = allworlds.check("dudek91", edges=2).findings[0]
    assert texts(refutation.figure(found)) != texts(ET.parse(refutation.FILE).getroot())
