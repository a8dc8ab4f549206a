"""The text of ``explain``."""

from __future__ import annotations

from textwrap import wrap

from allworlds.explaining import Explanation
from allworlds.reports.picture import answer_picture, world_picture


def explain_text(explanation: Explanation, width: int) -> str:
    """The broken law, the story in sentences, and both maps where there was an answer."""
    lines = [f"{explanation.explorer} breaks the law '{explanation.law}'", ""]
    for sentence in explanation.sentences:
        lines += wrap(sentence, width, break_on_hyphens=False)
    lines += ["", "the world", "", world_picture(explanation.world, explanation.robot, width)]
    if explanation.answer:
        picture = answer_picture(explanation.answer.map, explanation.answer.here, width)
        lines += ["", "the answer (S, R: the robot)", "", picture]
    return "\n".join(lines)
