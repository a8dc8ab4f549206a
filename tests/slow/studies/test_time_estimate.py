"""How long a check will take is guessed from its last level."""

import pytest

from studies import test_time_estimate as quick

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.usefixtures("without_workers")
@pytest.mark.parametrize("engine", ["python"])
def test_an_estimate_is_about_all_worlds(engine, monkeypatch):
    quick.test_an_estimate_is_about_all_worlds(engine, monkeypatch)
