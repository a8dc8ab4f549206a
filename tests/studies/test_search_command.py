import json
import re
from functools import partial

import pytest


@pytest.fixture
def search(cli):
    return partial(cli, "ambiguity", "search")


def test_a_pair_is_one_json_document_on_stdout(search, tmp_path):
    code, out, _ = search(
        *("--lighthouse", "position", "--vertices", "3", "--edges", "2"),
        *("--out", str(tmp_path), "--json"),
    )
    document = json.loads(out)
    assert (code, document["status"]) == (0, "sat")
    assert [world["lighthouse"]["kind"] for world in document["pair"]] == ["position"] * 2
    assert document["certificate"] == str(tmp_path / "pair.json")


def test_the_text_draws_both_worlds_and_says_why(search, tmp_path):
    code, out, _ = search(
        *("--lighthouse", "compass", "--class", "simple", "--vertices", "4"),
        *("--edges", "4", "--out", str(tmp_path)),
    )
    assert code == 0
    _, first, second = re.split(r"^World [AB] \(genus 0\)$", out, flags=re.MULTILINE)
    for drawing, vertices, darts in ((first, 3, 6), (second, 4, 8)):
        drawn = drawing.partition("( ) vertex")[0]
        assert set(re.findall(r"v\d", drawn)) == {f"v{v}" for v in range(vertices)}
        assert sorted(re.findall(r"(?<!v)\d", drawn)) == [str(dart) for dart in range(darts)]
    assert "cannot be told apart" in " ".join(out.split())


def test_that_there_is_none_names_the_proofs(search, tmp_path):
    bounds = ["--vertices", "3", "--edges", "2", "--out", str(tmp_path)]
    code, out, _ = search("--lighthouse", "directional", *bounds)
    assert code == 0
    assert out.startswith("NONE")
    assert (tmp_path / "m2n1to3.cnf").exists()


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("--motions", "1,1", "--percepts", "3A"), 2, "2 motions and 1 percepts"),
        (("--motions", "one"), 2, "motions 'one'"),
        (("--motions", "1", "--percepts", "3PP"), 2, "percept '3PP'"),
        (("--solver", "/nowhere/cadical"), 2, "/nowhere/cadical"),
        (("--degree-marked", "9"), 4, "vacuous"),
        (("--time-limit", "0.000001"), 3, "undecided"),
    ],
)
def test_exit_codes_say_what_kind_of_answer_it_is(search, tmp_path, words, code, said):
    bounds = ["--vertices", "3", "--edges", "2", "--out", str(tmp_path)]
    seen, out, err = search("--lighthouse", "position", *bounds, *words)
    assert seen == code
    assert said in err
    assert (len(err.splitlines()), out if code == 2 else "") == (1, "")
