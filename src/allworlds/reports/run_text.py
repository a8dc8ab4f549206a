"""The texts of one run: the world drawn, the walk step by step, the broken law."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import wrap

from allworlds.engines import SingleRun
from allworlds.judging import Answered, Fault, Finding, Undecided, believed_walk, true_trail
from allworlds.protocol import Ambiguous, Estimate, Percept, Transcript
from allworlds.reports.drawing.text import draw
from allworlds.reports.finding_words import (
    choices_words,
    expected_words,
    headline,
    remarks,
    seen_words,
    wrong,
)
from allworlds.reports.scenes import ANSWER, walk_in_answer, walk_in_world
from allworlds.reports.text_layout import GAP, entry, table
from allworlds.studies.replay import Replay
from allworlds.words import plural
from allworlds.world import World

LONGEST_WALK = 60
"""The steps of a longer walk are told from both ends."""


def finding_text(finding: Finding, width: int, origin: str = "") -> str:
    """The smallest refuting world as one can read it, with the origin that it has, if any."""
    told = entry("confirmed", remarks(finding), width)
    return _refutation(finding, width, told + (entry("origin", origin, width) if origin else []))


def _refutation(finding: Finding, width: int, remarks: list[str]) -> str:
    world = finding.world
    answer = finding.seen if isinstance(finding.seen, Estimate) else None
    lines = wrap(f"FINDING: {headline(finding)}", width, break_long_words=False)
    lines += ["", "the world", "", draw(walk_in_world(world, finding.transcript), width)]
    lines += ["", *walk_lines(world, finding.transcript, answer, width)]
    lines += ["", *_broken(finding, answer, width)]
    if finding.choices:
        lines += entry("choices", choices_words(finding), width)
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
    transcript = episode.transcript
    lines = ["the world", "", draw(walk_in_world(world, transcript), width), ""]
    match ending:
        case Answered(estimate):
            lines += walk_lines(world, transcript, estimate, width)
            lines += [
                "",
                *wrap(ANSWER, width),
                "",
                draw(walk_in_answer(world, estimate, transcript), width),
                "",
            ]
        case Undecided(quotient):
            lines += [
                *walk_lines(world, transcript, None, width),
                "",
                *_quotient(quotient, width),
                "",
            ]
        case Fault():
            raise AssertionError(ending)
    lines += entry("HOLDS", f"{_cost(run)}; laws: {', '.join(run.rules.applying)}", width)
    return "\n".join(lines)


def run_line(run: SingleRun, _width: int) -> str:
    """The verdict of one run in one line, however wide it is."""
    if run.finding:
        return f"REFUTED: law {run.finding.law} is broken"
    return f"HOLDS: {_cost(run)}: no law is broken"


def _cost(run: SingleRun) -> str:
    bound = "" if run.outcome.bound is None else f" of at most {run.outcome.bound}"
    return plural(run.outcome.cost, "traversal") + bound


def _quotient(answer: Ambiguous, width: int) -> list[str]:
    """An answer that names no map: what is the same in all worlds that look so."""
    header = ["dart", "sigma", "alpha", "degree", "marks", ""]
    rows = [
        [*map(str, row), "here" if row[0] == answer.here else ""]
        for row in zip(
            *(range(len(answer.sigma)), answer.sigma, answer.alpha, answer.degree, answer.marks),
            strict=True,
        )
    ]
    said = "the answer: several worlds look alike, and this is their quotient"
    return [said, "", *table(header, rows, "rrrrr", width)]


def replay_text(replay: Replay, width: int) -> str:
    """Whether a finding still stands."""
    lines = entry(*_replayed(replay), width)
    if replay.again.finding:
        lines += ["", _refutation(replay.again.finding, width, [])]
    return "\n".join(lines)


def replay_line(replay: Replay, _width: int) -> str:
    """The same in one line, however wide it is."""
    return ": ".join(_replayed(replay))


def _replayed(replay: Replay) -> tuple[str, str]:
    recorded, again = replay.recorded, replay.again.finding
    if again is None:
        return "FIXED", f"{replay.again.explorer} now keeps every law in the recorded world"
    if again.law != recorded.law:
        law = f"law '{again.law}' is broken now, where '{recorded.law}' was recorded"
        return "REPRODUCED", law
    return "REPRODUCED", f"law '{again.law}' is broken again"


def walk_lines(
    world: World, transcript: Transcript, answer: Estimate | None, width: int
) -> list[str]:
    """The steps: where the robot came to, what it sensed, and what the answer makes expect."""
    believed = None
    if answer is not None:
        believed = believed_walk(world, answer, transcript).percepts
    rows = _steps(world, transcript, believed)
    if len(rows) > LONGEST_WALK:
        half = LONGEST_WALK // 2
        between = f"({len(rows) - 2 * half} more)"
        rows = [*rows[:half], ["...", between, "", "", "", ""], *rows[-half:]]
    lines = _walk_table(rows, width) if believed else _walk_table([r[:4] for r in rows], width)
    fits = believed == transcript.percepts
    if fits and answer is not None and len(answer.map.sigma) != len(world.map.sigma):
        said = "The answer fits every percept: the walk ended before it could be known."
        lines += ["", *wrap(said, width)]
    before = [] if world.told is None else [f"told before the start: {world.told}", ""]
    return ["the walk", "", *before, *lines]


def _steps(
    world: World, transcript: Transcript, believed: Sequence[Percept] | None
) -> list[list[str]]:
    """The cells of each step; the last two are empty where nothing is believed."""
    motions = ["start", *(str(action) for action in transcript.actions)]
    walk = zip(true_trail(world, transcript), transcript.percepts, strict=True)
    return [
        [
            *(str(i), motions[i], f"v{world.map.vertex_of[dart]} dart {dart}", str(percept)),
            *_expected(i, percept, believed),
        ]
        for i, (dart, percept) in enumerate(walk)
    ]


_STEP = ("step", "motion", "arrives at", "sensed", "", "expected by the answer")


def _walk_table(rows: Sequence[Sequence[str]], width: int) -> list[str]:
    """The steps as a table; where that is too wide what is sensed stands below each motion.

    What the answer makes expect is then told only where it is not what is sensed.
    """
    lines = table(_STEP[: len(rows[0])], rows, "r")
    if max(map(len, lines)) <= width:
        return lines
    below = " " * (len(_STEP[0]) + GAP)
    lines = [(" " * GAP).join(_STEP[:3]), f"{below}sensed"]
    if len(rows[0]) > 4:
        lines.append(f"{below}≠ what the answer makes expect")
    for step, motion, place, sensed, *belief in rows:
        lines.append(f"{step:>{len(_STEP[0])}}  {motion:6}  {place}".rstrip())
        told = [sensed, f"≠ {belief[1]}" if belief and belief[0] == "≠" else ""]
        lines += [below + line for text in told for line in wrap(text, width - len(below))]
    return lines


def _expected(i: int, percept: Percept, believed: Sequence[Percept] | None) -> list[str]:
    if not believed:
        return ["", ""]
    return ["=" if believed[i] == percept else "≠", str(believed[i])]


def _broken(finding: Finding, answer: Estimate | None, width: int) -> list[str]:
    if answer is None:
        return [
            *entry("law", finding.law, width),
            *entry("expected", expected_words(finding), width),
            *entry("seen", seen_words(finding), width),
        ]
    lines = entry("law", f"{finding.law}: {wrong(finding)}", width)
    scene = walk_in_answer(finding.world, answer, finding.transcript)
    return [*lines, "", *wrap(ANSWER, width), "", draw(scene, width), ""]
