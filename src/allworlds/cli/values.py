"""The texts of the command line that become values."""

from __future__ import annotations

import os
import re

import typer

from allworlds.inputs import InputError, show


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


def motion_list(text: str | None) -> tuple[int, ...]:
    """Motions with commas, negative ones too; none where there is no text."""
    if text is None:
        return ()
    if not re.fullmatch(r"-?[0-9]{1,3}(,-?[0-9]{1,3})*", text):
        raise InputError(f"motions {show(text)} are not integers of up to 3 digits with commas")
    return tuple(int(part) for part in text.split(","))
