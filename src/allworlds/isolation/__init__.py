"""Isolation: foreign code runs in processes that it may kill, and the check goes on.

``jobs``
    what parent and worker say to each other;
``worker``, ``standins``
    the process that examines units, and what explorers play against in it;
``process``
    the parent's side of one worker;
``workers``
    the transport: units handed out, workers outlived;
``confirm``
    a finding once more in a fresh process, and the walk of a run that was lost.
"""

from allworlds.isolation.confirm import confirmed, examine_apart
from allworlds.isolation.jobs import HarnessError
from allworlds.isolation.workers import Workers, workers_for

__all__ = ["HarnessError", "Workers", "confirmed", "examine_apart", "workers_for"]
