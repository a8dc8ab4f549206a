"""The modules of this paper can be imported, and fixtures and settings are those of all tests.

Both papers have modules of one name: ``pytest papers/minimal_information/tests`` and
``pytest papers/lower_bounds/tests`` are two processes.
"""

import sys
from pathlib import Path

TESTS = Path(__file__).parent
sys.path[:0] = [str(TESTS.parent), str(TESTS)]

pytest_plugins = ["conftest"]
