"""Tasks: what counts as done, and what is wrong with a run."""

import pickle

import numpy as np
import pytest

from allworlds import run
from allworlds.inputs.checks import InputError
from allworlds.judging.episode import Answered, AroundExplorer, Over
from allworlds.judging.rules import Rules
from allworlds.judging.tasks import TASKS, Task, task_named
from allworlds.judging.walk import Walk
from allworlds.protocol.actions import Estimate, Move
from allworlds.world import Nothing, World
from small import EDGE, LOLLIPOP, LOOP, PATH, TORUS, TRIANGLE, all_maps

JUDGES = """
def sees(world, transcript, answer):
    return repr(answer)


def least(steps):
    return lambda world, transcript, answer: f"{transcript.cost} of {steps}"


def raises(world, transcript, answer):
    return {}["lamp"]


def numbers(world, transcript, answer):
    return 3


nothing = 3


def looks(world, transcript, answer):
    steps = [(str(action), percept.degree) for action, percept in transcript]
    assert len(transcript) == len(steps) == len(transcript.actions)
    assert transcript.first.degree == world.map.degree_at[world.start]
    assert [percept.degree for percept in transcript.percepts[1:]] == [each[1] for each in steps]
    visited, walked = sorted(transcript.visited), sorted(transcript.walked)
    return f"{steps} {transcript.darts} {visited} {walked} {transcript.cost}"


def half(world, transcript, answer):
    return None


half.over = lambda world, transcript: 2 * len(transcript.walked) >= world.map.edge_count


def vague(world, transcript, answer):
    return None


vague.over = lambda world, transcript: transcript.cost

calls = []


def other_text(world, transcript, answer):
    calls.append(answer)
    return f"call {len(calls)}"


def every_other(world, transcript, answer):
    calls.append(answer)
    return "odd" if len(calls) % 2 else None


every_other.over = lambda world, transcript: calls.append(None) or len(calls) % 2 == 1
"""


def walk(map_, *motions, start=0):
    """The walk of these motions."""
    return Walk.of(World(map_, Nothing(), start), map(Move, motions))


def wrong(task, map_, motions, ending, start=0):
    return task_named(task).flaw(walk(map_, *motions, start=start), ending)


@pytest.mark.parametrize(
    ("task", "map_", "motions", "answer", "said"),
    [
        ("stop", PATH, [0, 1], None, None),
        ("stop", PATH, [0], None, "1 of 3 vertices not visited"),
        ("stop", LOOP, [], 3, None),
        ("home", EDGE, [0, 0], None, None),
        ("home", EDGE, [0], None, "the walk ended at another vertex than that where it began"),
        ("home", EDGE, [], None, "1 of 2 vertices not visited"),
        ("count:n", PATH, [], 3, None),
        ("count:n", PATH, [], 2, "the answer 2, and the number of vertices is 3"),
        ("count:n", EDGE, [], 2.0, "the answer 2.0, and the number of vertices is 2"),
        ("count:n", LOOP, [], True, "the answer True, and the number of vertices is 1"),
        ("count:m", TORUS, [], 2, None),
        ("count:m", TORUS, [], "2", "the answer '2', and the number of edges is 2"),
        ("face", TRIANGLE, [], 3, None),
        ("face", TORUS, [], 4, None),
        ("face", LOOP, [], 1, None),
        ("cover", PATH, [0], None, "1 of 3 vertices not visited"),
        ("cover", PATH, [0, 1], None, None),
        ("cover:edges", LOLLIPOP, [0], None, "1 of 2 edges not walked along"),
        ("cover:edges", LOLLIPOP, [0, 1], None, None),
    ],
)
def test_a_run_is_judged_by_its_task(task, map_, motions, answer, said):
    assert wrong(task, map_, motions, Answered(answer)) == said


class Two:
    def __index__(self):
        return 2


@pytest.mark.parametrize("two", [2, np.int64(2), np.uint8(2), Two()])
def test_whatever_is_an_integer_to_python_is_an_answer_in_numbers(two):
    def explore(first):
        yield Move(0)
        return two

    for task, right in [("count:n", True), ("count:m", False), ("face", True)]:
        assert run(explore, World(EDGE, Nothing()), task=task).finding is None or not right
    judged = run(explore, World(PATH, Nothing()), task="count:n").finding
    assert "the answer 2, and the number of vertices is 3" in judged.seen


@pytest.mark.parametrize("two", [np.bool_(1), 2.5j, np.float32(2)])
def test_what_is_no_integer_to_python_is_no_answer_in_numbers(two):
    def explore(first):
        yield Move(0)
        return two

    assert run(explore, World(EDGE, Nothing()), task="count:n").finding.law == "no-estimate"


@pytest.mark.parametrize("here", [1, np.int64(1)])
def test_the_place_in_an_estimate_is_any_integer(here):
    def explore(first):
        yield Move(0)
        return Estimate(EDGE, here)

    assert run(explore, World(EDGE, Nothing())).finding is None
    assert Estimate(EDGE, here).to_json()["here"] == 1


def test_left_of_the_first_dart_is_the_face_that_turning_left_goes_round():
    for map_ in all_maps(4):
        dart, length = 0, 0
        while length == 0 or dart != 0:
            # Arrived, the next dart clockwise of the one back is the first to the left.
            dart = map_.sigma[map_.alpha[dart]]
            length += 1
        assert wrong("face", map_, [], Answered(length)) is None
        assert wrong("face", map_, [], Answered(length + 1)) is not None


