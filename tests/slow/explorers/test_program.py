"""One process behind many episodes; see tests/engines/test_workers.py for what goes wrong."""

import shutil

import pytest

from allworlds.studies.check.exhaustive import check
from explorers import test_program as quick
from native_libraries import EXAMPLES

program = quick.program


@pytest.mark.slowest
def test_the_example_in_javascript_walks_as_the_built_in_does():
    if shutil.which("node") is None:
        pytest.skip("there is no node")
    program, built_in = (
        check(name, edges=3, engine="python")
        for name in (f"exec:node {EXAMPLES}/javascript/algorithm1.js", "algorithm1")
    )
    assert program.exit_code == 0
    assert program.levels == built_in.levels
