"""Shards: a job cut into parts of about equal weight, each for a machine of its own."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from heapq import heapify, heapreplace
from typing import Annotated, TypeAlias

from msgspec import Struct

from allworlds.inputs import SCOPE, InputError, Option, Request, Taken, an_integer, show


class Whole(Struct, frozen=True):
    """Every world of the extent."""

    def __str__(self) -> str:
        return "0/1"


class Shard(Struct, frozen=True):
    """The part of number ``index`` when every level is dealt out to ``count`` parts.

    Raises:
        InputError: naming what is out of range.
    """

    index: int
    count: int

    def __post_init__(self) -> None:
        for name, number in (("K", self.index), ("N", self.count)):
            an_integer(f"shard {name}", number)
        if self.count < 1 or not 0 <= self.index < self.count:
            raise InputError(f"shard {self} is out of range; K/N needs 0 <= K < N, counted from 0")

    def __str__(self) -> str:
        return f"{self.index}/{self.count}"


WHOLE = Whole()

Portion: TypeAlias = Whole | Shard
"""The part of the units of a job that is done."""

UNMERGEABLE = "without --run DIR the report of this shard cannot be merged with others"
"""The notice to the user of a shard that cannot be merged."""


def shards_of(portion: object) -> int:
    """The number of parts of the job to which this part belongs."""
    return portion.count if isinstance(portion, Shard) else 1


SHARD_DIGITS = 9


def shard_numbers(text: str) -> tuple[int, int]:
    """The two numbers of ``K/N``."""
    match = re.fullmatch(r"([0-9]+)/([0-9]+)", text)
    if match is None:
        raise InputError(f"shard {show(text)} is not of the form K/N, counted from 0")
    if max(map(len, match.groups())) > SHARD_DIGITS:
        raise InputError(f"shard {show(text)} is too big; N is at most {10**SHARD_DIGITS - 1}")
    return int(match[1]), int(match[2])


def a_shard(pair: object) -> Portion:
    """The shard of ``(K, N)``; of one shard, and of None, the whole.

    Raises:
        InputError: for anything else.
    """
    if isinstance(pair, Whole | Shard):
        return pair
    if pair is None:
        return Whole()
    if not isinstance(pair, tuple | list) or len(pair) != 2:
        raise InputError(f"shard = {show(pair)} is not a pair (K, N)")
    shard = Shard(an_integer("shard K", pair[0]), an_integer("shard N", pair[1]))
    return Whole() if shard.count == 1 else shard


class AskedShard(Request):
    """The part of a request that names the shard."""

    shard: Annotated[
        Taken[tuple[int, int] | Portion | None, Portion],
        Option(
            SCOPE,
            "K/N",
            "Only the K-th of N parts of about equal weight, from 0.",
            parse=shard_numbers,
            default="0/1",
            apart=True,
        ),
    ] = Taken(a_shard, None)


def dealt(weights: Sequence[int], shard: Shard) -> Iterator[int]:
    """The numbers of the units that fall to a shard, ascending.

    The heaviest unit that is left goes to the lightest shard; among equals the first to the first.
    """
    heaviest = sorted(range(len(weights)), key=lambda i: (-weights[i], i))
    loads = [(0, index) for index in range(min(shard.count, len(weights)))]
    heapify(loads)
    mine = []
    for i in heaviest:
        load, index = loads[0]
        if index == shard.index:
            mine.append(i)
        heapreplace(loads, (load + weights[i], index))
    yield from sorted(mine)
