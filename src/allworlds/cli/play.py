"""The verb ``play``, with its conversation in the terminal."""

from __future__ import annotations

import re
import sys
from typing import Annotated

import allworlds
from allworlds import Drop, Move, Percept, Pick
from allworlds.cli.files import ensure_writable, write_text
from allworlds.cli.options import LighthouseOfWorld, OutputGroup, WorldText
from allworlds.cli.output import emit, printable
from allworlds.document import replace
from allworlds.inputs import OUTPUT, SCOPE, Option, integer_of
from allworlds.reports import game
from allworlds.world import HOLES


def play(
    world: WorldText,
    *,
    lighthouse: LighthouseOfWorld = "directional",
    seed: Annotated[
        int | None,
        Option(
            SCOPE,
            "S",
            "The seed of a WORLD of a family: random:8 with --seed 3 is one for a class-room.",
            parse=integer_of,
        ),
    ] = None,
    holes: Annotated[str | None, HOLES] = None,
    html: Annotated[
        str | None,
        Option(
            OUTPUT,
            "FILE",
            "Write a web page for playing, and do not play here.",
        ),
    ] = None,
    output: OutputGroup,
) -> int:
    """Example: allworlds play theta-torus --html play.html

    Be the robot, in a web page or here. Here each line is an action: a number leaves by that dart,
    counted clockwise from the one you came by; drop or pick moves a marker; an empty line ends the
    walk and uncovers the world. In the end your cost stands beside that of Algorithm 1.
    """
    if html is None:
        made = allworlds.play(world, lighthouse=lighthouse, seed=seed, holes=holes, player=_asked)
        return emit(made, "play", output)
    ensure_writable(html)
    made = allworlds.play(world, lighthouse=lighthouse, seed=seed, holes=holes)
    made = replace(made, path=html)
    write_text(html, game(made))
    return emit(made, "play", output)


LEGAL = "a number, drop, pick, or an empty line to end"


def _asked(percept: Percept, refused: str) -> Drop | Move | Pick | None:
    """Read the next action from stdin; prompts go to stderr."""
    _say(f"that cannot be done: {refused}\n" if refused else f"you sense: {percept}\n")
    while True:
        _say("> ")
        line = sys.stdin.readline().strip()
        if re.fullmatch(r"-?[0-9]{1,9}", line):
            return Move(int(line) % percept.degree)
        if line in ("", "drop", "pick"):
            return {"": None, "drop": Drop(), "pick": Pick()}[line]
        _say(f"{printable(line)[:40]!r} is not one of {LEGAL}\n")


def _say(text: str) -> None:
    print(text, end="", file=sys.stderr, flush=True)
