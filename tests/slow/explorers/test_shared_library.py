"""Explorers in shared libraries: where they take part, and what they do to their process."""

from array import array

import pytest

import small
from allworlds.explorers.loading import load
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.studies.check.exhaustive import check
from allworlds.studies.check.report import most_expensive_runs
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.studies.run import run
from allworlds.world import Directional, Position, World
from explorers import test_shared_library as quick
from explorers.test_shared_library import native
from native_libraries import ATTACKS, EXAMPLES, FOR_TESTS, attack, built, example, quotient
from processes import PATIENCE, SOON


@pytest.mark.slowest
def test_it_takes_part_in_fuzz_and_leaves_findings_in_a_corpus(tmp_path):
    assert fuzz(native(example("c/algorithm1.c")), edges=8, runs=20).exit_code == 0
    wrong = native(example("c/hasty.c"))
    assert fuzz(wrong, edges=8, runs=20).exit_code == 1
    check(wrong, edges=2, corpus=tmp_path)
    again = check(wrong, edges=2, corpus=tmp_path)
    assert again.exit_code == 1
    assert again.runs == 0


@pytest.fixture(scope="module")
def without_choices():
    """Algorithm 1 in C without ``choose``."""
    return native(built(EXAMPLES / "c/algorithm1.c", "-Dallworlds_choose=not_exported"))


@pytest.mark.usefixtures("compiled")
def test_a_library_that_plays_tells_which_run_of_the_batch_it_is_in():
    from allworlds.engines.compiled_engine import level_of
    from allworlds.engines.kernel.arrays import Stretch
    from allworlds.engines.kernel.engine import UnitJudge
    from allworlds.engines.kernel.library_player import LibraryPlayer

    memory = Stretch.of(2)
    beat = array("q", [0, 0])
    level = level_of("algorithm1", Rules(), Extent(MapClass.MAPS, 2), 2)
    judge = UnitJudge(level, (-4,), 1, memory, memory)
    judge.lay_out(4)
    laid = judge.lay_out(4)  # a second batch, whose numbers in the unit are others
    subject = load(native(example("c/algorithm1.c")))
    player, played = LibraryPlayer(subject.native, beat), set()
    for seed in range(30):
        batch = {"heads": judge.heads.tobytes(), "worlds": memory.worlds[: laid.runs].tobytes()}
        told = {"edges": 2, "runs": laid.runs, "seed": seed, "policy": "fifo", "again": False}
        assert player.play(batch | told)
        played.add(beat[0])
    assert played == {*range(laid.runs)}


@pytest.mark.slowest
@pytest.mark.usefixtures("compiled")
def test_both_engines_find_the_same_most_expensive_runs_of_a_library(without_choices):
    by_kernel, by_python = (
        [(run.world, run.outcome.cost) for run in most_expensive_runs(report)]
        for report in (
            check(without_choices, edges=4, engine=engine) for engine in ("kernel", "python")
        )
    )
    assert by_kernel == by_python


@pytest.mark.slowest
def test_a_library_that_counts_its_runs_is_found():
    # In three runs the two orders may agree by chance, in about one check of four.
    library = native(attack("here_is = episodes % 2"))
    found = (one for _ in range(40) for one in check(library, edges=1).findings)
    first = next(one for one in found if one.law == "nondeterministic")
    assert "the second answer differs" in first.seen


@pytest.mark.parametrize("source", ["cpp/algorithm1.cpp", "rust/algorithm1.rs"])
@pytest.mark.parametrize("policy", ["fifo", "lifo", "nearest"])
def test_algorithm_1_in_another_language_walks_as_ours(source, policy):
    quick.test_algorithm_1_in_another_language_walks_as_ours(source, policy)


EDGE = World(small.EDGE, Directional(0))


@pytest.mark.slowest
@pytest.mark.processes
def test_it_may_say_that_several_worlds_look_alike():
    position, ours = Position(0), native(quotient())
    for map_ in (small.PLANE, small.TORUS):
        assert run(ours, World(map_, position)).verdict.value == "holds"
    report = check(ours, edges=2, lighthouse="position", engine="python")
    twin = f"{FOR_TESTS / 'quotients.py'}:two_loops"
    theirs = check(twin, edges=2, lighthouse="position", workers=1)
    (finding,), (other,) = report.findings, theirs.findings
    assert (finding.law, finding.world) == (other.law, other.world)
    assert (finding.expected, finding.seen) == (other.expected, other.seen)


@pytest.mark.slowest
@pytest.mark.processes
@pytest.mark.early
@pytest.mark.parametrize("code", ATTACKS)
def test_what_it_does_to_its_process_is_a_finding_in_that_world(code):
    law, seen = ATTACKS[code]
    limit = SOON if law == "timeout" else PATIENCE
    report = check(native(attack(code)), edges=1, answer_timeout=limit)
    assert report.runs == 3
    if not law:
        assert report.exit_code == 0
        return
    (finding,) = report.findings
    assert (finding.law, finding.world, finding.minimal) == (law, EDGE, True)
    assert seen in finding.seen


@pytest.mark.processes
def test_a_quotient_without_darts_or_with_too_many_is_no_answer():
    for size in (0, 1 << 20):
        found = run(native(quotient(SIZE=size)), World(small.PLANE, Position(0)))
        assert found.finding.law == "no-estimate"
