"""The engines of the kernel against each other, and against the Python engine."""

import pytest

from allworlds.engines.compiled_engine import (
    AGREED,
)

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.fixture(autouse=True)
def fresh_comparison():
    AGREED.clear()
    yield
    AGREED.clear()
