"""Whatever one run leaves behind for another is found, whichever units they belong to."""

import pytest

from allworlds.engines import across, lanes, players, user_code_checks
from allworlds.engines.limits import TimeIsUp, check_deadline
from allworlds.engines.run_directory import FILE
from allworlds.judging.findings.finding import Finding
from allworlds.studies.check.exhaustive import check
from allworlds.studies.explain import explain
from allworlds.studies.merge import merge, status
from allworlds.studies.run import replay
from allworlds.world.world import World
from models import PARITY
from small import slowest

pytestmark = pytest.mark.processes

LATCH = """
from allworlds import Estimate, CombinatorialMap
from allworlds.explorers.builtin.algorithm1 import algorithm1

SEEN = []

def explore(first):
    estimate = yield from algorithm1(first)
    known = len(estimate.map.sigma), estimate.map.vertex_count, first.degree
    wrong = bool(SEEN) and known == {later}
    if known == {earlier}:
        SEEN.append(1)
    return Estimate(CombinatorialMap([0, 1], [1, 0]), 0) if wrong else estimate
"""
"""Sets a flag in some worlds, and reads it in others."""

SIZES = {"another": ((6, 2, 5), (6, 2, 1)), "smaller": ((2, 1, 2), (6, 3, 2))}


@pytest.fixture
def latch(tmp_path):
    def written(name="another"):
        earlier, later = SIZES[name]
        module = tmp_path / f"{name}.py"
        module.write_text(LATCH.format(earlier=earlier, later=later))
        return f"{module}:explore"

    return written


def size(world):
    return len(world.map.sigma), world.map.vertex_count, world.map.degree_at[world.start]


@pytest.mark.parametrize("name", SIZES)
def test_a_flag_that_one_run_leaves_for_another_is_found_with_both_runs(latch, name):
    report = check(latch(name), edges=3)
    (found,) = report.findings
    assert (report.exit_code, found.law, found.confirmed) == (1, "nondeterministic", True)
    assert [size(world) for world in found.earlier] == [SIZES[name][0]]
    assert size(found.world) == SIZES[name][1]
    assert "after that world" in found.seen
    assert (report.worlds, report.runs) == (86, 309)


def test_replay_plays_both_runs_and_explain_names_both(latch, tmp_path):
    (found,) = check(latch(), edges=3).findings
    read = Finding.from_json(found.text)
    assert isinstance(read.earlier[0], World)
    again = replay(read)
    assert again.outcome == "reproduced"
    assert again.again.finding.earlier == found.earlier
    assert found.reproduce.startswith("allworlds replay ")
    assert (
        "acts differently in a new process and in a process in which it has explored"
        in " ".join(explain(read).sentences)
    )
    tmp_path.joinpath("another.py").write_text(LATCH.format(earlier=0, later=0))
    assert replay(read).outcome == "not-reproduced"


@pytest.mark.slowest
def test_a_corpus_tries_both_runs_again(latch, tmp_path):
    check(latch(), edges=3, corpus=tmp_path / "corpus")
    report = check(latch(), edges=1, corpus=tmp_path / "corpus")
    assert (len(report.corpus.beyond_scope), report.corpus.fixed) == (1, ())


@pytest.mark.slowest
def test_shards_that_are_merged_and_a_check_that_goes_on_find_it_too(latch, tmp_path):
    runs = [tmp_path / "0", tmp_path / "1"]
    for k, run in enumerate(runs):
        check(latch(), edges=3, shard=(k, 2), run=run)
    (found,) = merge(*runs).findings
    assert found.after
    assert sum(status(run).units.done for run in runs) == sum(status(r).units.all for r in runs)
    again = check(latch(), edges=3, shard=(0, 2), run=runs[0])
    assert [each.after for each in again.findings] == [found.after]
    assert runs[0].joinpath(FILE).exists()


def test_two_workers_and_a_condition_find_it_too(latch, tmp_path, monkeypatch):
    monkeypatch.setattr(lanes, "ALONE", 0.0)
    monkeypatch.setattr(user_code_checks, "PROCESSES", 1)
    tmp_path.joinpath("every.py").write_text("def every(map):\n    return True\n")
    (found,) = check(latch(), edges=3, workers=2, where=f"{tmp_path}/every.py:every").findings
    assert found.after


@pytest.mark.parametrize("sizes", [((2, 2, 1), (2, 1, 2)), ((2, 1, 2), (2, 2, 1))], ids=str)
def test_either_run_comes_before_the_other(latch, monkeypatch, sizes):
    monkeypatch.setattr(across, "TWICE", 0)
    monkeypatch.setitem(SIZES, "either", sizes)
    (found,) = check(latch("either"), edges=1).findings
    assert [size(world) for world in found.earlier] == [sizes[0]]


def test_nothing_is_looked_for_past_the_time_limit(latch, monkeypatch):
    """The clock is past the deadline once the earlier runs are looked for."""
    settle = across.Across.settle

    def late(self):
        monkeypatch.setattr(players, "check_deadline", lambda at: check_deadline(at and 0.0))
        settle(self)

    monkeypatch.setattr(across.Across, "settle", late)
    report = check(latch(), edges=3, time_limit=1000, workers=1)
    assert report.ending.reason.startswith("the time limit of 1000 s was reached")
    assert not any(found.after for found in report.findings)


