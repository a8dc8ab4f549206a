"""``replay``: a finding run again, and whether it still stands."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

from allworlds.engines import Limits, SingleRun, single_run, subject_of, unused_choice
from allworlds.inputs import InputError, show
from allworlds.judging import Finding, recorded_trail
from allworlds.outcome import SCHEMA, Exit
from allworlds.protocol import ANSWER_TIMEOUT

if TYPE_CHECKING:
    from allworlds import documents


@dataclass(frozen=True, slots=True)
class Replay:
    """What became of a finding.

    Attributes:
        recorded: the finding.
        again: the run of today.
        notice: the first recorded choice that this run has not taken; empty if it took all, or
            if another explorer was to answer by itself.
    """

    recorded: Finding
    again: SingleRun
    notice: str = ""

    @property
    def outcome(self) -> Literal["reproduced", "fixed"]:
        """``reproduced`` if the run still breaks a law, ``fixed`` if it breaks none."""
        return "reproduced" if self.again.finding else "fixed"

    @property
    def exit_code(self) -> Exit:
        """The exit code of the command."""
        return Exit.FIXED if self.outcome == "fixed" else Exit.ANSWERED

    def to_json(self) -> documents.ReplayDocument:
        """The document of ``replay --json``."""
        return {
            "schema": SCHEMA,
            "outcome": self.outcome,
            "exit_code": self.exit_code,
            "explorer": self.again.explorer,
            "law": self.recorded.law,
            "law_now": self.again.finding.law if self.again.finding else None,
            "run": self.again.to_json(),
        }


def replay(
    finding: Finding,
    explore: str | Callable[..., Any] | None = None,
    *,
    answer_timeout: float = ANSWER_TIMEOUT,
) -> Replay:
    """Run a finding's world again under its rules, with ``explore`` in place of its explorer.

    The recorded choices are repeated for the recorded explorer, as far as they fit: it may have
    been changed since.  Another one answers to the recorded policy.

    Raises:
        InputError: if the explorer is not to be found, the finding's transcript is no walk in
            its world, or it records choices of an explorer that takes none, unless that one is
            named by ``explore``, too.
    """
    if not isinstance(finding, Finding):
        raise InputError(f"finding = {show(finding)} is no Finding; Finding.from_json makes one")
    limits = Limits(answer_timeout=answer_timeout)
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
    return Replay(finding, again, notice)
