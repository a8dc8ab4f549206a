import importlib
import importlib.util
from pathlib import Path

import pytest

PROOFS = Path(__file__).parents[2] / "proofs"


@pytest.fixture
def checkers(monkeypatch):
    """The modules of the folder ``proofs`` by name: they stand outside the package."""
    monkeypatch.syspath_prepend(str(PROOFS))
    return importlib.import_module


@pytest.fixture
def checker_of(checkers):
    """The module ``checker.py`` of a claim, loaded anew."""

    def load(claim):
        path = PROOFS / claim / "checker.py"
        specification = importlib.util.spec_from_file_location(f"{claim}_checker", path)
        module = importlib.util.module_from_spec(specification)
        specification.loader.exec_module(module)
        return module

    checkers("lrat")
    return load


@pytest.fixture
def proofs():
    return PROOFS
