"""To play: whatever is answered is what the world says, and nothing else is told."""

import io
import json
import sys
from types import SimpleNamespace

import pytest

from allworlds import Drop, Move, Pick
from allworlds.cli.app import call
from allworlds.explorers.loading import HASH_SEED
from allworlds.inputs.checks import InputError
from allworlds.maps.build import cycle
from allworlds.studies import run as run_module
from allworlds.studies.run import _asked_hash_seed, play
from allworlds.world import Directional, Movable, World
from allworlds.world.named import map_of_family
from small import LOOP, PATH


def script(*actions):
    """A player that does these, and the list of what it is told."""
    told, left = [], iter([*actions, None])

    def player(percept, refused):
        told.append((str(percept), refused))
        return next(left)

    return player, told


def test_a_player_is_told_what_it_senses_and_its_walk_is_recorded():
    world = World(PATH, Directional(0), 0)
    player, told = script(Move(0), Move(1))
    played = play(world, player=player)
    assert [percept for percept, _ in told] == [str(p) for p in played.transcript.percepts]
    assert played.transcript.actions == (Move(0), Move(1))
    assert played.transcript.percepts == [world.percepts[d] for d in (0, 1, 3)]
    assert played.exit_code == 0


def test_what_cannot_be_done_is_told_and_is_no_step():
    player, told = script(Pick(), Drop(), Drop(), Pick())
    played = play(World(LOOP, Movable(), 0), player=player)
    assert played.transcript.actions == (Drop(), Pick())
    assert [refused for _, refused in told] == [
        "",
        "a Pick only where a marker lies",
        "",
        "a Drop only with a marker in hand",
        "",
    ]


def test_without_a_player_nothing_is_done():
    assert play("theta").transcript.steps == ()


def test_a_world_that_is_none_is_refused():
    with pytest.raises(InputError, match="is no World"):
        play(3)


def test_a_world_of_a_family_is_that_of_its_seed_and_holes():
    told = {"seed": 3, "holes": "20%"}
    assert play("lattice:3x4", **told).world.map == map_of_family("lattice:3x4", "20%", 3)
    for name, value in told.items():
        with pytest.raises(InputError, match=f"{name} {value} has no effect on world 'theta'"):
            play("theta", **{name: value})
        with pytest.raises(InputError, match=f"{name} {value} .* on a world that is given"):
            play(World(PATH), **{name: value})


@pytest.mark.parametrize("end", ["\n", ""])
def test_a_line_is_an_action_and_the_conversation_is_no_result(end, capsys, monkeypatch):
    monkeypatch.setattr(sys, "stdin", io.StringIO(f"0\n -1 \ndrop\nleft \x1b\n{end}"))
    assert call(["play", "theta", "--json"]) == 0
    said = capsys.readouterr()
    document = json.loads(said.out)
    assert [row.get("move") for row in document["transcript"]] == [None, 0, 2]
    assert document["path"] is None
    assert said.err.count("you sense: degree 3") == 3
    assert said.err.count("> ") == 5
    assert "that cannot be done: the directional lighthouse gives no markers" in said.err
    legal = "a number, drop, pick, write K with a number K, or an empty line to end"
    assert f"is not one of {legal}" in said.err
    assert "\x1b" not in said.err


def test_a_number_is_written_where_the_lighthouse_has_room_for_it(capsys, monkeypatch):
    monkeypatch.setattr(sys, "stdin", io.StringIO("write 3\nwrite 2\nwrite two\n\n"))
    assert call(["play", "theta", "--lighthouse", "whiteboard:states=3", "--json"]) == 0
    said = capsys.readouterr()
    assert [row.get("write") for row in json.loads(said.out)["transcript"]] == [None, 2]
    assert "that cannot be done: a Write(k) with k from 0 to 2" in said.err
    assert "you sense: degree 3, marks 2" in said.err
    assert "'write two' is not one of" in said.err


def test_nothing_is_called_marked_where_vertices_have_labels(capsys, monkeypatch):
    monkeypatch.setattr(sys, "stdin", io.StringIO("1\n\n"))
    assert call(["play", "theta", "--lighthouse", "labels"]) == 0
    said = capsys.readouterr()
    assert "you sense: degree 3, label 1, bearing 0\n> you sense: degree 3, label 2" in said.err
    assert "mark" not in said.out + said.err


def test_a_page_is_written_and_nothing_is_played(tmp_path, capsys):
    page = tmp_path / "play.html"
    assert call(["play", "theta", "-o", str(page)]) == 0
    assert page.read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
    said = capsys.readouterr()
    assert "".join(said.out.split()) == f"PAGE{page},tobeopenedinawebbrowser"
    assert not said.err


def test_a_page_that_cannot_be_written_is_refused_before_anything_is_done(tmp_path, capsys):
    assert call(["play", "theta", "-o", f"html:{tmp_path}"]) == 2
    assert "cannot be written" in capsys.readouterr().err


@pytest.mark.parametrize(("named", "seed"), [("7", 7), ("random", None), ("", None)])
def test_the_hash_seed_of_the_environment_is_that_of_a_run(named, seed, monkeypatch):
    monkeypatch.setenv(HASH_SEED, named)
    assert _asked_hash_seed() == seed


@pytest.mark.parametrize(
    ("edges", "kind", "cost"),
    [
        (200, "directional", "algorithm1"),
        (201, "directional", None),
        (3, "door", "algorithm1-door"),
        (3, "compass", None),
    ],
)
def test_algorithm_1_is_run_beside_in_worlds_that_are_not_too_large(edges, kind, cost, monkeypatch):
    def played(subject, *_):
        return SimpleNamespace(cost=subject.name)

    monkeypatch.setattr(run_module.single, "single_run", played)
    world = World(cycle(edges), kind, 0)
    assert run_module._cost_of_algorithm1(world) == cost
