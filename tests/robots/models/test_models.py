"""Every built-in model, on all small maps, under every scheduler, against the second opinion."""

from itertools import product
from random import Random

import pytest

from allworlds.inputs.checks import InputError
from allworlds.maps import CombinatorialMap, rooted_code
from allworlds.maps.families import family
from allworlds.protocol.actions import (
    Do,
    Drop,
    IllegalAction,
    Move,
    Percept,
    Pick,
    Wait,
    Watch,
    Write,
)
from allworlds.protocol.turns import Automaton
from allworlds.robots.model import QUIET, SCHEDULERS, Model, Places
from allworlds.robots.models.faults import Crash
from allworlds.robots.models.snapshot import Snapshot
from allworlds.robots.models.table import model_of
from allworlds.robots.models.views import Eyes
from allworlds.robots.single_search import search
from fair_runs import Automata
from one_by_one import agree
from small import EDGE, LOLLIPOP, LOOP, PATH, TRIANGLE, all_maps, slowest


def meets(first, *, told=None):
    seen = yield Move(1)
    if seen.marks == 0:
        yield Move(seen.degree)


def sees(first, *, told=None):
    seen = yield Do("first")
    if len(seen) == 2:
        yield Do("second")


def heads(first, *, told=None):
    seen = yield Do(0)
    yield Do(len(seen[1]) % seen[1][0])


def goes_on(first, *, told=None):
    turn = 0
    for _ in range(told if told < 3 else 2):
        _, moved, _, others = yield Move(turn)
        turn = int(moved) + len(others)


def writes(first, *, told=None):
    _, _, board = yield Do({"write": [told, first[1]], "move": 1})
    if board is None:
        _, _, board = yield Write(7)
    elif board == 7:
        yield Wait()
    return board


def talks(first, *, told=None):
    if told == 0:
        yield Do({"go": 1})
        _, others = yield Move(1)
        return len(others)
    _, others = first
    if others and others[0][1] is None:
        _, others = yield Watch()
    yield Move(others[0][1]["go"] if others and others[0][1] else 0)
    return None


def lays(first, *, told=None):
    yield Drop()
    _, tokens, _, _ = yield Move(1)
    if tokens:
        yield Pick()
    yield Move(tokens)


def looks(first, *, told=None):
    seen = yield Do({"write": told[1]})
    seen = yield Move(told[1])
    return [0] if seen[3] is None else [0, seen[3]]


def maps_badly(first, *, told=None):
    seen = yield Move(1)
    for _ in range(2):
        seen = yield Move(seen.marks)


CASES = {
    "meeting": (meets, 2),
    "meeting:multiplicity=weak,apart=false": (meets, 2),
    "snapshot": (sees, 2),
    "snapshot:exclusive=true,crossing=false,multiplicity=strong": (sees, 2),
    "snapshot:local=true,apart=false": (sees, 2),
    "snapshot:chirality=true": (heads, 2),
    "one-interval": (goes_on, 2),
    "one-interval:exclusive=false,ends=true,apart=false": (goes_on, 2),
    "shared-whiteboard:labels=true": (writes, 2),
    "shared-whiteboard:goal=agree,apart=false": (writes, 2),
    "shared-whiteboard:goal=agree,apart=false,at_once=true": (writes, 2),
    "face-to-face": (talks, 2),
    "face-to-face:together=false": (talks, 2),
    "tokens": (lays, 2),
    "tokens:apart=false,movable=false": (lays, 2),
    "black-hole": (looks, 2),
    "black-hole:at_once=true": (looks, 2),
    "lighthouse:directional": (maps_badly, 1),
    "crash:1+meeting": (meets, 2),
    "crash:2+black-hole:at_once=true": (looks, 2),
    "hidden:1+lighthouse:directional": (maps_badly, 1),
    "hidden:2+meeting:apart=false": (meets, 2),
}


MORE_SCHEDULES = {"snapshot:local=true,apart=false": 7, "snapshot": 7}
"""Where the adversary has more choices: fewer starts, and in async ``longest`` turns."""


