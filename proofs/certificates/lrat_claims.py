"""The part that several claims share: a file's formula is the one meant, and it is refuted."""

from __future__ import annotations

import re
from pathlib import Path

import lrat
from clauses import require_comments, require_same
from lrat import Refused
from twin_clauses import twin_clauses
from world_clauses import Asked, Size


def refuted(formula: Path, proof: Path, asked: Asked, sizes: tuple[Size, Size]) -> int:
    """The length of the proof that there are no two different worlds as asked for.

    The formula is written anew, from its statement; the file must have the same clauses.  From
    the file come only their order, to which the proof refers, and which other starts it
    excludes: its comments name them, and any may be named.

    Raises:
        Refused: if the file has another formula, or the proof is wrong; naming the file.
    """
    text = lrat.read(formula)
    try:
        variables, clauses = lrat.read_formula(text)
        wanted = twin_clauses(asked, sizes, _other_starts(text, sizes))
        require_same(wanted, variables, clauses)
        require_comments(wanted, text)
    except Refused as error:
        raise Refused(f"{formula.name}: {error}") from None
    try:
        return lrat.check(variables, clauses, lrat.read(proof).splitlines())
    except Refused as error:
        raise Refused(f"{proof.name}: {error}") from None


def _other_starts(text: str, sizes: tuple[Size, Size]) -> list[int]:
    named = re.findall(r"^c variables \d+\.\.\d+ carried(\d{1,6})\[", text, re.MULTILINE)
    starts = [int(dart) for dart in named]
    one, two = sizes
    if starts and (one.edges != two.edges or len(set(starts)) < len(starts)):
        raise Refused(f"other starts {starts} are excluded twice, or between worlds of two sizes")
    if any(start >= two.darts for start in starts):
        raise Refused(f"other starts {starts}, but the darts are 0 to {two.darts - 1}")
    return starts
