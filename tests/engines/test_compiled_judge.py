"""What the compiled judge says to the second player of a batch, and the runs that it lays out."""

from array import array
from types import SimpleNamespace

import pytest
from numpy import zeros

from allworlds import CombinatorialMap, Estimate, Move
from allworlds.documents.document import replace
from allworlds.engines import compiled_judge
from allworlds.engines.batch import FIRST, Due, Work
from allworlds.engines.compiled_judge import CompiledBatch, CompiledJudge
from allworlds.engines.judge import PythonJudge
from allworlds.engines.kernel.arrays import (
    HEAD,
    RUN_BUDGET,
    RUN_MOTIONS,
    RUN_NUMBER,
    RUN_PLACE,
    RUN_TOLD,
    BrokenRun,
)
from allworlds.engines.kernel.capabilities import LIGHTHOUSES
from allworlds.engines.more_seeds import MoreSeeds
from allworlds.engines.players import PlayerHere
from allworlds.engines.tally import EnginesDisagree, RunCounter
from allworlds.engines.units import Scope, units_of_level
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.loading import in_process_subject
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import rooted_code
from allworlds.world.lighthouses.kinds import lighthouse_kind
from allworlds.world.world import World
from small import EDGE


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


def test_an_entry_of_a_message_has_a_number_only_if_one_is_told():
    heads = zeros((3, HEAD), int)
    heads[:, RUN_BUDGET], heads[:, RUN_TOLD] = (7, 8, 9), (-1, 0, 5)
    entries = compiled_judge._entries(SimpleNamespace(heads=heads), [2, 0, 1], [b"a", b"b", b"c"])
    assert [entry[:4] for entry in entries] == [
        (b"a", 5, False, 9),
        (b"b", None, False, 7),
        (b"c", 0, False, 8),
    ]


KINDS = [*sorted(LIGHTHOUSES - {"cluster-single"}), "cluster:single=true"]


def judge_of(kind, map_class=MapClass.MAPS, edges=3, keep=1):
    scope = Scope(Extent(map_class, edges), Rules(lighthouse_kind(kind)))
    python = PythonJudge(RunCounter(scope, keep), "somebody's")
    return CompiledJudge(python, lambda: 7, native=False)


def laid_out(kind, map_class=MapClass.MAPS, edges=3):
    """Each batch of a level that compiled code lays out, with the runs that Python enumerates."""
    judge = judge_of(kind, map_class, edges)
    counter = judge.counter
    for unit in units_of_level(counter.scope.extent, edges):
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


# ---------------------------------------------------------------- both judges

BOUQUET = CombinatorialMap([(d + 1) % 66 for d in range(66)], [d ^ 1 for d in range(66)])


def hasty(first):
    """Answers with one edge in front of one door, and else walks on until there is one."""
    percept = first
    while percept.degree > 1:
        percept = yield Move(1)
    return Estimate(EDGE, 0)


def failing(first):
    """Fails in some worlds, and does the same as ``hasty`` in others."""
    if first.degree == 3:
        raise ZeroDivisionError
    return (yield from hasty(first))


def long_winded(first):
    """Answers with too many darts for one byte if v0 lies behind the first door."""
    if first.bearing == 0:
        return Estimate(BOUQUET, 0)
    return (yield from algorithm1(first))


def played(batch, explorer=hasty):
    """The batch, with the logs of an explorer that Python plays."""
    player = PlayerHere(replace(in_process_subject(explorer), explore=explorer).player())
    batch.plain = True
    player.give(None, batch.by.worlds(batch, range(len(batch))))
    ((_, logs),) = player.heard()
    batch.take(FIRST, range(len(batch)), logs)
    return batch


def batches_of(judge, explorer=hasty, size=1 << 10):
    """All batches of the last level, with their logs."""
    extent = judge.counter.scope.extent
    for unit in units_of_level(extent, extent.edges):
        for batch in judge.batches(Work(unit, judge.counter.tally()), lambda: size):
            yield played(batch, explorer)


