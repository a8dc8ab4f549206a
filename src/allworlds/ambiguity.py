"""The verbs of ``allworlds ambiguity``, as in ``from allworlds.ambiguity import census``."""

import sys
from typing import TYPE_CHECKING

from allworlds.studies import ambiguity

if TYPE_CHECKING:
    from allworlds.studies.ambiguity import *  # noqa: F403  # for type checkers

sys.modules[__name__] = ambiguity
