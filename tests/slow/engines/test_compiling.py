"""Compiled code is kept, and used again as long as the sources are the same."""

import os
from pathlib import Path

import pytest

from allworlds.engines.kernel import compiling
from allworlds.engines.kernel.compiling import is_compiled
from allworlds.engines.kernel.engine import compile_apart
from allworlds.engines.kernel.runs import examine

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.slowest
def test_what_is_kept_is_good_for_the_same_sources_installed_later():
    compile_apart("algorithm1")
    source = Path(compiling.__file__)
    before = source.stat()
    os.utime(source)
    try:
        assert is_compiled(examine)
    finally:
        os.utime(source, ns=(before.st_atime_ns, before.st_mtime_ns))


@pytest.mark.slowest
def test_what_is_kept_is_no_good_for_other_sources(monkeypatch):
    compile_apart("algorithm1")
    monkeypatch.setattr(compiling._file_of(examine), "_source_stamp", "of others")
    assert not is_compiled(examine)
