"""The hash seeds and address layouts of one explorer's players, in turn.

Processes that are forked by one have its addresses and hashes in common, so an explorer that goes
by ``id(x)``, or by the order of a set, would do the same in both plays.  The first player has hash
seed 0; the second has another one, in a process with other addresses, and changes to the next in
the course of a check.  Seeds are fixed, so that a repeated check has equal results; addresses are
drawn by the system.

Where plays differ by the seed alone, both players have one seed from then on, and other addresses.
"""

from __future__ import annotations

from dataclasses import dataclass

SEEDS = 8
"""The number of hash seeds: 0 and those below this number."""

BEGINNING, SPELL = 256, 128
"""The number of second plays before the first change, and before each of the next ones."""


@dataclass(slots=True)
class Tour:
    """The hash seeds of both players, as they change.

    Attributes:
        seed: of the second player.
        alike: whether the first has the same; else it has 0.
        stays: whether there are no more changes.
    """

    seed: int = 1
    alike: bool = False
    stays: bool = False
    _played: int = 0
    _until: int = BEGINNING
    _changes: int = 0

    @property
    def seeds(self) -> tuple[int, int]:
        """The hash seeds of the first and of the second player."""
        return (self.seed if self.alike else 0, self.seed)

    @property
    def hash_seed(self) -> int | None:
        """The seed of both, if they have one because it makes a difference; else None."""
        return self.seed if self.alike else None

    @property
    def differ(self) -> bool:
        """Whether the players have different seeds."""
        return not self.alike and self.seed != 0

    @property
    def complete(self) -> bool:
        """Whether every seed has had its turn."""
        return self.stays or self._changes >= SEEDS - 2

    @property
    def upcoming(self) -> int | None:
        """The next seed of the second player, if a change is near; else None."""
        soon = self._played + SPELL // 2 >= self._until
        return self._next if soon and not self.complete else None

    def hold(self) -> None:
        """Keep the seeds for some plays."""
        self._until = max(self._until, self._played + SPELL)

    def count(self, plays: int) -> None:
        """Count second plays."""
        self._played += plays

    def change(self) -> bool:
        """Take the next seed if it is time for it; return whether it was."""
        if self.stays or self._played < self._until:
            return False
        self.seed = self._next
        self._changes += 1
        # Later ones get as many plays as half of all before, so that there are few changes.
        self._until = self._played + (self._played // 2 if self.complete else SPELL)
        return True

    @property
    def _next(self) -> int:
        return (self.seed + 1) % SEEDS if self.alike else self.seed % (SEEDS - 1) + 1
