"""Figures: their content against other roads to it, their captions, their files."""

import csv
from collections import defaultdict
from fractions import Fraction
from pathlib import Path

import pytest
from allworlds.evidence.figures import FigureRequest, holes as fig3
from allworlds.evidence.figures.augmentation import figure_2
from allworlds.evidence.figures.bounds import figure_bounds
from allworlds.evidence.figures.figure_table import FIGURES, Figure
from allworlds.evidence.figures.holes import PLACES, figure_3
from allworlds.evidence.figures.twins import CAPTION, figure_1
from allworlds.studies.optimum import optimum
from msgspec import structs

from allworlds import figure, run
from allworlds.document import replace
from allworlds.engines import Limits, Silent
from allworlds.inputs import InputError
from allworlds.judging import paper_bound, printed_bound
from allworlds.outcome import Interrupted, Verdict
from allworlds.world import World, map_of_family


def verdict_of(drawn):
    """The verdict of a figure that shows this."""
    file = Path("figure")
    told = {"caption": ("So.",), "columns": ("edges",), "rows": 0}
    return Figure(figure="1", path=file, data=file, drawn=drawn, **told).verdict


# ---------------------------------------------------------------- Fig. 1


def test_the_pair_is_the_papers_and_senses_what_its_caption_says():
    pair = figure_1()
    assert verdict_of(pair) is Verdict.HOLDS
    header, rows = pair.table()
    sensed = [dict(zip(header, row, strict=True)) for row in rows]
    assert [step["motion"] for step in sensed] == [None, 1, 1, 2, 2, 1]
    for side in ("left", "right"):
        seen = [(step[f"{side}_degree"], step[f"{side}_marks"]) for step in sensed]
        assert tuple(seen[1:]) == CAPTION


def test_a_pair_that_senses_something_else_or_can_be_told_apart_is_refuted():
    from allworlds import twins
    from allworlds.world import world_named

    pair = figure_1()
    (dart, percept), *rest = pair.walks[0][::-1]
    odd = [*rest[::-1], (dart, replace(percept, marks=0))]
    assert verdict_of(replace(pair, walks=(odd, pair.walks[1]))) is Verdict.REFUTED
    apart = twins(world_named("k4"), world_named("wheel-4"))
    assert verdict_of(replace(pair, compared=apart)) is Verdict.REFUTED


# ---------------------------------------------------------------- Fig. 2


def test_each_pass_explores_one_edge_and_keeps_the_papers_books():
    shown = figure_2()
    assert verdict_of(shown) is Verdict.HOLDS
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


@pytest.fixture(scope="module")
def small():
    """Two graphs of the two smallest sizes."""
    ladders = {"lattice": ("lattice:3x3", "lattice:4x4"), "dense": ("dense:5",)}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(fig3, "LADDERS", ladders)
        patch.setattr(fig3, "WHO", (("algorithm1", "fifo"), ("algorithm1", "lifo"), ("greedy", "")))
        yield figure_3(2, 5, Limits(), Silent())


def test_every_run_is_one_in_the_world_of_that_name_under_that_policy(small):
    assert verdict_of(small) is Verdict.NOT_REFUTED
    header, rows = small.table()
    assert {(row[4], row[3]) for row in rows} == {
        (f"{text} --holes 10% --seed {seed}", name)
        for text in ("lattice:3x3", "lattice:4x4", "dense:5")
        for seed in (5, 6)
        for name in ("algorithm1, fifo", "algorithm1, lifo", "greedy")
    }
    for row in rows:
        told = dict(zip(header, row, strict=True))
        text, _, holes, _, seed = told["world"].split()
        world = World(map_of_family(text, holes, int(seed)))
        name, _, policy = told["explorer"].partition(", ")
        again = run(name, world, policy=policy or "fifo", place=told["place"]).outcome
        assert again.cost == told["traversals"]
        assert again.bound == told["bound_1_plus_2"]
        assert told["twice_the_edges"] == 2 * world.map.edge_count


