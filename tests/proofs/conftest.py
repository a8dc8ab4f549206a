import importlib
import importlib.util
from pathlib import Path

import pytest

PROOFS = Path(__file__).parents[2] / "proofs"
CERTIFICATES, COQ = PROOFS / "certificates", PROOFS / "coq"


@pytest.fixture
def checkers(monkeypatch):
    """The modules of the folders of proofs by name: they stand outside the package."""
    for folder in (PROOFS, COQ, CERTIFICATES):
        monkeypatch.syspath_prepend(str(folder))
    return importlib.import_module


@pytest.fixture
def checker_of(checkers):
    """The module ``checker.py`` of a claim, loaded anew."""

    def load(claim):
        path = CERTIFICATES / claim / "checker.py"
        specification = importlib.util.spec_from_file_location(f"{claim}_checker", path)
        module = importlib.util.module_from_spec(specification)
        specification.loader.exec_module(module)
        return module

    checkers("lrat")
    return load


@pytest.fixture
def proofs():
    """The folder of the certificates."""
    return CERTIFICATES
