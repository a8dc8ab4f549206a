"""Every command says what it is recorded to say, with workers."""

import pytest

from recorded.record import RECORDS, record
from recorded.test_recorded import DEAR


@pytest.mark.parametrize("name", [*sorted(DEAR), "check-first-edge", "check-exec", "run-wrong"])
def test_what_is_said_is_what_is_recorded(name, tmp_path):
    assert record(name, str(tmp_path)) == (RECORDS / f"{name}.txt").read_text(encoding="utf-8")
