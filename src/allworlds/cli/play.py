"""The verb ``play``."""

from __future__ import annotations

import re
import sys
from typing import Annotated

import allworlds
from allworlds import Drop, Move, Percept, Pick
from allworlds.cli.files import ensure_all_writable, write_files
from allworlds.cli.options import LighthouseOfWorld, OutputGroup, WorldText
from allworlds.cli.output import emit, printable
from allworlds.document import replace
from allworlds.inputs import OUTPUT, Option


def play(
    world: WorldText,
    *,
    lighthouse: LighthouseOfWorld = "directional",
    html: Annotated[
        str | None,
        Option(
            OUTPUT,
            "FILE",
            "Write a web page in which it is played, and play nothing here.",
        ),
    ] = None,
    output: OutputGroup,
) -> int:
    """Example: allworlds play theta-torus --html play.html

    Be the robot: in a web page, or here, where every line is what to do: a number to leave by
    that dart, clockwise from the one you came by, drop or pick for a marker; an empty line
    ends the walk and uncovers the world.
    """
    files = {"html": html}
    ensure_all_writable(files)
    if html is None:
        return emit(allworlds.play(world, lighthouse=lighthouse, player=_asked), "play", output)
    made = replace(allworlds.play(world, lighthouse=lighthouse), path=html)
    write_files("play", made, files)
    return emit(made, "play", output)


LEGAL = "a number, drop, pick, or an empty line to end"


def _asked(percept: Percept, refused: str) -> Drop | Move | Pick | None:
    """What the next line of stdin says; the conversation goes to stderr."""
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
