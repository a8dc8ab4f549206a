"""The other jobs of every verb that goes through worlds, as the quick tests treat one a kind."""

import json

import pytest

import allworlds
from allworlds import fuzz
from allworlds.engines import sweep
from allworlds.engines.limits import TimeIsUp
from allworlds.engines.listeners import Listener
from allworlds.engines.players import Unsettled
from clusters import cluster_here
from engines import test_sweep as quick
from engines.test_sweep import KINDS, SWEEPS, WRONG

pytestmark = pytest.mark.usefixtures("compiled", "without_workers")

OTHERS = [name for name in quick.SWEEPS if name not in quick.KINDS]


@pytest.mark.parametrize("name", OTHERS)
def test_a_time_limit_that_is_over_at_once_leaves_it_undecided(name):
    quick.test_a_time_limit_that_is_over_at_once_leaves_it_undecided(name)


@pytest.mark.slowest
@pytest.mark.parametrize("name", SWEEPS)
def test_what_was_interrupted_at_several_places_goes_on(name, undisturbed, tmp_path):
    job, whole = SWEEPS[name], undisturbed(name)
    for parts in (1, 2, 3):
        cut = job(run=tmp_path, listener=Interrupts(parts))
        if cut.exit_code != 130:  # it has fewer units
            break
        assert_finished_rows(text(cut), whole)
        assert allworlds.status(tmp_path).state == "unfinished"
    assert text(job(run=tmp_path)) == whole
    assert text(job(run=tmp_path)) == whole
    standing = allworlds.status(tmp_path)
    assert (standing.state, standing.left_s) == ("finished", 0)
    if "refuted" not in name:  # a finding ends it before the last level
        assert standing.worlds.done == standing.worlds.all
        assert standing.units.done == standing.units.all


@pytest.mark.slowest
@pytest.mark.parametrize("name", SWEEPS)
def test_what_is_sharded_and_merged_is_the_same(name, undisturbed, tmp_path):
    job = SWEEPS[name]
    code = json.loads(undisturbed(name)).get("exit_code", 0)
    runs = [tmp_path / str(k) for k in range(3)]
    codes = {job(run=run, shard=(k, 3)).exit_code for k, run in enumerate(runs)}
    assert codes <= {0, code}
    merged = allworlds.merge(*reversed(runs))
    assert text(merged) == undisturbed(name)


@pytest.mark.slowest
def test_what_a_shrinker_had_when_the_time_was_up_is_not_the_end(tmp_path, monkeypatch):
    """A directory keeps no smallest finding that was not sought to the end."""

    def job(**more):
        return fuzz(f"{WRONG}:everywhere", edges=4, min_edges=3, runs=20, **more)

    with monkeypatch.context() as patch:
        late = []

        def shrunk(finding, *_):
            late.append(finding)
            return finding

        patch.setattr("allworlds.studies.fuzz.sample_sweep.smallest_from", shrunk)
        patch.setattr(
            "allworlds.studies.check.tally_sweep.Confirmation.is_late",
            property(lambda _: bool(late)),
        )
        assert job(run=tmp_path, time_limit=1000).findings
    assert late
    assert text(job(run=tmp_path)) == text(job())


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


class Interrupts(Listener):
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
    runs; one that refutes ends with the first draws, and may be interrupted after them.
    """
    told, whole = json.loads(told), json.loads(whole)
    if told.get("scope", {}).get("sample"):
        assert told["runs"] < whole["runs"] + bool(whole["findings"])
    else:
        first = [row for row in whole["rows"] if row in told["rows"]]
        assert told["rows"] == first
        for family in {row.get("family") for row in first}:
            mine = [row for row in first if row.get("family") == family]
            all_ = [row for row in whole["rows"] if row.get("family") == family]
            assert mine == all_[: len(mine)]
        assert not told.get("complete", told.get("scope", {}).get("complete"))


@pytest.fixture(scope="module")
def cluster():
    """The address of a scheduler whose workers are threads of this process."""
    with cluster_here(pytest.importorskip("distributed")) as address:
        yield address


@pytest.mark.slowest
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("name", SWEEPS)
def test_what_a_cluster_does_is_the_same_and_goes_on_without_it(
    name, undisturbed, cluster, tmp_path
):
    job = SWEEPS[name]
    cut = job(run=tmp_path, dask=cluster, listener=Interrupts(2))
    if cut.exit_code == 130:
        assert_finished_rows(text(cut), undisturbed(name))
    assert text(job(run=tmp_path, dask=cluster)) == undisturbed(name)
    assert text(job(run=tmp_path)) == undisturbed(name)


@pytest.mark.slowest
@pytest.mark.parametrize("name", SWEEPS)
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


@pytest.mark.parametrize("name", ["worst", "fuzz", "compare --to", "count", "check all"])
def test_the_status_of_every_verb_is_told(name, cli, tmp_path):
    SWEEPS[name](run=tmp_path)
    code, out, _ = cli("status", tmp_path)
    assert code == 0
    assert name.split()[0] in out
    assert "finished" in out


class Counts(Listener):
    """Counts how many worlds were announced for each level, and how many were done."""

    def __init__(self):
        self.announced, self.done = [], []

    def level(self, edges, worlds):
        self.announced.append(worlds)
        self.done.append(0)

    def progress(self, count):
        self.done[-1] += count


@pytest.mark.parametrize("name", [*KINDS, *OTHERS])
def test_as_many_worlds_are_done_in_each_level_as_were_announced(name):
    heard = Counts()
    SWEEPS[name](listener=heard)
    assert sum(heard.done)
    assert heard.done == heard.announced
