"""The command line, called in this process."""

import pytest

from allworlds.cli.app import _guarded


@pytest.fixture
def guarded(capsys):
    """Exit code, stdout and stderr of a call."""

    def call(*arguments):
        code = _guarded([str(argument) for argument in arguments])
        return code, *capsys.readouterr()

    return call
