import importlib.util
from functools import partial

import pytest

from allworlds import check, count, worst
from allworlds.engines.engine_table import ENGINES, engine_for, obstacle, why_not_compiled
from allworlds.engines.limits import Limits
from allworlds.engines.listeners import Listener
from allworlds.engines.single import subject_of
from allworlds.engines.units import Scope
from allworlds.explorers.loading import Subject, load
from allworlds.inputs.checks import InputError
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from shared_fixtures import EXPLORERS

pytestmark = pytest.mark.usefixtures("compiled")


class Stopper(Listener):
    """A listener that presses Ctrl-C, or only listens."""

    def __init__(self, after=None):
        self.worlds, self.after, self.notices = 0, after, []

    def level(self, edges, worlds):
        pass

    def progress(self, worlds):
        self.worlds += worlds
        if self.after is not None and self.worlds > self.after:
            raise KeyboardInterrupt

    def notice(self, text):
        self.notices.append(text)


def closure():
    def foreign(first):
        yield from ()

    return foreign


@pytest.mark.parametrize(
    ("options", "reason"),
    [
        ({"policy": "random:1"}, "random:1"),
        ({"schedules": "all", "edges": 2}, "plays one schedule a run"),
        ({"step_budget": 100_000}, "100000"),
        ({"edges": 13}, "13"),
        ({"explore": closure()}, "foreign"),
    ],
)
def test_what_the_kernel_cannot_do_is_refused_by_name(options, reason):
    options = {"edges": 3, **options}
    with pytest.raises(InputError, match="engine 'kernel'") as refusal:
        check(engine="kernel", **options)
    assert reason in str(refusal.value)


def test_an_engine_that_is_none_is_refused():
    with pytest.raises(InputError, match=r"'warp' is not one of auto, python, kernel"):
        check(edges=2, engine="warp")


def scope_to(edges, lighthouse="directional"):
    return Scope(Extent(MapClass.MAPS, edges, None), Rules(lighthouse, own_bound="none"))


MINE, PROGRAM = Subject("mine.py:explore", frozenset()), Subject("exec:./mine", frozenset())
LIBRARY, CLOSURE = Subject("native:mine.so", frozenset()), Subject("f", frozenset(), closure())


@pytest.mark.parametrize(
    ("subject", "memory", "engine"),
    [
        (MINE, None, "kernel"),
        (PROGRAM, None, "kernel"),
        (CLOSURE, None, "python"),
        # A compiler needs more than an explorer in Python may be meant to have.
        (MINE, 500, "python"),
        (PROGRAM, 500, "python"),
        (LIBRARY, 500, "kernel"),
    ],
)
def test_auto_takes_it_for_explorers_of_ones_own_too(subject, memory, engine):
    assert engine_for("auto", scope_to(5), subject, memory).name == engine
    assert engine_for("auto", scope_to(4), subject, memory).name == "python"
    assert engine_for("auto", scope_to(5, "movable"), subject, memory).name == "python"


@pytest.mark.parametrize("name", ["right", "planted"])
def test_both_judges_of_a_users_explorer_count_and_find_the_same(name):
    compiled, general = (
        check(f"{EXPLORERS / 'wrong.py'}:{name}", edges=2, engine=engine).to_json()
        for engine in ("kernel", "python")
    )
    for report in (compiled, general):
        del report["engine"]
    assert compiled == general


@pytest.fixture
def no_compiler(monkeypatch):
    """A machine without numba."""
    there = importlib.util.find_spec
    monkeypatch.setattr(
        "allworlds.inputs.checks.find_spec", lambda name: None if name == "numba" else there(name)
    )


@pytest.mark.usefixtures("no_compiler")
def test_without_a_compiler_the_python_engine_does_what_it_can():
    assert check(edges=2, engine="auto").engine == "python"
    scope = Scope(Extent(MapClass.MAPS, 6, None), Rules("directional"))
    assert engine_for("auto", scope, load("algorithm1")) is ENGINES["python"]
    assert "pip install" in why_not_compiled(scope, load("algorithm1"))
    assert [row.rooted for row in count(edges=2).rows] == [2, 10]


@pytest.mark.usefixtures("no_compiler")
@pytest.mark.parametrize(
    ("options", "reason"),
    [
        ({"where": "cubic"}, "does not know the condition 'cubic'"),
        ({"task": "cover"}, "judges the task map alone, not 'cover'"),
        ({"policy": "random:1"}, "random:1"),
        ({"explore": closure()}, "judges no explorer that lives in this process alone"),
    ],
)
def test_the_compiler_is_not_asked_for_where_compiled_code_would_refuse_all_the_same(
    options, reason
):
    told = Stopper(after=0)
    assert check(edges=6, listener=told, **options).exit_code
    assert told.worlds
    assert told.notices == []
    with pytest.raises(InputError) as refusal:
        check(edges=6, engine="kernel", **options)
    assert reason in str(refusal.value)
    assert "numba" not in str(refusal.value)


@pytest.mark.usefixtures("no_compiler")
def test_the_compiler_is_not_asked_for_where_the_memory_is_limited(wrong):
    scope, subject = (
        Scope(Extent(MapClass.MAPS, 6, None), Rules()),
        subject_of(wrong("right"), Limits()),
    )
    assert "needs numba" in why_not_compiled(scope, subject)
    assert why_not_compiled(scope, subject, 500) == ""


@pytest.mark.usefixtures("no_compiler")
def test_the_compiler_is_not_asked_for_where_there_is_no_room():
    with pytest.raises(InputError, match="99") as refusal:
        worst(edges=99)
    assert "numba" not in str(refusal.value)


@pytest.mark.usefixtures("no_compiler")
@pytest.mark.parametrize("asked", [worst, partial(check, engine="kernel")])
def test_what_needs_the_compiler_says_how_to_install_it(asked):
    with pytest.raises(InputError, match=r"needs numba: .*pip install '\.\[fast\]'"):
        asked()


@pytest.mark.parametrize(
    ("edges", "budget", "told"),
    [
        (12, 10_920, ""),
        (12, None, ""),
        (13, 10_920, "has room for 12 edges, not for 13"),
        (12, 10_921, "has room for a step budget of 10920, not of 10921"),
    ],
)
def test_compiled_code_has_room_for_so_many_edges_and_steps(edges, budget, told):
    scope = Scope(Extent(MapClass.MAPS, edges), Rules("directional", step_budget=budget))
    assert obstacle(scope, load("algorithm1")) == told
