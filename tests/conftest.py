"""What all tests share: drawn examples that are the same every time, and the command line."""

import pytest
from hypothesis import settings

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
        assert err.count("\n") == 1, err
        return err

    return run