@pytest.mark.parametrize(("task", "steps"), [("cover", 2), ("cover:edges", 2)])
def test_a_run_is_over_with_the_last_vertex_or_edge_and_not_before(task, steps):
    over, gone = task_named(task).over, walk(PATH)
    for step in range(1, steps + 1):
        assert not over(gone)
        gone.step(Move(1))
        assert over(gone) == (step == steps)


def fields_of(walk):
    return {name: getattr(walk, name) for name in (*Walk.__struct_fields__, "here", "walked")}


@pytest.mark.parametrize("map_", all_maps(2))
def test_a_walk_in_a_player_has_in_each_step_the_fields_of_that_in_the_judge(map_):
    world, asked = World(map_, Nothing()), []
    there = AroundExplorer(pickle.loads(pickle.dumps(world)), asked.append)
    motions = ()
    for k in (None, 0, 1, 1, 0, 2):
        if k is not None:
            there.move(k)
            motions += (k,)
        _ = there.over
        gone = walk(map_, *motions)
        assert fields_of(asked[-1]) == fields_of(gone)
        assert fields_of(pickle.loads(pickle.dumps(asked[-1]))) == fields_of(gone)
        assert len(asked[-1].darts) == 1 + len(motions)


def test_what_ends_runs_gets_to_a_player_with_the_world():
    over = pickle.loads(pickle.dumps(task_named("cover").over))
    assert [over(walk(PATH, *motions)) for motions in ((), (1,), (1, 1))] == [False, False, True]


def test_where_there_is_one_vertex_all_is_visited_before_the_first_step():
    assert task_named("cover").is_over(walk(TORUS))
    assert not task_named("cover:edges").is_over(walk(TORUS))
    assert not task_named("stop").is_over(walk(TORUS))
    assert task_named("stop").over is None


def test_an_estimate_gets_to_a_judge_as_it_is(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "judges.py").write_text(JUDGES)
    estimate = Estimate(EDGE, 1)
    assert wrong("judges.py:sees", EDGE, [], Answered(estimate)) == repr(estimate)
    assert wrong("judges.py:sees", EDGE, [], Over()) == "None"
    assert wrong("judges.py:least?steps=4", EDGE, [0, 0], Answered(None)) == "2 of 4"
    with pytest.raises(InputError, match=r"raises KeyError: .lamp."):
        wrong("judges.py:raises", EDGE, [], Answered(None))
    with pytest.raises(InputError, match="returns 3, no text and not None"):
        wrong("judges.py:numbers", EDGE, [], Answered(None))
    with pytest.raises(InputError, match="is no function, but 3"):
        task_named("judges.py:nothing")
    assert wrong("judges.py:looks", PATH, [0, 1], Answered(None)) == (
        "[('move 0', 2), ('move 1', 1)] [0, 1, 3] [0, 1, 2] [0, 2] 2"
    )
    half = task_named("judges.py:half")
    assert not half.is_over(walk(TORUS))
    assert half.is_over(walk(TORUS, 0))
    with pytest.raises(InputError, match=r"over of task .judges.py:vague. returns 0, no"):
        task_named("judges.py:vague").is_over(walk(TORUS))
    for name in ("there", "count:x", "home:edges", "map:x"):
        with pytest.raises(InputError, match=rf"'{name}' is not one of map, .*, face, path/to"):
            task_named(name)


@pytest.mark.parametrize(
    ("judge", "says"),
    [("other_text", "'call 1' and 'call 2'"), ("every_other", "'odd' and None")],
)
def test_a_judge_that_is_not_the_same_twice_refutes_nobody(tmp_path, monkeypatch, judge, says):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "judges.py").write_text(JUDGES)
    refused = rf"^task 'judges.py:{judge}' is no function of the run: asked twice, it says {says} "
    with pytest.raises(InputError, match=refused + "of a run in "):
        wrong(f"judges.py:{judge}", EDGE, [0], Answered(None))


def test_an_over_that_is_not_the_same_twice_ends_no_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "judges.py").write_text(JUDGES)
    refused = r"^over of task 'judges.py:every_other' is no .* it says True and False of a run in "
    with pytest.raises(InputError, match=refused):
        task_named("judges.py:every_other").is_over(walk(EDGE))


def test_a_judge_is_given_as_a_function_that_another_process_can_import(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    (tmp_path / "own_judges.py").write_text(
        "def sees(world, transcript, answer):\n    return None\n"
    )
    from own_judges import sees

    assert task_named(sees).name == "own_judges:sees"
    assert task_named(sees) == task_named("own_judges:sees")
    with pytest.raises(InputError, match="lives in this process alone"):
        task_named(lambda world, transcript, answer: None)


def test_the_laws_of_an_estimate_are_those_of_the_task_map():
    assert Rules().task == Task("map")
    assert "bound" in Rules().applying
    for name in {*TASKS} - {"map"}:
        assert Rules(task=name).applying == ()
        assert Rules(task=name, bound="2*m").applying == ("bound",)
        with pytest.raises(InputError, match="law 'map' is about the task map alone"):
            Rules(task=name, laws=["map"])
