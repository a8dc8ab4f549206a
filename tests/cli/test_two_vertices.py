"""The lighthouses and explorers without a direction, from the command line."""

import json

import pytest

from printed import without_made_by

pytestmark = pytest.mark.usefixtures("without_workers")

# v0 with an edge to v1 and a loop: the edge is dart 0.
LOLLIPOP = '{"sigma":[1,2,0,3],"alpha":[3,2,1,0]'
PAIR = [
    {"sigma": [1, 0, 3, 4, 5, 6, 7, 2], "alpha": [2, 5, 0, 4, 3, 1, 7, 6]},
    {"sigma": [1, 0, 3, 4, 5, 6, 7, 2], "alpha": [2, 5, 0, 7, 6, 1, 4, 3]},
]


def test_the_lighthouse_of_a_built_in_explorer_need_not_be_named(cli):
    plain = cli("check", "algorithm1-cluster", "--edges", 2, "--json")
    named = cli(
        *("check", "algorithm1-cluster", "--edges", 2, "--json"),
        *("--lighthouse", "cluster:single=true", "--bound", "two-vertices"),
    )
    assert (plain[0], named[0]) == (0, 0)
    assert without_made_by(plain[1]) == without_made_by(named[1])
    report = json.loads(plain[1])
    assert (report["verdict"], report["left_out"]) == ("holds", 5)
    assert (report["scope"]["lighthouse"], report["engine"]) == ("cluster:single=true", "python")


def test_without_the_promise_the_explorer_is_refuted_and_the_command_shows_it_again(cli):
    options = ["--lighthouse", "cluster", "--edges", 3, "--json"]
    code, out, _ = cli("check", "algorithm1-cluster", *options)
    (finding,) = json.loads(out)["findings"]
    assert code == 1
    assert len(finding["world"]["sigma"]) == 6
    assert finding["world"]["lighthouse"]["kind"] == "cluster"
    command = finding["reproduce"]
    assert command.startswith("allworlds run algorithm1-cluster '{")
    assert command.endswith("}'")
    code, out, _ = cli("run", "algorithm1-cluster", json.dumps(finding["world"]), "--json")
    assert (code, json.loads(out)["finding"]["transcript"]) == (1, finding["transcript"])


def test_a_replayed_finding_is_told_in_words(cli, tmp_path):
    _, out, _ = cli("check", "algorithm1-natural", "--edges", 3, "--json")
    (tmp_path / "report.json").write_text(out)
    code, out, _ = cli("replay", tmp_path / "report.json")
    assert (code, out.split()[0]) == (0, "REPRODUCED")
    code, out, _ = cli("explain", tmp_path / "report.json")
    assert code == 0
    assert "236 traversals" in out


def test_a_run_takes_the_explorers_lighthouse_where_the_world_names_none(cli):
    code, out, _ = cli("run", "algorithm1-natural", LOLLIPOP + "}", "--json")
    report = json.loads(out)
    assert (code, report["world"]["lighthouse"]) == (0, {"kind": "natural", "dart": 0})
    assert (report["cost"], report["bound"]) == (7, 21)
    code, out, _ = cli("run", "algorithm1-cluster", LOLLIPOP + "}")
    assert "HOLDS      7 traversals of at most 21" in out
    code, out, _ = cli("run", "algorithm1-cluster", "--family", "lattice:3x3", "--json")
    assert (code, json.loads(out)["world"]["lighthouse"]["kind"]) == (0, "cluster")
    code, out, _ = cli("run", "algorithm1", LOLLIPOP + "}", "--json")
    assert json.loads(out)["world"]["lighthouse"]["kind"] == "directional"


def test_fuzz_takes_a_lighthouse(cli):
    options = ["--edges", 6, "--runs", 20, "--json"]
    _, own, _ = cli("fuzz", "algorithm1-cluster", *options)
    _, named, _ = cli("fuzz", "algorithm1-cluster", "--lighthouse", "cluster", *options)
    assert json.loads(own)["scope"]["lighthouse"] == "cluster:single=true"
    assert json.loads(named)["scope"]["lighthouse"] == "cluster"
    assert json.loads(own)["left_out"] > json.loads(named)["left_out"] > 0


@pytest.mark.parametrize("kind", ["cluster", "natural"])
def test_the_pair_with_two_edges_cannot_be_told_apart(cli, kind):
    # Half a turn round v1 and the exchange of v0's darts make darts alike in pairs.
    pair = [json.dumps({**map_, "lighthouse": {"kind": kind, "dart": 0}}) for map_ in PAIR]
    code, out, _ = cli("ambiguity", "twins", *pair, "--json")
    report = json.loads(out)
    assert (code, report["twins"], report["distinguishable"]) == (0, True, False)
    assert [world["lighthouse"]["kind"] for world in report["worlds"]] == [kind, kind]
    bare = [json.dumps(map_) for map_ in PAIR]
    code, again, err = cli("ambiguity", "twins", *bare, "--lighthouse", kind, "--json")
    assert (code, err) == (0, "")
    assert without_made_by(again) == without_made_by(out)
    code, out, _ = cli("ambiguity", "twins", *bare, "--lighthouse", "directional", "--json")
    assert json.loads(out)["distinguishable"]


BAD = [
    (["check", "--lighthouse", "cluster:single=maybe"], "'maybe'"),
    (["check", "--lighthouse", "cluster:markers=2"], "'markers'"),
    (["check", "--lighthouse", "cluster:single"], "'single'"),
    (["check", "--lighthouse", "natural:single=true"], "has no option 'single'"),
    (["fuzz", "--edges", "3", "--runs", "1", "--lighthouse", "lamp"], "'lamp'"),
    (["run", "algorithm1-cluster", "theta"], "cluster:single=true has no place"),
    (["run", "algorithm1-natural", "k4"], "natural has no place"),
    (["run", LOLLIPOP + ',"lighthouse":{"kind":"cluster","dart":1}}'], "legal are 0"),
    (["run", LOLLIPOP + ',"lighthouse":{"kind":"natural","dart":3}}'], "dart 3"),
    (["run", LOLLIPOP + ',"lighthouse":{"kind":"cluster","singel":true}}'], "'singel'"),
    (["run", LOLLIPOP + ',"lighthouse":{"kind":"cluster","single":"yes"}}'], "'yes'"),
    (["check", "algorithm1-cluster", "--engine", "kernel", "--policy", "random:1"], "'random:1'"),
    (
        ["ambiguity", "search", "--lighthouse", "cluster", "--vertices", "2", "--edges", "2"],
        "'cluster'",
    ),
    (["ambiguity", "class", "edge", "--lighthouse", "cluster"], "cluster"),
]


@pytest.mark.parametrize(("arguments", "named"), BAD, ids=lambda value: str(value)[:60])
def test_bad_input_is_one_line_that_names_it(refused, arguments, named):
    assert named in refused(*arguments)


def test_worlds_that_tell_different_numbers_are_told_apart_before_the_first_motion(cli):
    # v0 of degree 2 between vertices of degrees 1 and 3: the robot is told which is v1.
    worlds = [
        '{"sigma":[1,0,2,4,5,3],"alpha":[2,3,0,1,5,4],'
        f'"lighthouse":{{"kind":"natural","dart":{dart}}}}}'
        for dart in (0, 1)
    ]
    code, said, _ = cli("ambiguity", "twins", *worlds)
    assert code == 0
    assert said.startswith("TOLD APART")
    assert "0 motions" in said
