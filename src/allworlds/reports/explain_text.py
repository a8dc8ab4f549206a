"""The text of ``explain``."""

from __future__ import annotations

from textwrap import wrap

from allworlds.judging import Explanation
from allworlds.reports.cost_curve import cost_lines
from allworlds.reports.drawing.text import draw
from allworlds.reports.scenes import ANSWER, OTHER, walk_in_answer, walk_in_world


def explain_text(explanation: Explanation, width: int) -> str:
    """The broken law, the story in sentences, and both maps where there was an answer."""
    lines = [f"{explanation.explorer} breaks the law '{explanation.law}'", ""]
    for sentence in explanation.sentences:
        lines += wrap(sentence, width, break_on_hyphens=False)
    if explanation.spent:
        lines += ["", *cost_lines(explanation.spent, width)]
    world, transcript = explanation.world, explanation.finding.transcript
    lines += ["", "the world", "", draw(walk_in_world(world, transcript), width)]
    if explanation.answer:
        scene = walk_in_answer(world, explanation.answer, transcript)
        lines += ["", *wrap(ANSWER, width), "", draw(scene, width)]
    if explanation.other:
        scene = walk_in_world(explanation.other, transcript)
        lines += ["", *wrap(OTHER, width), "", draw(scene, width)]
    return "\n".join(lines)
