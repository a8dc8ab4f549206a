"""Worlds of files on the command line: told of, written in another notation, one of them run."""

import csv
import io
import json
from pathlib import Path

import pytest

from allworlds import World, convert
from allworlds.inputs.checks import InputError
from allworlds.maps import family, named_map, unrooted_code
from allworlds.notations.table import NOTATIONS, entries
from allworlds.studies.convert import _files
from allworlds.world.named import world_named

PLANTRI = Path(__file__).parents[1] / "support" / "data" / "plantri"
PLAN = {"hall": ["bath", "attic"], "bath": ["hall"], "attic": ["hall"]}


def plans(tmp_path, text=None):
    """A file of two plans."""
    path = tmp_path / "plans.json"
    path.write_text(text or json.dumps({"house": PLAN, "barn": {"in": ["out"], "out": ["in"]}}))
    return path


def test_each_world_of_a_file_is_told_of(cli, tmp_path):
    code, out, _ = cli("convert", plans(tmp_path), "--json", "-o", f"csv:{tmp_path / 'rows'}")
    told = json.loads(out)
    assert (code, told["written"]) == (0, None)
    house = {"number": 1, "name": "house", "vertices": 3, "edges": 2, "genus": 0, "faces": 1}
    house |= {"automorphisms": 2, "names": ["hall", "bath", "attic"]}
    assert told["rows"][0] == house | {"doors": [["bath", "attic"], ["hall"], ["hall"]]}
    rows = [*csv.DictReader(io.StringIO((tmp_path / "rows").read_text()))]
    assert [*rows[0]] == [*house][:-1]
    assert rows == [{key: str(row[key]) for key in rows[0]} for row in told["rows"]]


def test_the_doors_of_each_room_are_told_in_their_order(cli, tmp_path):
    plan = {"hall": ["bath", "attic", "cellar"], "bath": ["hall"], "attic": ["hall"]}
    path = plans(tmp_path, json.dumps(plan | {"cellar": ["hall"]}))
    code, out, _ = cli("convert", path)
    assert (code, "hall    bath, attic, cellar\n" in out) == (0, True)
    assert "( ) vertex" not in out
    assert "( ) vertex with its darts clockwise" in cli("convert", path, "-v")[1]
    _, turned, _ = cli("convert", path, "--order", "anticlockwise")
    assert "hall    bath, cellar, attic\n" in turned


def test_rooms_of_many_worlds_are_told_if_all_is_asked_for(cli):
    many = PLANTRI / "poly5.pl"
    assert "its doors lead" not in cli("convert", many)[1]
    assert cli("convert", many, "-v")[1].count("its doors lead") == len([*entries(many)])


@pytest.mark.parametrize("count", [3, 4])
def test_rooms_of_three_worlds_are_told_and_of_four_if_all_is_asked_for(cli, tmp_path, count):
    path = plans(tmp_path, json.dumps({f"house {number}": PLAN for number in range(count)}))
    assert ("hall   bath, attic\n" in cli("convert", path)[1]) == (count == 3)


def test_a_world_is_drawn_in_a_file(cli, refused, tmp_path):
    (tmp_path / "plan.json").write_text(json.dumps(PLAN))
    page, picture = tmp_path / "x.html", tmp_path / "x.svg"
    assert cli("convert", tmp_path / "plan.json", "-o", picture, "-o", page)[0] == 0
    assert 'class="name beside">attic' not in picture.read_text()
    assert ">attic<" in picture.read_text()
    assert ">attic<" in page.read_text()
    why = "a file .svg holds one picture, and not 2; .html holds all"
    assert why in refused("convert", plans(tmp_path), "-o", tmp_path / "y.svg")


def test_worlds_are_written_in_several_notations(cli, tmp_path):
    names = [tmp_path / f"x{suffix}" for suffix in (".pl", ".jsonl", ".sage")]
    outputs = [word for name in names for word in ("-o", name)]
    code, out, _ = cli("convert", plans(tmp_path), "--json", *outputs)
    told = json.loads(out)
    assert (code, told["written"]) == (0, [*map(str, names)])
    assert told["left_out"] == ["name", "names"]
    assert [len([*entries(name)]) for name in names] == [2, 2, 2]


def test_worlds_are_written_in_the_notation_of_the_suffix(cli, tmp_path):
    for notation in NOTATIONS:
        for suffix in notation.suffixes if notation.write else ():
            written = tmp_path / f"tri5{suffix}"
            assert cli("convert", PLANTRI / "tri5.pl", "-o", written)[0] == 0
            ((_, entry),) = entries(written)
            assert unrooted_code(entry.map) == unrooted_code(world_named(f"@{written}").map)
    worlds = tmp_path / "x.ec"
    report = tmp_path / "x.html"
    assert cli("convert", PLANTRI / "tri6.pl", "-o", worlds, "-o", report)[0] == 0
    assert len([*entries(worlds)]) == 2
    assert "allworlds convert" in report.read_text()


