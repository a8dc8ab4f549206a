"""Explorers that go by hashes: told from others, and judged so that a report is always the same."""

import pytest

pytestmark = pytest.mark.processes
