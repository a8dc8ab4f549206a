"""The comparison of two plays of one run, and the broken law of an explorer whose plays differ.

In the first play the explorer walks in the world; in the second it gets the percepts of the first
play.  Each play gives a log.  These functions only compare logs; other modules judge them.
"""

from collections.abc import Sequence

from allworlds import log as entries
from allworlds.documents.document import replace
from allworlds.inputs.checks import show
from allworlds.judging.episode import Answered, Fault, ending_of, fault_of
from allworlds.judging.laws.law_table import PRECEDENCE, Violation
from allworlds.judging.referee import LOST, Outcome
from allworlds.log import Log
from allworlds.protocol import actions
from allworlds.world.world import World

SHOWN_BEFORE, SHOWN_AFTER = 8, 4
"""The largest numbers of actions of a play that are shown: before the first action that differs in
the two plays, and from this action on."""


def overruled(outcome: Outcome, first: Log, second: Log, *, choices: bool = False) -> Outcome:
    """The outcome of the first play, or an outcome which says that the two plays differ.

    If the plays differ, the law ``nondeterministic`` is broken, with one exception: ``outcome``
    stays if both plays break the same law, this law comes before ``nondeterministic`` in the order
    of precedence, and it is neither ``crash`` nor ``timeout``.

    Args:
        outcome: the outcome of the first play.
        first: the log of the first play.
        second: the log of the second play.
        choices: whether the choices are compared, too; see :func:`difference_of`.
    """
    difference = difference_of(first, second, choices=choices)
    if difference is None or not _may_be_overruled(outcome.violation, second):
        return outcome
    faults = [fault for fault in (fault_of(second), fault_of(first)) if fault]
    detail = next((fault.detail for fault in faults if fault.detail), "")
    detail = "\n".join(filter(None, [side_by_side(in_words(first), in_words(second)), detail]))
    return replace(outcome, violation=difference, detail=detail)


def _may_be_overruled(violation: Violation | None, second: Log) -> bool:
    """Whether the law ``nondeterministic`` may replace the broken law of the first play.

    The two plays of the run differ.  The result is False only if three conditions are met.  First:
    the law of ``violation`` stands before ``nondeterministic`` in the order of precedence.  Second:
    it is neither ``crash`` nor ``timeout``, which a run may break because of the machine.  Third:
    the second play ends with a fault by the same law.

    Args:
        violation: the violation of the first play; None if it breaks no law.
        second: the log of the second play.
    """
    if violation is None or violation.law in LOST:
        return True
    fault = fault_of(second)
    if fault is None or fault.law != violation.law:
        return True
    return PRECEDENCE.index("nondeterministic") < PRECEDENCE.index(violation.law)


def difference_of(first: Log, second: Log, *, choices: bool = False) -> Violation | None:
    """The violation of the law ``nondeterministic`` if two plays differ; None if they do not.

    The texts of faults are not compared, because they may contain an address or a time.

    Args:
        first: the log of the play in the world.
        second: the log of the play in which the explorer got the percepts of the first play.
        choices: whether the explorer's choices are compared, too, and not only actions and ending;
            needed only if every schedule is tried.
    """
    actions, again = [*first.actions], [*second.actions]
    if actions != again:
        pairs = zip(actions, again, strict=False)
        same = next((i for i, (a, b) in enumerate(pairs) if a != b), None)
        where = "in its length" if same is None else f"at step {same + 1}"
        difference = f"the second walk differs {where}"
        beyond = second.ending[0] == entries.BEYOND and len(again) == len(actions) + 1
        if same is None and beyond and fault_of(first) is None:
            return nondeterministic("the second walk goes on where the first one ended")
    elif _meaning(first) != _meaning(second):
        difference = "the second answer differs"
    elif choices and (first.choices, first.widths) != (second.choices, second.widths):
        difference = "the choices of the second play differ"
    else:
        return None
    for which, log in (("first", first), ("second", second)):
        # Once the second walk has left the first one, each of its actions is illegal.
        left, fault = log is second and actions != again, fault_of(log)
        if fault and not (left and fault.law == "illegal-action"):
            difference += f"; the {which} ended with {fault.law}: {fault.seen}"
    return nondeterministic(difference)


def side_by_side(first: tuple[list[str], str], second: tuple[list[str], str]) -> str:
    """A text of two lines, one for each play: its actions near the first difference, its ending.

    Each play is given as :func:`in_words` returns it.
    """
    pairs = zip(first[0], second[0], strict=False)
    differ = next((i for i, (a, b) in enumerate(pairs) if a != b), len(first[0]))
    begin, end = max(0, differ - SHOWN_BEFORE), differ + SHOWN_AFTER
    lines = []
    for which, (moves, ending) in (("first", first), ("second", second)):
        more = len(moves) - end
        shown = [*moves[begin:end], f"and {more} more" if more > 0 else ending]
        lines.append(f"{which} play, from step {begin + 1} on: {', '.join(shown)}")
    return "\n".join(lines)


def in_words(log: Log) -> tuple[list[str], str]:
    """The actions of a play, each as a text, and the play's ending as a text."""
    return [str(actions.action_numbered(number)) for number in log.actions], _ending(log)


def _ending(log: Log) -> str:
    ending = ending_of(log)
    if isinstance(ending, Fault):
        return ending.law
    return f"the answer {show(ending.answer)}" if isinstance(ending, Answered) else "all was done"


def nondeterministic(seen: str) -> Violation:
    """The violation of the law ``nondeterministic``; ``seen`` says how the two plays differ."""
    return Violation(
        "nondeterministic",
        "the same walk and answer when the same world is explored again",
        seen,
    )


def _meaning(log: Log) -> object:
    """The part of a play's ending that must be equal in both plays: the answer or the broken law.

    There are three cases.  First: the play ended because its last action got no percept; then the
    result is None.  Second: the play ended with a fault; then the result is the name of the broken
    law.  Third: otherwise the result is the ending as the log records it, with the answer.

    In the first case the two plays may record different endings that mean the same.  In the first
    play the last action was illegal in the world, so no percept was recorded for it.  In the second
    play the recorded percepts are at their end at this action.
    """
    if log.ending[0] in (entries.BEYOND, entries.REFUSED):
        return None  # there is no percept after a refused action
    fault = fault_of(log)
    return fault.law if fault else log.ending


def after_worlds(outcome: Outcome, worlds: Sequence[World]) -> Outcome:
    """The outcome of a run whose two plays differ because of earlier runs in these worlds.

    The worlds are added to ``outcome``, and their number is named in its violation.  An outcome
    whose violation is not of the law ``nondeterministic`` is returned unchanged.
    """
    violation = outcome.violation
    if violation is None or violation.law != "nondeterministic":
        return outcome
    said = "that world" if len(worlds) == 1 else f"those {len(worlds)} worlds"
    seen = f"after {said}, in the same process: {violation.seen}"
    return replace(outcome, violation=nondeterministic(seen), after=tuple(worlds))