def test_what_is_not_written_leaves_the_old_file(refused, tmp_path):
    old = tmp_path / "old.pl"
    old.write_bytes(b"old")
    loop = plans(tmp_path, json.dumps({"hall": ["hall", "hall"]}))
    why = "world 1 is not written: vertex hall has a loop, not told so"
    assert why in refused("convert", loop, "-o", old)
    assert old.read_bytes() == b"old"
    assert {*tmp_path.iterdir()} == {old, tmp_path / "plans.json"}


def test_no_file_of_the_users_is_taken_for_a_draft(cli, tmp_path):
    for name in ("x.json.part", "x.part", "x.json.tmp", "x.tmp"):
        (tmp_path / name).write_text("mine")
    before = {*tmp_path.iterdir()}
    assert cli("convert", plans(tmp_path), "-o", tmp_path / "x.json")[0] == 0
    assert {file.read_text() for file in before} == {"mine"}
    assert {*tmp_path.iterdir()} - before == {tmp_path / "x.json", tmp_path / "plans.json"}
    modes = {(tmp_path / name).stat().st_mode for name in ("x.json", "plans.json")}
    assert len(modes) == 1


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (["-o", "x.graphml"], "worlds cannot be written as 'x.graphml'; legal are .json, "),
        (["-o", "x.odd"], "-o 'x.odd' is no file that convert writes: .json, "),
        (["--order", "left"], "order 'left' is not one of clockwise, anticlockwise"),
        (["--y", ""], "y '' is not one of up, down"),
    ],
)
def test_options_without_a_meaning_are_refused(words, why, refused, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert why in refused("convert", plans(tmp_path), *words)
    assert [*tmp_path.iterdir()] == [tmp_path / "plans.json"]


def test_what_a_notation_has_no_place_for_is_left_out_and_told(tmp_path):
    told = convert(plans(tmp_path), output=tmp_path / "x.pl")
    assert (told.written, len(told.rows)) == ((str(tmp_path / "x.pl"),), 2)
    assert told.left_out == ("name", "names")
    assert convert(plans(tmp_path), output=tmp_path / "x.jsonl").left_out is None
    assert [entry.labels.vertices for _, entry in entries(tmp_path / "x.pl")] == [(), ()]


# ---------------------------------------------------------------- WORLD


def test_a_world_is_one_of_a_file_by_its_name_or_number(tmp_path):
    path = plans(tmp_path)
    assert world_named(f"@{path}:house").map.edge_count == 2
    assert world_named(f"@{path}:2").labels.vertices == ("in", "out")
    assert world_named(f"@{PLANTRI / 'tri5.pl'}").map.edge_count == 9
    colons = path.rename(tmp_path / "a:1.json")
    with pytest.raises(
        InputError, match="more than one world; @FILE:NAME names one of 'house', 'b"
    ):
        world_named(f"@{colons}")


def test_start_and_lighthouse_are_as_the_file_fixes_them(tmp_path):
    world = World(named_map("k4"), "position", 5)
    assert world_named(f"@{plans(tmp_path, json.dumps(world.to_json()))}") == world
    free = plans(tmp_path, json.dumps({"sigma": world.map.sigma, "alpha": world.map.alpha}))
    assert world_named(f"@{free}", "compass") == World(world.map, "compass", 0)
    wrong = world.to_json() | {"lighthouse": {"kind": "beacon"}}
    with pytest.raises(InputError, match=r"^file .*plans\.json.*beacon"):
        world_named(f"@{plans(tmp_path, json.dumps(wrong))}")


def test_a_rotation_may_stand_on_the_command_line(cli):
    code, out, _ = cli("run", "algorithm1", json.dumps(PLAN), "--json")
    assert (code, json.loads(out)["world"]["names"]) == (0, ["hall", "bath", "attic"])


def test_a_torus_is_told_by_its_genus(tmp_path):
    path = tmp_path / "torus.jsonl"
    map_ = family("torus:3x3")
    path.write_text(json.dumps({"sigma": map_.sigma, "alpha": map_.alpha}))
    (row,) = convert(path).rows
    assert (row.genus, row.faces, row.automorphisms) == (1, 9, 36)


def test_files_are_named_alone_or_in_a_list(tmp_path):
    assert _files(None) == ()
    assert _files("a.pl") == _files(Path("a.pl")) == _files(["a.pl"]) == ("a.pl",)
    assert _files(["a.pl", Path("b.pl")]) == ("a.pl", "b.pl")


def test_a_file_in_a_directory_that_is_not_there_is_refused(tmp_path):
    there = tmp_path / "none" / "x.pl"
    with pytest.raises(InputError) as refused:
        convert(plans(tmp_path), output=[there])
    assert str(refused.value) == f"file '{there}' cannot be written: No such file or directory"
