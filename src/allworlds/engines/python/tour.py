"""The hash seeds and address layouts of one explorer's players, in turn.

Processes that are forked by one have most of its addresses and its hashes in common, so an explorer
that goes by ``id(x)``, or by the order of a set, would do the same in both plays.  The first player
has hash seed 0; the second has another one, in a process with other addresses, and changes to the
next in the course of a check.  Seeds are fixed, so that a repeated check has equal results;
addresses are drawn.

An explorer that is known to go by hashes is played twice with one seed, on other addresses.
"""

from __future__ import annotations

from msgspec import Struct

SEEDS = 8
"""The number of hash seeds: 0 and those below this number."""

BEGINNING, SPELL = 256, 128
"""The number of second plays before the first change, and before each of the next ones."""

VISITS = 3
"""In the long run a library has this number of new layouts for each process without compiled code
that it visits: such a visit takes the time of some thousand plays."""

BEHIND, APART = SEEDS, 1 << 22
"""The number of the process with compiled code that forks second players in the long run, and the
number of second plays from which on; it takes a second to start."""


class Tour(Struct):
    """The places of both players, as they change.

    A *place* is a hash seed, and the number of the process with that seed that forks the player.

    Attributes:
        seed: the hash seed of the first player; None if nobody has set it.
        alike: whether the second has the same; else it has the number of its layout.
        turn: the number of the second player's layout, from 1 on.
        stays: whether there are no more changes.
        at_home: whether the second player, in the long run, comes from a process with compiled
            code.
    """

    seed: int | None = 0
    alike: bool = False
    turn: int = 1
    stays: bool = False
    at_home: bool = False
    _played: int = 0
    _until: int = BEGINNING
    _changes: int = 0

    @property
    def places(self) -> tuple[tuple[int, int], tuple[int, int]]:
        """The places of the first and of the second player."""
        seed = self.seed or 0
        if self.is_home:
            second = 0, BEHIND * (self._played >= APART)
        else:
            second = (seed, self.turn) if self.alike else (self.turn, 0)
        return (seed, 0), second

    @property
    def is_home(self) -> bool:
        """Whether the second player comes from a process with compiled code now."""
        return self.at_home and self._all_met and not self._visits(self._changes)

    @property
    def hash_seed(self) -> int | None:
        """The seed of both, if they have one because it makes a difference; else None."""
        return self.seed if self.alike else None

    @property
    def differ(self) -> bool:
        """Whether the players have different seeds."""
        return not self.alike

    @property
    def complete(self) -> bool:
        """Whether every layout has had its turn, and neither is nor comes a visit to one."""
        later = self._changes + (self._played >= self._until)
        return self._all_met and not (
            self.at_home and (self._visits(self._changes) or self._visits(later))
        )

    @property
    def upcoming(self) -> tuple[int, int] | None:
        """The next place of the second player, if it is new, and a change is near."""
        soon = self._played + SPELL // 2 >= self._until
        if not soon or self._all_met:
            return None
        return (self.seed or 0, self._next) if self.alike else (self._next, 0)

    def hold(self, plays: int = SPELL) -> None:
        """Keep the places for so many plays."""
        self._until = max(self._until, self._played + plays)

    def count(self, plays: int) -> None:
        """Count second plays."""
        self._played += plays

    def change(self, plays: int = 0, *, may_visit: bool = True) -> bool:
        """Take the next layout if it is time for it; return whether it was.

        Args:
            plays: the number of the next ones; a visit does not begin with many.
            may_visit: whether they can be made without compiled code.
        """
        if self.stays or self._played < self._until:
            return False
        if self._visits(self._changes + 1):
            if may_visit and plays > 2 * SPELL:
                return False
            self._changes += not may_visit
        self._changes += 1
        if self._visits(self._changes):
            self._until = self._played + 1
        else:
            # Later ones get as many plays as half of all before, so that there are few changes.
            self._until = self._played + (self._played // 2 if self._all_met else SPELL)
        if not self.is_home:
            self.turn = self._next
        return True

    @property
    def _all_met(self) -> bool:
        return self.stays or self._changes >= SEEDS - 2 + self.at_home

    def _visits(self, changes: int) -> bool:
        """Whether a library visits a process without compiled code after so many changes."""
        late = changes - (SEEDS - 1)
        return self.at_home and late > 0 and late % (VISITS + 1) == 0

    @property
    def _next(self) -> int:
        return self.turn % (SEEDS - 1) + 1
