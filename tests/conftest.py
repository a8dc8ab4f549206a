"""What all tests share: drawn examples that are the same every time, and the command line."""

import sys
from contextlib import contextmanager

import pytest
from coverage import Coverage
from hypothesis import settings

from allworlds.checker.laboratory import Laboratory
from allworlds.checker.pool import LocalPool
from allworlds.cli import call

settings.register_profile(
    "same-every-time", derandomize=True, database=None, deadline=None, max_examples=60
)
settings.load_profile("same-every-time")


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
    """Checks run in this process: they are the same there, and no worker has to start."""

    @contextmanager
    def here(subject, _limits, deadline):
        with subject.running():
            yield LocalPool(subject, deadline)

    monkeypatch.setattr(sys.modules[Laboratory.__module__], "WorkerPool", here)


@pytest.fixture(scope="session")
def untraced():
    """A context in which coverage is not measured, for a fixture that goes through many worlds.

    Tracing makes Python four times as slow; for a test there is the mark ``no_cover``.
    """

    @contextmanager
    def paused():
        measured = Coverage.current()
        if measured:
            measured.stop()
        try:
            yield
        finally:
            if measured:
                measured.start()

    return paused
