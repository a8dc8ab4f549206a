"""Cost by size: members that their names give back, runs that single runs confirm."""

import csv
import io
import json
import sys
from itertools import combinations
from statistics import mean
from types import SimpleNamespace

import pytest

from allworlds import compare, run
from allworlds.documents.document import replace
from allworlds.engines.limits import TimeIsUp
from allworlds.engines.listeners import Listener
from allworlds.engines.players import Unsettled
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.loading import load
from allworlds.inputs.checks import InputError
from allworlds.judging.rules import Rules
from allworlds.maps import CombinatorialMap, MapClass, rooted_code, rooted_isomorphism
from allworlds.maps.classes import Extent
from allworlds.maps.families import edges_of
from allworlds.outcome import Completed, Interrupted
from allworlds.protocol.actions import Estimate, Move
from allworlds.reports.formats import file_of, text as text_of
from allworlds.studies.compare.entrants import CompareRequest, Entrant
from allworlds.studies.compare.growth import (
    GROWING,
    GrowingWorlds,
    GrownWorld,
    GrowRow,
    Growth,
    _exponent,
    distinct,
    form_of,
    members_of,
)
from allworlds.studies.compare.intervals import Power
from allworlds.world import Directional, World
from allworlds.world.named import map_of_code, map_of_family
from kept_jobs import EXPLORERS


@pytest.fixture(scope="module")
def report():
    return compare("algorithm1", "folding-oldest", family=["lattice", "cubic"], to=30, draws=2)


def hesitates(first):
    """Algorithm 1, but first there and back as often as the bearing says."""
    for _ in range(2 * first.bearing):
        yield Move(0)
    return (yield from algorithm1(first))


def test_isomorphic_worlds_count_once_and_every_direction_is_run():
    told = compare("algorithm1", hesitates, family="torus", to=18, draws=10)
    one, other = told.rows
    assert (one.seeds, one.worlds, one.places, one.runs) == (10, 1, 4, 4)
    assert (one.drawn_from, one.exact, one.interval) == (1, True, None)
    # Of one world `compare` without `to` walks in every place too.
    (row,) = compare("algorithm1", hesitates, family="torus:3x3", seed=1).rows
    assert [one.mean, other.mean] == [*row.mean.values()]
    assert [one.worst, other.worst] == [*row.worst.values()]
    assert [cost for member in one.members for cost in member.costs] == [one.worst] * 4
    costs = sorted(cost for member in other.members for cost in member.costs)
    assert costs == [one.worst + 2 * bearing for bearing in range(4)]


def test_no_two_worlds_of_a_size_are_isomorphic_and_every_seed_is_isomorphic_to_one():
    (size,) = members_of("lattice", 12, 10, 1)
    kept = [*distinct(size).values()]
    assert len(kept) < len(size)
    for a, b in combinations(kept, 2):
        assert not rooted_isomorphism(a, 0, b, 0)
    for member in size:
        assert sum(bool(rooted_isomorphism(member.map(), 0, b, 0)) for b in kept) == 1


@pytest.mark.parametrize(
    ("seeds", "places", "exact"), [(30, 4, True), (3, 4, False), (30, 2, False)]
)
def test_a_sample_is_exact_if_it_is_the_whole_family_in_every_place(seeds, places, exact):
    pytest.importorskip("scipy")
    asked = {"family": "lattice", "to": 12, "draws": seeds, "places": places}
    report = compare("algorithm1", "folding-oldest", **asked)
    one, other = report.rows
    # A square of 3 x 3 vertices has 24 darts, and 4 turns carry it to itself.
    assert one.drawn_from == 24 // 4
    assert (one.worlds == 6, one.exact, other.exact) == (seeds == 30, exact, exact)
    (ratio,) = report.ratios
    assert ratio.exact == exact
    assert (ratio.interval is None) == (one.interval is None) == (exact or seeds == 3)
    assert ("every world that a seed can draw" in text_of(report, 200)) == exact


def test_every_start_of_an_exact_sample_has_the_same_chance():
    (row,) = compare("folding-oldest", family="lattice", to=12, draws=30, places=4).rows
    map_ = map_of_family("lattice:3x3", None, 1)
    means = []
    for start in map_.darts:
        rooted = CombinatorialMap(*rooted_code(map_.sigma, map_.alpha, start))
        places = Directional.places(rooted, 0)
        costs = [run("folding-oldest", World(rooted, place)).cost for place in places]
        means.append(mean(costs))
    assert row.mean == pytest.approx(mean(means))


