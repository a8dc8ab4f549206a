"""The judges of a lane, without a lane."""

import sys
from random import Random
from types import SimpleNamespace

import pytest

from allworlds import log
from allworlds.engines import judge
from allworlds.engines.batch import Due
from allworlds.engines.judge import PythonJudge
from allworlds.engines.judges import Judges
from allworlds.engines.tally import RunCounter
from allworlds.engines.units import Scope
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
