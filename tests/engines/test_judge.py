"""The judges of a lane, without a lane."""

import sys
from random import Random
from types import MappingProxyType, SimpleNamespace

import pytest

from allworlds import log
from allworlds.engines import judge
from allworlds.engines.batch import FIRST, SECOND, Due, RunBatch, Work
from allworlds.engines.judge import PythonJudge, table_of
from allworlds.engines.judges import Judges
from allworlds.engines.players import Logs
from allworlds.engines.tally import RunCounter, Tally
from allworlds.engines.units import LevelUnit, Scope, units_of_level
from allworlds.inputs.checks import InputError
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.world import Directional, World
from allworlds.world.lighthouses.kinds import lighthouse_kind
from small import EDGE

RUN = Due(0, 0, World(EDGE, Directional(0)))


def judge_of(task):
    return PythonJudge(RunCounter(Scope(Extent(MapClass.MAPS, 1), Rules(task=task)), 1), "mine")


def test_a_task_that_ended_a_run_must_say_so_again():
    cover = judge_of("cover")
    assert cover.judged(RUN, bytes((0, log.OVER))).outcome.violation is None
    with pytest.raises(InputError) as error:
        cover.judged(RUN, bytes((log.OVER,)))
    assert str(error.value) == (
        f"over of task 'cover' is no function of the run: it has ended one in {EDGE}, and says now "
        "that it goes on"
    )


def test_a_log_that_is_no_walk_is_an_error_of_ours_or_of_a_lighthouse_of_the_users(monkeypatch):
    read = log.Log(bytes((log.DROP, 0, log.OVER)))
    with pytest.raises(RuntimeError, match=r"^the log of a run is no walk in its world: "):
        judge_of("map").episode(RUN.world, read)
    monkeypatch.setattr(judge, "kind_of", lambda _: SimpleNamespace(codes=("code",)))
    with pytest.raises(InputError) as error:
        judge_of("map").episode(RUN.world, read)
    assert str(error.value).startswith(
        f"lighthouse 'directional' is no function of the run: an action in {EDGE} was legal, and "
        "is not when the log is followed: "
    )


@pytest.mark.parametrize(
    ("schedules", "given", "every"),
    [("one", None, False), ("one", (0,), False), ("all", None, True), ("all", (0,), False)],
)
def test_every_schedule_is_tried_unless_the_choices_are_given(schedules, given, every):
    scope = Scope(Extent(MapClass.MAPS, 1), Rules(policy="lifo"), schedules=schedules)
    python = PythonJudge(RunCounter(scope, 1), "mine", given)
    assert python.every is every
    message = python.worlds_message([RUN])
    assert (message["every"], message["policy"]) == (every, "fifo" if every else "lifo")
    (batch,) = python.batches(Work(LevelUnit(1, (-1,)), Tally(1)), lambda: 9)
    assert batch.due(0).script == (given or ())


