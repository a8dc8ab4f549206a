"""Two plays of one run compared, and the outcome that follows from both."""

from __future__ import annotations

from collections.abc import Sequence

from allworlds.document import replace
from allworlds.engines.python.examiner import LOST, Outcome
from allworlds.engines.python.play import RECORD_ENDS
from allworlds.inputs import show
from allworlds.judging import (
    PRECEDENCE,
    Fault,
    Log,
    Over,
    UncheckedAmbiguous,
    UncheckedAnswer,
    UncheckedValue,
    Violation,
)
from allworlds.protocol import action_numbered

SHOWN_BEFORE, SHOWN_AFTER = 8, 4
"""The number of actions that are shown before the first that differs, and from it on."""


def overruled(outcome: Outcome, first: Log, second: Log) -> Outcome:
    """The outcome of a first play, overruled by the violation of two plays that differ."""
    difference = difference_of(first, second)
    if difference is None or not _may_be_overruled(outcome.violation, second):
        return outcome
    faults = [log.ending for log in (second, first) if isinstance(log.ending, Fault)]
    detail = next((fault.detail for fault in faults if fault.detail), "")
    detail = "\n".join(filter(None, [side_by_side(first, second), detail]))
    return replace(outcome, violation=difference, detail=detail)


def _may_be_overruled(violation: Violation | None, second: Log) -> bool:
    """Whether nondeterminism has precedence over this law, or the second play does not break it.

    A law that is broken in one of two plays alone is no more than a sign that they differ.
    """
    if violation is None or violation.law in LOST:
        return True
    if not isinstance(second.ending, Fault) or second.ending.law != violation.law:
        return True
    return PRECEDENCE.index("nondeterministic") < PRECEDENCE.index(violation.law)


def difference_of(first: Log, second: Log) -> Violation | None:
    """The violation of an explorer whose plays on the same percepts differ; None if they do not."""
    if first.actions != second.actions:
        pairs = zip(first.actions, second.actions, strict=False)
        same = next((i for i, (a, b) in enumerate(pairs) if a != b), None)
        where = "in its length" if same is None else f"at step {same + 1}"
        difference = f"the second walk differs {where}"
    elif _goes_on(second) and not isinstance(first.ending, Fault):
        return nondeterministic("the second walk goes on where the first one ended")
    elif _meaning(first) != _meaning(second):
        difference = "the second answer differs"
    elif first.widths and first.choices != second.choices:
        # Every schedule is tried, and which there are follows from the choices.
        difference = "the choices of the second play differ"
    else:
        return None
    for which, log in (("first", first), ("second", second)):
        # Where the second walk leaves the first, nothing that it does is legal.
        left = log is second and first.actions != second.actions
        if isinstance(log.ending, Fault) and not (left and log.ending.law == "illegal-action"):
            difference += f"; the {which} ended with {log.ending.law}: {log.ending.seen}"
    return nondeterministic(difference)


def _goes_on(second: Log) -> bool:
    """Whether a second play acts where the percepts of the first one end."""
    return isinstance(second.ending, Fault) and second.ending.expected == RECORD_ENDS


def side_by_side(first: Log, second: Log) -> str:
    """Both plays, a line each: the actions around the first that differs, and the endings."""
    pairs = zip(first.actions, second.actions, strict=False)
    differ = next((i for i, (a, b) in enumerate(pairs) if a != b), len(first.actions))
    begin, end = max(0, differ - SHOWN_BEFORE), differ + SHOWN_AFTER
    return "\n".join(
        f"{which} play, from step {begin + 1} on: {_walk(log, begin, end)}"
        for which, log in (("first", first), ("second", second))
    )


def _walk(log: Log, begin: int, end: int) -> str:
    actions = [str(action_numbered(number)) for number in log.actions[begin:end]]
    if len(log.actions) > end:
        return ", ".join([*actions, f"and {len(log.actions) - end} more"])
    return ", ".join([*actions, _ending(log)])


def _ending(log: Log) -> str:
    match log.ending:
        case Fault(law=law):
            return law
        case UncheckedAmbiguous():
            return "a quotient"
        case UncheckedValue(text):
            return f"the answer {text}"
        case Over():
            return "all was done"
        case UncheckedAnswer(sigma, alpha, here):
            return show({"sigma": sigma, "alpha": alpha, "here": here})


def nondeterministic(seen: str) -> Violation:
    """The violation of two plays with this difference."""
    return Violation(
        "nondeterministic",
        "the same walk and answer when the same world is explored again",
        seen,
    )


def _meaning(log: Log) -> object:
    """The part of the ending that both plays must share: the answer, or the law of the fault."""
    return log.ending.law if isinstance(log.ending, Fault) else log.ending


def differing_or_first(first: Log, again: Sequence[Log]) -> Log:
    """The first of the later plays that differs from the first play, or else the first of them."""
    return next((log for log in again if difference_of(first, log)), again[0])


def may_be_the_machine(first: Log, second: Log) -> bool:
    """Whether the plays differ, and the machine may be the cause of the ending of one."""
    endings = (first.ending, second.ending)
    suspicious = any(isinstance(end, Fault) and end.machine for end in endings)
    return suspicious and difference_of(first, second) is not None


def ending_in_words(log: Log) -> str:
    """The fault of a play, or that it ended with an answer."""
    return log.ending.seen if isinstance(log.ending, Fault) else "it ended with an answer"
