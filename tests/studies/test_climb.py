"""Cost by size: members that their names give back, runs that single runs confirm, exponents."""

import csv
import io
import json
import sys
from math import log

import pytest

from allworlds import compare, run
from allworlds.document import replace
from allworlds.engines import TimeIsUp, Unsettled
from allworlds.inputs import InputError
from allworlds.maps import edges_of
from allworlds.protocol import Estimate
from allworlds.reports import file_of
from allworlds.reports.growth_text import growth_csv, growth_text
from allworlds.studies.compare import Climb, GrowRow, Growth
from allworlds.studies.compare.growing_families import GROWING, members_of
from allworlds.world import FamilyWords
from kept_jobs import EXPLORERS


@pytest.fixture(scope="module")
def report():
    return compare("algorithm1", "greedy", family=["lattice", "thick"], to=50, worlds=2)


@pytest.mark.no_cover
def test_every_cost_is_that_of_a_single_run_in_the_world_of_that_name(report):
    for row in report.rows:
        for member, cost in zip(row.members, row.costs, strict=True):
            text, seed = member.split(" --seed ")
            world = FamilyWords(family=text, seed=int(seed)).world("directional")
            assert run(row.explorer, world).outcome.cost == cost
            assert (world.map.edge_count, world.map.vertex_count) == (row.edges, row.vertices)


def test_rows_stand_by_family_size_and_explorer_whoever_was_faster(report):
    names = [(row.family, row.edges, row.explorer) for row in report.rows]
    order = {"lattice": 0, "thick": 1, "algorithm1": 0, "greedy": 1}
    assert names == sorted(names, key=lambda key: (order[key[0]], key[1], order[key[2]]))
    again = compare("algorithm1", "greedy", family=["lattice", "thick"], to=50, worlds=2, workers=2)
    assert again.rows == report.rows


@pytest.mark.parametrize("name", GROWING)
def test_the_sizes_of_a_family_ascend_to_the_largest_that_was_asked_for(name):
    ladder = members_of(name, 100, 2, 5)
    sizes = [size[0].map().edge_count for size in ladder]
    assert sizes == sorted(set(sizes))
    assert 2 <= len(sizes) <= 6
    assert 70 <= edges_of(ladder[-1][0].text) <= 100
    assert [member.seed for member in ladder[0]] == [5, 6]


