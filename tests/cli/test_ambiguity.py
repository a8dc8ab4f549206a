import json

import pytest

import allworlds
from allworlds.maps import named_map
from allworlds.world import World
from allworlds.world.bisimulation import flaw
from printed import without_made_by


def test_twins_answer_yes_and_no_with_exit_code_zero(cli):
    code, out, err = cli("ambiguity", "twins", "fig1-left", "fig1-right", "--json")
    document = json.loads(out)
    assert (code, err, document["schema"]) == (0, "", 2)
    assert (document["distinguishable"], document["twins"]) == (False, True)
    worlds = [World.from_json(world) for world in document["worlds"]]
    assert flaw(worlds, document["bisimulation"]) is None
    code, out, _ = cli("ambiguity", "twins", "cycle-3", "cycle-4", "--json")
    assert (code, json.loads(out)["motions"]) == (0, [0, 1, 1])


@pytest.mark.parametrize(
    ("lighthouse", "twins"), [("none", True), ("compass", True), ("position", False)]
)
def test_the_lighthouse_of_named_maps_is_an_option(cli, lighthouse, twins):
    _, out, _ = cli(
        "ambiguity", "twins", "cycle-3", "cycle-5", "--lighthouse", lighthouse, "--json"
    )
    document = json.loads(out)
    assert document["twins"] is twins
    assert [world["lighthouse"]["kind"] for world in document["worlds"]] == [lighthouse] * 2


def test_a_world_in_json_keeps_its_own_lighthouse_and_gets_one_if_it_has_none(cli, tmp_path):
    file = tmp_path / "k4.json"
    file.write_text(json.dumps(named_map("k4").to_json()))
    own = json.dumps({**named_map("k4").to_json(), "lighthouse": {"kind": "none"}})
    code, out, _ = cli("ambiguity", "twins", f"@{file}", own, "--lighthouse", "none", "--json")
    assert (code, json.loads(out)["relation"]) == (0, "same")
    code, out, err = cli("ambiguity", "twins", f"@{file}", own, "--json")
    assert (code, out) == (2, "")
    assert err == (
        "allworlds: the worlds have the lighthouses position and none; two worlds are compared "
        "under one lighthouse\n"
    )


def test_worlds_are_drawn_unless_json_is_asked_for(cli):
    assert cli("ambiguity", "twins", "fig1-left", "fig1-right")[1].startswith("TWINS")
    assert cli("ambiguity", "class", "k4")[1].startswith("AMBIGUOUS")
    assert cli("ambiguity", "census", "--edges", "2")[1].startswith("AMBIGUOUS")


def test_a_class_past_its_limit_has_a_notice_on_stderr_and_an_exact_size(cli):
    code, out, err = cli("ambiguity", "class", "wheel-4", "--limit", "3", "--json")
    document = json.loads(out)
    assert (code, document["size"], document["listed"], document["poses"]) == (0, 10, 3, 24)
    assert "3 of 10 worlds are listed" in err
    code, quiet, err = cli("ambiguity", "class", "wheel-4", "--limit", "3", "--json", "-q")
    assert (code, err) == (0, "")
    assert without_made_by(quiet) == without_made_by(out)
    assert cli("ambiguity", "class", "wheel-4", "--json")[2] == ""


@pytest.mark.usefixtures("compiled")
def test_the_census_counts_inside_a_class(cli):
    code, out, err = cli("ambiguity", "census", "--edges", "6", "--class", "simple", "--json")
    assert (code, err) == (0, "")
    assert [row["classes"] for row in json.loads(out)["rows"]] == [0, 0, 0, 0, 0, 3]


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        (["ambiguity", "twins", "k4", "nowhere"], "'nowhere' is neither JSON"),
        (["ambiguity", "twins", "k4", "k4", "--lighthouse", "sun"], "'sun' is not one of"),
        (["ambiguity", "twins", "k4", '{"sigma": [0, 1]}'], "'alpha' is missing"),
        (["ambiguity", "twins", "k4"], "B"),
        (["ambiguity", "class", "k4", "--limit", "0"], "limit 0"),
        (["ambiguity", "class", "k4", "--limit", "many"], "many"),
        (["ambiguity", "class", "k4", "--lighthouse", "none"], "not none: a class may have no end"),
        (["ambiguity", "class", "theta", "--class", "simple"], "not simple"),
        (["ambiguity", "census"], "needs a bound"),
        (["ambiguity", "census", "--edges", "0"], "edges = 0"),
        (["ambiguity", "census", "--edges", "2", "--class", "round"], "'round'"),
    ],
)
def test_bad_input_is_one_line_that_names_the_value(refused, arguments, named):
    assert named in refused(*arguments)


def test_two_position_markers_are_refused(refused):
    world = {**named_map("k4").to_json(), "lighthouse": {"kind": "position", "dart": [0, 3]}}
    err = refused("ambiguity", "class", json.dumps(world))
    assert "lighthouse.dart = [0, 3] is not an integer" in err


@pytest.mark.parametrize("verb", [["ambiguity", "twins"], ["ambiguity"], ["ambiguity", "class"]])
def test_help_begins_with_an_example(cli, verb):
    _, out, _ = cli(*verb, "--help")
    assert f"Example: allworlds {verb[0]}" in out


def test_the_verbs_are_functions_of_the_package():
    k4 = World.from_json(named_map("k4").to_json(), missing="position")
    assert allworlds.twins(k4, k4).relation == "same"
    assert allworlds.ambiguity.class_of(k4).size == 4
    assert allworlds.ambiguity.census(edges=2).rows[-1].classes == 1
