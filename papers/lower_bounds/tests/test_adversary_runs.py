"""``run EXPLORER adversary:corridor:F``: explorers of every kind, and what is refused."""

import json
import sys

import pytest

from allworlds import run
from allworlds.document import replace
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.maps import family
from allworlds.outcome import Exit, Verdict
from allworlds.protocol import Move
from allworlds.reports import text
from allworlds.world import Deciding, World, adversary_named

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


def made_for(cli, *words, size="1"):
    world = f"adversary:corridor:{size}"
    code, out, err = cli("run", *words, world, "--seed", "1", "--no-walk", "--json")
    assert err == ""
    told = json.loads(out)
    assert told["adversary"].pop("tester") == (words[0] == "algorithm1")
    return code, told


def test_a_built_in_explorer_gets_its_own_bad_world():
    told = run("algorithm1", adversary_named("adversary:corridor:1", 1))
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
@pytest.mark.long
def test_a_users_explorer_that_shows_what_it_has_settled_is_treated_as_the_built_in_one(cli, mine):
    _, told = made_for(cli, "algorithm1", size="2")
    _, other = made_for(cli, f"{mine / 'mine.py'}:explore", size="2")
    assert told["adversary"]["settled"] == 1
    assert (other["adversary"], other["world"]) == (told["adversary"], told["world"])
    program = f"{sys.executable} {mine / 'program.py'}"
    _, unshown = made_for(cli, "--exec", program, size="2")
    assert (unshown["adversary"]["settled"], unshown["adversary"]["depended"]) == (0, 1)
    assert unshown["adversary"]["same"]


class Generous(Deciding):
    """An adversary that excludes nothing: it makes the first pair that is asked for an edge."""

    def _exclude(self, root, wanted):
        for y in wanted:
            self._mate |= {self._mate[root]: self._mate[y], self._mate[y]: self._mate[root]}
            self._mate |= {root: y, y: root}
        return not wanted


def test_a_tester_that_does_less_than_every_tester_must_is_an_error(monkeypatch, cli):
    monkeypatch.setattr("allworlds.engines.single.Deciding", Generous)
    told = run("algorithm1", "adversary:corridor:1")
    assert told.adversary.same
    assert told.adversary.excluded < told.adversary.testers_exclude == 24
    assert (told.verdict, told.exit_code) == (Verdict.ERROR, Exit.INTERNAL)
    assert "0 pairs excluded, less than every tester" in text("run", told, 200)
    assert not replace(told.adversary, excluded=24, cost=95).keeps_the_bound
    assert replace(told.adversary, excluded=24, cost=96).keeps_the_bound
    # Of an explorer that is not known as a tester the cost is a measurement.
    mine = run(lambda first: (yield from algorithm1(first)), "adversary:corridor:1")
    assert (mine.cost, mine.exit_code) == (told.cost, Exit.HOLDS)
    assert "are a measurement" in text("run", mine, 100)


def test_what_was_played_is_told_in_a_line_and_also_where_a_law_is_broken(cli):
    words = "run", "algorithm1", "adversary:corridor:1", "--seed", "1"
    code, out, _ = cli(*words, "-q")
    assert (code, out.count("\n")) == (0, 1)
    assert "882 traversals of at most 4,322, the same walk as against adversary:corridor:1" in out
    code, out, _ = cli(*words, "--bound", "100")
    assert code == 1
    assert "made by    adversary:corridor:1 with seed 1: 56 pairs" in out


def test_a_walk_that_is_left_out_is_in_the_rows_of_a_file(cli, tmp_path):
    files = [tmp_path / "with.csv", tmp_path / "without.csv"]
    for file, words in zip(files, ([], ["--no-walk"]), strict=True):
        assert cli("run", "greedy", "theta", "--csv", file, *words)[0] == 0
    assert files[0].read_text() == files[1].read_text()
    assert len(files[0].read_text().splitlines()) > 2


def test_the_walk_can_be_left_out(cli):
    words = "run", "algorithm1", "adversary:corridor:1", "--seed", "1"
    _, with_walk, _ = cli(*words)
    _, without, _ = cli(*words, "--no-walk")
    assert "move" in with_walk
    assert "move" not in without
    assert "made by" in without


@pytest.mark.slow
def test_an_explorer_of_this_process_that_walks_otherwise_in_the_world_left_is_refuted():
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
        (["run", "greedy", "adversary:corridor:0"], "F is at least 1"),
        (["check", "adversary:corridor:1"], "no explorer, but makes a world for one"),
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
