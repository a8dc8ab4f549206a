"""Reports about one finding of a team: a new search of its world, and its run in words.

The *model* of a finding says how the finding's world changes: what the robots sense, and what can
follow their actions.  A model is built in, or a user's Python class.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from typing_extensions import override

from allworlds.documents import document as doc
from allworlds.documents.report import Report
from allworlds.engines.limits import TimeoutOptions
from allworlds.outcome import Facts, Verdict
from allworlds.robots.team_finding import LAWS, TeamFinding
from allworlds.studies.team.search_sweep import request_again, searched
from allworlds.studies.team.team_report import TeamReport
from allworlds.words import plural


class TeamReplay(Report):
    """Report of 'replay', of a team.

    The new search of the world of a finding; ``recorded`` is this finding. ``notice`` is always
    empty; in the report of 'replay' of one robot it is a sentence about the recorded choices.
    """

    again: Annotated[TeamReport, doc.about("the search of today")] = doc.key(name="search")
    recorded: doc.NotInDocument[TeamFinding]
    notice: doc.NotInDocument[str] = ""

    @doc.computed
    def law(self) -> doc.Text:
        """The law of the recorded finding."""
        return self.recorded.law

    @doc.computed
    def law_now(self) -> doc.Text | None:
        """The law that is broken now; null: none."""
        return self.again.findings[0].law if self.again.findings else None

    @doc.computed
    def outcome(self) -> Literal["reproduced", "fixed", "not-reproduced"]:
        """``reproduced``: a law is broken; ``fixed``: none is; ``not-reproduced``: undecided.

        Any broken law counts, not only the recorded one.  If the new search finds no broken law,
        there are three cases.  First: the recorded law is ``budget``, and the budget cuts off a run
        again.  Such a run breaks a law only under the option ``within``, but here it counts as
        ``reproduced``.  Second: the verdict of the new search is ``holds``.  The finding is fixed.
        Third: the verdict is another one, for example because a time limit stops the search.  The
        outcome is undecided.
        """
        if self.again.findings:
            return "reproduced"
        holds = self.again.verdict is Verdict.HOLDS
        cut_off = self.recorded.law == "budget" and self.again.unfinished is not None
        return "reproduced" if cut_off else "fixed" if holds else "not-reproduced"

    @property
    @override
    def facts(self) -> Facts:
        said = self.outcome
        return Facts(fixed=said == "fixed", undecided=said == "not-reproduced")


def replayed(finding: TeamFinding, explore: Any, limits: TimeoutOptions) -> TeamReplay:
    """Search the world of a finding again, and return the report with the new search.

    The model of the finding is used again.

    Args:
        finding: the finding.
        explore: a program that replaces the programs of all robots; None keeps the recorded ones.
        limits: the time-outs of the programs.

    Raises:
        InputError: if a program or the model cannot be found, or if the text of the model is not
            the recorded one.
    """
    programs = (explore,) if explore is not None else finding.team
    request = request_again(finding, programs, limits)
    return TeamReplay(again=searched(request).uninterrupted(), recorded=finding)


class TeamExplanation(Report):
    """Report of 'explain', of a team.

    The run of a finding of several robots, in words and as a space-time diagram.
    """

    finding: TeamFinding
    number: Annotated[doc.Positive, doc.about("of the finding in its report; 1: the first")]
    findings: Annotated[doc.Positive, doc.about("how many findings the report holds")]

    @doc.computed
    def sentences(self) -> doc.Some[doc.Text]:
        """The finding in plain words."""
        return tuple(sentences_of(self.finding))


def sentences_of(finding: TeamFinding) -> Iterator[str]:
    """Yield a few sentences that explain a finding."""
    yield f"{LAWS[finding.law]} Here this law is broken: {finding.seen}."
    events = len(finding.events)
    if finding.loop:
        first = events - finding.loop + 1
        which = f"Events {first} to {events} repeat" if first < events else f"Event {first} repeats"
        yield f"{which} for ever."
        yield "The schedule is fair: a robot that can act all this time does act."
    elif events:
        yield f"This happens after {plural(events, 'event')}, and in this world never after fewer."
    late = [*_stale(finding)]
    if late:
        yield f"A move follows from what was sensed earlier: {'; '.join(late)}."
    chosen = [event.world for event in finding.events if event.world]
    if chosen:
        yield f"The adversary: {'; '.join(dict.fromkeys(chosen))}."


def _stale(finding: TeamFinding) -> Iterator[str]:
    """Yield a sentence for each stale move.

    A move is stale if another robot has moved since the look of the robot that moves now: this
    robot moves by an old percept.
    """
    looked: dict[int, int] = {}
    moved: dict[int, int] = {}
    for number, event in enumerate(finding.events, 1):
        for turn in event.robots:
            since = looked.get(turn.robot, number)
            others = [at for robot, at in moved.items() if robot != turn.robot and at > since]
            if turn.phase == "move" and others:
                yield f"robot {turn.robot} looks in event {since} and moves in event {number}"
        for turn in event.robots:
            if turn.phase == "look":
                looked[turn.robot] = number
            else:
                moved[turn.robot] = number
