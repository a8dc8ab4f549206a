"""Options that several verbs share, and the texts that become values."""

from __future__ import annotations

import os
import re
import tempfile
from pathlib import Path
from typing import Annotated

import typer

from allworlds.corpora import own_corpus
from allworlds.errors import InputError, show
from allworlds.maps.build import named_map, named_maps
from allworlds.maps.families import family
from allworlds.subjects.subject import EXEC
from allworlds.world import Directional, World, lighthouse_named

SCOPE, RULES, EFFORT, OUTPUT = "What is checked", "How it is judged", "Effort", "Output"

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
        "--edges", metavar="M", help="At most M edges.", rich_help_panel=SCOPE, show_default=False
    ),
]
Vertices = Annotated[
    int | None,
    typer.Option(
        "--vertices",
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
    str,
    typer.Option(
        "--bound",
        metavar="BOUND",
        help="Largest number of traversals: paper (1)+(2), none, or an expression over n, m, d0, "
        "D with + - * // **, min, max (default: the lighthouse's own).",
        rich_help_panel=RULES,
        show_default=False,
    ),
]
LawNames = Annotated[
    str,
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
        metavar="S",
        help="Seconds of silence that break the law 'timeout'.",
        rich_help_panel=EFFORT,
    ),
]
TimeLimit = Annotated[
    float | None,
    typer.Option(metavar="S", help="Seconds for everything.", rich_help_panel=EFFORT),
]
Memory = Annotated[
    int | None,
    typer.Option(metavar="MB", help="Address space of each worker.", rich_help_panel=EFFORT),
]
CorpusDirectory = Annotated[
    Path | None,
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


def law_names(text: str) -> tuple[str, ...]:
    """The laws of a list with commas; none for the empty text."""
    names = tuple(part.strip() for part in text.split(",")) if text else ()
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"laws {show(text)} name {name!r} twice")
    return names


def worker_count(text: str) -> int:
    """A number of processes, or one a usable core for ``auto``."""
    if text == "auto":
        return len(os.sched_getaffinity(0))
    if re.fullmatch(r"[0-9]{1,9}", text) and int(text) > 0:
        return int(text)
    raise InputError(f"workers {show(text)} is neither auto nor a positive number")


def shard_numbers(text: str) -> tuple[int, int]:
    """``K/N``."""
    match = re.fullmatch(r"([0-9]{1,9})/([0-9]{1,9})", text)
    if match is None:
        raise InputError(f"shard {show(text)} is not of the form K/N, counted from 0")
    return int(match[1]), int(match[2])


def fraction(text: str) -> float:
    """``10%`` or ``0.1``."""
    match = re.fullmatch(r"([0-9]+(?:\.[0-9]+)?)(%?)", text)
    value = float(match[1]) / (100 if match[2] else 1) if match else -1.0
    if not 0 <= value < 1:
        raise InputError(f"holes {text!r} is no share of the edges; 0% up to 99% are legal")
    return value


def index_list(text: str) -> tuple[int, ...]:
    """Integers from 0 on with commas."""
    if not re.fullmatch(r"([0-9]{1,9}(,[0-9]{1,9})*)?", text):
        raise InputError(f"choices {show(text)} are not indices from 0 on with commas")
    return tuple(int(part) for part in text.split(",") if part)


def world_named(text: str, kind: str = Directional.kind) -> World:
    """The world of inline JSON, of ``@file``, of the corpus, or of a named map.

    Where no lighthouse is named it is of that kind, at its default place: at dart 0 of a
    named map.
    """
    lighthouse_named(kind)
    if text.startswith("@"):
        return World.from_json(read_text(text[1:]), missing=kind)
    if text.lstrip().startswith("{"):
        return World.from_json(text, missing=kind)
    try:
        map_ = named_map(text)
    except ValueError:
        return _world_of_corpus(text, kind)
    return World.from_json(map_.to_json(), missing=kind)


def _world_of_corpus(name: str, kind: str) -> World:
    corpus = own_corpus()
    for entry in corpus.of_kind("world"):
        if entry.name == name:
            return World.from_json(corpus.document(entry), missing=kind)
    raise InputError(
        f"world {show(name)} is neither JSON, nor @file, nor one of {', '.join(named_maps())}, "
        "nor a world of the corpus"
    )


def world_of_family(text: str, holes: str, seed: int) -> World:
    """The world of a family with its marker on dart 0."""
    return World(family(text, holes=fraction(holes), seed=seed), Directional(0))


def ensure_directory(path: Path | None) -> None:
    """Make the directory if it is missing; bad input if no file can be written there."""
    if path is None:
        return
    try:
        path.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=path):
            pass
    except OSError as error:
        reason = f"{show(str(path))} cannot be written: {error.strerror}"
        raise InputError(f"corpus {reason}") from None


def read_text(path: str) -> str:
    """The text of a file the user has named."""
    try:
        return Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is no text"
        raise InputError(f"file {path!r} cannot be read: {reason}") from None
