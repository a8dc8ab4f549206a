"""Sections and sentences about a finding."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from allworlds.explorers.loading import is_program
from allworlds.judging.explanations.story import Belief, Story
from allworlds.judging.findings.finding import Finding
from allworlds.judging.findings.rules import Rules
from allworlds.judging.findings.walks import find_parting, true_trail
from allworlds.protocol.answers import Estimate
from allworlds.protocol.playing import BUILT, NO_MAP
from allworlds.reports.scenes import walk_in_answer, walk_in_world
from allworlds.reports.telling import (
    Block,
    Curve,
    Elsewhere,
    Quote,
    Section,
    ToldFacts,
    ToldRecord,
    ToldWalk,
    View,
    fact,
)
from allworlds.words import listed, number, plural, size
from allworlds.world.world import World

if TYPE_CHECKING:
    from allworlds.studies.explain import Explanation

LONGEST_LIST = 60
"""The choices of a longer list are told from both ends."""


def headline_of(finding: Finding) -> str:
    """One line: the explorer, the broken law and the world's size."""
    map_ = finding.world.map
    of_size = size(map_.edge_count, map_.vertex_count)
    return f"{finding.explorer} breaks the law '{finding.law}' in a world with {of_size}"


def finding_section(
    finding: Finding,
    number: int = 1,
    origin: str = "",
    *,
    title: str = "",
    checked: bool = True,
) -> Section:
    """Everything about a finding, as one section.

    Args:
        finding: which one.
        number: which of those that are told.
        origin: where it comes from; empty where a check has come upon it by itself.
        title: in place of its number, its explorer and its law.
        checked: it comes from a check, which has confirmed it, or tried to.
    """
    from allworlds.studies.explain import explain  # which a check that holds does not need

    story, told = Story(finding), explain(finding)
    title = title or f"Finding {number}: {headline_of(finding)}"
    detail = _detail(finding)
    blocks: list[Block] = [_law(finding)]
    if finding.law == "no-estimate":
        blocks += detail
    blocks.append(_walk(story, told, f"The walk of finding {number}"))
    if told.spent:
        blocks.append(Curve(told.spent))
    blocks += [ToldFacts([*_remarks(finding, origin, checked=checked)])]
    blocks.append(Quote("command", "reproduce", finding.reproduce, command=True))
    if finding.law != "no-estimate":
        blocks += detail
    blocks += printed(finding.output, finding.detail)
    transcript = finding.transcript
    log = [f"start: {transcript.first}", *(f"{a}: {p}" for a, p in transcript.steps)]
    said = "Copy the finding as JSON, for replay and explain"
    blocks.append(ToldRecord(said, finding.to_json(), "\n".join(log)))
    return Section(f"finding-{number}", title, blocks)


def _detail(finding: Finding) -> list[Block]:
    """The detail of the finding, under what it is."""
    detail = finding.detail
    if finding.law == "no-estimate":
        # The explanation has told the line of the call.
        detail = "" if detail.startswith(BUILT) else detail.partition(f"\n\n{BUILT}")[0]
        title = "the permutations that were tried"
    elif finding.law == "nondeterministic":
        title = "the two plays, from where they differ"
    else:
        title = "output on stderr" if is_program(finding.explorer) else "traceback"
    return [Quote("detail", title, detail)] if detail else []


def printed(output: str, told: str = "") -> list[Block]:
    """The output of the explorer, unless it is shown already."""
    if not output or output.rstrip() in told:
        return []
    return [Quote("output", "printed by the explorer", output, prefix="| ")]


def nothing_checked(rules: Rules) -> str:
    """The reason why runs have checked nothing: their laws are about checkpoints alone."""
    laws = listed(rules.judged)
    return f"nothing was checked: the explorer shows no checkpoint, as needed for {laws}"


def _law(finding: Finding) -> ToldFacts:
    """The law, and what was expected and seen, where that is no map."""
    wrong = {
        "map": "the answer is not the same map as the world",
        "pose": "the answer is the same map, but 'here' is not the robot's dart",
    }.get(finding.law, "")
    if wrong and isinstance(finding.seen, Estimate):
        return fact("law", f"{finding.law}: {wrong}")
    if str(finding.seen).startswith(NO_MAP):
        return fact("law", f"{finding.law}: the explorer's sigma and alpha are no map")
    at_most = "at most " if isinstance(finding.expected, int) else ""
    expected = at_most + _traversals(finding.expected)
    return ToldFacts(
        [("law", finding.law), ("expected", expected), ("seen", _traversals(finding.seen))]
    )


def _traversals(value: Any) -> str:
    return plural(value, "traversal") if isinstance(value, int) else str(value)


def _walk(story: Story, told: Explanation, title: str) -> ToldWalk:
    world, transcript = story.world, story.transcript
    view = View("world", "The world", walk_in_world(world, transcript), story.walked)
    if told.answer:
        belief = Belief(story)
        answer = answer_view(world, belief.answer, transcript, belief.walk.trail)
        elsewhere = Elsewhere("expected by the answer", belief.walk.expected)
        return ToldWalk(
            title,
            story,
            [view, answer],
            told.sentences,
            elsewhere,
            belief.walk.agreement,
            told.step,
        )
    if told.other:
        trail = true_trail(told.other, transcript)
        scene = walk_in_world(told.other, transcript)
        other = View("answer", "Another world, with the same percepts", scene, trail)
        agreement = _agreement(story, told.other)
        return ToldWalk(title, story, [view, other], told.sentences, None, agreement, told.step)
    return ToldWalk(title, story, [view], told.sentences, parting=told.step)


def answer_view(world: World, answer: Estimate, transcript: Any, trail: Any) -> View:
    """The picture of an answer, with the walk as it would be there."""
    scene = walk_in_answer(world, answer, transcript)
    note = "R: the robot's place according to the answer"
    return View("answer", "The answer", scene, trail, note)


def _agreement(story: Story, other: World) -> int:
    """The number of steps in which both worlds look alike to an observer who sees everything."""
    trail = true_trail(other, story.transcript)
    fits = [True] * len(trail)
    parting = find_parting(story.map, story.walked, other.map, trail, fits)
    return parting.step if parting else len(trail)


def _remarks(finding: Finding, origin: str, *, checked: bool) -> Iterator[tuple[str, str]]:
    if finding.choices:
        yield "choices", _choices(finding)
    if checked:
        confirmed = "no"
        if finding.confirmed:
            confirmed = "yes: a new process, given only the percepts, repeated the run"
        smaller = "a smaller one may refute"
        if finding.minimal:
            among = finding.rules.among
            scope = f"the scope (--where {among.name})" if among else "the scope"
            smaller = f"no smaller world of {scope} refutes"
        yield "confirmed", f"{confirmed}; {smaller}"
    if origin:
        yield "origin", origin


def _choices(finding: Finding) -> str:
    """The index taken at each choice; of many the first and the last."""
    indices = [*map(str, finding.choices)]
    if len(indices) > LONGEST_LIST:
        half = LONGEST_LIST // 2
        between = f"... ({number(len(indices) - 2 * half)} more) ..."
        indices = [*indices[:half], between, *indices[-half:]]
    return ", ".join(indices)
