"""The page of ``play``, in which the reader is the robot, and the content of its report."""

from typing import Any
from xml.etree import ElementTree as ET

from allworlds.inputs.checks import InputError
from allworlds.judging.explanations.story import Walked
from allworlds.judging.laws.bounds import bound_named
from allworlds.protocol.actions import Pick
from allworlds.reports.drawing.svg import record, tag
from allworlds.reports.parts import (
    Block,
    Cell,
    Headline,
    Paragraph,
    ReportContent,
    Section,
    ShownWalk,
    Table,
    View,
    scene_of,
    walk_in_world,
)
from allworlds.reports.web.sections import figure, framed, read
from allworlds.studies.run import Play, Walker
from allworlds.words import plural
from allworlds.world.lighthouses import composed, kinds
from allworlds.world.world import World

NAMES = {
    Walker.ALGORITHM_1: "Algorithm 1",
    Walker.EVERY_EDGE: "a shortest walk along every edge, which knows the map",
}
"""Whose costs stand beside the player's, in words."""

LEAST = (
    "An explorer that does not know the number of edges, and is right in every world, goes along "
    "every edge, and so walks no less than that shortest walk."
)


def play_content(play: Play) -> ReportContent:
    """The path of the page, without a word about the world; or the world and the walk in it."""
    if play.path is not None:
        headline = Headline("PAGE", f"{play.path}, to be opened in a web browser")
        return ReportContent("allworlds play", "you", play, headline, [], page=lambda: game(play))
    walked = Walked(play.world, play.transcript)
    scene = walk_in_world(play.world, play.transcript)
    blocks: list[Block] = [
        ShownWalk("Your walk", walked, [View("world", "The world", scene, walked.walked)])
    ]
    if play.transcript.steps:
        rows: list[list[Cell]] = [["you", play.transcript.cost], *costs_data(play)["others"]]
        blocks += [Table(["walked by", "traversals"], rows, "Costs in this world")]
        blocks += [Paragraph(LEAST)]
    headline = Headline("PLAYED", plural(play.transcript.cost, "traversal"))
    return ReportContent("allworlds play", "you", play, headline, [Section("walk-1", "", blocks)])


def game(play: Play) -> str:
    """The page of the game, which hides the world at first."""
    world = play.world
    board = ET.fromstring(read("play.html"))  # noqa: S314  # our own file
    (place,) = board.iterfind(".//div[@id='world']")
    place.append(figure("The world", scene_of(world), "played", "robot"))
    board.append(record({**world_data(world), "costs": costs_data(play)}, id="play-json"))
    lighthouse = f"{world.lighthouse.kind} lighthouse"
    told = "" if world.told is None else f" You are told: {world.told}."
    return framed(
        ("allworlds play", "you are the robot"),
        ("EXPLORE", f"Which world is this, and where in it are you? A {lighthouse}.{told}", "open"),
        [tag("noscript", tag("p", "This page needs JavaScript: it is played.")), board],
        play.to_json(),
        read("play.css"),
        "".join(map(read, ("robot.js", "spots.js", "view.js"))),
    )


def world_data(world: World) -> dict[str, Any]:
    """Data of the world for the script, whatever the lighthouse; see ``robot.js``.

    Raises:
        InputError: for a lighthouse of the user's under which the robot leaves marks.
    """
    map_ = world.map
    marking = next((part for part in kinds.parts_of(world.lighthouse) if part.leaves_marks), None)
    if marking is not None and marking.code is not None:
        raise InputError(
            f"under the lighthouse {world.lighthouse.written} the robot leaves marks in a way of "
            "your own, which a page cannot do; leave -o out to play in the terminal"
        )
    written = marking if isinstance(marking, composed.Whiteboard) else None
    spots = None
    if written:
        spots = [written.place_of_number(map_, dart) for dart in map_.darts]
    elif isinstance(marking, composed.Movable) and marking.distinct:
        spots = list(map_.vertex_of)
    return {
        "sigma": list(map_.sigma),
        "alpha": list(map_.alpha),
        "vertex": list(map_.vertex_of),
        "percepts": [percept.to_json() for percept in world.percepts],
        "start": world.start,
        "labels": world.lighthouse.labels_vertices,
        "hand": world.lighthouse.in_hand,
        "pick": not world.lighthouse.refusal(Pick(), 1, 0),
        "states": written.states if written else 0,
        "spots": spots,
        "bound": bound_named(world.lighthouse.as_kind.default_bound).of(map_, world.start),
    }


def costs_data(play: Play) -> dict[str, Any]:
    """The costs of others for the script, and what is to be said of them."""
    return {"others": [[NAMES[one.who], one.cost] for one in play.costs], "said": LEAST}
