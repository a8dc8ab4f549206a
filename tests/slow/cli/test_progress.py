"""Progress: how far a long job is, and how long it would take."""

import pytest

from cli import test_progress as quick
from small import slowest

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.parametrize("name", [slowest("count compiled")])
def test_what_is_promised_is_done(name):
    quick.test_what_is_promised_is_done(name)
