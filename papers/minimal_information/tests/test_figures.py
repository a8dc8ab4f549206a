"""Figures: their content against other roads to it, their captions, their files."""

import csv
import runpy
import sys
from fractions import Fraction
from itertools import islice

import pytest
from msgspec import structs

import figure_3 as fig3
import figures
from allworlds import World, ambiguity, run
from allworlds.documents.document import replace
from allworlds.maps import family, named_map
from drawn import write
from figure_1 import CAPTION, figure_1
from figure_2 import figure_2
from figure_3 import _explore, figure_3
from formulas import paper_bound, printed_bound
from paper_claims import PAPER

KEPT = PAPER / "figures"
means = runpy.run_path(str(KEPT / "means.py"))["means"]

# ---------------------------------------------------------------- Fig. 1


def test_the_pair_is_the_papers_and_senses_what_its_caption_says():
    pair = figure_1()
    assert pair.right
    header, rows = pair.table()
    sensed = [dict(zip(header, row, strict=True)) for row in rows]
    assert [step["motion"] for step in sensed] == [None, 1, 1, 2, 2, 1]
    for side in ("left", "right"):
        seen = [(step[f"{side}_degree"], step[f"{side}_marks"]) for step in sensed]
        assert tuple(seen[1:]) == CAPTION


def test_a_pair_that_senses_something_else_or_can_be_told_apart_is_refuted():
    pair = figure_1()
    (dart, percept), *rest = pair.walks[0][::-1]
    odd = [*rest[::-1], (dart, replace(percept, marks=0))]
    assert not replace(pair, walks=(odd, pair.walks[1])).right
    worlds = (World(named_map(name), "position") for name in ("k4", "wheel-4"))
    assert not replace(pair, compared=ambiguity.twins(*worlds)).right


# ---------------------------------------------------------------- Fig. 2


def test_each_pass_explores_one_edge_and_keeps_the_papers_books():
    shown = figure_2()
    assert shown.right
    map_ = shown.told.world.map
    for one in shown.passes:
        other = map_.alpha[one.e]
        assert one.added == {one.e, other}
        assert one.e in one.before.open
        new = one.after.vertices(map_) - one.before.vertices(map_)
        if one.is_loop:
            assert not new
            assert other in one.hypotheses
            assert one.after.open == one.before.open - {one.e, other}
        else:
            assert new == {map_.vertex_of[other]}
            entered = set(map_.vertices[map_.vertex_of[other]]) - {other}
            assert one.after.open == (one.before.open - {one.e}) | entered
        degrees = {map_.degree_at[dart] for dart in one.hypotheses}
        assert degrees == {map_.degree_at[other]}
    assert [one.is_loop for one in shown.passes] == [False, True]
    assert [row[1] for row in shown.table()[1]] == ["non-loop", "loop"]


# ---------------------------------------------------------------- Fig. 3


class Here:
    """This process in place of others."""

    map = staticmethod(map)

    def __init__(self, initializer):
        pass

    def shutdown(self, **_):
        pass

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass


@pytest.fixture
def holes(monkeypatch):
    """Figure 3 of these graphs and explorers, run in this process."""

    def made(ladders, who=fig3.WHO, **drawn):
        monkeypatch.setattr(fig3, "ProcessPoolExecutor", Here)
        monkeypatch.setattr(fig3, "LADDERS", ladders)
        monkeypatch.setattr(fig3, "WHO", who)
        return figure_3(**drawn)

    return made


@pytest.fixture
def small(holes):
    """Two graphs of the two smallest sizes."""
    ladders = {"lattice": ("lattice:3x3", "lattice:4x4"), "dense": ("dense:5",)}
    who = (("algorithm1", "fifo"), ("algorithm1", "lifo"), ("greedy", ""))
    return holes(ladders, who, worlds=2, seed=5)


def test_every_run_is_one_in_the_world_of_that_name_under_that_policy(small):
    assert small.right
    header, rows = small.table()
    assert {(row[4], row[3]) for row in rows} == {
        (f"{text} --holes 10% --seed {seed}", name)
        for text in ("lattice:3x3", "lattice:4x4", "dense:5")
        for seed in (5, 6)
        for name in ("algorithm1, fifo", "algorithm1, lifo", "greedy")
    }
    for row in rows:
        told = dict(zip(header, row, strict=True))
        text, _, _, _, seed = told["world"].split()
        world = World(family(text, holes=0.1, seed=int(seed)), "directional")
        name, _, policy = told["explorer"].partition(", ")
        again = run(_explore(name), world, policy=policy or "fifo", place=told["place"]).outcome
        assert again.cost == told["traversals"]
        assert paper_bound(world.map.vertex_count, world.map.edge_count) == told["bound_1_plus_2"]
        assert told["twice_the_edges"] == 2 * world.map.edge_count


def test_every_direction_of_the_marker_is_run_or_as_many_as_the_caption_says(small):
    degrees = set()
    for one in small.costs:
        text, _, _, _, seed = one.world.split()
        degree = family(text, holes=0.1, seed=int(seed)).degree_at[0]
        assert len(one.by_place) == min(small.places, degree)
        assert {*one.by_place} <= {*range(degree)}
        degrees.add(degree)
    assert max(degrees) > 1
    assert f"at most {small.places} directions of the marker" in small.caption()[0]