def test_the_exponent_of_a_power_is_its_exponent():
    name = {"family": "torus", "explorer": "who", "members": ("torus",), "bound": None}
    rows = tuple(GrowRow(edges=m, vertices=m // 2, costs=(3 * m**2,), **name) for m in (10, 20, 40))
    grown = Growth(complete=True, explorers=("who",), families=("torus",), rows=rows)
    (fitted,) = grown.exponents
    assert fitted.exponent == fitted.last == 2
    assert (fitted.slope, fitted.last_slope) == pytest.approx((2, 2))


def test_the_exponent_is_that_of_the_least_squares(report):
    rows = [r for r in report.rows if (r.family, r.explorer) == ("thick", "greedy")]
    xs, ys = [log(r.edges) for r in rows], [log(r.mean) for r in rows]
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    slope = sum((a - x) * (b - y) for a, b in zip(xs, ys, strict=True)) / sum(
        (a - x) ** 2 for a in xs
    )
    fitted = {(e.family, e.explorer): e.slope for e in report.exponents}
    assert fitted["thick", "greedy"] == pytest.approx(slope)


def stops_at_once(first):
    return Estimate(None, first.degree)
    yield


def test_a_broken_law_refutes():
    told = compare(stops_at_once, family=["bouquet"], to=13, worlds=1)
    assert (told.verdict.value, told.exit_code) == ("refuted", 1)
    assert told.findings[0].law == "no-estimate"
    assert "broken a law" in growth_text(told, 100)
    assert replace(told, complete=False).exit_code == 130


def test_a_world_without_a_place_is_left_out_and_nothing_left_is_vacuous():
    told = compare("algorithm1-natural", family=["torus"], to=18, worlds=1)
    assert (told.verdict.value, told.exit_code, told.left_out) == ("vacuous", 4, 1)
    assert "1 world without a place" in growth_text(told, 100)


def test_the_time_limit_and_an_interrupt_leave_finished_families(monkeypatch):
    walked = Climb._costs
    for error, code in ((TimeIsUp(), 3), (Unsettled("lost"), 3), (KeyboardInterrupt(), 130)):

        def costs(growth, one, maps, deadline, error=error):
            if growth.rows:
                raise error
            return walked(growth, one, maps, deadline)

        monkeypatch.setattr(Climb, "_costs", costs)
        told = compare("greedy", family=["bouquet", "strip"], to=14, worlds=1, time_limit=1000)
        assert told.exit_code == code
        assert {row.family for row in told.rows} == {"bouquet"}
        assert "finished families" in growth_text(told, 100)


def test_the_csv_has_a_line_for_each_run(report):
    rows = [*csv.DictReader(io.StringIO(growth_csv(report)))]
    assert len(rows) == sum(len(row.costs) for row in report.rows)
    assert rows[0]["member"] == report.rows[0].members[0]
    unbounded = replace(report, rows=(replace(report.rows[0], bound=None),))
    assert growth_csv(unbounded).splitlines()[1].endswith(",")
    assert " - " in growth_text(unbounded, 100) or growth_text(unbounded, 100).count("-")


@pytest.mark.slow
def test_the_plot_is_the_same_for_the_same_report(report):
    pytest.importorskip("matplotlib")
    plot = file_of("compare", "plot", report)
    assert plot == file_of("compare", "plot", report)
    assert "<svg" in plot
    assert all(text in plot for text in ("lattice", "thick", "greedy", "algorithm1"))


def test_the_command_writes_what_it_is_asked_for(cli, tmp_path):
    file = tmp_path / "rows.csv"
    code, out, _ = cli(
        *("compare", "greedy", "--family", "strip", "--to", 20, "--json", "--csv", file)
    )
    assert code == 0
    assert json.loads(out)["verdict"] == "not-refuted"
    assert file.read_text().startswith("family,edges")


def test_a_plot_without_what_draws_is_refused_before_anything_is_walked(refused, monkeypatch):
    monkeypatch.setattr("allworlds.inputs.find_spec", lambda _: None)
    said = refused("compare", "greedy", "--family", "strip", "--to", 20, "--plot", "x.svg")
    assert "allworlds[figures]" in said


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"family": ["ring"]}, "ring"),
        ({"family": ["regular:"]}, "regular:"),
        ({"family": ["lattice:3"]}, "lattice:3"),
        ({"family": ["lollipop:5"]}, "D is even"),
        ({"family": ["strip"], "to": 3}, "to = 3"),
        ({"family": ["strip"], "edges": 3}, "edges = 3 has no effect"),
        ({"family": ["strip"], "holes": "10%"}, "holes = '10%' has no effect"),
        ({"family": ["strip"], "map_class": "simple"}, "class 'simple' has no effect"),
        ({"family": ["strip"], "worlds": 0}, "worlds = 0"),
        ({"family": ["strip"], "seed": -1}, "seed = -1"),
        ({"family": []}, "family"),
    ],
)
def test_bad_input_is_named(options, said):
    with pytest.raises(InputError, match=said):
        compare("greedy", **{"to": 400, **options})


@pytest.mark.parametrize("family", ["lattice", "regular:6", "lattice,torus", ["bouquet"]])
def test_a_family_without_a_size_is_refused_with_both_spellings(family):
    with pytest.raises(InputError, match=r"lattice:3x4, for one world, or to \(--to M\)"):
        compare("greedy", "algorithm1", family=family)


def test_what_grows_is_asked_for_by_to(cli, refused):
    assert "worlds = 2 has no effect" in refused("compare", "greedy", "--worlds", 2)
    assert "--to" in refused("compare", "greedy", "--family", "strip", "--plot", "x.svg")
    assert "--to" in refused(
        *("compare", "greedy", "--family", "strip", "--to", 20, "--html", "x.html")
    )
    one = ("compare", "greedy", "algorithm1", "--family", "random:8", "--json")
    assert cli(*one)[1:2] != cli(*one, "--seed", 1)[1:2]
    at_zero, left_out = (json.loads(cli(*one, *more)[1]) for more in (("--seed", 0), ()))
    assert at_zero["rows"] == left_out["rows"]
    grown = ("compare", "greedy", "--family", "random", "--to", 20, "--worlds", 1, "--json")
    at_one, left_out = (json.loads(cli(*grown, *more)[1]) for more in (("--seed", 1), ()))
    assert at_one["rows"] == left_out["rows"]


def test_an_explorer_twice_or_none_is_refused():
    with pytest.raises(InputError, match="named twice"):
        compare("greedy", "greedy", family=["strip"], to=400)
    with pytest.raises(InputError, match="an explorer at least"):
        compare(family=["strip"], to=400)


def test_a_program_grows_like_any_other(cli):
    program = f"{sys.executable} {EXPLORERS / 'program.py'} right"
    code, out, _ = cli(
        *("compare", "algorithm1", "--exec", program, "--family", "bouquet", "--to", 12, "--json")
    )
    document = json.loads(out)
    assert code == 0
    assert document["explorers"] == ["algorithm1", f"exec:{program}"]
    walked = {name: [] for name in document["explorers"]}
    for row in document["rows"]:
        walked[row["explorer"]].append(row["members"])
    assert walked["algorithm1"] == walked[f"exec:{program}"] != []
