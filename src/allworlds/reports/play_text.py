"""The text of ``play``."""

from __future__ import annotations

from allworlds.reports.drawing.text import draw
from allworlds.reports.run_text import walk_lines
from allworlds.reports.scenes import walk_in_world
from allworlds.reports.text_layout import entry
from allworlds.studies.play import Play
from allworlds.words import plural


def play_text(play: Play, width: int) -> str:
    """Where the page is, and not a word about the world; or the world and the walk in it."""
    if play.path is not None:
        return "\n".join(entry("PAGE", f"{play.path}, to be opened in a web browser", width))
    drawn = draw(walk_in_world(play.world, play.transcript), width)
    walk = walk_lines(play.world, play.transcript, None, width)
    cost = plural(play.transcript.cost, "traversal")
    return "\n".join(["the world", "", drawn, "", *walk, "", *entry("PLAYED", cost, width)])
