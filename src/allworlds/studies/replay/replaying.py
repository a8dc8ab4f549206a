"""``replay``: a finding run again, and whether it still stands."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Literal

from allworlds.document import Aside, Report, Text, about, computed, key, one_of
from allworlds.engines import (
    Limits,
    SingleRun,
    single_run,
    subject_of,
    unused_choice,
)
from allworlds.inputs import (
    InputError,
    answers,
    show,
)
from allworlds.judging import Finding, LawName, recorded_trail
from allworlds.outcome import Exit
from allworlds.studies.replay.replay_request import ReplayRequest


class Replay(Report):
    """Report of 'replay'.

    What became of a finding.

    ``notice`` tells the first recorded choice that this run has not taken; it is empty if the run
    took all, or if another explorer was to answer by itself.
    """

    outcome: Annotated[
        Literal["reproduced", "fixed"],
        about("`reproduced`: a law is broken again; `fixed`: none is"),
    ] = computed(lambda replay: "reproduced" if replay.again.finding else "fixed")
    exit_code: Annotated[Exit, one_of(Exit.ANSWERED, Exit.FIXED)] = computed(
        lambda replay: Exit.FIXED if replay.outcome == "fixed" else Exit.ANSWERED
    )
    explorer: Annotated[Text, about("the one that ran")] = computed(
        lambda replay: replay.again.explorer
    )
    law: Annotated[LawName, about("the recorded one")] = computed(
        lambda replay: replay.recorded.law
    )
    law_now: Annotated[LawName | None, about("the one that is broken now; null: none")] = computed(
        lambda replay: replay.again.finding.law if replay.again.finding else None
    )
    again: Annotated[SingleRun, about("the run of today")] = key(name="run")
    recorded: Aside[Finding]
    notice: Aside[str] = ""


@answers(ReplayRequest)
def replay(request: ReplayRequest) -> Replay:
    """Run a finding's world again under its rules, with ``explore`` in place of its explorer.

    The recorded choices are repeated for the recorded explorer, as far as they fit: it may have
    been changed since.  Another one answers to the recorded policy.

    Raises:
        InputError: if the explorer is not to be found, the finding's transcript is no walk in
            its world, or it records choices of an explorer that takes none, unless that one is
            named by ``explore``, too.
    """
    finding, explore = request.finding, request.explore
    if not isinstance(finding, Finding):
        raise InputError(f"finding = {show(finding)} is no Finding; Finding.from_json makes one")
    limits = Limits(answer_timeout=request.answer_timeout)
    recorded_trail(finding.world, finding.transcript)
    same = explore is None or explore == finding.explorer
    subject = subject_of(finding.explorer if explore is None else explore, limits)
    if explore is None and finding.choices and not subject.takes_choices:
        raise InputError(
            f"the finding records the choices {show(list(finding.choices))}, but "
            f"{finding.explorer} takes no choices; to run it without them, name it as the "
            "explorer, too"
        )
    kind = finding.world.lighthouse.kind
    again = single_run(
        subject,
        finding.world,
        replace(finding.rules, own_bound=subject.bound_under(kind)),
        finding.choices if same else (),
        limits,
    )
    notice = unused_choice(finding.choices, again) if same else ""
    if notice:
        notice = f"the recorded {notice}; they count as far as they fit"
    return Replay(again=again, recorded=finding, notice=notice)
