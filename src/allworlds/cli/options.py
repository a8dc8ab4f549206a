"""Options that several verbs share, and the texts that become values."""

from __future__ import annotations

import os
import re
import tempfile
from typing import Annotated

import typer

from allworlds.inputs import InputError, a_path, show
from allworlds.subjects import EXEC, names_explorer

SCOPE, RULES, EFFORT, OUTPUT = "What is checked", "How it is judged", "Effort", "Output"


def integer(text: str | int) -> int:
    """The integer of a text, or a default; unlike ``int`` without 1_0 and other scripts."""
    if isinstance(text, int) or re.fullmatch(r"[+-]?[0-9]{1,4000}", text):
        return int(text)
    raise typer.BadParameter(f"{show(text)} is not an integer")


def seconds(text: str | float) -> float:
    """The number of a text, or a default."""
    if isinstance(text, float) or re.fullmatch(
        r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?|-?inf|nan", text
    ):
        return float(text)
    raise typer.BadParameter(f"{show(text)} is not a number of seconds")


Explorer = Annotated[
    str | None,
    typer.Argument(
        metavar="[EXPLORER]",
        help="A built-in name, module:attribute, path/to/file.py:attribute or an entry point "
        "(default: algorithm1).",
        show_default=False,
    ),
]
Exec = Annotated[
    str | None,
    typer.Option(
        "--exec",
        metavar="COMMAND",
        help="In place of EXPLORER: a program that speaks JSON lines.",
        rich_help_panel=SCOPE,
    ),
]
Edges = Annotated[
    int | None,
    typer.Option(
        "--edges",
        parser=integer,
        metavar="M",
        help="At most M edges.",
        rich_help_panel=SCOPE,
        show_default=False,
    ),
]
Vertices = Annotated[
    int | None,
    typer.Option(
        "--vertices",
        parser=integer,
        metavar="N",
        help="At most N vertices (alone: simple classes only).",
        rich_help_panel=SCOPE,
    ),
]
MapClassName = Annotated[
    str,
    typer.Option(
        "--class",
        metavar="CLASS",
        help="maps, simple, planar or planar-simple.",
        rich_help_panel=SCOPE,
    ),
]
LighthouseName = Annotated[
    str | None,
    typer.Option(
        "--lighthouse",
        metavar="KIND",
        help="KIND[:key=value,...] (default: directional, or the one that a built-in explorer is "
        "written for).",
        rich_help_panel=SCOPE,
        show_default=False,
    ),
]
PolicyName = Annotated[
    str,
    typer.Option(
        "--policy",
        metavar="POLICY",
        help="Who answers the explorer's choices: fifo, lifo, nearest or random:SEED.",
        rich_help_panel=RULES,
    ),
]
BoundName = Annotated[
    str | None,
    typer.Option(
        "--bound",
        metavar="BOUND",
        help="Largest number of traversals: paper (1)+(2), two-vertices, none, or an expression "
        "over n, m, d0, D with + - * // **, min, max (default: the explorer's own, else the "
        "lighthouse's).",
        rich_help_panel=RULES,
        show_default=False,
    ),
]
LawNames = Annotated[
    str | None,
    typer.Option(
        "--laws",
        metavar="LAWS",
        help="Of map, pose, invariant-1, invariant-2, variant, folding, bound, with commas "
        "(default: all that apply).",
        rich_help_panel=RULES,
        show_default=False,
    ),
]
StepBudget = Annotated[
    int | None,
    typer.Option(
        "--step-budget",
        parser=integer,
        metavar="B",
        help="More traversals break the law 'budget' (default: 8 x ((1)+(2)) + 100).",
        rich_help_panel=RULES,
        show_default=False,
    ),
]
AnswerTimeout = Annotated[
    float,
    typer.Option(
        "--answer-timeout",
        parser=seconds,
        metavar="S",
        help="Seconds of silence that break the law 'timeout'.",
        rich_help_panel=EFFORT,
    ),
]
TimeLimit = Annotated[
    float | None,
    typer.Option(
        parser=seconds, metavar="S", help="Seconds for everything.", rich_help_panel=EFFORT
    ),
]
Memory = Annotated[
    int | None,
    typer.Option(
        parser=integer,
        metavar="MB",
        help="Address space of each worker process; the kernel engine has none.",
        rich_help_panel=EFFORT,
    ),
]
CorpusDirectory = Annotated[
    str | None,
    typer.Option(
        "--corpus",
        metavar="DIR",
        help="A directory of findings: tried first, and new ones are written to it.",
        rich_help_panel=EFFORT,
        show_default=False,
    ),
]
Json = Annotated[
    bool,
    typer.Option("--json", help="One JSON document on stdout.", rich_help_panel=OUTPUT),
]
Quiet = Annotated[
    bool,
    typer.Option("-q", "--quiet", help="No progress.", rich_help_panel=OUTPUT),
]


