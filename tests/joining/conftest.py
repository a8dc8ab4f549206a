import pytest

from kept_jobs import reporting


@pytest.fixture
def report(cli):
    return reporting(cli)
