"""The checker: every world of a class, one explorer, a verdict with its scope.

``scope``
    what is to be checked, and with which options;
``examine``
    one run after the other, judged and tallied; **the** loop of the exhaustive check;
``worker``, ``pool``, ``laboratory``
    the same loop in processes that can be killed;
``engines``, ``kernel_pool``
    the compiled engine in their place, where it can;
``finding``, ``confirm``
    the refuting run as a value, and its confirmation in a fresh process;
``past``
    findings of earlier checks, which are tried first;
``belief``, ``parting``
    the same walk in a wrong answer, and where the two part;
``drive``, ``tally``, ``report``
    level by level to a :class:`Report`, with the count gate and the witnesses;
``single``, ``replay``
    one world at a time.
"""

from allworlds.checker.drive import check
from allworlds.checker.finding import Finding
from allworlds.checker.replay import Replay, replay
from allworlds.checker.report import Report, Verdict
from allworlds.checker.scope import Limits, Scope, ScopeError
from allworlds.checker.single import SingleRun, run, worlds

__all__ = [
    "Finding",
    "Limits",
    "Replay",
    "Report",
    "Scope",
    "ScopeError",
    "SingleRun",
    "Verdict",
    "check",
    "replay",
    "run",
    "worlds",
]
