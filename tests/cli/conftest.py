"""The command line, called in this process."""

import pytest

from allworlds.cli.app import call


@pytest.fixture
def guarded(capsys):
    """Exit code, stdout and stderr of a call."""

    def told(*arguments):
        code = call([str(argument) for argument in arguments])
        return code, *capsys.readouterr()

    return told
