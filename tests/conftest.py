"""Fixtures and settings of all tests: the same drawn examples each time, the command line."""

import covered  # isort: split

import fcntl
import gc
import os
import signal
import subprocess
import sys
from contextlib import ExitStack

import pytest
from hypothesis import settings

from allworlds.cli.app import call
from allworlds.engines.lanes import Lanes
from allworlds.engines.players import PlayerHere
from allworlds.explorers.loading import load

COMPILE = """
import os, sys

import allworlds

from allworlds.engines.kernel.worlds import by_vertices_and_faces

allworlds.check(edges=2, engine="kernel")
by_vertices_and_faces(4, 5, ())
allworlds.worst(edges=1)
allworlds.ambiguity.census(edges=5, map_class="simple")
os.write(int(sys.argv[1]), b"done")
"""
"""The compiled code of quick tests: judge, ``examine``, the count, ``worst`` and the census.

The kernel that walks on demand and the one that plays libraries are compiled by slow tests.
"""

pytest_plugins = ["shared_fixtures"]

settings.register_profile(
    "same-every-time", derandomize=True, database=None, deadline=None, max_examples=60
)
settings.load_profile("same-every-time")


PATIENCE = 600
"""Seconds after which a slow test hangs."""


def pytest_configure(config):
    """Signals reach the tests that make them also where they begin ignored.

    So are interrupts in the background, and hangups under nohup.
    """
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGHUP, signal.SIG_DFL)
    if covered.COVERED:
        config.pluginmanager.register(covered.COVERED)


def pytest_collection_finish():
    """Keep the collector of garbage from the many objects of the tests that were collected."""
    gc.freeze()


@pytest.fixture(scope="session", autouse=True)
def temporary(tmp_path_factory):
    """Put all temporary directories, as those of ``search``, into the one of the tests.

    So they are removed with it.
    """
    place = str(tmp_path_factory.mktemp("temporary"))
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("TMPDIR", place)
        patch.setattr("tempfile.tempdir", place)
        # Nor do checks of the tests tell anything to the service that the tests may run in.
        for name in ("GITHUB_ACTIONS", "GITHUB_STEP_SUMMARY", "GITHUB_WORKSPACE"):
            patch.delenv(name, raising=False)
        yield


@pytest.fixture
def cli(capsys):
    """The command line, called in this process: exit code, stdout and stderr."""

    def run(*arguments):
        code = call([str(argument) for argument in arguments])
        return code, *capsys.readouterr()

    return run


@pytest.fixture
def refused(cli):
    """The one line with which these arguments are refused."""

    def run(*arguments):
        code, out, err = cli(*arguments)
        assert (code, out) == (2, ""), err
        assert err.startswith("allworlds: ")
        assert err.count("\n") == 1, err
        return err

    return run


@pytest.fixture
def without_workers(monkeypatch):
    """Checks and runs are done in this process: no worker has to start, and all else is the same.

    Only the confirmation of a finding takes a fresh process still, and the first look at an
    explorer; and one, not eight, is asked about a predicate or lighthouse again.  What a program
    writes to stderr goes nowhere, as in a player that nobody overhears.
    """

    with ExitStack() as running:

        def loaded(subject, limits):
            if not subject.importable:
                return subject
            here = load(subject.name, limits.answer_timeout, subject.source)
            running.enter_context(here.running())
            return here

        def player(setup, seed, notice=None):
            del seed  # of hashes: they are those of this process
            subject = loaded(setup.subject, setup.limits)
            explorer = subject.player(notice) if notice and subject.own else subject.player()
            return PlayerHere(
                explorer, of_user=subject.from_user, prints=setup.prints, subject=subject
            )

        for module in ("across", "plays", "single"):
            monkeypatch.setattr(f"allworlds.engines.{module}.started", player)
        monkeypatch.setattr("allworlds.robots.program_player.started", player)
        monkeypatch.setattr("allworlds.engines.user_code_checks.PROCESSES", 1)
        monkeypatch.setattr(
            "allworlds.engines.lanes.Lanes",
            lambda subject, limits, deadline, *more: Lanes(
                subject, limits, deadline, make=more[-1]
            ),
        )
        monkeypatch.setattr("allworlds.explorers.program.Program._pass_stderr_on", lambda _: None)
        yield


@pytest.fixture(autouse=True)
def without_workers_unless_the_test_is_about_them(request):
    """Use no worker processes in quick tests, but those with the mark ``processes``."""
    if not (is_slow(request.node) or request.node.get_closest_marker("processes")):
        request.getfixturevalue("without_workers")


def is_slow(item):
    """Whether a test is left out of the quick run."""
    return item.nodeid.startswith("tests/slow/") or item.get_closest_marker("slowest")


def needs_kernel(item):
    """Whether a test uses compiled code; those that do not are run first."""
    return "compiled" in item.fixturenames


def pytest_collection_modifyitems(items):
    """Put tests without compiled code first, and among equals early tests before others.

    So the compiler works while the first tests run.  Slow tests, and those that wait for the
    compiler, have more time before they count as hanging.
    """
    for item in items:
        longer = is_slow(item) or needs_kernel(item)
        if longer and not item.get_closest_marker("timeout"):
            item.add_marker(pytest.mark.timeout(PATIENCE))
    items.sort(key=lambda item: (needs_kernel(item), not item.get_closest_marker("early")))


@pytest.fixture(scope="session")
def what_is_compiled(tmp_path_factory):
    """The file that a compiler locks while it is at work, and writes to when it is done."""
    base = tmp_path_factory.getbasetemp()
    return (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "compiled"


@pytest.fixture(scope="session", autouse=True)
def compiler(request, temporary, what_is_compiled):
    """A process that compiles the kernel, which nothing traces, if a test will need it.

    Whichever worker of pytest begins first starts it; the tests go on meanwhile.
    """
    del temporary
    if not any(map(needs_kernel, request.session.items)):
        yield
        return
    with what_is_compiled.open("a") as done, ExitStack() as at_the_end:
        try:
            fcntl.flock(done, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            pass  # another worker has started it
        else:
            if os.fstat(done.fileno()).st_size == 0:
                process = subprocess.Popen(  # the lock is its own, too: it goes when it ends
                    [sys.executable, "-c", COMPILE, str(done.fileno())], pass_fds=[done.fileno()]
                )
                at_the_end.callback(process.wait)
        done.close()
        yield


@pytest.fixture(scope="session")
def compiled(what_is_compiled, compiler):
    """The kernel has been compiled, and is loaded by whoever needs it."""
    del compiler
    with what_is_compiled.open() as done:
        fcntl.flock(done, fcntl.LOCK_SH)
        assert done.read() == "done", "compiling has failed; its last words are above"
