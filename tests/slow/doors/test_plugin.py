"""The pytest plugin, in test runs of its own."""

import pytest

from doors.test_plugin import MARKED

pytestmark = pytest.mark.usefixtures("without_workers")

pytest_plugins = ["pytester"]


@pytest.mark.slowest
def test_workers_of_xdist_collect_the_same_tests(pytester):
    pytester.makepyfile(MARKED)
    result = pytester.runpytest_subprocess("-n", "2", "-p", "no:cov")
    result.assert_outcomes(passed=3)