def laws_in(batch):
    """The law that is broken in each run of a batch; None if none is."""
    found = (batch.outcome(index).outcome.violation for index in range(len(batch)))
    return [violation and violation.law for violation in found]


def with_a_lie(batch):
    """The batch, of whose last run the Python judge has said that its bound is another one."""
    known = batch.outcome(len(batch) - 1)
    batch.judged[len(batch) - 1] = known._replace(outcome=replace(known.outcome, bound=99))
    return batch


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("explorer", [hasty, failing])
def test_of_each_law_that_compiled_code_finds_broken_there_is_a_run(explorer):
    judge, every = judge_of("directional", keep=8), set()
    for batch in batches_of(judge, explorer):
        assert judge.judge(batch)
        laws = laws_in(batch)
        assert {laws[index] for index in batch.broken} == {*laws} - {None}
        assert len(batch.broken) == len({*batch.broken})
        every |= {*laws}
    assert every == ({"map", "budget"} if explorer is hasty else {"map", "budget", "crash"})


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("explorer", [hasty, algorithm1])
def test_both_judges_count_the_same(explorer):
    judge = judge_of("directional", keep=8)
    for batch in batches_of(judge, explorer, size=10):
        assert judge.judge(batch)
        assert not judge.every
        python = judge._python_tally(batch)
        assert (batch.tally.rows, batch.tally.witnesses) == (python.rows, python.witnesses)
        assert batch.tally.runs == len(batch)


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize(
    ("explorer", "law", "said"),
    [
        (hasty, "pose", "says that pose is broken, the python engine that map is, in the world"),
        (
            algorithm1,
            "map",
            "says that map is broken, the python engine that none is, in the world",
        ),
    ],
)
def test_a_law_that_the_python_judge_does_not_find_broken_is_told(explorer, law, said, monkeypatch):
    judge = judge_of("directional")
    batch = next(batches_of(judge, explorer))
    (sums, good), world = judge._sums(batch), batch.due(0).world.map
    blamed = BrokenRun(2, world.sigma, world.alpha, batch.due(0).place, law)
    monkeypatch.setattr(judge, "_sums", lambda _: (replace(sums, broken=(blamed,)), good))
    with pytest.raises(EnginesDisagree, match=said):
        judge.judge(batch)


@pytest.mark.usefixtures("compiled")
def test_the_first_logs_are_judged_twice_and_no_others():
    judge = judge_of("directional")
    first, *_, second = batches_of(judge)
    with pytest.raises(EnginesDisagree, match="count differently"):
        judge.judge(with_a_lie(first))
    assert judge.judge(with_a_lie(second))


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("native", [False, True])
def test_python_counts_a_batch_that_compiled_code_cannot_read(native):
    judge = judge_of("directional")
    judge.native, every = native, set()
    for batch in batches_of(judge, long_winded):
        batch.plain = native
        assert judge.judge(batch)
        laws = laws_in(batch)
        every |= {*laws}
        assert batch.broken == [index for index, law in enumerate(laws) if law]
        assert batch.tally.rows == judge._python_tally(batch).rows != {}
        assert batch.plain
        some = [len(batch) - 1, 0]
        assert judge.percepts(batch, some, [1, 0]) == judge.python.percepts(batch, some, [1, 0])
    assert every == {"map", None}


@pytest.mark.usefixtures("compiled")
def test_a_batch_keeps_its_own_runs_while_the_next_ones_are_laid_out():
    judge = judge_of("directional")
    for batch in [*batches_of(judge, size=10)]:
        batch.plain = False
        assert judge.judge(batch)
        outcomes = [batch.outcome(row).outcome for row in range(len(batch))]
        assert batch.motioned[:, RUN_BUDGET].tolist() == batch.heads[:, RUN_BUDGET].tolist()
        assert batch.motioned[:, RUN_MOTIONS].tolist() == [each.cost for each in outcomes]
        assert len(batch.starts) == len(batch) + 1
        assert len(batch.percepts) == 3 * sum(each.cost + 1 for each in outcomes)
        some = [len(batch) - 1, 0]
        assert judge.percepts(batch, some, [1, 0]) == judge.python.percepts(batch, some, [1, 0])


