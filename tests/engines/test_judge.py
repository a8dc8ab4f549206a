"""The judges of a lane, without a lane."""

import sys
from random import Random
from types import SimpleNamespace

import pytest

from allworlds import log
from allworlds.engines import judge
from allworlds.engines.batch import Due, Work
from allworlds.engines.judge import PythonJudge
from allworlds.engines.judges import Judges
from allworlds.engines.tally import RunCounter, Tally
from allworlds.engines.units import LevelUnit, Scope
from allworlds.inputs.checks import InputError
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.world import Directional, World
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
