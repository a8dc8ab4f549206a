"""Every command says what it is recorded to say."""

import pytest

from recorded.record import COMMANDS, RECORDS, record

pytestmark = pytest.mark.usefixtures("compiled")

DEAR = {
    "check",
    "check-kernel",
    "check-lifo",
    "check-natural",
    "check-planar-simple",
    "check-python",
    "check-shard",
    "check-simple",
    "ambiguity-census-text",
    "count-compiled",
    "search-unsat",
}
"""Those that take longer than the others: slow tests."""


def test_every_record_has_its_command():
    assert sorted(path.stem for path in RECORDS.iterdir()) == sorted(COMMANDS)


@pytest.mark.parametrize("name", sorted(COMMANDS.keys() - DEAR))
def test_what_is_said_is_what_is_recorded(name, tmp_path):
    assert record(name, str(tmp_path)) == (RECORDS / f"{name}.txt").read_text(encoding="utf-8")
