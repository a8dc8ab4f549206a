"""Every study that goes through worlds: interrupted, resumed, merged and limited, it says the same.

The documents are compared byte for byte, so that the order of their keys counts, too.
"""

import json

import pytest

from allworlds import ambiguity, check, compare, count, fuzz, worst
from allworlds.engines import sweep
from allworlds.engines.limits import Silent, TimeIsUp
from allworlds.engines.players import Unsettled
from allworlds.verbs import VERBS
from clusters import cluster_here
from kept_jobs import EXPLORERS

pytestmark = [pytest.mark.usefixtures("compiled", "without_workers")]

WRONG = f"{EXPLORERS / 'wrong.py'}"

SWEEPS = {
    "check": lambda **more: check(edges=3, engine="python", **more),
    "check refuted": lambda **more: check(
        f"{WRONG}:here_of_another", edges=3, max_findings=3, **more
    ),
    "worst": lambda **more: worst(edges=4, **more),
    "check all": lambda **more: check(edges=2, schedules="all", **more),
    "compare": lambda **more: compare("algorithm1", "folding", edges=3, **more),
    "compare refuted": lambda **more: compare(
        "algorithm1", f"{WRONG}:here_of_another", edges=3, **more
    ),
    "compare one world": lambda **more: compare(
        "algorithm1", "folding", family="lattice:3x3", **more
    ),
    "compare --to": lambda **more: compare(
        "algorithm1", "folding-oldest", family=["lattice", "cubic"], to=30, draws=2, **more
    ),
    "fuzz": lambda **more: fuzz(edges=7, runs=600, **more),
    "fuzz refuted": lambda **more: fuzz(f"{WRONG}:everywhere", edges=4, runs=600, **more),
    "count": lambda **more: count(edges=4, **more),
    "count simple": lambda **more: count(vertices=4, map_class="simple", **more),
    "ambiguity census": lambda **more: ambiguity.census(edges=4, **more),
}
"""Small jobs by their verb, and what is special about them."""

KINDS = ("check refuted", "worst", "compare", "compare --to", "fuzz", "count", "ambiguity census")
"""One for each way of going through worlds; the others are left to the slow tests."""

ON_A_CLUSTER = ("check refuted", "compare --to", "ambiguity census")


def text(report):
    return json.dumps(report.to_json())


@pytest.fixture(scope="module")
def undisturbed():
    """The text of a job that nothing disturbs, made once."""
    known = {}

    def of(name):
        if name not in known:
            known[name] = text(SWEEPS[name]())
        return known[name]

    return of


class Interrupts(Silent):
    """Interrupts at the part that comes after so many parts of units, kept ones among them."""

    def __init__(self, parts):
        self.left = parts

    def progress(self, worlds):
        if self.left == 0:
            raise KeyboardInterrupt
        self.left -= 1


def assert_finished_rows(told, whole):
    """Require that an unfinished report has the first rows of the whole, and is not complete.

    Worlds that grow have the first sizes of each family.  The report of a sample must have fewer
    runs.
    """
    told, whole = json.loads(told), json.loads(whole)
    if told.get("scope", {}).get("sample"):
        assert told["runs"] < whole["runs"]
    else:
        first = [row for row in whole["rows"] if row in told["rows"]]
        assert told["rows"] == first
        for family in {row.get("family") for row in first}:
            mine = [row for row in first if row.get("family") == family]
            all_ = [row for row in whole["rows"] if row.get("family") == family]
            assert mine == all_[: len(mine)]
        assert not told.get("complete", told.get("scope", {}).get("complete"))


def test_every_verb_with_a_sweep_is_tried():
    words = {" ".join(name.split()[:2]) for name in SWEEPS} | {name.split()[0] for name in SWEEPS}
    assert {verb.name for verb in VERBS if verb.swept} <= words


class Counts(Silent):
    """Counts how many worlds were announced for each level, and how many were done."""

    def __init__(self):
        self.announced, self.done = [], []

    def level(self, edges, worlds):
        self.announced.append(worlds)
        self.done.append(0)

    def progress(self, count):
        self.done[-1] += count


@pytest.mark.no_cover
@pytest.mark.parametrize("name", KINDS)
def test_as_many_worlds_are_done_in_each_level_as_were_announced(name):
    heard = Counts()
    SWEEPS[name](listener=heard)
    assert sum(heard.done)
    assert heard.done == heard.announced


@pytest.fixture(scope="module")
def cluster():
    """The address of a scheduler whose workers are threads of this process."""
    with cluster_here(pytest.importorskip("distributed")) as address:
        yield address


@pytest.mark.no_cover
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("name", ON_A_CLUSTER)
def test_what_a_cluster_does_is_the_same_and_goes_on_without_it(
    name, undisturbed, cluster, tmp_path
):
    job = SWEEPS[name]
    cut = job(run=tmp_path, dask=cluster, listener=Interrupts(2))
    if cut.exit_code == 130:
        assert_finished_rows(text(cut), undisturbed(name))
    assert text(job(run=tmp_path, dask=cluster)) == undisturbed(name)
    assert text(job(run=tmp_path)) == undisturbed(name)


@pytest.mark.no_cover
@pytest.mark.parametrize("name", KINDS)
def test_what_was_finished_when_it_was_ended_is_reported(name, undisturbed, monkeypatch):
    """Before each level in turn, by the time limit, by lost workers and by the user."""
    gather, whole = sweep.gather, undisturbed(name)
    for error, code in ((TimeIsUp(), 3), (Unsettled("lost"), 3), (KeyboardInterrupt(), 130)):
        for levels in (0, 2):
            done, ended = [], []

            def ends(*all_, levels=levels, done=done, ended=ended, error=error):
                if len(done) == levels:
                    ended.append(error)
                    raise error
                gather(*all_)
                done.append(all_)

            monkeypatch.setattr(sweep, "gather", ends)
            cut = SWEEPS[name](time_limit=1000)
            if ended:  # it has so many levels
                refuted = bool(getattr(cut, "findings", ()))
                assert cut.exit_code == (1 if refuted and code == 3 else code)
                assert_finished_rows(text(cut), whole)
                rows = cut.to_json()["rows"]
                assert bool(rows) == (levels > 0)


@pytest.mark.parametrize("name", KINDS)
def test_a_time_limit_that_is_over_at_once_leaves_it_undecided(name):
    cut = SWEEPS[name](time_limit=1e-9)
    refuted = bool(getattr(cut, "findings", ()))
    assert cut.exit_code == (1 if refuted else 3)


@pytest.mark.parametrize("name", ["worst", "fuzz", "compare --to", "count", "check all"])
def test_the_status_of_every_verb_is_told(name, cli, tmp_path):
    SWEEPS[name](run=tmp_path)
    code, out, _ = cli("status", tmp_path)
    assert code == 0
    assert name.split()[0] in out
    assert "finished" in out
