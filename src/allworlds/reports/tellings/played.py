"""Telling of ``play``: a page, or a walk."""

from __future__ import annotations

from allworlds.judging import Walked
from allworlds.reports.play.costs import costs_beside, in_words
from allworlds.reports.scenes import walk_in_world
from allworlds.reports.telling import Headline, Section, ToldResult, ToldWalk, View, Words
from allworlds.studies.play import Play
from allworlds.words import plural


def play_telling(play: Play) -> ToldResult:
    """The path of the page, without a word about the world; or the world and the walk in it."""
    if play.path is not None:
        headline = Headline("PAGE", f"{play.path}, to be opened in a web browser")
        return ToldResult("allworlds play", "you", play, headline, [])
    walked = Walked(play.world, play.transcript)
    scene = walk_in_world(play.world, play.transcript)
    walk = ToldWalk("Your walk", walked, [View("world", "The world", scene, walked.walked)])
    beside = in_words(costs_beside(play.world)) if play.transcript.steps else ""
    said = [Words(beside)] if beside else []
    headline = Headline("PLAYED", plural(play.transcript.cost, "traversal"))
    return ToldResult(
        "allworlds play", "you", play, headline, [Section("walk-1", "", [walk, *said])]
    )
