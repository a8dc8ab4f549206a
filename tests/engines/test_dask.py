"""Units on a Dask cluster: the report is the same, whatever becomes of its workers."""

import asyncio
import os
import signal
import socket
import subprocess
import sys
import threading
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from pathlib import Path
from types import SimpleNamespace
from typing import ClassVar

import pytest

import processes
from allworlds import check
from allworlds.engines import dask as cluster
from allworlds.engines.dask import Dask
from allworlds.engines.engine_table import ThisThread
from allworlds.engines.limits import LOCAL, ClusterLost
from allworlds.engines.units import PartialResult
from allworlds.explorers.loading import Subject
from allworlds.explorers.sources import content_digest, not_alike, with_content
from allworlds.inputs.checks import InputError
from allworlds.version import __version__
from clusters import cluster_here
from kept_jobs import EXPLORERS

distributed = pytest.importorskip("distributed")
pytestmark = [
    pytest.mark.processes,
    pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning"),
]
WRONG = EXPLORERS / "wrong.py"
PROGRAM = EXPLORERS / "program.py"


@pytest.fixture(scope="module")
def here():
    """The address of a scheduler whose workers are threads of this process."""
    with cluster_here(distributed) as address:
        yield address


def test_an_explorer_of_a_module_travels_as_its_text(here, tmp_path, monkeypatch):
    (tmp_path / "travels.py").write_text(
        "from allworlds.explorers.builtin.algorithm1 import algorithm1\n\n"
        "def explore(first):\n    return (yield from algorithm1(first))\n"
    )
    monkeypatch.chdir(tmp_path)
    sent = with_content(Subject("travels:explore", frozenset()))
    assert "algorithm1" in sent.source.text
    (tmp_path / "travels.py").rename(tmp_path / "gone.py")
    assert not_alike(sent, content_digest(sent), 1) == ""
    for name in ("algorithm1", "package.module:explore", "exec:ls", f"{WRONG}:right"):
        subject = Subject(name, frozenset())
        assert with_content(subject) is subject or subject.name.endswith("right")


def test_what_a_worker_lacks_is_named(here, monkeypatch, tmp_path):
    program = tmp_path / "robot"
    program.write_bytes(PROGRAM.read_bytes())
    subject = Subject(f"exec:{sys.executable} {program} right", frozenset())
    digest = content_digest(subject)
    assert not_alike(subject, digest, 1) == ""
    program.write_text("something else")
    assert "has another text here" in not_alike(subject, digest, 1)
    missing = Subject(f"exec:{tmp_path / 'nobody'}", frozenset())
    assert f"{tmp_path / 'nobody'}" in not_alike(missing, digest, 1)
    monkeypatch.setattr("allworlds.engines.engine_table.not_alike", lacks)
    with pytest.raises(InputError, match=r"the Dask worker \S+: it lacks the program"):
        check(f"{WRONG}:right", edges=1, dask=here)


def lacks(*_):
    return "it lacks the program"


def test_a_worker_of_another_version_is_named(here, monkeypatch):
    monkeypatch.setattr(cluster, "done", done_for_another_version)
    with pytest.raises(InputError, match=r"the Dask worker .* has allworlds .*, not 0\.0"):
        check(edges=1, engine="python", dask=here)


def done_for_another_version(job, _, *more, done=cluster.done):
    return done(job, "0.0", *more)


def test_an_explorer_of_this_process_is_not_sent(here):
    def explore(first):
        yield

    with pytest.raises(InputError, match="lives in this process alone"):
        check(explore, edges=1, dask=here)


@pytest.mark.usefixtures("compiled")  # else a line on compiling comes first
def test_no_scheduler_is_refused(refused, monkeypatch):
    monkeypatch.setattr(cluster, "PATIENCE", 0.5)
    for address, why in (
        ("tcp://127.0.0.1:9", "it is silent for 0.5 s"),
        ("nonsense://x", "unknown address scheme"),
        ("foo", "missing port number"),
    ):
        said = refused("worst", "--edges", "1", "--dask", address)
        assert f"dask '{address}': no scheduler answers there: {why}" in said


