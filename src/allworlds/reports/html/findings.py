"""A finding on a page: its pictures, its walk, what it means, and how to run it again."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from xml.etree import ElementTree as ET

from allworlds.judging import Belief, Explanation, Finding, Story, explain, find_parting, true_trail
from allworlds.maps import Dart
from allworlds.reports.cost_curve import cost_picture
from allworlds.reports.finding_words import (
    choices_words,
    expected_words,
    headline,
    remarks,
    seen_words,
    wrong,
)
from allworlds.reports.html.beside import figures_beside
from allworlds.reports.html.viewer import figure, viewer
from allworlds.reports.html.walk import walk
from allworlds.reports.markup import Child, record, tag
from allworlds.reports.scenes import OTHER, walk_in_answer, walk_in_world
from allworlds.world import World


def finding_section(finding: Finding, number: int, origin: str = "") -> ET.Element:
    """All that there is to see and to read of the finding, with the origin that it has, if any."""
    name = f"finding-{number}"
    story, explanation = Story(finding), explain(finding)
    belief = Belief(story) if explanation.answer else None
    return tag(
        "section",
        tag("h2", f"Finding {number}: ", tag("bdi", headline(finding)), id=f"{name}-title"),
        _viewer(story, belief, explanation, name),
        *([cost_picture(explanation.spent, f"{name}-cost")] if explanation.spent else []),
        tag("dl", *_facts(finding, origin)),
        *_again(finding, name),
        record(finding.to_json(), class_="finding", id=f"{name}-json"),
        class_="finding",
        id=name,
        aria_labelledby=f"{name}-title",
    )


def _sentences(sentences: tuple[str, ...]) -> Iterator[Child]:
    for sentence in sentences:
        yield tag("bdi", sentence)
        yield " "


def _viewer(story: Story, belief: Belief | None, told: Explanation, name: str) -> ET.Element:
    """The pictures of a finding, and its walk."""
    world, transcript = story.world, story.transcript
    scene = walk_in_world(world, transcript)
    others: dict[str, Sequence[Dart]] = {}
    if belief:
        answer = walk_in_answer(world, belief.answer, transcript)
        trails, agreement = (story.walked, belief.believed), belief.agreement
        figures = figures_beside(scene, answer, trails, agreement, name)
    elif told.other:
        others["believed"] = true_trail(told.other, transcript)
        figures = _agreeing(story, told.other, others["believed"], name)
    else:
        figures = [figure("The world", scene, f"{name}-world", "robot")]
    title = f"The walk of finding {name.rpartition('-')[2]}."
    about = tag("p", *_sentences(told.sentences), class_="story")
    return viewer(figures, walk(story, name, belief, told.step, others), title, about)


def _agreeing(story: Story, other: World, trail: Sequence[Dart], name: str) -> list[ET.Element]:
    """The world, and beside it the other one in which the robot would have sensed the same."""
    fits = [True] * len(trail)
    parting = find_parting(story.map, story.walked, other.map, trail, fits)
    world = walk_in_world(story.world, story.transcript)
    scene, trails = walk_in_world(other, story.transcript), (story.walked, trail)
    agreement = parting.step if parting else len(trail)
    return figures_beside(world, scene, trails, agreement, name, OTHER.capitalize())


def _facts(finding: Finding, origin: str) -> Iterator[ET.Element]:
    about = wrong(finding)
    facts = [("law", f"{finding.law}: {about}" if about else finding.law)]
    if not about:
        facts += [("expected", expected_words(finding)), ("seen", seen_words(finding))]
    if finding.choices:
        facts.append(("choices", choices_words(finding)))
    if finding.world.told is not None:
        facts.append(("told", f"{finding.world.told}, before the start"))
    facts.append(("confirmed", remarks(finding)))
    if origin:
        facts.append(("origin", origin))
    for name, text in facts:
        yield tag("dt", name)
        yield tag("dd", tag("bdi", text))


def _again(finding: Finding, name: str) -> Iterator[ET.Element]:
    """How to run it again, and what was recorded."""
    yield tag("h3", "Run it again")
    yield _text(finding.reproduce, f"{name}-command")
    yield tag("p", _copier("Copy the command", f"{name}-command"))
    if finding.detail:
        yield tag("h3", "Traceback, or what it wrote to stderr")
        yield _text(finding.detail, f"{name}-detail")
    transcript = finding.transcript
    lines = [f"start: {transcript.first}"]
    lines += [f"{action}: {percept}" for action, percept in transcript.steps]
    summary = tag("summary", "The transcript, as it was recorded")
    yield tag("details", summary, _text("\n".join(lines), f"{name}-transcript"))
    copier = _copier("Copy the finding as JSON, for replay and explain", f"{name}-json")
    yield tag("p", copier)


def _text(text: str, name: str) -> ET.Element:
    return tag("pre", tag("bdi", text, id=name), tabindex="0")


def _copier(label: str, of: str) -> ET.Element:
    return tag("button", label, type="button", data_copy=of, hidden="hidden")