@pytest.mark.parametrize(("edges", "longest"), [(2, 2), slowest(2, 3), slowest(3, 3)])
@pytest.mark.parametrize("name", CASES)
def test_schedules_one_by_one_are_as_many_and_end_alike(name, edges, longest):
    """Under each scheduler that the model has; in ssync and async from some of the starts.

    With 3 edges in fsync and central alone: the schedules of the others are too many to be tried.
    """
    model, _ = model_of(name)
    program, robots = CASES[name]
    fewer = MORE_SCHEDULES.get(name, 1)
    one_in = {"fsync": 1, "central": 1, "ssync": 7 * fewer, "async": 19 * fewer}
    tried = 0
    schedulers = [each for each in model.schedulers if edges < 3 or one_in[each] == 1]
    for map_, scheduler in product(all_maps(edges), schedulers):
        every = [*model.starts(map_, robots)]
        for starts in every[:: one_in[scheduler]]:
            budget = longest if scheduler == "async" and fewer > 1 else 3
            tried += agree(map_, starts, model, [program] * robots, scheduler, budget=budget)
    assert tried


@pytest.mark.parametrize("name", CASES)
def test_renumbered_darts_make_no_difference(name):
    model, _ = model_of(name)
    program, robots = CASES[name]
    drawn = Random(5)
    for map_, scheduler in product(all_maps(3)[::5], model.schedulers):
        for starts in [*model.starts(map_, robots)][::7]:
            names = [*map_.darts]
            drawn.shuffle(names)
            other = map_.relabelled(names)
            renamed = tuple(names[dart] for dart in starts)
            found, again = (
                search(m, s, model, [program] * robots, scheduler, budget=3)
                for m, s in ((map_, starts), (other, renamed))
            )
            assert told_of(found) == told_of(again)


def told_of(found):
    whole = not found.law and (found.unfinished, found.configurations, found.schedules)
    return found.law, len(found.events), whole


# ---------------------------------------------------------------- snapshots


def rules(number):
    """An oblivious robot that chooses by the robots of its first view."""

    def step(memory, views):
        actions = [Do("first"), Do(len(views) - 1), Do("either"), Wait()]
        return memory, actions[(number >> 2 * sum(views[0][0][1:2])) % 4]

    return Automaton(None, step)


@pytest.mark.parametrize("scheduler", SCHEDULERS)
def test_fair_cycles_of_snapshots_are_those_of_the_second_algorithm(scheduler):
    model = Snapshot()
    broken = 0
    for map_, start in ((PATH, (0, 3)), (TRIANGLE, (0, 2)), (LOLLIPOP, (0, 1)), (EDGE, (0, 1))):
        for number in range(0, 64, 5):
            team = [rules(number)] * 2
            found = search(map_, start, model, team, scheduler)
            (condition,) = model.progress(map_)
            second = Automata(map_, model, team, scheduler)
            assert bool(found.law) == second.breaks(start, condition)
            broken += bool(found.law)
    assert broken


def test_a_direction_is_that_of_the_look():
    """A robot goes to where it saw the nearer one, though that is the farther one when it moves."""
    ring = family("cycle:6")
    (state,) = Snapshot().initial(ring, (0, 4, 6))
    views = Snapshot().sensed(ring, state, 0)
    assert [view[0] for view in views] == [[1, 0, 0, 1, 1, 0], [1, 0, 1, 1, 0, 0]]
    ((looked, _),) = Snapshot().looked(ring, state, 0, Do("second"))
    (away, _), *_ = Snapshot().step(ring, looked, {1: Do("first"), 2: Do("first")})
    ((after, _),) = Snapshot().step(ring, away, {0: Do("second")})
    assert ring.vertex_of[after.darts[0]] == 1
    assert after.due == (None, None, None)


def test_without_chirality_a_mirrored_map_looks_the_same():
    model = Snapshot(multiplicity="strong")
    for map_ in all_maps(3):
        mirrored = map_.mirrored()
        for start in [*model.starts(map_, 2)][::3]:
            (one,), (other,) = (model.initial(m, start) for m in (map_, mirrored))
            for robot in (0, 1):
                assert model.sensed(map_, one, robot) == model.sensed(mirrored, other, robot)


def test_of_equal_views_the_adversary_takes_one():
    ring = family("cycle:4")
    (state,) = Snapshot().initial(ring, (0, 4))
    steps = [*Snapshot().step(ring, state, {0: Do("first")})]
    assert len(steps) == 2
    assert all(words.startswith("robot 0 leaves by dart") for _, words in steps)


