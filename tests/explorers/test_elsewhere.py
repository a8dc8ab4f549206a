"""A robot that starts elsewhere: the lighthouses with ``start=any``, and the search for v0."""

import json
from inspect import signature

import pytest

import allworlds
from allworlds import Estimate, Move
from allworlds.engines.engine_table import kind_of
from allworlds.explorers.builtin import elsewhere as module
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.builtin.elsewhere import FromElsewhere
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.loading import ELSEWHERE_BUDGET, Subject, built_in, own_bound, with_search
from allworlds.explorers.sources import content_digest, names_explorer, whole_name
from allworlds.inputs.checks import InputError
from allworlds.judging.episode import Answered, play
from allworlds.judging.laws.bounds import paper_bound
from allworlds.judging.laws.law_table import Case
from allworlds.protocol.choices import Choices
from allworlds.world.lighthouses.kinds import lighthouse_kind
from allworlds.world.world import World

SHOWING_V0 = {
    "directional": "algorithm1",
    "door": "algorithm1-door",
    "cluster": "algorithm1-cluster",
}
BUDGET = 400


def worlds(edges, kind="directional"):
    single = ",single=true" if kind == "cluster" else ""
    name = f"{kind}:start=any{single}"
    return list(allworlds.worlds(edges=edges, lighthouse=name, places="all"))


def played(explorer, world, budget=BUDGET):
    """The log, and whether the answer is right: ``right``, ``pose``, ``map``, or ``none``."""
    subject = Subject("it", frozenset(), explorer)
    episode = play(world, subject.player(), Choices(lambda *_: 0, ()), budget)
    if not isinstance(episode.ending, Answered):
        return episode.transcript, "none"
    case = Case(episode.walk, (), episode.ending.answer)
    return episode.transcript, case.answer


def answers(explorer, found):
    return {played(explorer, world)[1] for world in found}


# ---------------------------------------------------------------- the lighthouses


def test_a_map_with_a_start_has_as_many_places_as_darts():
    assert len(worlds(1)) == 2 * 2  # a loop, an edge; two places each
    assert len(worlds(2)) == 2 * 2 + 10 * 4
    for kind in ("directional", "door"):
        for world in worlds(2, kind):
            assert world.lighthouse.start == "any"
            assert world.map.darts == range(
                len({w.dart for w in world.lighthouse.as_kind.places(world.map, 0)})
            )


def test_a_cluster_stands_at_each_end_of_each_edge_that_is_alone():
    path = World.from_json(
        {"sigma": [0, 2, 1, 3], "alpha": [1, 0, 3, 2]}, missing="cluster:start=any"
    )
    assert [w.dart for w in path.lighthouse.as_kind.places(path.map, 0)] == [0, 1, 2, 3]
    assert path.lighthouse.legal_darts(path.map, 0) == [0, 1, 2, 3]


@pytest.mark.parametrize("kind", SHOWING_V0)
def test_a_world_is_written_and_read_with_its_option(kind):
    for world in worlds(2, kind):
        assert world.to_json()["lighthouse"]["start"] == "any"
        assert World.from_json(json.dumps(world.to_json())) == world
        assert (world.percepts[world.lighthouse.dart].marks, world.lighthouse.as_kind.folds) == (
            1,
            False,
        )


@pytest.mark.parametrize("kind", SHOWING_V0)
def test_places_are_numbered_whatever_the_darts_are_called(kind):
    for world in worlds(2, kind):
        other = world.relabelled([*reversed(world.map.darts)])
        assert other.lighthouse.number(other.map, other.start) == world.lighthouse.number(
            world.map, 0
        )


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("directional:start=all", "option start = 'all'; legal are v0 and any"),
        ("position:start=any", "has no option 'start'"),
        ("natural:start=any", "has no option 'start'"),
    ],
)
def test_other_starts_are_refused(name, reason):
    with pytest.raises(InputError, match=reason):
        lighthouse_kind(name)


def test_a_start_in_a_document_is_refused_if_it_is_no_word():
    place = {"kind": "directional", "dart": 1, "start": 1}
    with pytest.raises(InputError, match=r"lighthouse.start = 1 is not a text"):
        World.from_json({"sigma": [0, 1], "alpha": [1, 0], "lighthouse": place})
    with pytest.raises(InputError, match="cannot stand at dart 1 with start 0; legal are 0"):
        World.from_json({"sigma": [0, 1], "alpha": [1, 0], "lighthouse": {**place, "start": "v0"}})