@pytest.mark.usefixtures("compiled")  # as above
def test_the_thread_for_the_cluster_ends_with_what_it_was_for(refused, monkeypatch):
    from distributed.utils import LoopRunner

    monkeypatch.setattr(cluster, "PATIENCE", 0.5)
    stop, stopped = LoopRunner.stop, []
    monkeypatch.setattr(LoopRunner, "stop", lambda one: stopped.append(one) or stop(one))
    refused("worst", "--edges", "1", "--dask", "foo")
    assert len(stopped) == 1


@contextmanager
def another_service(words):
    """The address of one that says these words to whoever comes, and nothing else."""
    came = []
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve():
            with suppress(OSError):
                while True:
                    came.append(server.accept()[0])
                    came[-1].sendall(words)

        threading.Thread(target=serve, daemon=True).start()
        yield f"tcp://127.0.0.1:{server.getsockname()[1]}"
        server.shutdown(socket.SHUT_RDWR)
    for connection in came:
        connection.close()


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (b"", "no scheduler answers there: it is silent for 0.5 s; legal"),
        (b"HTTP/1.1 400 Bad Request\r\n\r\n", "no scheduler answers there: "),
        (b"\0" * 400, "no scheduler answers there: "),
    ],
)
@pytest.mark.usefixtures("compiled")
def test_what_answers_may_be_no_scheduler(refused, monkeypatch, words, told):
    monkeypatch.setattr(cluster, "PATIENCE", 0.5)
    with another_service(words) as address:
        said = refused("worst", "--edges", "1", "--dask", address)
    assert f"dask '{address}': {told}" in said
    assert said.count("\n") == 1


@pytest.mark.usefixtures("compiled")  # else a line on compiling comes first
def test_the_address_of_a_worker_is_refused(refused, here):
    with distributed.Client(here) as client:
        worker = next(iter(client.scheduler_info()["workers"]))
    said = refused("worst", "--edges", "1", "--dask", worker)
    assert f"dask '{worker}': a worker answers there, which is no scheduler; legal" in said