@pytest.mark.parametrize("size", [1, 4, 9, 10])
def test_all_batches_but_the_last_are_full(size):
    python = PythonJudge(RunCounter(Scope(Extent(MapClass.MAPS, 2), Rules()), 1), "mine")
    work = Work(LevelUnit(2, (-3,)), Tally(1))
    sizes = [len(batch) for batch in python.batches(work, lambda: size)]
    assert sizes == [size] * (9 // size) + [9 % size] * (9 % size > 0)
    assert not work.tally.rows


def test_worlds_without_a_place_are_left_out_and_counted():
    rules = Rules(lighthouse_kind("natural"))
    left_out = 0
    for edges in (1, 2):
        scope = Scope(Extent(MapClass.MAPS, edges), rules)
        python = PythonJudge(RunCounter(scope, 1), "mine")
        for unit in units_of_level(scope.extent, edges):
            work = Work(unit, Tally(1))
            for batch in python.batches(work, lambda: 1):
                work.tally.add(batch.tally)
            without = sum(run.lighthouse is None for run in python.counter.runs(unit))
            assert work.tally.left_out == without
            left_out += without
    assert left_out


def test_a_log_must_make_the_choices_that_were_due():
    judge = judge_of("map")
    due = RUN._replace(script=(1,))
    for taken in (0, 1):
        judge.every = True
        one = log.choice(taken, 2) + log.motion(0) + log.answer((0, 1), (1, 0), 1)
        assert judge.judged(due, one).fits is (taken == 1)
        judge.every = False
        assert judge.judged(due, one).fits


@pytest.mark.parametrize(("law", "choices"), [("crash", (1, 0)), ("no-estimate", (1,))])
def test_the_choices_of_a_lost_run_are_those_that_were_due(law, choices):
    lost = log.choice(1, 2) + log.fault(law, "an action", "none")
    assert judge_of("map").judged(RUN._replace(script=(1, 0)), lost).outcome.choices == choices


def test_a_run_of_many_schedules_has_the_cost_of_the_cheapest():
    scope = Scope(
        Extent(MapClass.MAPS, 1), Rules(laws=("map", "pose"), step_budget=9), schedules="all"
    )
    python = PythonJudge(RunCounter(scope, 1), "mine")
    work = Work(LevelUnit(1, (-1,)), Tally(1))
    end = log.answer((0, 1), (1, 0), 1)
    for steps, least in ((3, 3), (1, 1), (5, 1)):
        (batch,) = python.batches(work, lambda: 9)
        batch.logs[0] = [log.motion(0) * steps + end]
        assert python.judge(batch)
        ((due, cost),) = work.best.values()
        assert (due, cost) == (batch.due(0), least)
        assert batch.tally.traversals == steps
        assert not batch.broken
    batch.judged[0] = batch.judged[0]._replace(fits=False)
    python.judge(batch)
    assert batch.broken == [0]


@pytest.mark.parametrize(
    ("kept", "compiles", "started"),
    [(False, True, 1), (False, False, 0), (True, True, 0)],
)
def test_one_lane_starts_the_compiler_once_if_nothing_is_kept(kept, compiles, started, monkeypatch):
    calls = []
    engine = SimpleNamespace(is_kept=lambda: kept, compile_apart=lambda: calls.append(1))
    monkeypatch.setitem(sys.modules, "allworlds.engines.compiled_engine", engine)
    judges = Judges(judge_of("map"), Random(1), native=False, compiles=compiles)
    assert [judges._is_compiled() for _ in range(3)] == [kept] * 3
    assert len(calls) == started


# ---------------------------------------------------------------- messages


ALONE = (0, 1), (1, 0)
END = log.answer(*ALONE, 1)


def batch_of(judge, *logs):
    """A batch of one run as often as there are logs of the first play."""
    batch = RunBatch(judge, Work(LevelUnit(1, (-1,)), Tally(1)), [RUN] * len(logs))
    batch.take(FIRST, range(len(logs)), logs)
    return batch


def test_a_player_is_told_the_table_of_a_world_or_the_world_itself():
    judge = judge_of("map")
    message = judge.worlds(batch_of(judge, b"", b"", b""), [0, 2])
    named = {key: message[key] for key in ("kind", "runs", "order", "any_answer", "hear", "lines")}
    assert named == {
        "kind": "table", "runs": 2, "order": [0, 1], "any_answer": False, "hear": False,
        "lines": False,
    }  # fmt: skip
    budget = judge.rules.budget(EDGE)
    assert message["content"] == [(table_of(RUN.world), None, False, budget, "", ())] * 2
    cover = judge_of("cover")
    message = cover.worlds(batch_of(cover, b""), [0])
    assert (message["kind"], message["any_answer"]) == ("model", True)
    (((world, over), *_),) = message["content"]
    assert (world, over) == (RUN.world, cover.rules.task.over)


# One vertex with an edge, dart 0, and a loop, darts 1 and 2; dart 3 is the other end of the edge.
LOOP_AND_EDGE = CombinatorialMap((1, 2, 0, 3), (3, 2, 1, 0))


@pytest.mark.parametrize(
    ("marker", "start", "table"),
    [
        (1, 0, [(0, 3, 3, 1, 2), (0, 2, 3, 1, 1), (0, 1, 3, 1, 3), (3, 0, 1, 0, 0)]),
        (3, 3, [(0, 1, 1, 1, 1), (1, 0, 3, 0, 0), (1, 3, 3, 0, 0), (1, 2, 3, 0, 0)]),
    ],
)
def test_the_table_of_a_world_has_five_numbers_for_each_dart(marker, start, table):
    world = World(LOOP_AND_EDGE, Directional(marker), start)
    assert [*table_of(world)] == [number for row in table for number in row]


def test_a_player_of_percepts_is_told_whether_the_task_ends_the_run():
    for task, end, over in (("map", END, False), ("cover", bytes((log.OVER,)), True)):
        judge = judge_of(task)
        message = judge.percepts(batch_of(judge, log.motion(0) + end, b""), [0], [0])
        assert (message["kind"], message["order"]) == ("record", [0])
        ((sensed, told, ends, *_),) = message["content"]
        assert (len(sensed), told, ends) == (6, None, over)


@pytest.mark.parametrize(
    ("told", "sent"), [(None, None), (3, 3), (MappingProxyType({"n": 3}), {"n": 3})]
)
def test_what_a_lighthouse_tells_is_sent_as_a_number_or_a_dictionary(told, sent):
    run = SimpleNamespace(world=SimpleNamespace(told=told, map=EDGE), script=(1,))
    judge = judge_of("map")
    entry = judge._entry(run, b"table")
    assert entry == (b"table", sent, False, judge.rules.budget(EDGE), "", (1,))
    assert type(entry[1]) is type(sent)


# ---------------------------------------------------------------- batches


def test_logs_come_in_one_message_or_one_by_one():
    judge = judge_of("map")
    batch = batch_of(judge, b"a", b"b", b"c")
    assert batch.plain
    assert batch.logs == [{0: b"a", 1: b"b", 2: b"c"}, {}]
    assert batch.unplayed(SECOND, range(3)) == [0, 1, 2]
    batch.take(SECOND, [1], Logs.of([b"y"]))
    assert batch.logs[SECOND] == {1: b"y"}
    assert batch.unplayed(SECOND, range(3)) == [0, 2]
    whole = Logs.of([b"x", b"y", b"z"])
    batch.take(SECOND, range(3), whole)
    assert batch.logs[SECOND] is whole
    assert batch.unplayed(SECOND, range(3)) == []
    batch.take(SECOND, [2], [b"lost"])
    assert batch.logs[SECOND] == {0: b"x", 1: b"y", 2: b"lost"}
    batch.take(SECOND, range(3), [b"1", b"2", b"3"])
    assert batch.logs[SECOND] == {0: b"1", 1: b"2", 2: b"3"}


def test_a_run_goes_on_with_its_next_schedule_until_all_were_tried():
    judge = judge_of("map")
    first, last = (log.choice(taken, 2) + log.motion(0) + END for taken in (0, 1))
    batch = batch_of(judge, first, last)
    assert batch.follow_ups() == []
    judge.every = True
    assert batch.follow_ups() == [RUN._replace(script=(1,))]


def test_what_was_judged_once_is_not_judged_again(monkeypatch):
    judge = judge_of("map")
    batch = batch_of(judge, log.motion(0) + END)
    one = batch.outcome(0)
    assert one.fits
    monkeypatch.setattr(judge, "judged", None)
    assert batch.outcome(0) is one
    assert [*batch.record(0).percepts] == [*one.outcome.episode.walk.percepts]
    assert batch.record(0)._replace(percepts=()) == ((), RUN.world, (), False)


# ---------------------------------------------------------------- the choice of a judge


class Compiled:
    """In place of the compiled judge: it notes which batches it was compared on."""

    def __init__(self, python, seed, *, native):
        self.python, self.seed, self.native, self.compared = python, seed, native, []

    def compare_with(self, batches):
        self.compared.append([*batches])


@pytest.fixture
def judges(monkeypatch):
    """The judges of a scope with this last level; those with so many worlds are to be compiled."""
    module = SimpleNamespace(CompiledJudge=Compiled)
    monkeypatch.setitem(sys.modules, "allworlds.engines.compiled_judge", module)

    def made(last, least, *, kept=True):
        scope = Scope(Extent(MapClass.MAPS, last), Rules())
        python = PythonJudge(RunCounter(scope, 1, least), "mine")
        longest = SimpleNamespace(getrandbits=lambda bits: 2**bits - 1)
        judges = Judges(python, longest, native=True, compiles=False)
        monkeypatch.setattr(judges, "_is_compiled", lambda: kept)
        return judges

    return made


def unit(edges):
    return LevelUnit(edges, (-1,))


@pytest.mark.parametrize(
    ("edges", "last", "least", "in_compiled_code"),
    [
        (3, 3, 74, True),
        (3, 3, 75, False),
        (2, 3, 74, True),  # it is kept for the next level
        (2, 3, 75, False),
        (2, 2, 74, False),
        (1, 3, 74, False),
        (1, 1, 0, True),
        (3, 3, None, False),
    ],
)
def test_a_level_is_judged_in_compiled_code_if_it_or_the_next_is_large(
    judges, edges, last, least, in_compiled_code
):
    of = judges(last, least)
    assert (of.of(unit(edges)) is of.python) is not in_compiled_code


def test_only_units_of_a_level_are_judged_in_compiled_code(judges):
    of = judges(3, 0)
    assert of.of(object()) is of.python
    assert isinstance(of.of(unit(3)), Compiled)


def test_code_that_is_not_kept_yet_is_asked_for_again_if_the_python_judge_may_do_without(judges):
    of = judges(3, 2, kept=False)
    assert of.of(unit(3)) is of.python
    of._is_compiled = lambda: True
    assert isinstance(of.of(unit(3)), Compiled)
    assert isinstance(judges(3, 0, kept=False).of(unit(3)), Compiled)


def test_one_compiled_judge_is_compared_once_on_the_logs_of_small_worlds(judges):
    of = judges(4, 2)
    batches = [SimpleNamespace(work=Work(unit(edges), None)) for edges in (1, 3, 4, 2)]
    batches.append(SimpleNamespace(work=Work(object(), None)))
    for batch in batches:
        of.remember(batch)
    compiled = of.of(unit(4))
    of.remember(batches[0])
    assert of.of(unit(3)) is compiled
    assert compiled.compared == [[batches[0], batches[1], batches[3]]]
    assert of._small == []
    assert (compiled.python, compiled.native, compiled.seed()) == (of.python, True, 2**63 - 1)


@pytest.mark.parametrize("least", [0, None])
def test_no_batch_is_remembered_if_there_is_no_later_comparison(judges, least):
    of = judges(3, least)
    of.remember(SimpleNamespace(work=Work(unit(1), None)))
    assert of._small == []
