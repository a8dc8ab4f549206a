"""The verb ``play``, with its conversation in the terminal."""

import re
import sys

import allworlds
from allworlds import Drop, Move, Percept, Pick, Write, document as doc
from allworlds.cli.output import OutputGroup, emit, printable
from allworlds.inputs.requests import answer
from allworlds.studies.play import PlayRequest


def play(request: PlayRequest, *, output: OutputGroup) -> int:
    """Example: allworlds play theta-torus -o play.html

    Be the robot, in a web page or here. Here each line is an action: a number leaves by that dart,
    counted clockwise from the one you came by; drop or pick moves a marker, write 3 writes the
    number 3; an empty line ends the walk and uncovers the world. In the end your cost stands beside
    that of Algorithm 1.
    """
    page = dict(output.named).get("html")
    asked = request if page else doc.replace(request, player=_asked)
    return emit(doc.replace(answer(allworlds.play, asked), path=page), output)


LEGAL = "a number, drop, pick, write K with a number K, or an empty line to end"


def _asked(percept: Percept, refused: str) -> Drop | Move | Pick | Write | None:
    """Read the next action from stdin; prompts go to stderr."""
    _say(f"that cannot be done: {refused}\n" if refused else f"you sense: {percept}\n")
    while True:
        _say("> ")
        line = sys.stdin.readline().strip()
        if re.fullmatch(r"-?[0-9]{1,9}", line):
            return Move(int(line) % percept.degree)
        if written := re.fullmatch(r"write +([0-9]{1,9})", line):
            return Write(int(written[1]))
        if line in ("", "drop", "pick"):
            return {"": None, "drop": Drop(), "pick": Pick()}[line]
        _say(f"{printable(line)[:40]!r} is not one of {LEGAL}\n")


def _say(text: str) -> None:
    print(text, end="", file=sys.stderr, flush=True)
