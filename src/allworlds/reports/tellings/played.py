"""Telling of ``play``: a page, or a walk."""

from __future__ import annotations

from allworlds.judging.explanations.story import Walked
from allworlds.reports.scenes import walk_in_world
from allworlds.reports.telling import (
    Block,
    Cell,
    Headline,
    Section,
    ToldResult,
    ToldTable,
    ToldWalk,
    View,
    Words,
)
from allworlds.studies.play import Play, Walker
from allworlds.words import plural

NAMES = {
    Walker.ALGORITHM_1: "Algorithm 1",
    Walker.EVERY_EDGE: "a shortest walk along every edge, which knows the map",
}
"""Whose costs stand beside the player's, in words."""

LEAST = (
    "An explorer that does not know the number of edges, and is right in every world, goes along "
    "every edge, and so walks no less than that shortest walk."
)


def play_telling(play: Play) -> ToldResult:
    """The path of the page, without a word about the world; or the world and the walk in it."""
    if play.path is not None:
        from allworlds.reports.play.page import game

        headline = Headline("PAGE", f"{play.path}, to be opened in a web browser")
        return ToldResult("allworlds play", "you", play, headline, [], page=lambda: game(play))
    walked = Walked(play.world, play.transcript)
    scene = walk_in_world(play.world, play.transcript)
    blocks: list[Block] = [
        ToldWalk("Your walk", walked, [View("world", "The world", scene, walked.walked)])
    ]
    if play.transcript.steps:
        rows: list[list[Cell]] = [["you", play.transcript.cost]]
        rows += [[NAMES[one.who], one.cost] for one in play.costs]
        blocks += [ToldTable(["walked by", "traversals"], rows, "Costs in this world")]
        blocks += [Words(f"{LEAST} {play.not_compared}".rstrip())]
    headline = Headline("PLAYED", plural(play.transcript.cost, "traversal"))
    return ToldResult("allworlds play", "you", play, headline, [Section("walk-1", "", blocks)])
