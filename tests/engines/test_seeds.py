"""Both plays have hash seeds of their own, and there are not too many of them."""

from random import Random
from types import SimpleNamespace

import pytest

from allworlds import log as entries
from allworlds.engines import more_seeds, units
from allworlds.engines.batch import SECOND
from allworlds.engines.hash_seeds import SIX_MORE
from allworlds.engines.judges import SMALL
from allworlds.inputs.checks import InputError
from allworlds.studies.check.exhaustive import check

pytestmark = pytest.mark.processes

COUNTS = """
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    with open({file!r}, "a") as plays:
        plays.write("x")
    return (yield from algorithm1(first))
"""
GOES_BY_ORDER = """
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    estimate = yield from algorithm1(first)
    return estimate if [*{"left", "right"}] == ["left", "right"] else 7
"""


@pytest.mark.parametrize(("edges", "workers"), [(2, 1)])
def test_there_are_two_plays_a_run_and_more_under_other_seeds(tmp_path, edges, workers):
    plays, module = tmp_path / "plays", tmp_path / "counts.py"
    module.write_text(COUNTS.format(file=str(plays)))
    report = check(f"{module}:explore", edges=edges, workers=workers)
    assert report.exit_code == 0
    small = sum(row.runs for row in report.rows if row.edges <= units.TWICE)
    more = more_seeds.KEPT * len(SIX_MORE) if edges > SMALL else 0
    across = 2 * small + (report.runs if edges > units.TWICE else 0)
    least = 2 * report.runs + across + more
    # Of each batch of second plays one may be made once more, and with several workers all runs
    # are played in one order more.
    most = least + report.runs // 4 + 8 + (workers > 1) * (report.runs + small)
    assert least <= len(plays.read_text()) <= most


def test_an_explorer_that_is_too_long_in_being_imported_is_refused_by_name(tmp_path):
    module = tmp_path / "slow.py"
    module.write_text("import time\ntime.sleep(1000)\ndef explore(first): yield\n")
    said = r"slow.py:explore.* does not import: it was at it for 1 s"
    with pytest.raises(InputError, match=said):
        check(f"{module}:explore", edges=1, start_timeout=1)


@pytest.mark.parametrize("name", ["{}:explore", "{}", "native:{}", "exec:{}", "exec:python3 {}"])
def test_a_loop_of_links_is_no_file_and_is_told_as_what_it_is(tmp_path, name):
    one, other = tmp_path / "one.py", tmp_path / "other.py"
    one.symlink_to(other)
    other.symlink_to(one)
    with pytest.raises(InputError, match=r"one\.py'.* is a loop of links"):
        check(name.format(one), edges=1)


@pytest.mark.parametrize("option", ["where", "task", "lighthouse"])
def test_a_loop_of_links_is_no_model(tmp_path, option):
    loop = tmp_path / "loop.py"
    loop.symlink_to(loop)
    with pytest.raises(InputError, match=r"loop\.py' is a loop of links"):
        check(edges=1, **{option: f"{loop}:Model"})


def test_what_differs_under_another_seed_is_explained_once():
    explained = []
    settler = SimpleNamespace(
        judge=SimpleNamespace(
            counter=SimpleNamespace(tally=lambda: "tally"), percepts_message=lambda *_: None
        ),
        plays=SimpleNamespace(anew=lambda *_: ([bytes((entries.OVER,))] * 2, ())),
        differ=lambda one, _: one == "another",
        explain_under=lambda _, batch, rows, which: explained.append((batch, which, *dict(rows))),
    )
    outcomes = [SimpleNamespace(log="equal"), SimpleNamespace(log="another")]
    work = SimpleNamespace(unit="unit")
    batch = SimpleNamespace(work=work, record=str, outcome=outcomes.__getitem__)
    seeds = more_seeds.MoreSeeds(settler, Random(1), wanted=True)
    seeds._kept = [(batch, 0), (batch, 1)]
    assert seeds.end() == "tally"
    assert explained == [(batch, SECOND, 1)]


@pytest.fixture
def kept():
    """What is kept of batches of these numbers of runs, in worlds of this size."""

    def kept(edges, *sizes, last=4, wanted=True):
        scope = SimpleNamespace(extent=SimpleNamespace(levels=range(1, last + 1)))
        judge = SimpleNamespace(counter=SimpleNamespace(scope=scope))
        seeds = more_seeds.MoreSeeds(SimpleNamespace(judge=judge), Random(1), wanted=wanted)
        map_ = SimpleNamespace(edge_count=edges)
        for size in sizes:
            seeds.keep(Batch([SimpleNamespace(world=SimpleNamespace(map=map_))] * size))
        assert bool(seeds) == bool(seeds._kept)
        return [index for _, index in seeds._kept]

    return kept


class Batch(list):
    due = list.__getitem__


def test_the_first_runs_of_the_last_level_are_kept(kept):
    most = more_seeds.KEPT
    assert kept(4, 3, 2) == [0, 1, 2, 0, 1]
    assert kept(4, most - 1, 3) == [*range(most - 1), 0]
    assert kept(4, most + 1) == [*range(most)]
    assert kept(4, most, 1) == [*range(most)]


@pytest.mark.parametrize(
    "options", [{"last": 5}, {"wanted": False}, {"edges": SMALL, "last": SMALL}]
)
def test_no_runs_are_kept_of_smaller_worlds_or_of_small_ones_or_if_none_are_wanted(kept, options):
    assert kept(options.pop("edges", 4), 3, **options) == []


def test_of_worlds_of_several_sizes_the_first_says_whether_they_are_kept():
    extent = SimpleNamespace(levels=range(1, 5))
    judge = SimpleNamespace(counter=SimpleNamespace(scope=SimpleNamespace(extent=extent)))
    settler = SimpleNamespace(judge=judge)
    small, large = (
        SimpleNamespace(world=SimpleNamespace(map=SimpleNamespace(edge_count=m))) for m in (3, 4)
    )
    for runs, kept in (([large, small], 2), ([small, large], 0)):
        seeds = more_seeds.MoreSeeds(settler, Random(1), wanted=True)
        seeds.keep(Batch(runs))
        assert len(seeds._kept) == kept


def test_nothing_is_kept_after_a_difference_was_explained():
    seeds = more_seeds.MoreSeeds(None, Random(1), wanted=True)
    judge = SimpleNamespace(
        counter=SimpleNamespace(tally=lambda: "tally"), percepts_message=lambda *_: None
    )
    plays = SimpleNamespace(anew=lambda *_: ([bytes((entries.OVER,))], ()))
    seeds._settler = SimpleNamespace(
        judge=judge, plays=plays, differ=lambda *_: False, explain_under=None
    )
    batch = SimpleNamespace(
        work=SimpleNamespace(unit="unit"),
        record=str,
        outcome=lambda _: SimpleNamespace(log="log"),
    )
    seeds._kept = [(batch, 0)]
    assert (seeds.end(), seeds._wanted, seeds._kept) == ("tally", True, [])
    seeds._kept = [(batch, 0)]
    seeds._settler.differ, seeds._settler.explain_under = lambda *_: True, lambda *_: None
    assert (seeds.end(), seeds._wanted) == ("tally", False)
    assert (batch.work.unit, batch.work.tally) == ("unit", "tally")
