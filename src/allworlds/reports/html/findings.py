"""A finding on a page: its pictures, its walk, what it means, and how to run it again."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from xml.etree import ElementTree as ET

from allworlds.drawing import Scene, picture
from allworlds.explaining import Belief, Explanation, Story, explain
from allworlds.findings import Finding
from allworlds.markup import Child, record, tag
from allworlds.reports.cost_curve import cost_picture
from allworlds.reports.finding_words import (
    choices_words,
    expected_words,
    headline,
    remarks,
    seen_words,
    wrong,
)
from allworlds.reports.html.walk import walk
from allworlds.reports.scenes import OTHER, walk_in_answer, walk_in_world


def finding_section(finding: Finding, number: int, origin: str = "") -> ET.Element:
    """All that there is to see and to read of the finding, with the origin that it has, if any."""
    name = f"finding-{number}"
    story, explanation = Story(finding), explain(finding)
    belief = Belief(story) if explanation.answer else None
    return tag(
        "section",
        tag("h2", f"Finding {number}: ", tag("bdi", headline(finding)), id=f"{name}-title"),
        tag("p", *_sentences(explanation.sentences), class_="story"),
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
    figures = [figure("The world", walk_in_world(world, transcript), f"{name}-world", "robot")]
    if belief:
        scene = walk_in_answer(world, belief.answer, transcript)
        figures.append(figure("The answer", scene, f"{name}-answer", "believed"))
    if told.other:
        scene = walk_in_world(told.other, transcript)
        figures.append(figure(OTHER.capitalize(), scene, f"{name}-other", "believed"))
    title = f"The walk of finding {name.rpartition('-')[2]}."
    return viewer(figures, walk(story, belief, told, name), title)


def viewer(figures: Sequence[ET.Element], steps: ET.Element, title: str) -> ET.Element:
    """Pictures and a walk along which keys step in all of them."""
    keys = "Left and right arrow, Home and End step along the walk."
    return tag(
        "div",
        tag("div", *figures, class_="pictures"),
        tag(
            "div",
            *(
                tag("button", where.capitalize(), type="button", data_go=where)
                for where in ("first", "back", "next", "last")
            ),
            tag("p", "", class_="now", role="status"),
            class_="controls",
            hidden="hidden",
        ),
        tag("p", keys, class_="keys", hidden="hidden"),
        steps,
        class_="viewer",
        role="group",
        tabindex="0",
        aria_label=f"{title} {keys}",
    )


def figure(title: str, scene: Scene, name: str, follows: str) -> ET.Element:
    """A picture with its caption and its legend; the robot in it is that of ``follows``."""
    legend = [
        tag("span", "robot", class_="key robot-key"),
        tag("span", "walked", class_="key walked-key"),
        tag("span", "walked just now", class_="key last-key", hidden="hidden"),
    ]
    if scene.marks:
        legend.append(tag("span", "marked", class_="key marked-key"))
    if scene.pointed:
        legend.append(tag("span", "pointed along", class_="key pointed-key"))
    legend.append(tag("span", "dart faced at the start", class_="key start-key"))
    genus = scene.map.genus
    about = f"genus {genus}" + ("; edges that cross do not meet" if genus else "")
    return tag(
        "figure",
        tag("figcaption", tag("b", title), f", {about}"),
        tag("div", picture(scene, name, title), class_="frame", data_follows=follows),
        tag("p", *legend, class_="legend"),
    )


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
