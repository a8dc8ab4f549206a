"""The texts of one run: the world drawn, the walk step by step, the broken law."""

from __future__ import annotations

from collections.abc import Mapping
from textwrap import wrap
from typing import Any

from allworlds.checker.belief import believed_percepts, true_trail
from allworlds.checker.finding import Finding
from allworlds.checker.replay import Replay
from allworlds.checker.single import SingleRun
from allworlds.episode import Answered
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import Move, Percept, Transcript
from allworlds.reports.layout import entry, plural, table
from allworlds.reports.picture import answer_picture, world_picture
from allworlds.world import World

LONGEST_WALK = 60
"""The steps of a longer walk are told from both ends."""


def finding_text(finding: Finding, width: int) -> str:
    """The smallest refuting world as one can read it."""
    return _refutation(finding, width, entry("confirmed", _remarks(finding), width))


def _refutation(finding: Finding, width: int, remarks: list[str]) -> str:
    world = finding.world
    map_, robot = world.map, true_trail(world, finding.transcript)[-1]
    seen = finding.seen if isinstance(finding.seen, Mapping) else None
    answer = None if seen is None else (CombinatorialMap.from_json(seen), int(seen["here"]))
    size = f"{plural(map_.edge_count, 'edge')}, {plural(map_.vertex_count, 'vertex', 'vertices')}"
    what = f"{finding.explorer} breaks the law '{finding.law}' in a world with {size}"
    lines = wrap(f"FINDING: {what}", width, break_long_words=False)
    lines += ["", "the world", "", world_picture(world, robot, width)]
    lines += ["", *_walk(world, finding.transcript, answer)]
    lines += ["", *_broken(finding, answer, width)]
    if finding.choices:
        lines += entry("choices", ", ".join(map(str, finding.choices)), width)
    lines += remarks
    lines += ["reproduce", f"  {finding.reproduce}"]
    if finding.detail:
        lines += ["", *("  " + line for line in finding.detail.splitlines())]
    return "\n".join(lines)


def run_text(run: SingleRun, width: int) -> str:
    """One run, told step by step."""
    if run.finding:
        return _refutation(run.finding, width, [])
    world, episode = run.world, run.outcome.episode
    ending = episode.ending
    assert isinstance(ending, Answered)
    transcript, estimate = episode.transcript, ending.estimate
    trail = true_trail(world, transcript)
    lines = ["the world", "", world_picture(world, trail[-1], width), ""]
    lines += _walk(world, transcript, (estimate.map, estimate.here))
    lines += ["", "the answer", ""]
    lines += [answer_picture(estimate.map, estimate.here, width), ""]
    bound = "" if run.outcome.bound is None else f" of at most {run.outcome.bound}"
    cost = plural(transcript.cost, "traversal")
    laws = ", ".join(run.rules.applying)
    lines += entry("HOLDS", f"{cost}{bound}; laws: {laws}", width)
    return "\n".join(lines)


def replay_text(replay: Replay, width: int) -> str:
    """Whether a finding still stands."""
    recorded, again = replay.recorded, replay.again.finding
    if again is None:
        text = f"{replay.again.explorer} now keeps every law in the recorded world"
        return "\n".join(entry("FIXED", text, width))
    law = f"law '{again.law}' is broken again"
    if again.law != recorded.law:
        law = f"law '{again.law}' is broken now, where '{recorded.law}' was recorded"
    return "\n".join([*entry("REPRODUCED", law, width), "", _refutation(again, width, [])])


def _walk(
    world: World, transcript: Transcript, answer: tuple[CombinatorialMap, Dart] | None
) -> list[str]:
    """The steps: where the robot came to, what it sensed, and what the answer makes expect."""
    trail = true_trail(world, transcript)
    seen = [transcript.first, *(percept for _, percept in transcript.steps)]
    believed = answer and believed_percepts(world, *answer, transcript)
    motions = ["start", *(_motion(action) for action, _ in transcript.steps)]
    header = ["step", "motion", "arrives at", "sensed", "", "expected by the answer"]
    rows = []
    for i, (dart, percept) in enumerate(zip(trail, seen, strict=True)):
        place = f"v{world.map.vertex_of[dart]} dart {dart}"
        rows.append([str(i), motions[i], place, str(percept), *_expected(i, percept, believed)])
    if len(rows) > LONGEST_WALK:
        half = LONGEST_WALK // 2
        between = f"({len(rows) - 2 * half} more)"
        rows = [*rows[:half], ["...", between, "", "", "", ""], *rows[-half:]]
    lines = table(header if believed else header[:4], [r if believed else r[:4] for r in rows], "r")
    if believed == seen and answer is not None and len(answer[0].sigma) != len(world.map.sigma):
        lines += ["", "The answer fits every percept: the walk ended before it could be known."]
    return ["the walk", "", *lines]


def _expected(i: int, percept: Percept, believed: list[Percept] | None) -> list[str]:
    if not believed:
        return ["", ""]
    return ["=" if believed[i] == percept else "≠", str(believed[i])]


def _motion(action: object) -> str:
    return f"move {action.k}" if type(action) is Move else type(action).__name__.lower()


def _broken(
    finding: Finding, answer: tuple[CombinatorialMap, Dart] | None, width: int
) -> list[str]:
    if answer is None:
        return [
            *entry("law", finding.law, width),
            *entry("expected", _value(finding.expected), width),
            *entry("seen", _value(finding.seen), width),
        ]
    what = {
        "map": "the answer is not the same map as the world",
        "pose": "the answer is the same map, but 'here' is not the robot's dart",
    }
    lines = entry("law", f"{finding.law}: {what.get(finding.law, '')}", width)
    return [*lines, "", "the answer (S, R: the robot)", "", answer_picture(*answer, width), ""]


def _value(value: Any) -> str:
    return f"at most {plural(value, 'traversal')}" if isinstance(value, int) else str(value)


def _remarks(finding: Finding) -> str:
    confirmed = (
        "yes: a fresh process did the same from the recorded percepts alone"
        if finding.confirmed
        else "no"
    )
    minimal = (
        "no smaller world of the scope refutes" if finding.minimal else "a smaller one may refute"
    )
    return f"{confirmed}; {minimal}"
