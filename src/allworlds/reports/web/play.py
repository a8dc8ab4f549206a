"""The page of ``play``, in which the reader is the robot, and the content of its report."""

from typing import Any
from xml.etree import ElementTree as ET

from allworlds.inputs.checks import InputError
from allworlds.judging.explanations.story import Walked
from allworlds.judging.laws.bounds import bound_named
from allworlds.judging.walk import Walk
from allworlds.reports import parts
from allworlds.reports.drawing.svg import record, tag
from allworlds.reports.web.sections import figure, framed, read, world_data
from allworlds.studies.run import Play
from allworlds.words import plural


def play_content(play: Play) -> parts.ReportContent:
    """The content for a game that was played in the terminal, or will be played on a page.

    After a game in the terminal, the content is the world, the reader's walk in the world, and the
    costs.  If the reader is to play on a page, the content says only in which file this page is,
    and tells nothing about the world.
    """
    if play.path is not None:
        headline = parts.Headline("PAGE", f"{play.path}, to be opened in a web browser")
        return parts.ReportContent(
            "allworlds play", "you", play, headline, [], page=lambda: game(play)
        )
    walk = Walk.of(play.world, play.transcript.actions)
    view = parts.View("world", "The world", parts.walk_in_world(walk), walk.darts)
    blocks: list[parts.Block] = [parts.ShownWalk("Your walk", Walked(walk), [view])]
    if play.transcript.steps:
        rows: list[list[parts.Cell]] = [["you", play.transcript.cost], *costs_data(play)["others"]]
        blocks += [parts.Table(["walked by", "traversals"], rows, "Costs in this world")]
    headline = parts.Headline("PLAYED", plural(play.transcript.cost, "traversal"))
    return parts.ReportContent(
        "allworlds play", "you", play, headline, [parts.Section("walk-1", "", blocks)]
    )


def game(play: Play) -> str:
    """The page of the game, which hides the world at first.

    Raises:
        InputError: for a lighthouse of the user's own under which the robot leaves marks.
    """
    world = play.world
    data = world_data(world)
    if data is None:
        raise InputError(
            f"under the lighthouse {world.lighthouse.written} the robot leaves marks in a way of "
            "your own, which a page cannot do; leave -o out to play in the terminal"
        )
    board = ET.fromstring(read("play.html"))  # noqa: S314  # our own file
    (container,) = board.iterfind(".//div[@id='world']")
    container.append(figure("The world", parts.scene_of(world), "played", "robot"))
    board.append(record({**data, "costs": costs_data(play)}, id="play-json"))
    lighthouse = f"{world.lighthouse.kind} lighthouse"
    said = "" if world.told is None else f" You are told: {world.told}."
    return framed(
        ("allworlds play", "you are the robot"),
        ("EXPLORE", f"Which world is this, and where in it are you? A {lighthouse}.{said}", "open"),
        [tag("noscript", tag("p", "This page needs JavaScript: it is played.")), board],
        play.to_json(),
        read("play.css"),
        "".join(map(read, ("world.js", "robot.js", "spots.js", "play.js"))),
    )


def costs_data(play: Play) -> dict[str, Any]:
    """The costs with which the page's script compares the reader's cost, as JSON data.

    The key ``others`` has a list of pairs, each a name and a cost: the pair of Algorithm 1, or no
    pair if Algorithm 1 was not run.  The key ``bound`` has the world's bound on the cost; None if
    there is no bound.
    """
    world = play.world
    bound = bound_named(world.lighthouse.as_kind.default_bound).of(world.map, world.start)
    others = [] if play.algorithm1 is None else [["Algorithm 1", play.algorithm1]]
    return {"others": others, "bound": bound}
