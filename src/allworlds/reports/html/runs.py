"""Pages of one run: as it went, as it went again, and what it means."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from xml.etree import ElementTree as ET

from allworlds.engines import SingleRun
from allworlds.judging import Answered, Explanation, Walked, believed_walk
from allworlds.maps import Dart
from allworlds.reports.drawing.layout import layout
from allworlds.reports.finding_words import headline
from allworlds.reports.html.beside import figures_beside
from allworlds.reports.html.findings import finding_section
from allworlds.reports.html.frame import Page
from allworlds.reports.html.known import known, known_figure
from allworlds.reports.html.viewer import figure, viewer
from allworlds.reports.html.walk import LONGEST, tell_tests, walk
from allworlds.reports.markup import tag
from allworlds.reports.scenes import walk_in_answer, walk_in_world
from allworlds.studies.replay import Replay
from allworlds.studies.run import Hypothesis, hypotheses_in
from allworlds.words import number, plural


def run_page(run: SingleRun) -> Page:
    """One run, to be stepped through."""
    summary = {key: told for key, told in run.to_json().items() if key != "finding"}
    return Page("allworlds run", run.explorer, _verdict(run), [*_run(run)], summary)


def replay_page(replay: Replay) -> Page:
    """The run of today, and the recorded finding if it is mended."""
    again, recorded = replay.again, replay.recorded
    sections = [*_run(again)]
    if again.finding is None:
        text = f"{again.explorer} now keeps every law in the recorded world"
        verdict = ("FIXED", text, "holds")
        sections.append(finding_section(recorded, 1, "the recorded finding"))
    else:
        verdict = ("REPRODUCED", f"law '{again.finding.law}' is broken again", "refuted")
    summary = {**replay.to_json(), "run": None}
    return Page("allworlds replay", again.explorer, verdict, sections, summary)


def explain_page(explanation: Explanation) -> Page:
    """The finding with its explanation."""
    finding = explanation.finding
    verdict = ("EXPLAINED", headline(finding), "refuted")
    section = finding_section(finding, 1)
    return Page(
        "allworlds explain", explanation.explorer, verdict, [section], explanation.to_json()
    )


def _verdict(run: SingleRun) -> tuple[str, str, str]:
    if run.finding:
        return "REFUTED", f"law {run.finding.law} is broken", run.verdict.value
    return "HOLDS", f"{cost_words(run)}; laws: {', '.join(run.rules.applying)}", run.verdict.value


def cost_words(run: SingleRun) -> str:
    """What the run cost, and what it may cost."""
    bound = "" if run.outcome.bound is None else f" of at most {number(run.outcome.bound)}"
    return f"{plural(run.outcome.cost, 'traversal')}{bound}"


def _run(run: SingleRun) -> Iterator[ET.Element]:
    if run.finding:
        yield finding_section(run.finding, 1)
    else:
        yield run_section(run, "walk-1", "The walk")


def run_section(run: SingleRun, name: str, title: str) -> ET.Element:
    """A run under its title, to be stepped through."""
    return tag(
        "section",
        tag("h2", tag("bdi", title), id=f"{name}-title"),
        *run_parts(run, name),
        class_="finding",
        id=name,
        aria_labelledby=f"{name}-title",
    )


def run_parts(run: SingleRun, name: str) -> Iterator[ET.Element]:
    """The pictures of a run, and its walk."""
    world, episode = run.world, run.outcome.episode
    transcript, ending = episode.transcript, episode.ending
    if world.told is not None:
        yield tag("p", f"Told before the start: {world.told}.")
    steps = len(transcript.steps)
    if steps >= LONGEST:
        yield tag("p", f"The first {number(LONGEST - 1)} of {number(steps)} steps are told.")
    walked, scene = Walked(world, transcript), walk_in_world(world, transcript)
    others: dict[str, Sequence[Dart]] = {}
    tests: Sequence[Hypothesis] = ()
    if (seen := known(run)) is not None:
        drawn, tests = layout(world.map, world.start), hypotheses_in(run)
        others["known"] = walked.walked
        figures = [
            figure("The world", scene, f"{name}-world", "robot", drawn),
            known_figure(scene, seen, f"{name}-known", drawn, tests),
        ]
    elif isinstance(ending, Answered):
        answer = walk_in_answer(world, ending.estimate, transcript)
        belief = believed_walk(world, ending.estimate, transcript)
        others["believed"] = belief.trail
        trails = (walked.walked, belief.trail)
        figures = figures_beside(scene, answer, trails, belief.agreement, name)
    else:
        figures = [figure("The world", scene, f"{name}-world", "robot")]
    steps_list = walk(walked, name, others=others)
    tell_tests(steps_list, tests, walked)
    yield viewer(figures, steps_list, f"The walk of {run.explorer}.")
