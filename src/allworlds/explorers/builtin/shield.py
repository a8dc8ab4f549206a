"""The shield: any explorer, made right in every world under the directional lighthouse.

Two *guests*, the explorer and Algorithm 1, take turns with budgets 1, 2, 4, ...: in its turn a
guest goes on until it has made that many traversals in all.  All percepts go into one
folded log (:mod:`allworlds.explorers.builtin.folding`); as soon as no dart of it is open the
folded map is the answer, and the guests' answers are never used.

A guest walks in the log as far as that is known, which costs nothing: its percepts are read from
there.  Only where it goes through an open dart the robot follows, by a shortest way in the log.

Cost: less than 9 min(X, (1) + (2)) traversals, where X is what the explorer walks until its own
log has no open dart.  For in each turn the robot could walk back to v0 the way that the last guest
came, and then the way of the next: 2 (1 + 2 + ... + 2^(k-1)) before the turn with the budget 2^k,
and a guest that needs that turn has walked more than 2^(k-2).
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Generator, Sequence
from itertools import count
from typing import Any

from allworlds.explorers.builtin.algorithm1 import Walk, algorithm1
from allworlds.explorers.builtin.folding import (
    OPEN,
    FoldedLog,
    begun,
    estimate,
    has_open_dart,
    way,
)
from allworlds.inputs.checks import integer, let_users_interrupt, show
from allworlds.protocol.actions import Move, Percept
from allworlds.protocol.answers import Checkpoint, Estimate
from allworlds.protocol.faults import ExplorerFault

MOST_CHECKPOINTS = 1000
"""The largest number of checkpoints between two motions: an explorer with more is out."""


class Shield:
    """An explorer with a shield: a generator function that takes what the explorer takes.

    Attributes:
        explorer: the generator function inside.
    """

    def __init__(self, explorer: Callable[..., Generator[Any, Any, Any]]) -> None:
        self.explorer = explorer
        self.__signature__ = inspect.signature(explorer)

    def __call__(self, first: Percept, **keywords: Any) -> Walk[Estimate]:
        """Explore from a directional lighthouse; return the true map for every explorer inside."""
        log, here = begun(first)
        stranger = _Stranger(log, here, lambda seen: self.explorer(seen, **keywords))
        try:
            here = yield from _take_turns(log, here, (stranger, _Guest(log, here, algorithm1)))
        finally:
            stranger.dismiss()
        return estimate(log, here)


class _Guest:
    """An explorer in the shield, which walks in the folded log.

    Attributes:
        here: the dart of the log by which it has come; at the start the one that it faces.
        steps: its traversals.
        out: whether it makes no more motions.
    """

    def __init__(
        self, log: FoldedLog, here: int, explorer: Callable[[Percept], Generator[Any, Any, Any]]
    ) -> None:
        self.here, self.steps, self.out = here, 0, False
        self._log, self._explorer = log, explorer
        self._walk: Generator[Any, Any, Any] | None = None

    def next_dart(self) -> int | None:
        """The dart by which it leaves; None once it is out."""
        reply = None if self._walk is None else self._percept()
        self._walk = self._walk or self._explorer(self._percept())
        message = self._walk.send(reply)
        published = 0
        while type(message) is Checkpoint:
            published += 1
            if published > MOST_CHECKPOINTS:
                raise ValueError(f"{published} checkpoints between two motions")
            message = self._walk.send(None)
        if type(message) is not Move:
            raise ValueError(f"{show(message)} is no motion")
        return self._log.turn(self._log.canonical(self.here), integer(message.k))

    def _percept(self) -> Percept:
        """The percept of the guest there, read from the log."""
        log = self._log
        dart = log.canonical(self.here)
        degree = log.degree[log.node[dart]]
        at_v0 = log.node[dart] == 0
        return Percept(degree, 1, -dart % degree) if at_v0 else Percept(degree)


class _Stranger(_Guest):
    """A guest that may end, raise or yield illegal values: then it is out."""

    def next_dart(self) -> int | None:
        try:
            return super().next_dart()
        except ExplorerFault as fault:
            if fault.machine:
                raise
        except MemoryError:
            raise
        except BaseException as error:  # noqa: BLE001  # an explorer may raise anything
            let_users_interrupt(error)
        self.out = True
        return None

    def dismiss(self) -> None:
        """Close the guest's generator, and ignore every exception that it raises then."""
        try:
            if self._walk is not None:
                self._walk.close()
        except BaseException as error:  # noqa: BLE001  # the map is known all the same
            let_users_interrupt(error)


def _take_turns(log: FoldedLog, here: int, guests: Sequence[_Guest]) -> Walk[int]:
    """Let the guests go on in turn until no dart is open; return the robot's dart of arrival."""
    for turn in count():
        guest = guests[turn % len(guests)]
        while not guest.out and (guest.steps < 2**turn or any(other.out for other in guests)):
            dart = guest.next_dart()
            if dart is None:
                break
            if log.beyond(dart) == OPEN:
                for leaving in way(log, here, dart.__eq__):
                    seen = yield Move((leaving - here) % log.degree[log.node[here]])
                    here = log.arrive(leaving, seen)
                if not has_open_dart(log):
                    return here
            guest.here = log.beyond(log.canonical(dart))
            guest.steps += 1
    raise AssertionError("turns have no end")