@pytest.mark.parametrize("family", ["dense", "cubic", "bouquet", "corridor"])
def test_a_family_of_which_seeds_draw_more_than_the_start_is_never_exact(family):
    (row, *_) = compare("algorithm1", family=family, to=30, draws=2).rows
    assert (row.drawn_from, row.exact) == (None, False)


def test_of_many_places_a_sample_is_drawn_and_said():
    told = compare("algorithm1", family="dense", to=20, draws=2, places=3)
    (row,) = told.rows
    assert (row.runs, row.places) == (6, sum(one.map().degree_at[0] for one in row.members))
    assert all(len(set(one.ran)) == 3 and [*one.ran] == sorted(one.ran) for one in row.members)
    assert f"6 of {row.places}" in text_of(told, 120)
    again = compare("algorithm1", family="dense", to=20, draws=2, places=3)
    assert again.rows == told.rows


@pytest.mark.parametrize("name", GROWING)
def test_the_sizes_of_a_family_ascend_to_the_largest_that_was_asked_for(name):
    ladder = members_of(name, 100, 2, 5)
    sizes = [size[0].map().edge_count for size in ladder]
    assert sizes == sorted(set(sizes))
    assert 2 <= len(sizes) <= 6
    assert 70 <= edges_of(ladder[-1][0].text) <= 100
    assert [member.seed for member in ladder[0]] == [5, 6]


def grown(costs, explorers=("who",)):
    """A report with these costs in worlds, by explorer and edges."""
    rows = [
        GrowRow(
            family="torus",
            edges=m,
            vertices=m // 2,
            explorer=name,
            seeds=len(some),
            drawn_from=None,
            exact=False,
            members=tuple(
                GrownWorld(
                    name=f"t --seed {i}", edges=m, places=1, ran=(0,), costs=(c,), bound=None
                )
                for i, c in enumerate(some)
            ),
        )
        for name in explorers
        for m, some in costs[name].items()
    ]
    return Growth(
        ending=Completed(),
        request=CompareRequest(to=40, draws=5, places=1, seed=1),
        extent=Extent(MapClass.MAPS, 1),
        entrants=tuple(
            Entrant(replace(load("folding-oldest"), name=name), Rules()) for name in explorers
        ),
        families=("torus",),
        rows=tuple(rows),
    )


def test_the_ratio_is_that_of_each_world_and_has_an_interval():
    pytest.importorskip("scipy")
    first = {10: [10, 20, 40, 80, 160, 320]}
    told = grown({"a": first, "b": {10: [2 * c for c in first[10]]}}, ("a", "b"))
    (ratio,) = told.ratios
    # The costs scatter, their ratios do not.
    assert (ratio.explorer, ratio.worlds, ratio.ratio, ratio.interval) == ("b", 6, 2, (2, 2))
    assert told.rows[0].interval[1] > 2 * told.rows[0].interval[0]


def test_without_scipy_no_interval_is_shown_and_the_report_says_why(monkeypatch):
    costs = {"a": {10: [10, 20, 40, 80, 160, 320]}, "b": {10: [20, 20, 20, 20, 20, 20]}}
    told = grown(costs, ("a", "b"))
    monkeypatch.setattr("allworlds.inputs.checks.find_spec", lambda _: None)
    (ratio,) = told.ratios
    assert {row.interval for row in (*told.rows, ratio)} == {None}
    assert "interval needs scipy: in a clone" in " ".join(text_of(told, 200).split())


def stops_at_once(first):
    return Estimate(None, first.degree)
    yield


def test_a_broken_law_refutes():
    told = compare(stops_at_once, family=["bouquet"], to=13, draws=1)
    assert (told.verdict.value, told.exit_code) == ("refuted", 1)
    assert told.findings[0].law == "no-estimate"
    assert "broken a law" in text_of(told, 100)
    assert replace(told, ending=Interrupted()).exit_code == 130


def test_a_world_without_a_place_is_left_out_and_nothing_left_is_vacuous():
    told = compare("algorithm1-natural", family=["torus"], to=18, draws=1)
    assert (told.verdict.value, told.exit_code, told.left_out) == ("vacuous", 4, 1)
    assert "1 world: no place for the lighthouse" in text_of(told, 100)


