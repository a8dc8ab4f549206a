"""Rows for programs: every world and every run, with names by which ``run`` finds them."""

import csv
import io

import pytest

from allworlds import compare, run
from allworlds.inputs.checks import InputError
from allworlds.maps import CombinatorialMap, named_map, rooted_isomorphism
from allworlds.reports.formats import file_of
from allworlds.world import Directional, World, code_of, world_named
from allworlds.world.named import map_of_code, map_of_family
from allworlds.world.selection import worlds
from allworlds.world.world import at_place


def rows_of(report, verb="compare"):
    """The rows of a result, as its CSV has them."""
    return [*csv.DictReader(io.StringIO(file_of("csv", report)))]


@pytest.fixture(scope="module")
def by_world():
    return compare("algorithm1", "folding", edges=3, by="world")


def test_by_world_every_world_of_the_class_has_a_row_for_each_explorer(by_world):
    rows = rows_of(by_world)
    # OEIS A000698: 2 + 10 + 74 rooted maps with up to three edges.
    assert len(rows) == 2 * 86
    assert len({row["code"] for row in rows}) == 86
    for name in by_world.names:
        worst = max(int(row["worst"]) for row in rows if row["explorer"] == name)
        assert worst == max(row.worst[name] for row in by_world.rows)


def test_the_worlds_in_which_the_first_walks_less_are_those_of_a_ratio_above_one(by_world):
    rows = [row for row in rows_of(by_world) if row["explorer"] == "folding"]
    for kind, holds in (
        ("less", lambda ratio: ratio > 1),
        ("equal", lambda ratio: ratio == 1),
        ("more", lambda ratio: ratio < 1),
    ):
        told = sum(getattr(row, kind)["folding"] for row in by_world.rows)
        assert sum(holds(float(row["ratio"])) for row in rows) == told


def test_by_run_every_row_is_a_run_that_its_code_and_place_give_back():
    report = compare("algorithm1", "folding", edges=2, by="run")
    rows = rows_of(report)
    assert len(rows) == sum(row.runs for row in report.rows)
    for row in rows:
        world = at_place(world_named(row["code"]), int(row["place"]))
        told = run(row["explorer"], world).outcome
        assert told.cost == int(row["cost"])


def test_the_records_of_a_report_are_the_rows_of_its_csv(by_world):
    told = [
        {name: "" if value is None else str(value) for name, value in row.items()}
        for row in by_world.records()
    ]
    assert told == rows_of(by_world)


def test_without_by_there_is_a_row_for_each_size_and_explorer():
    report = compare("algorithm1", "folding", edges=2)
    assert len(rows_of(report)) == 2 * len(report.rows)
    assert report.in_worlds == ()


def test_rows_without_a_file_are_refused(refused):
    words = ("folding", "algorithm1", "--edges", 2, "--by", "world")
    assert refused("compare", *words) == "allworlds: by world has no effect without -o FILE.csv\n"


def test_one_world_of_a_family_has_its_family_and_seed():
    report = compare("algorithm1", "folding", family="torus:3x3", seed=4, by="run")
    rows = rows_of(report)
    assert {(row["family"], row["seed"]) for row in rows} == {("torus:3x3", "4")}
    assert len(rows) == 8


def test_the_command_line_takes_a_code_and_a_place(cli, refused):
    world = code_of(named_map("theta"))
    code, out, _ = cli("run", "folding", world, "--place", 1, "--json")
    assert code == 0
    told = run("folding", at_place(world_named(world), 1))
    assert f'"cost": {told.outcome.cost}' in out
    assert "place 7 is none of the 3 places" in refused("run", "folding", world, "--place", 7)
    assert cli("run", "folding", "--family", "torus:3x3", "--seed", 1, "--place", 3)[0] == 0


def test_a_row_names_its_run_in_python_too():
    report = compare("algorithm1", "folding", family="lattice:3x3", holes="20%", seed=4, by="run")
    for row in report.records():
        names = {name: row[name] for name in ("family", "holes", "seed")}
        assert run(row["explorer"], **names, place=row["place"]).cost == row["cost"]
        found = run(row["explorer"], row["code"], place=row["place"])
        assert found.cost == row["cost"]
        text = run(row["explorer"], row["family"], holes="20%", seed=4, place=row["place"])
        assert text.cost == row["cost"]
        assert text.world.map == map_of_family("lattice:3x3", "20%", 4)


def test_a_lighthouse_is_named_for_a_world_that_names_none():
    assert run("algorithm1", "k4").world.lighthouse.kind == "directional"
    assert run("dudek91", "k4").world.lighthouse.kind == "movable"
    told = run("dudek91", "k4", lighthouse="movable:markers=2")
    assert told.world.lighthouse.markers == 2


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({}, "neither a world nor a family"),
        ({"world": 5}, "world = 5 is no World"),
        ({"world": "k4", "family": "torus:3x3"}, "family torus:3x3 has no effect on a world"),
        ({"world": "k4", "holes": "10%"}, "holes 10% has no effect on world 'k4'"),
        ({"world": World(named_map("k4")), "lighthouse": "position"}, "lighthouse position has no"),
        ({"family": "k4"}, "family 'k4' is not one of"),
        ({"family": "torus:3x3", "place": 4}, "place 4 is none of the 4 places"),
    ],
)
def test_what_says_nothing_of_the_world_is_named(given, said):
    with pytest.raises(InputError, match=said):
        run("algorithm1", **given)


def test_a_code_is_the_same_for_isomorphic_worlds_alone():
    every = [world.map for world in worlds(edges=3)]
    codes = {code_of(map_) for map_ in every}
    assert len(codes) == len({(map_.sigma, map_.alpha) for map_ in every})
    for map_ in every[:20]:
        names = [0, *reversed(range(1, len(map_.sigma)))]
        other = map_.relabelled(names)
        assert code_of(other) == code_of(map_)
        assert rooted_isomorphism(map_of_code(code_of(map_)), 0, other, 0)


@pytest.mark.parametrize("text", ["0.1/1", "/", "0.0/1.0", "1.0/0.1", "../.."])
def test_a_code_that_is_no_map_is_refused(text):
    with pytest.raises(InputError):
        world_named(text)


def test_a_place_has_the_number_that_the_rows_have():
    world = World(CombinatorialMap([1, 2, 0, 3, 4, 5], [3, 4, 5, 0, 1, 2]), Directional(0))
    assert [at_place(world, i).lighthouse.dart for i in range(3)] == [0, 1, 2]
    with pytest.raises(InputError, match="place -1 is none of the 3"):
        at_place(world, -1)