def test_a_view_is_the_whole_map():
    """From the degrees and the other ends of the darts the map can be drawn."""
    model = Snapshot(chirality=True)
    for map_ in all_maps(3):
        (state,) = model.initial(map_, (0,))
        _, degrees, alpha = model.sensed(map_, state, 0)
        sigma, first = [], 0
        for degree in degrees:
            sigma += [first + (place + 1) % degree for place in range(degree)]
            first += degree
        drawn = CombinatorialMap(sigma, alpha)
        assert drawn.relabelled(range(len(alpha))) == drawn

        assert rooted_code(drawn.sigma, drawn.alpha, 0) == rooted_code(map_.sigma, map_.alpha, 0)


def test_with_chirality_a_robot_keeps_its_direction_on_a_ring():
    ring, model = family("cycle:5"), Snapshot(chirality=True)
    (state,) = model.initial(ring, (1,))
    places = []
    for action in (Do(0), Do(0), Do(1), Do(0)):
        ((state, _),) = model.step(ring, state, {0: action})
        places.append(ring.vertex_of[state.darts[0]])
    assert places == [1, 2, 1, 2]


# ---------------------------------------------------------------- boards, tokens, faults


def test_a_number_on_a_board_is_no_truth():
    model, _ = model_of("shared-whiteboard:apart=false")
    (state,) = model.initial(LOOP, (0, 0))
    one, true = (next(model.step(LOOP, state, {0: Do({"write": v})}))[0] for v in (1, True))
    assert one != true
    assert model.sensed(LOOP, true, 1)[2] is True


def test_of_two_that_write_at_once_the_adversary_says_who_is_last():
    model, _ = model_of("shared-whiteboard:apart=false")
    (state,) = model.initial(LOOP, (0, 0))
    steps = [*model.step(LOOP, state, {0: Write(1), 1: Write(2)})]
    assert [(model.sensed(LOOP, to, 0)[2], words) for to, words in steps] == [
        (1, "robot 0 writes last"),
        (2, "robot 1 writes last"),
    ]


def test_of_two_that_pick_one_token_one_gets_it():
    model, _ = model_of("tokens:apart=false")
    (state,) = model.initial(LOOP, (0, 0))
    ((state, _),) = model.step(LOOP, state, {0: Drop()})
    hands = [to.hands for to, _ in model.step(LOOP, state, {0: Pick(), 1: Pick()})]
    assert hands == [(1, 1), (0, 2)]


def test_a_crashed_robot_stays_and_is_seen():
    model, _ = model_of("crash:1+meeting")
    states = [*model.initial(EDGE, (0, 1))]
    assert [sorted(state.living) for state in states] == [[0, 1], [1], [0]]
    assert model.sensed(EDGE, states[1], 0) is None
    found = search(EDGE, (0, 1), model, [go_once] * 2, "central")
    assert (found.law, [e.world for e in found.events]) == ("", [])


def go_once(first):
    yield Move(0)


def test_a_crash_of_who_shall_come_is_a_deadlock():
    model, _ = model_of("crash:1+meeting:labels=true")

    def comes(first, *, told):
        yield Move(0) if told else Watch()
        yield Watch()

    found = search(EDGE, (0, 1), model, [comes] * 2, "async")
    assert found.law == "deadlock"
    assert search(EDGE, (0, 1), model.inside, [comes] * 2, "async").holds


def test_a_hidden_marker_is_seen_again_after_the_next_step():
    model, _ = model_of("hidden:1+meeting")
    (state,) = model.initial(EDGE, (0, 1))
    after = [to for to, _ in model.step(EDGE, state, {0: Move(0)})]
    assert [model.sensed(EDGE, to, 0) for to in after] == [Percept(1, 1), Percept(1, 0)]
    assert [model.sensed(EDGE, to, 1) for to in after] == [Percept(1, 1)] * 2
    steps = [*model.step(EDGE, after[1], {0: Move(0)})]
    assert [to.left for to, _ in steps] == [0]


def test_a_robot_that_has_crashed_has_no_marker_that_could_be_hidden():
    model, _ = model_of("hidden:1+crash:1+meeting")
    state, *_ = model.initial(EDGE, (0, 1))
    after = [to for to, _ in model.step(EDGE, state, {0: Move(0)})]
    assert {model.sensed(EDGE, to, 0) for to in after} == {None, Percept(1, 1), Percept(1, 0)}