def test_the_compiled_engine_does_not_take_them_for_others():
    names = ("cluster:single=true,start=any", "cluster:start=any", "directional:start=any")
    assert [kind_of(lighthouse_kind(name).as_class) for name in names] == ["", "", ""]
    assert kind_of(lighthouse_kind("cluster:single=true").as_class) == "cluster-single"
    assert kind_of(lighthouse_kind("directional:start=v0").as_class) == "directional"


# ---------------------------------------------------------------- the search


@pytest.mark.parametrize(("kind", "inside"), SHOWING_V0.items())
def test_the_robot_finds_the_map_from_everywhere(kind, inside):
    assert answers(FromElsewhere(BUILT_IN[inside].explore), worlds(2, kind)) == {"right"}


def test_algorithm_1_alone_needs_to_start_at_v0():
    assert answers(algorithm1, [w for w in worlds(2) if w.first.marks]) == {"right"}
    assert answers(algorithm1, [w for w in worlds(2) if not w.first.marks]) > {"right"}


def test_at_v0_the_search_costs_nothing():
    for world in worlds(2):
        if world.first.marks:
            assert played(FromElsewhere(algorithm1), world)[0] == played(algorithm1, world)[0]


def cost_of_search(degree, motions):
    """At most: all words of at most 1, 2, ... motions, each edge of their tree out and back."""
    tree, cost = 0, 0
    for _ in range(motions):
        tree = degree * (2 + tree)
        cost += tree
    return cost


def test_the_search_keeps_its_bound():
    for m in (1, 2, 3):
        for world in worlds(2) if m < 3 else worlds(3)[::40]:
            map_ = world.map
            steps = played(FromElsewhere(algorithm1), world)[0].cost
            limit = cost_of_search(max(map_.degrees), map_.diameter)
            assert steps <= limit + paper_bound(map_.vertex_count, map_.edge_count)
    for degree in range(2, 6):
        for motions in range(6):
            assert cost_of_search(degree, motions) <= 8 * degree**motions - 8


def test_all_words_of_a_length_are_tried_and_taken_back():
    """Where v0 is never shown: after words of up to two motions the robot is where it began."""
    world = allworlds.World(
        allworlds.CombinatorialMap([1, 2, 0, 4, 3, 5], [3, 5, 4, 0, 2, 1]), "none"
    )
    state, seen, visited = world.initial, world.first, []
    walk = FromElsewhere(algorithm1).tried(seen.degree, 2, 0)
    try:
        action = next(walk)
        while True:
            state, seen = world.step(state, action)
            visited.append(state.dart)
            action = walk.send(seen)
    except StopIteration as end:
        found, due = end.value
    assert found is None
    assert world.map.turn(state.dart, due) == world.start
    degrees = [world.map.degree_at[world.map.alpha[d]] for d in world.map.vertices[0]]
    assert len(visited) == sum(2 + 2 * degree for degree in degrees)


# ---------------------------------------------------------------- mutants of the search


class WrongWayBack(FromElsewhere):
    """After the words behind a dart it goes back as if it had just come."""

    def tried(self, degree, longest, due):
        for _ in range(degree if longest else 0):
            seen = yield Move(due)
            if seen.marks == 1:
                return seen, 0
            found, _ = yield from self.tried(seen.degree, longest - 1, 0)
            if found:
                return found, 0
            yield Move(0)
            due = 1
        return None, due


class EvenWordsOnly(FromElsewhere):
    """It leaves words of odd lengths out: it looks only after every second motion."""

    def tried(self, degree, longest, due, *, looks=False):
        for _ in range(degree if longest else 0):
            seen = yield Move(due)
            if looks and seen.marks == 1:
                return seen, 0
            found, back = yield from self.tried(seen.degree, longest - 1, 0, looks=not looks)
            if found:
                return found, 0
            yield Move(back)
            due = 1
        return None, due


class LastDartForgotten(FromElsewhere):
    """It leaves the last dart of each vertex out."""

    def tried(self, degree, longest, due):
        return (yield from super().tried(max(degree - 1, 1), longest, due))


class NeverFar(FromElsewhere):
    """It tries words of one motion, again and again."""

    def tried(self, degree, longest, due):
        return (yield from super().tried(degree, min(longest, 1), due))


