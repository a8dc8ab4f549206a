"""The exact worst and best cost of Algorithm 1 over all worlds and all schedules.

``every_schedule``
    one world, readably; also a sequence of choices that attains the worst cost;
``worst_request``
    what is asked for;
``worst_report``
    what is reported;
``all_worlds``
    every world of a class, with the compiled engine;
``compiled_engine``
    that engine, and what it brings.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.worst.all_worlds import worst as worst
    from allworlds.studies.worst.every_schedule import EverySchedule as EverySchedule
    from allworlds.studies.worst.worst_report import WorstReport as WorstReport
else:
    open_door(__name__)