def test_every_direction_of_the_marker_is_run_or_as_many_as_the_caption_says(small):
    for row in small.growth.rows:
        for one in row.members:
            assert len(set(one.ran)) == min(PLACES, one.places)
    assert any(one.places > 1 for row in small.growth.rows for one in row.members)
    assert f"at most {PLACES} directions of the marker" in small.caption()[0]


def test_the_printed_bound_lacks_what_the_paper_leaves_out():
    for n, m in ((2, 1), (3, 7), (144, 238)):
        left_out = 5 * m * n - 2 * m + Fraction(11 * n, 6)
        assert printed_bound(n, m) + left_out == paper_bound(n, m)
    assert printed_bound(2, 1) < 0


def test_the_caption_tells_when_a_mean_lies_below_twice_the_edges(small):
    row = small.growth.rows[0]
    for times, told in ((1, "some means lie below it"), (3, "every mean lies above it")):
        members = tuple(
            structs.replace(one, costs=(times * row.edges,) * len(one.costs)) for one in row.members
        )
        growth = structs.replace(small.growth, rows=(structs.replace(row, members=members),))
        assert any(told in said for said in replace(small, growth=growth).caption())


@pytest.mark.no_cover
def test_an_interrupted_figure_is_drawn_as_far_as_it_came(small, monkeypatch, tmp_path):
    none = structs.replace(small.growth, ending=Interrupted(), rows=())
    monkeypatch.setattr(
        "allworlds.evidence.figures.figure_table.figure_3", lambda *_: replace(small, growth=none)
    )
    told = figure("3", out=str(tmp_path / "f.svg"))
    assert told.exit_code == 130
    assert told.to_json()["rows"] == 0


# ---------------------------------------------------------------- the bound


@pytest.fixture(scope="module")
def cells():
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr("allworlds.evidence.figures.bounds.MOST_FAR", 2)
        return figure_bounds(3, Limits(), Silent())


def test_the_optimum_of_all_sizes_together_is_no_less_than_that_of_each(cells):
    assert verdict_of(cells) is Verdict.HOLDS
    largest = defaultdict(int)
    for cell in cells.cells:
        largest[cell.edges] = max(largest[cell.edges], cell.optimum)
    for row in optimum(edges=3).rows:
        assert largest[row.edges] <= row.optimum
    # Whoever knows m and n has no better worst case here than who knows m.
    assert largest == {1: 0, 2: 1, 3: 4}


def test_a_worst_case_above_the_bound_or_below_the_optimum_is_refuted(cells):
    for spoilt in ({"worst": 10**6}, {"worst": 0, "best": 0}, {"optimum": 10**6}):
        wrong = (replace(cells.cells[-1], **spoilt), *cells.cells[:-1])
        assert verdict_of(replace(cells, cells=wrong)) is Verdict.REFUTED
    for spoilt in ({"cost": 95}, {"cost": 10**6}):
        wrong = (replace(cells.corridors[0], **spoilt), *cells.corridors[1:])
        assert verdict_of(replace(cells, corridors=wrong)) is Verdict.REFUTED
    some = structs.replace(cells.report, ending=Interrupted())
    assert verdict_of(replace(cells, report=some)) is Verdict.INCONCLUSIVE
    disagrees = structs.replace(cells.report.rows[0], worlds=7)
    error = structs.replace(cells.report, rows=(disagrees,))
    assert verdict_of(replace(cells, report=error)) is Verdict.ERROR


def test_the_costs_against_the_adversary_stand_in_the_table(cells):
    header, rows = cells.table()
    first, second = (dict(zip(header, row, strict=True)) for row in rows[-2:])
    # docs/explorers.md, the table of the adversary.
    assert (first["edges"], first["vertices"], first["adversary"]) == (28, 4, 882)
    assert first["testers_at_least"] == 96
    assert (second["far_hubs"], second["edges"], second["adversary"]) == (2, 91, 11735)


def test_nothing_known_is_drawn_as_nothing(cells, monkeypatch, tmp_path):
    empty = replace(cells, cells=())
    monkeypatch.setattr("allworlds.evidence.figures.figure_table.figure_bounds", lambda *_: empty)
    told = figure("bounds", out=str(tmp_path / "f.png"))
    assert told.caption == ("Interrupted before anything was known.",)


