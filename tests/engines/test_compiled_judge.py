"""What the compiled judge says to the second player of a batch, and the runs that it lays out."""

from array import array
from types import SimpleNamespace

import pytest

from allworlds.engines import compiled_judge
from allworlds.engines.batch import Due, Work
from allworlds.engines.compiled_judge import CompiledBatch, CompiledJudge
from allworlds.engines.judge import PythonJudge
from allworlds.engines.kernel.arrays import RUN_MOTIONS, RUN_NUMBER, RUN_PLACE
from allworlds.engines.kernel.capabilities import LIGHTHOUSES
from allworlds.engines.more_seeds import MoreSeeds
from allworlds.engines.tally import EnginesDisagree, RunCounter
from allworlds.engines.units import Scope, units_of_level
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import rooted_code
from allworlds.world.lighthouses.kinds import lighthouse_kind
from allworlds.world.world import World


@pytest.fixture
def batch(monkeypatch):
    """Two runs of a library that have been judged: three percepts of the first, one more."""
    made = object.__new__(CompiledBatch)
    made.laid, made.plain = SimpleNamespace(runs=2), False
    made.percepts, made.starts, made.motioned = b"abcd", array("i", [0, 3, 4]), "heads of both"
    made.unit = SimpleNamespace(edges=5)
    python = SimpleNamespace(
        judged=None,
        counter=None,
        rules=SimpleNamespace(policy="fifo"),
        message=lambda kind, content, order: {"kind": kind, "content": [*content], "order": order},
    )
    made.by = CompiledJudge(python, lambda: 7, native=True)
    paired = staticmethod(lambda batch, indices, around: zip(indices, around, strict=True))
    monkeypatch.setattr(compiled_judge, "_entries", paired)
    return made


def test_a_library_replays_all_runs_of_a_batch_in_compiled_code(batch):
    message = batch.by.percepts(batch, [0, 1])
    assert (message["kind"], message["runs"], message["again"]) == ("native", 2, True)
    assert (message["percepts"], message["heads"]) == (b"abcd", "heads of both")


@pytest.mark.parametrize(("row", "percepts"), [(0, b"abc"), (1, b"d")])
def test_of_a_part_of_the_runs_it_replays_their_own_percepts(batch, row, percepts):
    message = batch.by.percepts(batch, [row], [0])
    assert message == {"kind": "record", "content": [(row, percepts)], "order": [0]}


def test_what_python_plays_is_replayed_by_python(batch):
    batch.plain = True
    message = batch.by.percepts(batch, [0, 1])
    assert message["content"] == [(0, b"abc"), (1, b"d")]


KINDS = [*sorted(LIGHTHOUSES - {"cluster-single"}), "cluster:single=true"]


def laid_out(kind, map_class=MapClass.MAPS, edges=3):
    """Each batch of a level that compiled code lays out, with the runs that Python enumerates."""
    scope = Scope(Extent(map_class, edges), Rules(lighthouse_kind(kind)))
    counter = RunCounter(scope, 1)
    judge = CompiledJudge(PythonJudge(counter, "somebody's"), lambda: 7, native=False)
    for unit in units_of_level(scope.extent, edges):
        for batch in judge.batches(Work(unit, counter.tally()), lambda: 10):
            numbers = range(batch.laid.first, batch.laid.until)
            every = [run for run in counter.runs(unit) if run.number in numbers and run.lighthouse]
            yield batch, [Due(r.number, r.place, World(r.map, r.lighthouse, 0)) for r in every]


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("map_class", [MapClass.MAPS, MapClass.SIMPLE])
@pytest.mark.parametrize("kind", KINDS)
def test_a_run_that_was_laid_out_is_the_one_that_python_enumerates(kind, map_class):
    runs = 0
    for batch, every in laid_out(kind, map_class):
        assert [batch.due(row) for row in range(len(batch))] == every
        runs += len(every)
    assert runs or kind == "natural"


@pytest.mark.usefixtures("compiled")
def test_a_run_is_found_by_its_world_and_its_place():
    for batch, every in laid_out("directional"):
        for row, due in enumerate(every):
            code = rooted_code(due.world.map.sigma, due.world.map.alpha, 0)
            assert batch.by._index_of(batch, code, due.place) == row
        with pytest.raises(EnginesDisagree, match="a world that is none"):
            batch.by._index_of(batch, ((0,), (0,)), 0)


@pytest.mark.usefixtures("compiled")
def test_the_second_player_is_told_neither_the_number_nor_the_place_of_a_run():
    batch, _ = [*laid_out("directional")][-1]
    assert batch.heads[:, RUN_NUMBER].any()
    assert batch.heads[:, RUN_PLACE].any()
    batch.logs[0] = [b""] * len(batch)
    batch.by._sums(batch)
    assert not batch.motioned[:, RUN_NUMBER:RUN_MOTIONS].any()


@pytest.mark.usefixtures("compiled")
def test_no_run_is_enumerated_again_to_keep_it_for_more_seeds(monkeypatch):
    batch, _ = next(laid_out("directional", edges=5))
    monkeypatch.setattr(RunCounter, "runs", None)
    judge = SimpleNamespace(counter=batch.by.counter)
    seeds = MoreSeeds(SimpleNamespace(judge=judge), None, wanted=True)
    for _ in range(9):
        seeds.keep(batch)
    assert seeds


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("native", [False, True])
def test_logs_that_compiled_code_cannot_read_are_judged_by_python_if_they_have_words(
    native, monkeypatch
):
    batch, _ = next(laid_out("directional", edges=1))
    asked = []
    monkeypatch.setattr(CompiledJudge, "_by_python", lambda _, each: asked.append(each))
    batch.by.native, batch.plain = native, False
    batch.logs[0] = [bytes((255,))] * len(batch)
    assert batch.by.judge(batch) is not native
    assert asked == ([] if native else [batch])
    batch.plain = True
    assert batch.by.judge(batch) or not native
    assert batch in asked
