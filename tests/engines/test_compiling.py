"""Compiled code is kept, and used again as long as the sources are the same."""

import pickle

import numba
import pytest

from allworlds.engines.kernel import compiling
from allworlds.engines.kernel.compiling import is_compiled
from allworlds.engines.kernel.runs import examine

pytestmark = pytest.mark.usefixtures("compiled")


def test_what_other_sources_kept_is_not_read(monkeypatch, tmp_path):
    index = tmp_path / "index"
    index.write_bytes(pickle.dumps(numba.__version__) + b"callworlds.engines.kernel.runs\nGone\n.")
    monkeypatch.setattr(compiling._file_of(examine), "_index_path", str(index))
    assert not is_compiled(examine)


def test_what_cannot_be_kept_is_not_there():
    assert not is_compiled(lambda: None)