@pytest.mark.parametrize(
    ("mutant", "sigma", "alpha", "dart"),
    [
        (EvenWordsOnly, [0, 1], [1, 0], 1),
        (NeverFar, [0, 2, 1, 3], [1, 0, 3, 2], 3),
        (LastDartForgotten, [1, 0, 3, 2, 4, 6, 5, 7], [2, 4, 0, 5, 1, 3, 7, 6], 7),
        (WrongWayBack, [1, 0, 3, 4, 2, 6, 5, 7], [2, 4, 0, 5, 1, 3, 7, 6], 7),
    ],
)
def test_wrong_searches_are_refuted(mutant, sigma, alpha, dart):
    """In the smallest worlds that do: with 1, 2, 4 and 4 edges, of the 792 with up to 4."""
    place = {"kind": "directional", "dart": dart, "start": "any"}
    world = World.from_json({"sigma": sigma, "alpha": alpha, "lighthouse": place})
    assert played(mutant(algorithm1), world)[1] == "none"
    assert played(FromElsewhere(algorithm1), world)[1] == "right"


# ---------------------------------------------------------------- its name, its rules


def test_the_name_of_a_search_is_read_like_that_of_a_shield(tmp_path):
    file = tmp_path / "mine.py"
    file.write_text("def explore(first):\n    yield\n")
    assert whole_name(f"elsewhere:shield:{file}") == f"elsewhere:shield:{file}:explore"
    assert names_explorer("elsewhere:algorithm1")
    subject = with_search(built_in("algorithm1"))
    assert (subject.name, subject.keywords) == ("elsewhere:algorithm1", {"choices"})
    assert content_digest(subject) == "built-in"
    assert isinstance(subject.explore, module.FromElsewhere)


def test_a_search_brings_its_lighthouse_and_its_budget():
    for name, kind in [
        ("algorithm1", "directional:start=any"),
        ("shield:algorithm1", "directional:start=any"),
        ("mine.py:explore", "directional:start=any"),
        ("algorithm1-door", "door:start=any"),
        ("algorithm1-cluster", "cluster:single=true,start=any"),
        ("dfs", "labels"),
    ]:
        subject = Subject(f"elsewhere:{name}", frozenset())
        assert (subject.lighthouse, subject.step_budget) == (kind, ELSEWHERE_BUDGET)


@pytest.mark.parametrize(
    ("name", "kind", "bound"),
    [
        ("elsewhere:algorithm1", "directional:start=any", "paper + 8*D**d"),
        ("elsewhere:mine.py:f", "directional", "paper + 8*D**d"),
        ("elsewhere:shield:algorithm1", "directional:start=any", "9*paper + 8*D**d"),
        ("elsewhere:algorithm1-door", "door:start=any", "paper + 2*m*(m+1) + 2*(D-1) + 8*D**(d+1)"),
        (
            "elsewhere:algorithm1-cluster",
            "cluster:single=true,start=any",
            "paper + 2*m**2 + 2*D + 8*D**d",
        ),
        ("elsewhere:algorithm1", "directional:start=any+told:n", None),
        ("elsewhere:shield:algorithm1", "directional:start=any+told:n", None),
        ("algorithm1-door", "door:start=any", None),
        ("algorithm1-door", "door", "paper + 2*m*(m+1) + 2*(d0-1)"),
    ],
)
def test_its_bound_is_that_of_the_explorer_and_of_the_search(name, kind, bound):
    assert own_bound(name, kind) == bound


def test_a_search_for_what_is_not_shown_is_refused():
    with pytest.raises(InputError, match=r"looks for one mark, which .* and not 'labels'"):
        own_bound("elsewhere:dfs", "labels")
    with pytest.raises(InputError, match="needs the directional lighthouse"):
        own_bound("shield:algorithm1", "directional:start=any")


def test_an_answer_says_where_the_robot_ends():
    """It goes back to the start at last: ``here`` is right there too."""

    def and_back(first):
        estimate = yield from FromElsewhere(algorithm1)(first)
        yield Move(0)
        map_ = estimate.map
        return Estimate(map_, map_.alpha[estimate.here])

    assert answers(and_back, worlds(2)) == {"right"}


def test_it_takes_the_keywords_of_what_begins_at_v0():
    assert signature(FromElsewhere(algorithm1)) == signature(algorithm1)