@pytest.mark.usefixtures("compiled")
def test_a_library_is_told_the_worlds_of_the_runs_that_it_is_asked_for():
    judge = judge_of("directional")
    judge.native = True
    *_, batch = batches_of(judge)
    batch.plain = False
    for runs in ([1, 3], range(len(batch))):
        message = judge.worlds(batch, runs)
        assert (message["again"], message["runs"], message["seed"]) == (False, len(runs), 7)
        assert (message["worlds"] == batch.tables[[*runs]]).all()
        assert (message["heads"] == batch.heads[[*runs]]).all()
    assert judge.percepts(batch, [1, 3], [0, 1])["kind"] == "record"


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("native", [False, True])
def test_a_batch_is_larger_if_a_library_plays_it(native):
    judge = judge_of("directional", edges=5)
    judge.native = native
    unit = next(units_of_level(judge.counter.scope.extent, 5))
    first, second, *_ = judge.batches(Work(unit, judge.counter.tally()), lambda: 10)
    asked = 10 * compiled_judge.LIBRARIES if native else 10
    assert asked <= len(first) < asked + 10
    assert first.plain is not native
    assert second.laid.first == first.laid.until == len(first)


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("native", [False, True])
@pytest.mark.parametrize(
    ("edges", "size", "waiting"), [(2, 1, 0), (2, 100, 0), (4, 4, 2), (4, 10, 9)]
)
def test_each_world_without_a_place_is_counted_once(edges, size, waiting, native):
    judge, every = judge_of("natural", edges=edges), 0
    judge.native = native
    for unit in units_of_level(judge.counter.scope.extent, edges):
        work, batches = Work(unit, judge.counter.tally()), []

        def judged(left, work=work, batches=batches):
            while len(batches) > left:
                batch = batches.pop(0)
                assert judge.judge(batch)
                work.tally.add(batch.tally)

        for batch in judge.batches(work, lambda: size):
            batches.append(played(batch))
            batch.plain = not native
            judged(waiting)  # the last ones are played while the next ones are laid out
        judged(0)
        runs = [*judge.counter.runs(unit)]
        without = sum(run.lighthouse is None for run in runs)
        assert work.tally.left_out == without
        assert work.tally.worlds == len({run.map for run in runs})
        every += without
    assert every


@pytest.fixture
def known():
    """A compiled judge, and all batches of a level that the Python judge has judged."""
    judge = judge_of("directional")
    return judge, [*batches_of(judge.python, size=10)]


@pytest.mark.usefixtures("compiled")
def test_the_logs_that_the_python_judge_has_judged_are_judged_anew(known, monkeypatch):
    judge, batches = known
    asked, honest = [], judge.judge
    monkeypatch.setattr(judge, "judge", lambda batch: asked.append(batch) or honest(batch))
    judge.compare_with(batches)
    assert [log for batch in asked for log in batch.logs[0]] == [
        log for batch in batches for log in batch.logs[0].values()
    ]
    asked.clear()
    judge.compare_with(batches[-1:])  # of some runs of the unit the logs are not known
    assert not asked


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("liar", [0, -1])
def test_a_difference_in_any_unit_is_told(known, liar):
    judge, batches = known
    with_a_lie(batches[liar])
    with pytest.raises(EnginesDisagree, match="count differently in the unit"):
        judge.compare_with(batches)


@pytest.mark.usefixtures("compiled")
def test_what_comes_after_the_comparison_of_small_worlds_is_compared_once_more(known):
    judge, batches = known
    judge.compare_with(batches)
    with pytest.raises(EnginesDisagree, match="count differently"):
        judge.judge(with_a_lie(next(batches_of(judge))))
