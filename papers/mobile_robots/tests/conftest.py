"""The modules of this paper can be imported, and fixtures and settings are those of all tests.

Papers have modules of one name: the tests of each paper are a process of their own.
"""

import sys
from pathlib import Path

TESTS = Path(__file__).parent
sys.path[:0] = [str(TESTS.parent), str(TESTS)]
ROOT = TESTS.parents[2]
sys.path += [
    str(ROOT / "examples" / "robots"),
    str(ROOT / "proofs"),
]  # proofs: of every paper's tests

pytest_plugins = ["conftest"]