def test_without_the_package_it_is_named(refused, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    said = refused("ambiguity", "census", "--edges", "1", "--dask", "local")
    assert "pip install '.[distributed]'" in said


def test_the_time_limit_ends_what_is_done_elsewhere(here):
    report = check(edges=5, engine="python", dask=here, time_limit=0.2)
    assert report.exit_code == 3
    assert report.levels != (1, 2, 3, 4, 5)


class Tally(list):
    worlds = 1
    add = list.extend


class Loses:
    """An engine whose workers are lost each time, or that never ends but by a halt."""

    def __init__(self, error):
        self.error = error

    def parts(self, unit):
        raise self.error


class Unit(int):
    key = property(str)


def test_a_unit_that_costs_workers_again_and_again_is_said_to(here):
    from distributed.scheduler import KilledWorker

    for error, said in (
        (
            KilledWorker("task", SimpleNamespace(address="tcp://gone"), 3),
            "were lost over the same units",
        ),
        (distributed.CancelledError("task"), "is gone"),
    ):
        with Dask(here) as transport, pytest.raises(ClusterLost, match=said):
            list(transport.map(Loses(error), [Unit(1)]))


def test_what_is_lost_is_said_by_the_verbs(cli, monkeypatch, here):
    async def lost(*_):
        raise ClusterLost("three workers were lost")

    monkeypatch.setattr(Dask, "_done", lost)
    code, out, _ = cli("check", "--edges", "1", "--dask", here)
    assert (code, "three workers were lost" in out) == (3, True)
    code, out, _ = cli("worst", "--edges", "1", "--dask", here)
    assert (code, "three workers were lost" in out) == (3, True)


class Lane:
    """A lane that is noted when it is closed."""

    closed: ClassVar = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.closed.append(self)

    def map(self, engine, units):
        yield from ThisThread().map(engine, units)


class Twice:
    def parts(self, unit):
        yield Tally([unit])
        yield Tally([unit])


@pytest.fixture
def task(monkeypatch):
    """A task as it comes to a worker; the list of the lanes that were closed."""
    monkeypatch.setattr(Lane, "closed", [])
    packed = distributed.protocol.pickle.dumps((Lane, str, Twice()))

    def do(job):
        results, seconds = cluster.done(job, __version__, packed, [Unit(7)])
        assert (results, seconds >= 0) == ([[7, 7]], True)

    return do, Lane.closed


def test_lanes_that_nobody_uses_are_closed(monkeypatch, task):
    do, closed = task
    monkeypatch.setattr(cluster, "IDLE", 0.0)
    for number in (1, 2):
        do("a")
        assert processes.wait(lambda number=number: len(closed) == number)


def test_lanes_are_used_until_their_job_ends(task, monkeypatch):
    do, closed = task
    do("b")
    (lane,) = cluster._JOBS["b"].idle
    monkeypatch.setattr("distributed.protocol.pickle.loads", None)
    do("b")
    assert cluster._JOBS["b"].idle == [lane]
    cluster.end_job("b")
    assert closed == [lane]
    with pytest.raises(ClusterLost, match="has ended"):
        do("b")


def test_what_is_done_when_its_job_ends_is_given_up(task, monkeypatch):
    do, closed = task
    monkeypatch.setattr(Twice, "parts", lambda self, _: iter([cluster.end_job("c"), Tally([1])]))
    with pytest.raises(ClusterLost, match="has ended"):
        do("c")
    assert processes.wait(lambda: len(closed) == 1)


# ---------------------------------------------------------------- tasks, without a cluster


@pytest.fixture
def tasks(monkeypatch):
    """The numbers of units in the tasks of a level, each of which takes so many seconds a unit."""

    def given(units, seconds, threads):
        transport = Dask("tcp://127.0.0.1:1", order=reversed)
        sizes = []

        def begin(batch):
            future = Future()
            sizes.append(len(batch))
            future.set_result(([Tally([unit]) for unit in batch], seconds * len(batch)))
            return future

        transport._threads, transport._watched = threads, Future()
        transport._done = lambda job, version, packed, batch: batch
        transport._begin = begin
        given = [Unit(i) for i in range(units)]
        first = next(transport.map("engine", given))
        assert (first.last, len(sizes)) == (True, 3 * max(2, threads))
        for _ in range(2):
            sizes.clear()
            parts = [*transport.map("engine", given)]
        assert sorted((part.unit, part.result, part.last) for part in parts) == [
            (unit, [unit], True) for unit in range(units)
        ]
        return sizes

    return given


def test_a_task_has_units_for_a_quarter_of_a_second_once_their_cost_is_known(tasks):
    sizes = tasks(1000, 0.01, threads=2)
    assert (sizes[:6], max(sizes)) == ([1] * 6, 24)  # at first, as the last level tells too little
    assert {*tasks(30, 10.0, threads=0)} == {1}
    assert max(tasks(4000, 0.01, threads=100)) > 90
    assert {*tasks(20, 10.0, threads=2)} == {1}


class Anew(Lane):
    """A lane that loses its first work on each unit."""

    def map(self, engine, units):
        for unit in units:
            for number, anew in enumerate((False, False, True, False)):
                last = number == 3
                yield PartialResult(unit, Tally([number]), last=last, anew=anew)


def test_what_is_begun_anew_counts_once(monkeypatch):
    monkeypatch.setattr(Lane, "closed", [])
    packed = distributed.protocol.pickle.dumps((Anew, str, None))
    results, _ = cluster.done("d", __version__, packed, [Unit(7), Unit(8)])
    assert results == [[2, 3], [2, 3]]
    cluster.end_job("d")


def test_the_end_of_a_job_halts_its_engine(task, monkeypatch):
    do, _ = task
    halted = []
    monkeypatch.setattr(Twice, "halt", lambda self: halted.append(type(self)), raising=False)
    do("e")
    cluster.end_job("e")
    assert halted == [Twice]
    cluster.end_job("never begun")
    monkeypatch.setattr("distributed.protocol.pickle.loads", None)
    with pytest.raises(ClusterLost, match="has ended"):
        do("never begun")


def test_a_lane_in_which_an_error_was_raised_is_closed(task, monkeypatch):
    do, closed = task
    monkeypatch.setattr(Twice, "parts", None)
    with pytest.raises(TypeError):
        do("f")
    assert len(closed) == 1
    assert cluster._JOBS["f"].idle == []


def test_a_lane_is_closed_some_time_after_its_last_use(task, monkeypatch):
    do, _ = task
    timers = []

    class Timer:
        daemon = False

        def __init__(self, seconds, then):
            self.asked = [seconds]
            timers.append(self)

        def start(self):
            self.asked.append(("start", self.daemon))

        def cancel(self):
            self.asked.append("cancel")

    monkeypatch.setattr(cluster, "Timer", Timer)
    do("g")
    do("g")
    started = cluster.IDLE, ("start", True)
    never, first, second = (timer.asked for timer in timers if len(timer.asked) > 1)
    assert never == [cluster.IDLE, "cancel"]
    assert (first, second) == ([*started, "cancel"], [*started])
    monkeypatch.setattr(Twice, "parts", lambda *_: iter([cluster.end_job("g"), Tally([1])]))
    with pytest.raises(ClusterLost, match="has ended"):
        do("g")
    assert timers[-1].asked == [0, ("start", True)]


def test_whoever_leaves_a_cluster_says_so(here, monkeypatch):
    left, leave = [], Dask._leave
    monkeypatch.setattr(Dask, "_leave", lambda *what: left.append(what[1]) or leave(*what))
    with Dask(here):
        assert not left
    assert left == [None]


@pytest.mark.parametrize(
    ("kind", "seconds"), [(None, 2.0), (ValueError, 2.0), (KeyboardInterrupt, 0.2)]
)
def test_whoever_interrupts_does_not_wait_long_for_the_cluster(kind, seconds):
    asked = []

    def run(work, callback_timeout):
        asked.append((work, callback_timeout))
        raise TimeoutError

    transport = Dask("tcp://127.0.0.1:1")
    transport._runner = SimpleNamespace(run_sync=run)
    transport._leave(kind, None, None)
    assert asked == [(transport._goodbye, seconds)]


# ---------------------------------------------------------------- a local cluster


def test_a_cluster_of_our_own_lasts_as_long_as_it_is_used(here, monkeypatch):
    told = []

    @contextmanager
    def local(workers):
        told.append(workers)
        yield here
        told.append("its end")

    monkeypatch.setattr(cluster, "local_cluster", local)
    with Dask(LOCAL, 3) as transport:
        (part,) = transport.map(Twice(), [Unit(7)])
        assert (part.result, told) == ([7, 7], [3])
    assert told == [3, "its end"]


STARTS_ANOTHER = """
import subprocess, sys
other = subprocess.Popen(["sh", "-c", "sleep 60 & echo begun; wait"], stdout=subprocess.PIPE)
other.stdout.readline()
print(" tcp://here ", flush=True)
sys.stdin.read()
"""


@pytest.fixture
def started(monkeypatch):
    """The processes that a local cluster starts, each of which runs this program instead."""
    begun = []

    def start(program):
        def popen(command, **options):
            begun.append(
                (command[-1], options, subprocess.Popen([*command[:-1], program], **options))
            )
            return begun[-1][-1]

        fake = SimpleNamespace(Popen=popen, PIPE=subprocess.PIPE)
        monkeypatch.setattr(cluster, "subprocess", fake)
        return begun

    return start


def test_a_local_cluster_ends_with_all_its_processes(started):
    begun = started(STARTS_ANOTHER)
    with cluster.local_cluster(3) as address:
        ((code, options, process),) = begun
        assert (address, code.endswith("serve(3)")) == ("tcp://here", True)
        place = Path(options["env"]["DASK_TEMPORARY_DIRECTORY"])
        assert (place.is_dir(), os.getsid(process.pid)) == (True, process.pid)
        others = processes.workers_of(process.pid)
        assert len(others) == 2
    assert (process.returncode, place.exists()) == (-signal.SIGKILL, False)
    assert processes.end(lambda: {pid for pid, _ in processes.running()} & {*others})


def test_a_local_cluster_that_does_not_start_is_lost(started):
    started("")
    with pytest.raises(ClusterLost, match="has not started"), cluster.local_cluster(1):
        pass


def test_a_local_cluster_tells_its_address_alone_and_lasts_until_its_owner_ends(monkeypatch):
    told = []

    class Local:
        scheduler_address = "tcp://here"

        def __init__(self, **options):
            told.append((options["n_workers"], options["threads_per_worker"]))

        def __enter__(self):
            return self

        def __exit__(self, *_):
            told.append("its end")

    calls = SimpleNamespace(
        dup=lambda fd: ("copy", fd),
        dup2=lambda *fds: told.append(fds),
        write=lambda fd, words: told.append((fd, words)),
    )
    monkeypatch.setattr(distributed, "LocalCluster", Local)
    monkeypatch.setattr(cluster, "os", calls)
    stdin = SimpleNamespace(read=lambda: told.append("stdin ends"))
    monkeypatch.setattr(cluster, "sys", SimpleNamespace(stdin=stdin))
    cluster.serve(3)
    where = ("copy", 1), b"tcp://here\n"
    assert told == [(2, 1), (3, 1), where, "stdin ends", "its end"]


# ---------------------------------------------------------------- a made-up scheduler


class Stop(Exception):
    """The end of a watch."""


class Scheduler:
    """A scheduler with two workers, and a clock."""

    def __init__(self):
        self.now, self.beats, self.fault = 0.0, {"a": 0.0, "b": 0.0}, None
        self.scheduler = self

    async def identity(self):
        if self.fault:
            raise self.fault
        return {
            "workers": {name: {"last_seen": at, "nthreads": 2} for name, at in self.beats.items()}
        }

    async def unregister(self, address, stimulus_id):
        assert stimulus_id
        del self.beats[address]


@pytest.fixture
def looked(monkeypatch):
    """Watch for some seconds, in which some workers give signs of life; return the threads."""
    scheduler = Scheduler()
    monkeypatch.setattr(cluster, "monotonic", lambda: scheduler.now)

    def look(seconds, *lively):
        async def sleep(passed):
            scheduler.now += passed
            scheduler.beats.update(dict.fromkeys(lively, scheduler.now))
            if scheduler.now > seconds:
                raise Stop

        # Not of asyncio itself: a cluster of this process sleeps, too.
        waits = SimpleNamespace(sleep=sleep, wait_for=asyncio.wait_for)
        monkeypatch.setattr(cluster, "asyncio", waits)
        monkeypatch.setattr(cluster, "SILENCE", 5.0)
        transport = Dask("tcp://127.0.0.1:1")
        transport._client = scheduler
        with suppress(Stop):
            asyncio.run(transport._watch())
        return transport._threads

    look.scheduler = scheduler
    return look


def test_a_silent_worker_is_given_up_when_its_time_is_over(looked):
    assert looked(5, "b") == 4
    looked.scheduler.now = 0.0
    assert looked(6, "b") == 2
    assert {*looked.scheduler.beats} == {"b"}


def test_a_cluster_whose_workers_are_all_silent_is_lost(looked):
    assert looked(5) == 4
    looked.scheduler.now = 0.0
    with pytest.raises(ClusterLost, match=r"no worker of the Dask .* gave a sign of life for 5 s"):
        looked(6)


@pytest.mark.parametrize(
    ("fault", "said"), [(TimeoutError(), "gave no sign of life for 5 s"), (OSError(), "is gone")]
)
def test_a_cluster_without_a_scheduler_is_lost(looked, fault, said):
    looked.scheduler.fault = fault
    with pytest.raises(ClusterLost, match=said):
        looked(1, "a")


# ---------------------------------------------------------------- real processes