def test_the_time_limit_and_an_interrupt_leave_finished_sizes(monkeypatch):
    walked = GrowingWorlds._units
    whole = compare("algorithm1", family=["bouquet", "strip"], to=60, draws=1)
    for error, code in ((TimeIsUp(), 3), (Unsettled("lost"), 3), (KeyboardInterrupt(), 130)):

        def units(growth, size, error=error):
            if len(growth._rows) == 2:
                raise error
            yield from walked(growth, size)

        monkeypatch.setattr(GrowingWorlds, "_units", units)
        told = compare("algorithm1", family=["bouquet", "strip"], to=60, draws=1, time_limit=1000)
        assert told.exit_code == code
        # Of each family the smallest size.
        smallest = [min(r.edges for r in whole.rows if r.family == f) for f in whole.families]
        assert [(row.family, row.edges) for row in told.rows] == [
            *zip(whole.families, smallest, strict=True)
        ]
        assert all(row in whole.rows for row in told.rows)
        lines, every = (file_of("csv", one).splitlines() for one in (told, whole))
        assert [line for line in every if line in lines] == lines
        assert len(lines) == 1 + sum(row.runs for row in told.rows)
        assert "finished sizes" in text_of(told, 100)


def test_a_shard_has_worlds_of_all_sizes_by_the_squares_of_their_edges():
    asked = {"family": "bouquet", "to": 60, "draws": 1, "places": 1}
    shards = [compare("algorithm1", **asked, shard=(k, 2)).rows for k in (0, 1)]
    assert [[row.edges for row in rows] for rows in shards] == [[60], [15, 30]]


def test_a_law_that_is_broken_in_a_begun_size_refutes():
    class Ends(Listener):
        def progress(self, worlds):
            raise TimeIsUp

    asked = {"family": "cubic", "to": 30, "draws": 3, "listener": Ends(), "time_limit": 1000}
    told = compare(stops_at_once, **asked)
    assert (told.verdict.value, told.rows) == ("refuted", ())
    assert told.findings[0].law == "no-estimate"


def test_the_csv_has_a_line_for_each_run(report):
    rows = [*csv.DictReader(io.StringIO(file_of("csv", report)))]
    assert len(rows) == sum(row.runs for row in report.rows)
    first = report.rows[0].members[0]
    assert f"{rows[0]['family']} --seed {rows[0]['seed']}" == first.name
    assert map_of_code(rows[0]["code"]) == CombinatorialMap(*_code(first.map()))
    unbounded = replace(first, bound=None)
    other = replace(report, rows=(replace(report.rows[0], members=(unbounded,)),))
    assert file_of("csv", other).splitlines()[1].endswith(",")


def _code(map_):
    return rooted_code(map_.sigma, map_.alpha, 0)


def test_by_world_the_csv_has_a_line_for_each_world_and_explorer(report):
    told = replace(report, by="world")
    rows = [*csv.DictReader(io.StringIO(file_of("csv", told)))]
    assert len(rows) == sum(row.worlds for row in report.rows)
    means = {(r["family"], r["seed"], r["explorer"]): float(r["mean"]) for r in rows}
    for row in rows:
        first = means[row["family"], row["seed"], "algorithm1"]
        assert float(row["ratio"]) == pytest.approx(float(row["mean"]) / first, abs=1e-6)


def test_by_size_the_csv_has_a_line_for_each_row_with_its_ratio(report):
    rows = replace(report, by="size").records()
    assert [(r["family"], r["edges"], r["explorer"], r["mean"]) for r in rows] == [
        (row.family, row.edges, row.explorer, row.mean) for row in report.rows
    ]
    assert [r["ratio"] for r in rows if r["ratio"]] == [one.ratio for one in report.ratios]
    by_world, by_run = (replace(report, by=by).records() for by in ("world", "run"))
    assert len(by_world) == sum(row.worlds for row in report.rows)
    assert report.records() == by_run
    with pytest.raises(InputError, match="by 'edge' is not one of size, world, run"):
        compare("algorithm1", "folding", edges=1, by="edge")


def test_the_command_writes_what_it_is_asked_for(cli, tmp_path):
    file = tmp_path / "rows.csv"
    code, out, _ = cli(
        *("compare", "folding-oldest", "--family", "strip", "--to", 20, "--json", "-o", file)
    )
    assert code == 0
    told = json.loads(out)
    assert (told["verdict"], told["rows"][0]["seeds"]) == ("not-refuted", 30)
    assert file.read_text().startswith("code,family,holes,seed,edges")


def test_the_text_runs_the_last_member_again():
    report = compare("algorithm1", "folding", family=["random"], to=12, draws=2, workers=1)
    assert "allworlds run algorithm1 --family random:6x12 --seed 2" in text_of(report, 100)


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
        ({"family": ["strip"], "draws": 0}, "draws = 0"),
        ({"family": ["strip"], "places": 0}, "places = 0"),
        ({"family": ["strip"], "seed": -1}, "seed = -1"),
        ({"family": ["strip"], "by": "map"}, "by 'map' is not one of size, world, run"),
        ({"family": []}, "family"),
    ],
)
def test_bad_input_is_named(options, said):
    with pytest.raises(InputError, match=said):
        compare("folding-oldest", **{"to": 400, **options})