def explorer_name(explorer: str | None, command: str | None) -> str:
    """The name of the subject; ``algorithm1`` where none is given."""
    if command is None:
        return "algorithm1" if explorer is None else explorer
    if explorer is not None:
        raise InputError(f"give EXPLORER {explorer!r} or --exec {command!r}, not both")
    return EXEC + command


def law_names(text: str | None) -> tuple[str, ...] | None:
    """The laws of a list with commas."""
    return None if text is None else tuple(part.strip() for part in text.split(","))


def worker_count(text: str) -> int:
    """A number of processes, or one a usable core for ``auto``."""
    if text == "auto":
        return len(os.sched_getaffinity(0))
    if re.fullmatch(r"[0-9]{1,9}", text) and int(text) > 0:
        return int(text)
    raise InputError(f"workers {show(text)} is neither auto nor a positive number")


SHARD_DIGITS = 9


def shard_numbers(text: str) -> tuple[int, int]:
    """``K/N``."""
    match = re.fullmatch(r"([0-9]+)/([0-9]+)", text)
    if match is None:
        raise InputError(f"shard {show(text)} is not of the form K/N, counted from 0")
    if max(map(len, match.groups())) > SHARD_DIGITS:
        raise InputError(f"shard {show(text)} is too big; N is at most {10**SHARD_DIGITS - 1}")
    return int(match[1]), int(match[2])


def index_list(text: str | None) -> tuple[int, ...]:
    """Integers from 0 on with commas; none where there is no text."""
    if text is None:
        return ()
    if not re.fullmatch(r"[0-9]{1,9}(,[0-9]{1,9})*", text):
        raise InputError(f"choices {show(text)} are not indices from 0 on with commas")
    return tuple(int(part) for part in text.split(","))


def explorer_and_world(words: list[str], *, family: bool, program: bool) -> tuple[str | None, str]:
    """The EXPLORER and the WORLD among the arguments of ``run``, where they are given.

    With a family there is no WORLD: it is the empty text.
    """
    wanted = 0 if family else 1
    if not wanted <= len(words) <= wanted + (not program):
        given = " ".join(words) or "nothing"
        raise InputError(f"run takes [EXPLORER] and a WORLD or --family, not {show(given)}")
    explorer = words[0] if len(words) > wanted else None
    world = "" if family else words[-1]
    if names_explorer(world):
        if explorer is None:
            raise InputError(f"WORLD is missing: {show(world)} is an explorer; {_WORLDS}")
        if not names_explorer(explorer):
            raise InputError(
                f"{show(world)} is an explorer and stands in the place of WORLD; EXPLORER comes "
                "first, then WORLD"
            )
    return explorer, world


_WORLDS = "a WORLD is inline JSON, @file, or a name such as k4, wheel-4, theta-torus"


def ensure_directory(name: str | None) -> None:
    """Make the directory if it is missing; bad input if no file can be written there."""
    if name is None:
        return
    path = a_path("corpus", name)
    try:
        path.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=path):
            pass
    except OSError as error:
        reason = f"{show(name)} cannot be written: {error.strerror}"
        raise InputError(f"corpus {reason}") from None
