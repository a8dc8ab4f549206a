"""The verbs of ``allworlds ambiguity`` as Python functions, such as ``ambiguity.census``."""

import sys
from typing import TYPE_CHECKING

from allworlds.studies import ambiguity

if TYPE_CHECKING:
    from allworlds.studies.ambiguity import *  # noqa: F403  # for type checkers

sys.modules[__name__] = ambiguity