def test_a_check_that_ends_before_the_unit_finds_it_when_it_goes_on(latch, tmp_path, monkeypatch):
    def up(self, known):
        raise TimeIsUp

    run, units_of = tmp_path / "run", lambda: status(tmp_path / "run").units
    with monkeypatch.context() as patched:
        patched.setattr(across.Across, "begin", up)
        assert check(latch(), edges=3, workers=1, run=run, time_limit=1000).verdict.value != "holds"
    assert units_of().done == units_of().all - 1
    (found,) = check(latch(), edges=3, run=run).findings
    assert [size(world) for world in found.earlier] == [SIZES["another"][0]]
    assert units_of().done == units_of().all


TURNS = """
from allworlds import Move
from allworlds.explorers.builtin.algorithm1 import algorithm1

SEEN = []


def explore(first):
    if first.degree == 1 and SEEN:
        yield Move(0)
        yield Move(0)
    if first.degree == 3:
        SEEN.append(1)
    return (yield from algorithm1(first))
"""


@pytest.mark.parametrize(
    ("ends", "options"),
    [
        ("raise ValueError", {}),
        ("os._exit(3)", {"memory": 1000}),
        ("os.kill(os.getpid(), signal.SIGKILL)", {}),
    ],
    ids=["error", "end", "signal"],
)
def test_who_is_lost_only_after_another_run_is_found(tmp_path, ends, options):
    module = tmp_path / "lost.py"
    begin = LATCH.partition("SEEN")[0] + "import os, signal\nSEEN = []\n"
    module.write_text(
        f"""{begin}
def explore(first):
    if first.degree == 4 and SEEN:
        {ends}
    if first.degree == 3:
        SEEN.append(1)
    return (yield from algorithm1(first))
"""
    )
    (found,) = check(f"{module}:explore", edges=2, **options).findings
    assert (found.law, found.confirmed) == ("nondeterministic", True)


@pytest.mark.parametrize(
    "options", [slowest({"task": "cover"}), {"lighthouse": "parity.py:Parity:modulus=9"}], ids=str
)
def test_a_task_and_a_lighthouse_of_ones_own_find_it_too(tmp_path, monkeypatch, options):
    monkeypatch.chdir(tmp_path)
    tmp_path.joinpath("parity.py").write_text(PARITY)
    module = tmp_path / "turns.py"
    module.write_text(TURNS)
    (found,) = check(f"{module}:explore", edges=2, **options).findings
    assert (found.law, found.confirmed) == ("nondeterministic", True)


class Lone:
    """A player that is lost in the run at this position, if it has loaded its explorer."""

    def __init__(self, position, description="loaded"):
        self.beat, self.description, self.asked = [position, 0], description, []

    def heard(self):
        raise players.Lost("crash", "it died", machine=True)

    def again(self):
        self.asked.append("again")

    def close(self):
        self.asked.append("close")


LOST = players.lost_log(b"", players.Lost("crash", "it died", machine=True))


@pytest.fixture
def lone(monkeypatch):
    """The plays of three runs; a fresh player is lost in each run, or in none."""

    def plays_of(player, alone=LOST):
        both = object.__new__(across.Across)
        play = across._Play(3, player)
        play.order = [5, 6, 7]
        both._plays, both.work, both.found = (play,), "work", {}
        both._named = lambda index, earlier: None
        both._after = lambda seed, earlier, index: alone
        both._differ = lambda one, other: one != other
        return both

    return plays_of


@pytest.mark.parametrize(
    ("player", "alone"),
    [(Lone(0), b"another"), (Lone(-1), LOST), (Lone(3), LOST), (Lone(0, None), LOST)],
)
def test_a_loss_that_no_fresh_player_repeats_is_noted_and_played_again(lone, player, alone):
    noted, both = [], lone(player, alone)
    assert both.hear(lambda *what: noted.append(what)) is False
    ((work, lost),) = noted
    assert (work, lost.seen) == ("work", "it died")
    assert player.asked == ["again"]


@pytest.mark.parametrize("position", [0, 2])
def test_a_loss_that_a_fresh_player_repeats_ends_the_plays(lone, position):
    noted, player = [], Lone(position)
    assert lone(player).hear(lambda *what: noted.append(what)) is True
    assert (noted, player.asked) == ([], ["close"])


def needed(culprits, earlier):
    """What is found if a run shows another log after all these culprits, and only then."""
    both = object.__new__(across.Across)
    both._seed = 0
    both._after = lambda seed, indices, index: b"x" * ({*culprits} <= {*indices})
    both._differ = lambda one, other: one != other
    return both._needed(b"", 9, earlier)


@pytest.mark.parametrize("culprits", [[4], [0], [8], [2, 5], [0, 8]])
def test_the_fewest_earlier_runs_are_found(culprits):
    assert needed(culprits, range(9)) == culprits


def test_no_earlier_runs_are_named_if_they_do_nothing_or_are_too_many():
    assert needed([99], range(9)) == []
    assert needed([], range(9)) == []
    most = across.MOST_EARLIER
    assert needed([*range(most)], range(most + 2)) == [*range(most)]
    assert needed([*range(most + 1)], range(most + 2)) == []


def test_each_of_the_two_plays_has_its_own_hash_seed(monkeypatch):
    begun = []
    monkeypatch.setattr(across, "started", lambda _, seed: begun.append(seed))
    monkeypatch.setattr(across, "RunBatch", lambda *_: None)
    made = across.Across(None, None, "work", (3, 5))
    assert [play.seed for play in made._plays] == [3, 5]
    assert begun == [5]  # the other one begins only if no process has played these runs before
