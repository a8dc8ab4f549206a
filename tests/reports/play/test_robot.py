"""The page's robot senses and does what the worlds say, and its notes are those of the log."""

import pytest

import allworlds
from allworlds import CombinatorialMap, Estimate, Move, Percept
from allworlds.judging.laws.folding import fold
from allworlds.maps import rooted_isomorphism
from allworlds.protocol.actions import Drop, Pick, Write
from allworlds.reports.web.sections import world_data
from allworlds.world import LIGHTHOUSES, Directional, IllegalAction, State, World
from allworlds.world.lighthouses.kinds import lighthouse_kind
from small import EDGE, LOLLIPOP, LOOP, PLANE, TORUS, all_maps


def state_json(state):
    lying, written = list(state.lying), [list(pair) for pair in state.written]
    return {"dart": state.dart, "lying": lying, "hand": state.hand, "written": written}


def action_json(action):
    match action:
        case Move(k):
            return {"move": k}
        case Drop():
            return {"drop": True}
        case Pick():
            return {"pick": True}
        case Write(k):
            return {"write": k}


def true_answer(world, state, action):
    try:
        after, percept = world.step(state, action)
    except IllegalAction:
        return None
    return [state_json(after), percept.to_json()]


MARKING = Drop(), Pick(), *map(Write, range(4))


def reachable(world):
    """Every state of the world, by search."""
    found = {world.initial: None}
    queue = [world.initial]
    for state in queue:
        for action in (*map(Move, range(world.sensed(state).degree)), *MARKING):
            try:
                after, _ = world.step(state, action)
            except IllegalAction:
                continue
            if after not in found:
                found[after] = None
                queue.append(after)
    return queue


@pytest.mark.parametrize(
    "name",
    [
        *("movable:markers=2", "movable:markers=2,pick=false", "movable:markers=3,distinct=true"),
        *("whiteboard:states=3", "doormarks:states=3", "compass+movable:markers=2,distinct=true"),
    ],
)
def test_marks_are_left_and_taken_up_as_in_the_world(name, ask):
    for map_ in (EDGE, LOOP, PLANE, TORUS):
        world = World(map_, next(lighthouse_kind(name).as_class.places(map_, 0)), 0)
        asked = [(s, a) for s in reachable(world) for a in (Move(0), Move(1), *MARKING)]
        given = [[state_json(state), action_json(action)] for state, action in asked]
        told = ask(what="steps", world=world_data(world), asked=given)
        assert told == [true_answer(world, state, action) for state, action in asked]
        assert None in told


def steps_of(transcript):
    return [
        {"action": action_json(action), "percept": percept.to_json()}
        for action, percept in transcript.steps
    ]


def home_again(transcript):
    """The conclusion of every arrival at the marker: the pointed dart is the one of the start."""
    known = [0, transcript.first.bearing]
    return [
        [known, [step, percept.bearing]]
        for step, percept in enumerate(transcript.percepts)
        if step and percept.bearing is not None
    ]


def notes_of(ask, world, log, dart):
    """The notes of the page after this log, if the reader claims to be at ``dart``."""
    return ask(
        what="notes",
        first=log.first.to_json(),
        steps=steps_of(log),
        conclusions=home_again(log),
        movable=False,
        world=world_data(world),
        dart=dart,
    )


def test_notes_with_every_return_concluded_are_the_folded_log(ask):
    for map_ in all_maps(3):
        for place in Directional.places(map_, 0):
            run = allworlds.run("algorithm1", World(map_, place, 0))
            log = run.outcome.episode.transcript
            for length in range(len(log.steps) + 1):
                part = type(log)(log.first, log.steps[:length])
                told = notes_of(ask, run.world, part, 0)
                assert not told["wrong"]
                folded = fold(part)
                assert told["open"] == sum(x == y for x, y in enumerate(folded.alpha))
                assert (told["estimate"] is not None) == (told["open"] == 0)


def test_complete_notes_are_the_world_with_the_robot_in_its_place(ask):
    for map_ in all_maps(3):
        for place in Directional.places(map_, 0):
            run = allworlds.run("algorithm1", World(map_, place, 0))
            log = run.outcome.episode.transcript
            state = run.world.initial
            for action in log.actions:
                state, _ = run.world.step(state, action)
            for dart in run.world.map.darts:
                told = notes_of(ask, run.world, log, dart)
                answer = told["estimate"]
                found = Estimate(CombinatorialMap(answer["sigma"], answer["alpha"]), answer["here"])
                same = bool(rooted_isomorphism(found.map, found.here, map_, dart))
                assert told["right"] == same
                assert told["right"] or dart != state.dart


def note(ask, moves, conclusions, percepts):
    return ask(
        what="notes",
        first=percepts[0],
        steps=[
            {"action": {"move": k}, "percept": percept}
            for k, percept in zip(moves, percepts[1:], strict=True)
        ],
        conclusions=conclusions,
        movable=False,
    )


def percept(degree, marks=0, bearing=None):
    return {"degree": degree, "marks": marks, "bearing": bearing}


@pytest.mark.parametrize(
    ("moves", "conclusions", "percepts", "why"),
    [
        ([0], [[[0, 0], [1, 0]]], [percept(1, 1, 0), percept(2)], "degrees 1 and 2"),
        ([0], [[[0, 0], [1, 1]]], [percept(2, 1, 0), percept(2)], "other marks or labels"),
        (
            [0],
            [[[0, 0], [1, 1]]],
            [percept(2, 1, 0), percept(2, 1, 0)],
            "would point along two darts",
        ),
        ([0], [[[0, 0], [1, 0]]], [percept(2), percept(2)], "lead to itself"),
        ([0], [[[0, 0], [0, 1]]], [percept(2), percept(2)], "two darts of place 0"),
    ],
)
def test_a_conclusion_against_what_was_sensed_is_told(moves, conclusions, percepts, why, ask):
    assert why in note(ask, moves, conclusions, percepts)["wrong"]


def test_a_wrong_conclusion_that_fits_is_left_to_the_robot(ask):
    told = note(ask, [0], [[[0, 0], [1, 1]]], [percept(2), percept(2)])
    assert told == {
        "open": 0,
        "places": 1,
        "wrong": "",
        "estimate": {"sigma": [1, 0], "alpha": [1, 0], "here": 1},
        "right": None,
    }


def test_states_are_those_of_python():
    assert state_json(State(3, (0, 1), 2)) == {
        "dart": 3,
        "lying": [0, 1],
        "hand": 2,
        "written": [],
    }


MAPS = TORUS, PLANE, EDGE, LOOP, LOLLIPOP


@pytest.mark.parametrize("kind", LIGHTHOUSES)
def test_what_is_sensed_has_the_words_of_the_texts(kind, ask):
    places = ((map_, each) for map_ in MAPS for each in LIGHTHOUSES[kind].places(map_, 0))
    map_, lighthouse = next(places)
    world, labels = World(map_, lighthouse, 0), lighthouse.labels_vertices
    percepts = [Percept(3, marks, bearing) for marks in range(4) for bearing in (None, 0, 2)]
    told = ask(
        what="said", world=world_data(world), percepts=[percept.to_json() for percept in percepts]
    )
    assert told == [percept.in_words(labels=labels) for percept in percepts]


def test_an_action_is_known_by_its_name(ask):
    actions = [Move(0), Move(12), Drop(), Pick(), Write(3)]
    assert ask(what="actions", names=[*map(str, actions)]) == [
        [action_json(action), str(action)] for action in actions
    ]
