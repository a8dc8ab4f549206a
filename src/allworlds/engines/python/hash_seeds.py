"""Explorers that go by hashes: how they are told from those that are not the same twice.

Python allows an explorer to go by the order of a set of strings, which ``PYTHONHASHSEED`` decides;
but then it must be right with every seed.  If each of two seeds gives its own play again and again,
whatever the addresses are, the seeds explain that two plays differ.

A job begins anew when its explorer turns out to go by hashes, so that the report does not depend on
the time at which that is noticed (:mod:`allworlds.engines.python.other_seeds`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol, TypeVar

from allworlds.document import replace
from allworlds.engines.python.comparison import difference_of
from allworlds.engines.python.play import Record
from allworlds.engines.python.scope import Scope
from allworlds.judging import Log

GOES_BY_HASHES = "the explorer goes by hashes: where PYTHONHASHSEED is another one, so is its walk"

LAYOUTS, RECORDS = 3, 8
"""The number of layouts on which each seed must give the same plays, and the largest number of
these plays."""

T = TypeVar("T")


class GoesByHashes(Exception):
    """Raised if an explorer goes by hashes; the job is then done with more than one seed."""


class SeededPlays(NamedTuple):
    """The plays of a record: with hash seed 0, and with another one."""

    record: Record
    first: Log
    second: Log


class SeededPlayers(Protocol):
    """The part of two players that is needed here."""

    def take_places(self, seed: int, turn: int, *, alike: bool) -> None:
        """Go on in fresh processes."""

    def send_records(self, records: Sequence[Record], policy: str) -> None:
        """Begin to play these once more."""

    def receive_logs(self) -> list[Log]:
        """Return the logs of the records that were sent, in their order."""


def seeds_explain(
    players: SeededPlayers, seed: int, plays: Sequence[SeededPlays], policy: str
) -> bool:
    """Whether seed 0 and this one give the same plays as before, on several layouts each."""
    some = plays[:RECORDS]
    records = [play.record for play in some]
    expected = {0: [play.first for play in some], seed: [play.second for play in some]}
    for layout in range(1, LAYOUTS + 1):
        for each, before in expected.items():
            players.take_places(each, layout, alike=True)
            players.send_records(records, policy)
            if any(map(difference_of, before, players.receive_logs())):
                return False
    return True


def with_more_seeds_if_needed(attempt: Callable[[Scope], T], scope: Scope) -> T:
    """The result for a scope; with other seeds, too, if the explorer goes by hashes."""
    try:
        return attempt(scope)
    except GoesByHashes:
        return attempt(replace(scope, more_seeds=True))