# ---------------------------------------------------------------- files


def test_a_panel_is_drawn_for_each_size_and_one_for_corridors(small, cells, monkeypatch, tmp_path):
    pytest.importorskip("matplotlib")
    for name, drawn in (("3", small), ("bounds", cells)):
        monkeypatch.setattr(
            f"allworlds.evidence.figures.figure_table.figure_{name}", lambda *_, drawn=drawn: drawn
        )
        shown = figure(name, out=str(tmp_path / f"{name}.svg")).path.read_text(encoding="utf-8")
        if name == "bounds":
            assert all(f">n = {vertices}<" in shown for vertices in (1, 2, 3, 4))
            assert ">corridors<" in shown
        else:
            assert "algorithm1, lifo" in shown


@pytest.mark.slow
@pytest.mark.parametrize("name", ["1", "2", "3", "bounds"])
def test_a_figure_is_the_same_each_time_and_its_data_stand_beside_it(
    name, small, cells, monkeypatch, tmp_path
):
    monkeypatch.setattr("allworlds.evidence.figures.figure_table.figure_3", lambda *_: small)
    monkeypatch.setattr("allworlds.evidence.figures.figure_table.figure_bounds", lambda *_: cells)
    told = [figure(name, out=str(tmp_path / f"{i}.svg")) for i in range(2)]
    first, second = (one.path.read_text(encoding="utf-8") for one in told)
    assert first == second
    assert "<svg" in first
    with told[0].data.open(encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    document = told[0].to_json()
    assert (document["columns"], document["rows"]) == (header, len(rows))
    assert document["path"].endswith("0.svg")
    assert document["data"].endswith("0.csv")
    assert told[0].exit_code == 0


@pytest.mark.parametrize(
    ("name", "options", "said"),
    [
        ("4", {}, "'4' is not one of 1, 2, 3, bounds"),
        ("1", {"out": "x.gif"}, "x.gif"),
        ("1", {"worlds": 3}, "worlds 3 has no effect"),
        ("3", {"worlds": 0}, "worlds = 0"),
        ("3", {"seed": -1}, "seed = -1"),
        ("3", {"edges": 4}, "edges 4 has no effect"),
        ("bounds", {"edges": 99}, "edges = 99"),
        ("3", {"workers": 0}, "workers 0"),
    ],
)
def test_bad_input_is_named(name, options, said):
    with pytest.raises(InputError, match=said):
        figure(name, **options)


def test_without_what_draws_nothing_is_computed(refused, monkeypatch, tmp_path):
    monkeypatch.setattr("allworlds.inputs.checks.find_spec", lambda _: None)
    said = refused("paper", "figure", "1", "--out", tmp_path / "f.svg")
    assert ".[figures]" in said


def test_a_file_that_cannot_be_written_is_named_before_anything_is_computed(refused):
    assert "/nowhere/f.svg" in refused("paper", "figure", "3", "--out", "/nowhere/f.svg")


def test_the_command_tells_the_caption(cli, tmp_path):
    code, out, _ = cli("paper", "figure", "2", "--out", tmp_path / "f.pdf")
    assert code == 0
    assert out.startswith("HOLDS")
    assert "cube" in out
    _, line, _ = cli("paper", "figure", "2", "--out", tmp_path / "f.pdf", "-q")
    assert line == f"HOLDS: figure 2 in {tmp_path}/f.pdf, its data in {tmp_path}/f.csv\n"
    assert (tmp_path / "f.pdf").read_bytes().startswith(b"%PDF")


def test_a_figure_goes_where_its_name_says_if_nobody_says():
    assert [str(path) for path in FigureRequest("2").files] == ["figure-2.svg", "figure-2.csv"]


def test_a_complete_growth_has_come_to_its_end(small):
    assert small.growth.complete
    assert set(FIGURES) == {"1", "2", "3", "bounds"}
