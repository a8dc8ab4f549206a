"""``run EXPLORER adversary:corridor:F``: explorers of every kind, and what is refused."""

import json
import sys

import pytest

from allworlds import run
from allworlds.maps import family
from allworlds.world import Adversary, World

MINE = """\
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first, *, choices):
    return (yield from algorithm1(first, choices=choices))
"""
PROGRAM = """\
import json, sys
from allworlds import Percept
from allworlds.explorers import built_in
from allworlds.protocol import Choices, Move

def percept(said):
    return Percept(**said["percept"])

walk = None
for line in sys.stdin:
    said = json.loads(line)
    if "episode" in said:
        walk = built_in("algorithm1").player()(percept(said), Choices(), None)
        reply = None
    else:
        reply = percept(said)
    try:
        message = walk.send(reply)
        while not isinstance(message, Move):
            message = walk.send(None)
        print(json.dumps({"move": message.k}), flush=True)
    except StopIteration as end:
        found = end.value
        map_ = {"sigma": list(found.map.sigma), "alpha": list(found.map.alpha)}
        print(json.dumps({"estimate": {**map_, "here": found.here}}), flush=True)
"""


@pytest.fixture
def mine(tmp_path):
    (tmp_path / "mine.py").write_text(MINE, encoding="utf-8")
    (tmp_path / "program.py").write_text(PROGRAM, encoding="utf-8")
    return tmp_path


def made_for(cli, *words):
    code, out, err = cli("run", *words, "adversary:corridor:1", "--seed", "1", "--json")
    assert err == ""
    return code, json.loads(out)


def test_a_built_in_explorer_gets_its_own_bad_world():
    told = run("algorithm1", Adversary(1, 1))
    assert told.cost == told.adversary.cost == 882
    assert told.adversary.same
    assert told.world.map != family("corridor:1", seed=1)
    again = run("algorithm1", World.from_json(told.world.to_json()))
    assert again.transcript == told.transcript
    assert again.adversary is None


@pytest.mark.slow
def test_a_users_explorer_and_a_program_get_the_same_world_as_the_built_in_one(cli, mine):
    code, told = made_for(cli, "algorithm1")
    assert (code, told["adversary"]["excluded"], told["cost"]) == (0, 56, 882)
    program = f"{sys.executable} {mine / 'program.py'}"
    for words in ([f"{mine / 'mine.py'}:explore"], ["--exec", program]):
        code, other = made_for(cli, *words)
        assert code == 0
        assert other["adversary"] == told["adversary"]
        assert other["world"] == told["world"]


@pytest.mark.slow
def test_an_explorer_of_this_process_that_walks_otherwise_in_the_world_left_is_refuted():
    from allworlds.explorers.builtin.algorithm1 import algorithm1
    from allworlds.protocol import Move

    calls = []

    def changing(first, *, choices):
        calls.append(first)
        if len(calls) == 1:
            yield Move(0)
        return (yield from algorithm1(first, choices=choices))

    told = run(changing, "adversary:corridor:1")
    assert not told.adversary.same
    assert told.verdict.value == "refuted"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["run", "greedy", "adversary:corridor:0"], "1 <= F <= 20"),
        (["run", "greedy", "adversary:lattice:3"], "adversary:corridor:F"),
        (["run", "quotient", "adversary:corridor:1"], "directional"),
        (["run", "greedy", "adversary:corridor:1", "--task", "cover"], "'map' is"),
        (["run", "greedy", "adversary:corridor:1", "--lighthouse", "none"], "directional"),
        (["run", "greedy", "--family", "adversary:corridor:1"], "allworlds run EXPLORER"),
        (["play", "adversary:corridor:1"], "allworlds run EXPLORER"),
        (["ambiguity", "class", "adversary:corridor:1"], "allworlds run EXPLORER"),
        (
            ["compare", "greedy", "prudent", "--family", "adversary:corridor:1"],
            "allworlds run EXPLORER",
        ),
    ],
)
@pytest.mark.slow
def test_what_has_no_adversary_is_refused_in_a_line(cli, words, said):
    code, out, err = cli(*words)
    assert (code, out) == (2, "")
    assert said in err
    assert err.count("\n") == 1