def test_a_view_is_clockwise_unless_it_is_said_to_be_the_other_way():
    eyes, map_ = Eyes(1, 1), family("corridor:2")
    views = {way: [eyes.view(map_, [0], dart, way) for dart in map_.darts] for way in (1, -1)}
    assert [eyes.view(map_, [0], dart) for dart in map_.darts] == views[1] != views[-1]


# ---------------------------------------------------------------- refusals and pictures


@pytest.mark.parametrize(
    ("name", "action", "told"),
    [
        ("shared-whiteboard:apart=false", Drop(), "legal is Do with the keys write and move, not "),
        ("shared-whiteboard:apart=false", Do({}), "legal is Do with the keys write and move, not "),
        ("shared-whiteboard:apart=false", Do({"go": 1}), "legal is Do with the keys write and"),
        ("shared-whiteboard:apart=false", Do({"move": True}), "legal is Do with the keys write"),
        ("face-to-face", Drop(), "legal are Move and Do, not "),
        ("one-interval", Do(1), "legal is a Move, not "),
        ("snapshot", Do(1), r"legal is Do\(k\), and k from 0 to 0, not "),
        ("snapshot", Do(-1), r"legal is Do\(k\), and k from 0 to 0, not "),
        ("snapshot", Do(value=False), r"legal is Do\(k\), and k from 0 to 0, not "),
        ("snapshot", Move(0), r"legal is Do\(k\), and k from 0 to 0, not "),
        ("snapshot:chirality=true", Do("either"), r"legal is Do\(k\), and k from 0 to 0, not "),
        ("meeting", Do(1), "legal is a Move, not "),
    ],
)
def test_an_action_without_a_meaning_is_refused_with_the_legal_ones(name, action, told):
    model, _ = model_of(name)
    state, *_ = model.initial(EDGE, (0, 1))
    with pytest.raises(IllegalAction, match=told):
        [*model.step(EDGE, state, {0: action})]


@pytest.mark.parametrize(("walk", "right"), [([0], True), ([], False), (0, False), ([True], False)])
def test_an_answer_about_a_black_hole_is_a_list_of_numbers(walk, right):
    model, _ = model_of("black-hole")
    (state,) = model.initial(EDGE, (0, 0))
    told = model.flaw(EDGE, state, [walk, None])
    assert told == ("" if right else f"the walk {walk!r} does not lead to the hole")


def test_nobody_answers_about_a_black_hole():
    model, _ = model_of("black-hole")
    (state,) = model.initial(EDGE, (0, 0))
    assert model.flaw(EDGE, state, [None, None]) == "nobody answers"


def test_a_picture_shows_visited_vertices_and_tokens():
    one, _ = model_of("one-interval")
    (state,) = one.initial(PATH, (0, 1))
    assert one.places(PATH, state) == Places((0, 1), {0: "visited", 1: "visited"})
    laying, _ = model_of("tokens:tokens=2")
    (state,) = laying.initial(PATH, (0, 1))
    for _ in range(2):
        ((state, _),) = laying.step(PATH, state, {1: Drop()})
    assert laying.places(PATH, state) == Places((0, 1), {1: "2 tokens"})


@pytest.mark.parametrize("goal", ["gather", "explore"])
def test_a_snapshot_has_at_most_eight_robots(goal):
    model = Snapshot(goal=goal)
    assert [*model.initial(EDGE, (0,) * 8)]
    with pytest.raises(InputError, match="robots = 9 are more than 8, the most of this goal"):
        [*model.initial(EDGE, (0,) * 9)]


def test_a_condition_of_a_wrapped_model_is_of_the_states_inside():
    model, _ = model_of("crash:1+snapshot")
    (condition,) = model.progress(EDGE)
    assert condition[:2] == ("all robots at one vertex", True)
    held = [condition.holds(next(model.initial(EDGE, starts))) for starts in ((0, 0), (0, 1))]
    assert held == [True, False]
    assert model.says_progress


def test_a_condition_without_a_predicate_is_that_of_the_wrapped_model():
    class Still(Model):
        def progress(self, map_):
            yield QUIET

    assert [*Crash(Still()).progress(EDGE)] == [QUIET]


def test_markers_are_hidden_in_models_with_marks_alone():
    model, _ = model_of("hidden:1+tokens")
    (state,) = model.initial(EDGE, (0, 1))
    with pytest.raises(InputError, match=r"hidden is of models with percepts that have marks, not"):
        model.sensed(EDGE, state, 0)
