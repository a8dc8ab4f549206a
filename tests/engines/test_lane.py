"""A lane, and the lanes of processes, without players or processes."""

import signal
import subprocess
import sys
from collections import Counter, deque
from types import SimpleNamespace

import pytest

from allworlds.engines import lanes
from allworlds.engines.batch import FIRST, SECOND
from allworlds.engines.lane import Lane
from allworlds.engines.lanes import MOST_ATTEMPTS, Lanes
from allworlds.engines.players import Lost, Unsettled
from allworlds.inputs.checks import InputError

LOST = Lost("crash", "it died", machine=True)


class Plays:
    """The players of a lane, which note what they are asked for."""

    def __init__(self, lost_in=(None, None)):
        self.asked, self._lost_in = [], lost_in

    def give(self, which, batch, indices):
        self.asked.append((which, batch, [*indices]))

    def go_on(self, which):
        self.asked.append(which)

    def lost_in(self, which):
        return self._lost_in


def lane_of(**parts):
    lane = object.__new__(Lane)
    for name, part in parts.items():
        setattr(lane, f"_{name}", part)
    lane.given_up = ""
    return lane


def test_what_no_compiled_code_can_judge_is_played_in_python():
    class Batch:
        plain, logs = False, [["a", "b"], {}]
        by = SimpleNamespace(judge=lambda _: False)

        def __len__(self):
            return 2

    batch, plays = Batch(), Plays()
    lane_of(plays=plays)._played(FIRST, batch)
    assert (batch.plain, batch.logs) == (True, [{}, {}])
    assert plays.asked == [(FIRST, batch, [0, 1])]


@pytest.mark.parametrize("which", [FIRST, SECOND])
def test_after_a_loss_outside_of_a_run_the_player_goes_on(which):
    remarks, work = [], object()
    losses = SimpleNamespace(remark=lambda *what: remarks.append(what))
    for lost_in, said in (((None, None), []), ((SimpleNamespace(work=work), None), [(work, LOST)])):
        plays, logs = Plays(lost_in), {"a": 1}
        lane_of(plays=plays, losses=losses, first_logs=logs)._lose(which, LOST)
        assert plays.asked == [which]
        assert remarks == said
        assert logs == ({} if which == FIRST else {"a": 1})


@pytest.mark.parametrize(("due", "judged", "settled"), [(3, 3, 2), (3, 2, 3), (2, 3, 3)])
def test_a_lane_has_played_judged_and_settled_all_of_its_runs(due, judged, settled):
    work = SimpleNamespace(batches=None, more=[], open=0, best={}, unit="unit", tally="tally")
    counter = SimpleNamespace(tally=lambda: "another")

    def done(*counts):
        lane = lane_of(works=[work], **dict(zip(("due", "judged", "settled"), counts, strict=True)))
        lane.counter, lane._reported = counter, 0
        return lane._done()

    (part,) = done(3, 3, 3)
    assert (part.unit, part.last) == ("unit", True)
    with pytest.raises(RuntimeError, match="runs were left out"):
        done(due, judged, settled)


@pytest.mark.parametrize(
    ("models", "kind", "said"),
    [
        (True, InputError, ": a lighthouse, task or condition of yours ends them"),
        (False, Unsettled, ""),
    ],
)
def test_a_unit_is_given_to_so_many_processes_and_to_no_more(models, kind, said):
    unit = SimpleNamespace(key="2:-1")

    def lost():
        process = SimpleNamespace(end=lambda: "signal 9", units=[unit])
        every._processes = [process]
        return Lanes._replace(every, process), every._processes

    every = SimpleNamespace(_lost=Counter(), models=models)
    for _ in range(MOST_ATTEMPTS - 1):
        assert lost() == ([unit], [])
    words = f"{MOST_ATTEMPTS} processes were lost over one unit, the last by signal 9{said}"
    with pytest.raises(kind, match=f"^{words}"):
        lost()


@pytest.mark.processes
def test_a_process_that_does_not_end_is_killed(monkeypatch):
    clock = iter([0.0, 9.0])
    monkeypatch.setattr(lanes.time, "monotonic", lambda: next(clock))
    with subprocess.Popen(
        [sys.executable, "-S", "-c", "print(flush=True); import time; time.sleep(600)"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
    ) as child:
        assert child.stdout.readline()
        process = object.__new__(lanes._Process)
        process.link, process.pid = child.stdin, child.pid
        assert f"signal {int(signal.SIGKILL)}" in process.end()


class Link:
    """The link to the owner, which sends these messages and then closes."""

    def __init__(self, *messages):
        self.messages, self.sent = deque(messages), []

    def poll(self, timeout):
        return bool(self.messages) or timeout is None

    def recv(self):
        if not self.messages:
            raise EOFError
        return self.messages.popleft()

    def send(self, part):
        self.sent.append(part)

    def fileno(self):
        return 7


class Done:
    """A lane that does each unit in one turn."""

    def __init__(self, counter, made, *, first_lane):
        self.counter, self.units, self.keeps = counter, [], counter == "keeps"
        made.append(self)
        self.closed, self.first_lane = 0, first_lane

    @property
    def busy(self):
        return bool(self.units)

    def offer(self, unit):
        self.units.append(unit)

    def turn(self, others):
        assert others == [7]
        unit = self.units.pop(0)
        return [SimpleNamespace(last=True, unit=unit, result=Counter(runs=1))]

    def end(self):
        return Counter(more=1)

    def close(self):
        self.closed += 1


def added(result, other):
    result.update(other)


def test_a_forked_lane_is_made_anew_for_another_counter(monkeypatch):
    made = []
    every = SimpleNamespace(
        subject="subject",
        limits="limits",
        make=lambda _subject, counter, _limits, first_lane: Done(
            counter, made, first_lane=first_lane
        ),
    )
    monkeypatch.setattr(Counter, "add", added, raising=False)
    link = Link(("keeps", "1"), ("keeps", "2"), ("other", "3"))
    with pytest.raises(EOFError):
        lanes._lane_of(link, every, first_lane=True)
    assert [(one.counter, one.closed, one.first_lane) for one in made] == [
        ("keeps", 1, True),
        ("other", 1, True),
    ]
    assert made[0].units == ["1", "2"]
    assert [(part.unit, dict(part.result)) for part in link.sent] == [("3", {"runs": 1})]


@pytest.mark.parametrize(("counter", "more"), [("keeps", {"more": 1}), ("other", {})])
def test_a_forked_lane_adds_the_plays_of_further_seeds_to_its_last_unit(counter, more, monkeypatch):
    every = SimpleNamespace(
        subject="subject",
        limits="limits",
        make=lambda _subject, counter, _limits, first_lane: Done(
            counter, [], first_lane=first_lane
        ),
    )
    monkeypatch.setattr(Counter, "add", added, raising=False)
    link = Link((counter, "1"), (counter, "2"))
    with pytest.raises(EOFError):
        lanes._lane_of(link, every, first_lane=False)
    told = [(part.unit, dict(part.result)) for part in link.sent]
    assert told == [("1", {"runs": 1}), ("2", {"runs": 1} | more)]
