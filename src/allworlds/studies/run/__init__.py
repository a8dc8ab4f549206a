"""One world, told step by step.

``run_request``
    what is asked for, and the names that a WORLD can have;
``single``
    the verb;
``hypotheses``
    the hypotheses that Algorithm 1 tests in a run, heard while it is played once more.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.run.hypotheses import (
        Hypothesis as Hypothesis,
        embedded as embedded,
        hypotheses_in as hypotheses_in,
    )
    from allworlds.studies.run.run_request import (
        AskedRun as AskedRun,
        RunRequest as RunRequest,
        WorldNames as WorldNames,
    )
    from allworlds.studies.run.single import run as run
else:
    open_door(__name__)
