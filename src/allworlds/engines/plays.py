"""The two plays of each run in a lane, by the lane's two players, and further plays.

A further play is made by a *fresh* player: a new process that has not played yet.

The first player plays in worlds.  The second player is another process, perhaps with another hash
seed, and holds no world: it plays by the percepts that the judge has computed from the first log.
It plays the runs in a random order.
"""

from collections.abc import Callable, Sequence
from functools import partial
from random import Random
from typing import NamedTuple, TypeAlias

from allworlds.engines.batch import FIRST, Indices, Message, RunBatch
from allworlds.engines.hash_seeds import Seeds
from allworlds.engines.players import (
    Lost,
    PlayerHere,
    PlayerProcess,
    Setup,
    answered,
    lost_log,
    started,
)
from allworlds.log import Log

DEPTH = 2
"""The largest number of batches that a player has at a time.

So the player can play one batch while the judge judges another batch.
"""

Attempt: TypeAlias = tuple[Sequence[bytes], Lost | None]
"""A pair: the logs that a fresh player has made, and None.

If the player was lost, the pair is the log of the run in which the player was lost, and the loss.
"""


class RunsToPlay(NamedTuple):
    """A batch, and the indices of those of its runs that a player is to play."""

    batch: RunBatch
    indices: Indices


class BothPlays:
    """The two players of a lane, and fresh players.

    The argument ``which`` of a method is the number of a player, :data:`FIRST` or :data:`SECOND`.

    Args:
        setup: the explorer, with the limits of its players.
        seeds: the hash seeds of both players.
        random: the generator of the random orders in which the second player plays.
    """

    def __init__(self, setup: Setup, seeds: Seeds, random: Random) -> None:
        self.setup, self.seeds, self._random = setup, seeds, random
        self._players: dict[int, PlayerProcess | PlayerHere] = {}

    @property
    def players(self) -> list[PlayerProcess | PlayerHere]:
        """The players that have been started."""
        return [*self._players.values()]

    @property
    def here(self) -> bool:
        """Whether the explorer plays in this process."""
        return any(isinstance(player, PlayerHere) for player in self._players.values())

    def close(self) -> None:
        """End both players."""
        for player in self._players.values():
            player.close()
        self._players.clear()

    # ---------------------------------------------------------------- the two

    def has_room(self, which: int) -> bool:
        """Whether a player, which may not have been started yet, can take one more batch."""
        return which not in self._players or len(self._players[which].jobs) < DEPTH

    def give(self, which: int, batch: RunBatch, indices: Indices) -> None:
        """Give a player these runs of a batch; start the player if it does not exist yet."""
        if which not in self._players:
            self._players[which] = started(self.setup, self.seeds[which], self._notice)
        self._players[which].give(RunsToPlay(batch, indices), self._message(which, batch, indices))

    def _message(self, which: int, batch: RunBatch, indices: Indices) -> Message:
        if which == FIRST:
            return batch.by.worlds(batch, indices)
        if not batch.plain and len(indices) == len(batch):  # compiled code draws the order
            return batch.by.percepts(batch, indices)
        order = self._random.sample(range(len(indices)), len(indices))
        if self._random.getrandbits(1):  # so that an explorer that counts runs cannot know the next
            order.insert(self._random.randrange(len(order)), self._random.choice(order))
        return batch.by.percepts(batch, indices, order)

    def _notice(self, event: str) -> None:
        """Count an event of a built-in explorer in the batch that the explorer is playing."""
        job, _ = self._players[FIRST].jobs[0]
        job.batch.tally.witnesses[event] += 1

    def hear(self, which: int) -> list[RunBatch]:
        """Store the logs that have come from a player; return the batches with new logs.

        Compiled code plays a shared library.  Sometimes it cannot make the logs of the second play,
        for example because they do not fit into memory.  Then the player says so, and is asked to
        play the same runs again, in Python.  The batch keeps the logs of its first play.  If
        compiled code cannot make the logs of the first play, the lane notices it when the batch is
        judged.

        Raises:
            Lost: if the player is lost.
            InputError, HarnessError: as in :meth:`PlayerProcess.heard`.
        """
        heard = list[RunBatch]()
        for job, logs in self._players[which].heard() if which in self._players else ():
            if logs is None:
                job.batch.plain = True
                self.give(which, job.batch, job.indices)
            else:
                job.batch.take(which, job.indices, logs)
                heard.append(job.batch)
        return heard

    def longest_walk(self) -> tuple[int, int] | None:
        """The explorer's turns in the longest run in progress, and the budget of that run.

        The budget is the largest legal number of traversals.  Return None if no run is in progress.
        """
        walks = list[tuple[int, int]]()
        for player in self.players:
            if not player.jobs:
                continue
            (batch, indices), _ = player.jobs[0]
            number, turns = player.beat
            if 0 <= number < len(indices):
                rules, run = batch.by.counter.scope.rules, batch.due(indices[number])
                walks.append((turns, rules.budget(run.world.map)))
        return max(walks, default=None)

    def lost_in(self, which: int) -> tuple[RunBatch | None, int | None]:
        """The batch and the index of the run in which a player was lost.

        If the player had no batch, batch and index are None.  If the player was lost outside a run,
        the index is None.
        """
        player = self._players[which]
        if not player.jobs or player.description is None:
            return None, None
        (batch, indices), _ = player.jobs[0]
        number = player.beat[0]
        return batch, indices[number] if 0 <= number < len(indices) else None

    def go_on(self, which: int) -> None:
        """Replace a player that was lost; the new player plays the runs that have no log yet."""
        player = self._players[which]
        if player.jobs:
            (batch, indices), _ = player.jobs.popleft()
            if rest := batch.unplayed(which, indices):
                job = RunsToPlay(batch, rest)
                player.jobs.appendleft((job, self._message(which, batch, rest)))
        player.again()

    # ---------------------------------------------------------------- fresh ones

    def alone(self, which: int, batch: RunBatch, index: int) -> Attempt:
        """Let a fresh player play the run ``index`` of a batch; return the log, and any loss.

        The fresh player plays as the player ``which`` does: in the world or by percepts, and with
        the same hash seed.
        """
        message = batch.by.worlds if which == FIRST else batch.by.percepts
        return self.anew(self.seeds[which], message(batch, [index]))

    def again(self, which: int, seed: int, batch: RunBatch, indices: Indices) -> dict[int, Log]:
        """Let a fresh player with this hash seed play these runs; return their logs by index.

        The fresh player plays as the player ``which`` does: in worlds or by percepts.
        """
        message = batch.by.worlds if which == FIRST else batch.by.percepts
        return self.fresh(seed, partial(message, batch), indices)

    def fresh(self, seed: int, make: Callable[[Indices], Message], runs: Indices) -> dict[int, Log]:
        """Let a fresh player with this hash seed play these runs; return their logs by index.

        If the fresh player is lost, it has sent no logs of several runs.  Then each of the runs is
        played alone, by one more fresh player.  If that player is lost, too, the log of its run
        ends with the loss.

        Args:
            seed: the hash seed.
            make: the function that makes the message for runs of given indices.
            runs: the indices of the runs.
        """
        logs, lost = self.anew(seed, make(runs))
        if lost and len(runs) > 1:
            return {index: self.fresh(seed, make, [index])[index] for index in runs}
        return dict(zip(runs, map(Log, logs), strict=True))

    def anew(self, seed: int, message: Message) -> Attempt:
        """Let a fresh player with this hash seed answer a message.

        Return a pair: the logs; and the loss if the player was lost, else None.
        """
        player = started(self.setup, seed)
        try:
            return answered(player, message | {"hear": message["runs"] == 1}), None
        except Lost as lost:
            return [lost_log(bytes(player.part), lost)], lost
        finally:
            player.close()
