"""The programs of this paper can be imported; drawn examples are the same each time."""

import sys
from pathlib import Path

from hypothesis import settings

sys.path.insert(0, str(Path(__file__).parents[1]))

settings.register_profile(
    "same-every-time", derandomize=True, database=None, deadline=None, max_examples=60
)
settings.load_profile("same-every-time")
