"""What was compiled once is used again as long as the sources are the same."""

import os
from pathlib import Path

import pytest

from allworlds import kernel
from allworlds.kernel import compiling

pytestmark = pytest.mark.usefixtures("compiled")


def test_what_is_kept_is_good_for_the_same_sources_installed_later():
    kernel.compile_apart("algorithm1")
    source = Path(compiling.__file__)
    before = source.stat()
    os.utime(source)
    try:
        assert kernel.is_compiled(kernel.examine)
    finally:
        os.utime(source, ns=(before.st_atime_ns, before.st_mtime_ns))


def test_what_is_kept_is_no_good_for_other_sources(monkeypatch):
    kernel.compile_apart("algorithm1")
    monkeypatch.setattr(compiling._file_of(kernel.examine), "_source_stamp", "of others")
    assert not kernel.is_compiled(kernel.examine)


def test_what_cannot_be_kept_is_not_there():
    assert not kernel.is_compiled(lambda: None)
