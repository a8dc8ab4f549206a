"""Worlds that are bred from draws, towards lines of an explorer that few worlds run."""

from random import Random
from types import SimpleNamespace

import pytest
from msgspec.structs import replace

from allworlds import Estimate
from allworlds.engines.limits import Limits, TimeIsUp
from allworlds.engines.single import subject_of
from allworlds.engines.units import Sample, Scope, Shard
from allworlds.explorers.builtin.algorithm1 import Algorithm1, algorithm1
from allworlds.inputs.checks import InputError
from allworlds.judging.episode import AroundExplorer
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.build import cycle, named_map
from allworlds.maps.classes import Extent
from allworlds.maps.mixture import mutated
from allworlds.outcome import Completed
from allworlds.protocol import playing
from allworlds.protocol.choices import Choices
from allworlds.protocol.code_lines import LinesPlay, TracedPlay
from allworlds.studies.fuzz import breeding, sample_sweep
from allworlds.studies.fuzz.breeding import (
    BRED_PER_GENERATION,
    DRAWS_PER_BLOCK,
    DRAWS_TRACED,
    MUTANTS_TRIED,
    PARENTS_PER_LINE,
    RAREST_LINES,
    Bred,
    _Pool,
    bred,
    bred_of,
    is_bred_for,
)
from allworlds.studies.fuzz.sample_sweep import (
    FuzzRequest,
    FuzzSweep,
    SampleCounter,
    fuzz,
    scope_of,
)
from allworlds.studies.fuzz.sampling import Batch
from allworlds.world import Directional
from allworlds.world.lighthouses.kinds import lighthouse_kind
from allworlds.world.world import World

EXTENT = Extent(MapClass.MAPS, 12)
SCOPE = Scope(EXTENT, Rules())


class Late(Algorithm1):
    def answer(self):
        answer = super().answer()
        if answer.map.vertex_count != 6:
            return answer
        if max(answer.map.degrees) != 5:
            return answer
        if answer.map.loop_count != 2:
            return answer
        if answer.map.genus != 1:
            return answer
        return Estimate(cycle(1), 0)


def late(first, choices=None, *_):
    return (yield from Late(first, choices).explore())


def loopless(first):
    """Is wrong where there is a loop."""
    answer = yield from algorithm1(first)
    return Estimate(cycle(1), 0) if answer.map.loop_count else answer


def is_late(map_):
    return (map_.vertex_count, max(map_.degrees), map_.loop_count, map_.genus) == (6, 5, 2, 1)


def test_worlds_are_bred_for_a_users_explorer_in_python_alone():
    assert is_bred_for(subject_of(late, Limits()))
    for name in ("algorithm1", "exec:cat"):
        assert not is_bred_for(subject_of(name, Limits()))
    assert fuzz("algorithm1", edges=3, runs=256).bred is None


def test_a_mutant_is_a_map_of_the_size_that_is_allowed():
    random, map_, sizes = Random(3), named_map("cube"), set()
    for _ in range(200):
        map_ = mutated(map_, 12, random)
        type(map_)(map_.sigma, map_.alpha)  # is a map
        sizes.add(map_.edge_count)
    assert max(sizes) == 12
    assert len(sizes) > 3


def test_lines_noted_once_are_those_that_a_whole_trace_has():
    ran = []
    for traced in (TracedPlay(), LinesPlay()):
        around = AroundExplorer(World(named_map("cube"), Directional(0), 0))
        playing.play_run(around, traced.player(late), Choices(), 9999, [0, 0])
        ran.append({place for place in traced.ran if place[0] == __file__})
    assert ran[0] == ran[1]
    assert ran[0]


def test_what_stands_in_the_corpus_is_tried_first_and_new_findings_go_there(tmp_path):
    def gives_up(first):
        return
        yield

    sample = {"edges": 4, "runs": 70, "corpus": tmp_path}
    found, again = fuzz(gives_up, **sample), fuzz(gives_up, **sample)
    (kept,) = tmp_path.iterdir()
    assert (found.corpus.written, again.corpus.reproduced) == ((kept.name,), (kept.name,))
    assert found.findings[0].key == again.findings[0].key
    assert (found.runs, again.runs) == (16, 0)  # the first wave; none
    assert again.verdict == "refuted"
    right = fuzz("algorithm1", **sample)
    assert (right.corpus.fixed, right.runs) == ((kept.name,), 70)
    with pytest.raises(InputError, match="cannot be given with run"):
        fuzz(**sample, run=tmp_path / "run")


# ---------------------------------------------------------------- without a player

UNIT = Bred(Batch(1, 0, 64, (), 4))


def pool(**least):
    unit = Bred(replace(UNIT.drawn, **least))
    return _Pool(unit, EXTENT, lighthouse_kind("directional").as_class)


def test_blocks_are_bred_by_the_shard_that_draws_them():
    sample = Sample(3 * DRAWS_PER_BLOCK, seed=5, min_edges=2, portion=Shard(1, 2))
    begins = [0, DRAWS_PER_BLOCK, 2 * DRAWS_PER_BLOCK]
    (unit,) = bred_of(sample, begins)
    first = DRAWS_PER_BLOCK
    assert unit.drawn == Batch(5, first, first + DRAWS_TRACED, (), 2)
    assert unit.key == f"{unit.drawn.key}/bred"