@pytest.mark.parametrize("family", ["lattice", "regular:6", "lattice,torus", ["bouquet"]])
def test_a_family_without_a_size_is_refused_with_both_spellings(family):
    with pytest.raises(InputError, match=r"lattice:3x4, for one world, or --to M for worlds"):
        compare("folding-oldest", "algorithm1", family=family)


def test_what_grows_is_asked_for_by_to(refused):
    assert "draws = 2 has no effect on worlds that do not grow" in refused(
        "compare", "folding-oldest", "--draws", 2
    )


def test_a_seed_left_out_is_the_first(cli):
    one = ("compare", "folding-oldest", "algorithm1", "--family", "random:8", "--json")
    assert cli(*one)[1:2] != cli(*one, "--seed", 1)[1:2]
    at_zero, left_out = (json.loads(cli(*one, *more)[1]) for more in (("--seed", 0), ()))
    assert at_zero["rows"] == left_out["rows"]
    grown = ("compare", "folding-oldest", "--family", "random", "--to", 20, "--draws", 1, "--json")
    at_one, left_out = (json.loads(cli(*grown, *more)[1]) for more in (("--seed", 1), ()))
    assert at_one["rows"] == left_out["rows"]


def test_a_family_without_a_world_so_small_is_refused_also_beside_another_one():
    for families in (["strip"], ["bouquet", "strip"]):
        with pytest.raises(InputError, match="family strip has no world with at most 12 edges"):
            compare("algorithm1", family=families, to=12)


def test_an_explorer_twice_or_none_is_refused():
    with pytest.raises(InputError, match="named twice"):
        compare("folding-oldest", "folding-oldest", family=["strip"], to=400)
    with pytest.raises(InputError, match="an explorer at least"):
        compare(family=["strip"], to=400)


def test_a_program_grows_like_any_other(cli):
    program = f"{sys.executable} {EXPLORERS / 'program.py'} right"
    code, out, _ = cli(
        *("compare", "algorithm1", "--exec", program, "--family", "bouquet", "--to", 12, "--json")
    )
    document = json.loads(out)
    assert code == 0
    names = [one["name"] for one in document["explorers"]]
    assert names == ["algorithm1", f"exec:{program}"]
    walked = {name: [] for name in names}
    for row in document["rows"]:
        walked[row["explorer"]].append(row["members"])
    assert walked["algorithm1"] == walked[f"exec:{program}"] != []


@pytest.mark.parametrize(("sizes", "exponent"), [(4, None), (5, 1.5)])
def test_an_exponent_is_of_the_rows_of_one_explorer_in_one_family(sizes, exponent):
    def row(edges, cost, family="cubic", explorer="mine"):
        return SimpleNamespace(
            family=family, explorer=explorer, edges=edges, means=[cost - 1, cost + 1]
        )

    rows = [row(4**k, 8**k) for k in range(2, 2 + sizes)]
    others = [row(4**7, 3, family="torus"), row(4**8, 5, explorer="other")]
    found = _exponent(SimpleNamespace(rows=[*others, *rows]), "cubic", "mine")
    assert (found.family, found.explorer, found.sizes) == ("cubic", "mine", sizes)
    assert found.exponent == exponent
    assert found.lack == ("" if exponent else "fewer than 5 sizes")


def test_an_exponent_has_three_digits(monkeypatch):
    power = Power(1.23456, (1.11111, 1.99999), "")
    monkeypatch.setattr("allworlds.studies.compare.intervals.power", lambda _: power)
    found = _exponent(SimpleNamespace(rows=[]), "cubic", "mine")
    assert (found.exponent, found.interval) == (1.235, (1.111, 2.0))


@pytest.mark.parametrize(
    ("option", "least"), [("to", 12), ("draws", 1), ("places", 1), ("seed", 0)]
)
def test_numbers_of_worlds_that_grow_have_a_least_value(option, least):
    asked = {"family": ["lattice"], "to": 12, "draws": 1, "places": 1, "seed": 0}
    report = compare("algorithm1", **{**asked, option: least})
    assert [(row.edges, row.worlds, row.runs) for row in report.rows] == [(12, 1, 1)]
    with pytest.raises(InputError, match=f"{option} = {least - 1} is less than {least}$"):
        compare("algorithm1", **{**asked, option: least - 1})


def test_the_degree_of_a_family_without_one():
    usual = {name: form_of(name)[1] for name, growing in GROWING.items() if growing.degree}
    assert usual == {"regular": 6, "lollipop": 4, "thick": 6}  # as they were first measured
    assert (form_of("regular:4")[1], form_of("torus")[1]) == (4, 0)