def test_after_ctrl_c_the_finished_sizes_are_drawn_in_all_panels(holes, monkeypatch, tmp_path):
    pytest.importorskip("matplotlib")
    walked, calls = fig3._costs, []

    def interrupted(*task):
        calls.append(task)
        if len(calls) == 6:
            raise KeyboardInterrupt
        return walked(*task)

    monkeypatch.setattr(fig3, "_costs", interrupted)
    ladders = {"lattice": ("lattice:3x3", "lattice:4x4"), "dense": ("dense:5",)}
    made = holes(ladders, (("algorithm1", "fifo"),), worlds=2, seed=5)
    # Two graphs of each family's smallest size, and one of the next size, which does not count.
    assert [(size.family, size.vertices, len(size.costs)) for size in made.sizes] == [
        ("lattice", 9, 2),
        ("dense", 5, 2),
    ]
    assert (made.complete, made.right) == (False, False)
    assert made.caption()[0] == "Interrupted: the finished sizes alone."
    assert not write(made, tmp_path / "3.svg")
    calls[:] = [None] * 5  # before anything is finished
    assert not write(holes(ladders, worlds=2), tmp_path / "3.svg")
    shown = (tmp_path / "3.svg").read_text(encoding="utf-8")
    assert all(shown.count(f">{title}<") == 2 for title in fig3.TITLES.values())


def test_a_run_that_breaks_a_law_is_told(small):
    wrong = replace(small.costs[0], right=False)
    assert not replace(small, costs=[wrong, *small.costs[1:]]).right


def test_the_printed_bound_lacks_what_the_paper_leaves_out():
    for n, m in ((2, 1), (3, 7), (144, 238)):
        left_out = 5 * m * n - 2 * m + Fraction(11 * n, 6)
        assert printed_bound(n, m) + left_out == paper_bound(n, m)
    assert printed_bound(2, 1) < 0


def test_the_caption_tells_when_a_mean_lies_below_twice_the_edges(small):
    for times, told in ((1, "some means lie below it"), (3, "every mean lies above it")):
        costs = [
            structs.replace(one, by_place=dict.fromkeys(one.by_place, times * one.edges))
            for one in small.costs
        ]
        assert any(told in said for said in replace(small, costs=costs).caption())


def test_the_means_of_the_figure_are_those_of_its_data(small):
    header, rows = small.table()
    lines = [dict(zip(header, map(str, row), strict=True)) for row in rows]
    names, *told = means(lines)
    found = [dict(zip(names, line, strict=True)) for line in told]
    assert [(f["edges"], f["explorer"], f["mean"]) for f in found] == [
        (str(size.edges), size.explorer, f"{size.mean:.2f}") for size in small.sizes
    ]


@pytest.mark.slow
def test_the_means_that_are_kept_are_those_of_the_program(holes):
    header, rows = holes({"lattice": ("lattice:4x4",)}, worlds=30, places=4).table()
    made = means(dict(zip(header, map(str, row), strict=True)) for row in rows)
    again = [[str(cell) for cell in line] for line in made]
    with (KEPT / "figure-3-means.csv").open(encoding="utf-8", newline="") as file:
        assert [*islice(csv.reader(file), len(again))] == again


# ---------------------------------------------------------------- files


def test_a_panel_is_drawn_for_each_family_with_each_explorer(small, tmp_path):
    pytest.importorskip("matplotlib")
    assert write(small, tmp_path / "3.svg")
    shown = (tmp_path / "3.svg").read_text(encoding="utf-8")
    assert all(name in shown for name in ("algorithm1, lifo", "lattices", "dense graphs"))


@pytest.mark.parametrize("name", ["1", "2"])
def test_a_figure_drawn_anew_is_the_one_that_is_kept(name, tmp_path):
    pytest.importorskip("matplotlib")
    assert write(figures.FIGURES[name](), tmp_path / f"figure-{name}.svg")
    for kind in ("svg", "csv"):
        file = f"figure-{name}.{kind}"
        assert (tmp_path / file).read_bytes() == (KEPT / file).read_bytes()


@pytest.mark.parametrize("name", ["1", "2"])
def test_a_caption_is_made_of_sentences(name):
    for sentence in figures.FIGURES[name]().caption():
        assert sentence[0].isupper()
        assert sentence[-1] == "."


def test_the_program_tells_the_caption_and_whether_the_figure_is_right(
    tmp_path, monkeypatch, capsys
):
    pytest.importorskip("matplotlib")
    monkeypatch.setattr(sys, "argv", ["figures.py", "2", "--out", str(tmp_path / "f.pdf")])
    assert figures.main() == 0
    assert "cube" in capsys.readouterr().out
    assert (tmp_path / "f.pdf").read_bytes().startswith(b"%PDF")
    pair = figure_1()
    wrong = replace(pair, walks=(pair.walks[0][:-1], pair.walks[1]))
    monkeypatch.setitem(figures.FIGURES, "2", lambda: replace(wrong, walks=(wrong.walks[0],) * 2))
    assert figures.main() == 1