def test_parents_are_the_last_worlds_of_the_rarest_lines():
    kept, cube, theta = pool(), named_map("cube"), named_map("theta")
    for line in range(RAREST_LINES):
        kept.add(theta, [("file", line)])
    for _ in range(PARENTS_PER_LINE + 2):
        kept.add(cube, [("file", 99)])
    assert len(kept.lately["file", 99]) == PARENTS_PER_LINE
    parents = []
    kept._child = lambda parent: parents.append(parent) or parent
    placed = [*kept.bred()]
    assert len(placed) == BRED_PER_GENERATION
    assert breeding.BRED_PER_BLOCK % BRED_PER_GENERATION == 0  # whole generations
    assert {*parents} == {theta}
    assert {map_ for map_, _ in placed} == {theta}
    assert {place for _, places in placed for place, _ in places} <= {*range(3)}


def test_a_child_is_of_the_extent_and_has_no_fewer_edges_than_asked(monkeypatch):
    sizes = {pool(min_edges=7)._child(cycle(7)).edge_count for _ in range(3)}
    assert min(sizes) >= 7
    tried = []
    monkeypatch.setattr(breeding, "mutated", lambda *_: tried.append(0) or cycle(3))
    assert pool()._child(cycle(5)) == cycle(5)
    assert len(tried) == MUTANTS_TRIED
    assert pool(min_edges=3)._child(cycle(5)) == cycle(3)


def test_what_refutes_among_the_bred_worlds_is_numbered(monkeypatch):
    monkeypatch.setattr(breeding, "BRED_PER_BLOCK", 2 * BRED_PER_GENERATION)
    subject = subject_of(loopless, Limits())
    runs = [*bred(Bred(Batch(1, 0, 8, (), 1)), SCOPE, subject, Limits())]
    assert [run.number for run in runs] == [*range(len(runs))]
    assert runs
    assert all(run.map.loop_count and run.first for run in runs)


def test_an_explorer_without_lines_has_no_bred_worlds(monkeypatch):
    monkeypatch.setattr(_Pool, "add", lambda *_: None)
    subject = subject_of(loopless, Limits())
    assert [*bred(Bred(Batch(1, 0, 4, (), 1)), SCOPE, subject, Limits())] == []


def explore(first):
    """An explorer of the user's."""
    yield from ()


def levels(runs, subject=explore, **asked):
    """The levels of a search: of each the most edges, its worlds, its units, and what it is of."""
    request = FuzzRequest(subject, edges=6, runs=runs, **asked)
    loaded = subject_of(subject, Limits())
    sweep = FuzzSweep(request, scope_of(request, Rules("directional")), loaded)
    return [(level.edges, level.worlds, [*level.units], level.of) for level in sweep.levels()]


def test_after_each_block_of_draws_worlds_are_bred_from_its_draws():
    small, *waves = levels(1100)
    assert (small[:2], small[3]) == ((4, 8), 0)
    drawn = [worlds for _, worlds, _, of in waves if of is None]
    assert drawn == [16, 48, 192, 768, 76]
    assert [of for *_, of in waves] == [None, None, None, 192, None, 3 * 192, None]
    bred_after = [units for *_, units, of in waves if of]
    begins = [[unit.drawn.first for unit in units] for units in bred_after]
    assert begins == [[0], [256, 512, 768]]
    assert {worlds for _, worlds, _, of in waves if of} == {0}


def test_no_world_is_bred_for_an_explorer_that_is_built_in_or_before_a_whole_block():
    assert [of for *_, of in levels(1100, "algorithm1")] == [0, *[None] * 5]
    assert [of for *_, of in levels(255)] == [0, None, None, None]
    assert [of for *_, of in levels(256)] == [0, None, None, None, 192]


def test_a_shard_breeds_its_own_blocks():
    _, *waves = levels(1100, shard=(1, 2))
    assert [[u.drawn.first for u in units] for *_, units, of in waves if of] == [[256, 768]]


def test_bred_runs_go_on_where_they_were_left(monkeypatch):
    monkeypatch.setattr(sample_sweep, "bred", lambda *_: iter("abcd"))
    counter = SampleCounter(None, 1, subject=None, limits=None)
    unit = Bred(Batch(0, 0, 64, (), 1))
    assert [*counter.runs(unit)] == ["a", "b", "c", "d"]
    assert [*counter.runs(unit, 3)] == ["d"]


@pytest.mark.parametrize(
    ("late", "found", "ends"), [(True, 1, True), (True, 0, False), (False, 1, False)]
)
def test_findings_that_time_left_unsettled_end_the_search(late, found, ends):
    confirmation = SimpleNamespace(
        is_late=late, confirmed=list, replaced=lambda _, found, by: found
    )
    sweep = SimpleNamespace(
        confirmation=confirmation,
        corpus=None,
        keep_new=lambda _: None,
        _shrunk=None,
        _tally=SimpleNamespace(findings=["found"] * found),
    )
    if ends:
        with pytest.raises(TimeIsUp):
            FuzzSweep.conclude(sweep, Completed())
    else:
        FuzzSweep.conclude(sweep, Completed())
