"""A finding, or an entry of the corpus, run again."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, Literal

from allworlds.document.report import Report
from allworlds.document.struct import (
    NotInDocument,
    Text,
    about,
    computed,
    key,
    replace,
)
from allworlds.engines.limits import TimeoutOptions
from allworlds.engines.single import SingleRun, single_run, subject_of, unused_choice
from allworlds.explorers.asked import ProgramWords
from allworlds.explorers.loading import own_bound
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import SCOPE, Option, OptionGroup, answers
from allworlds.judging.findings.finding import Finding, FindingOptions
from allworlds.judging.findings.walks import recorded_trail
from allworlds.judging.laws.law_table import LawName
from allworlds.outcome import Facts


class AnotherExplorer(ProgramWords):
    """An explorer in place of the recorded one, as the command line names it."""

    explorer: Annotated[
        str | None, Option(SCOPE, "EXPLORER", "In place of the recorded explorer.")
    ] = None

    def value(self) -> str | None:
        """The name of the explorer, if one is given."""
        return self.named(self.explorer)


class ReplayRequest(TimeoutOptions, FindingOptions, kw_only=False):
    """Request of ``replay``: a finding, and another explorer if wanted."""

    explore: Annotated[
        str | Callable[..., Any] | None,
        OptionGroup(AnotherExplorer, "an explorer in place of the recorded one"),
    ] = None


TRIES = 8
"""The number of runs, each in two fresh processes, before ``not-reproduced`` is said."""


class Replay(Report):
    """Report of 'replay'.

    The result of running a finding again.

    ``notice`` names the first recorded choice that this run did not take. It is empty if the run
    took all, or if another explorer made its own choices. ``users`` says that a user's explorer
    ran, not a built-in one.
    """

    again: Annotated[SingleRun, about("the run of today")] = key(name="run")
    recorded: NotInDocument[Finding]
    notice: NotInDocument[str] = ""
    users: NotInDocument[bool] = False

    @computed
    def explorer(self) -> Text:
        """The explorer that ran."""
        return self.again.explorer

    @computed
    def law(self) -> LawName:
        """The recorded one."""
        return self.recorded.law

    @computed
    def law_now(self) -> LawName | None:
        """The law that is broken now; null: none."""
        return self.again.finding.law if self.again.finding else None

    @computed
    def outcome(self) -> Literal["reproduced", "fixed", "not-reproduced"]:
        """``reproduced``: a law is broken again; ``fixed``: none is; else it cannot be shown."""
        if self.again.finding:
            return "reproduced"
        open_ = self.users and self.recorded.law == "nondeterministic"
        return "not-reproduced" if open_ else "fixed"

    @property
    def facts(self) -> Facts:
        """Whether no law is broken any more, or whether that is open."""
        outcome = self.outcome
        return Facts(fixed=outcome == "fixed", undecided=outcome == "not-reproduced")


@answers(ReplayRequest)
def replay(request: ReplayRequest) -> Replay:
    """Run a finding's world again under its rules, with ``explore`` in place of its explorer.

    The recorded choices are repeated for the recorded explorer, as far as they fit: it may have
    been changed since.  Another one answers to the recorded policy.  After a finding of the law
    ``nondeterministic`` the run is made up to :data:`TRIES` times.

    Raises:
        InputError: if the explorer is not to be found, the finding's transcript is no walk in
            its world, or it records choices of an explorer that takes none, unless that one is
            named by ``explore``, too.
    """
    finding, explore = request.finding, request.explore
    if not isinstance(finding, Finding):
        raise InputError(f"finding = {show(finding)} is no Finding; Finding.from_json makes one")
    limits = request.patience
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
    rules = replace(
        finding.rules,
        own_bound=own_bound(subject.name, kind),
        bound=finding.rules.the_bound,
        laws=finding.rules.applying or None,
    )
    script = finding.choices if same else ()
    for _ in range(TRIES if finding.law == "nondeterministic" else 1):
        again = single_run(subject, finding.world, rules, script, limits, finding.hash_seed)
        if again.finding:
            break
    notice = unused_choice(finding.choices, again) if same else ""
    if notice:
        notice = f"the recorded {notice}; choices are repeated as far as they fit"
    return Replay(again=again, recorded=finding, notice=notice, users=subject.from_user)
