import importlib
from pathlib import Path

import pytest

PROOFS = Path(__file__).parents[2] / "proofs"


@pytest.fixture
def checkers(monkeypatch):
    """The modules of the folder ``proofs`` by name: they stand outside the package."""
    monkeypatch.syspath_prepend(str(PROOFS))
    return importlib.import_module


@pytest.fixture
def proofs():
    return PROOFS
