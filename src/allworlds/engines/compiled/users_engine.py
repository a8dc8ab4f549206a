"""The compiled engine of users' explorers, for workers: it is sent to their referees."""

from __future__ import annotations

from collections.abc import MutableSequence
from typing import Any

from msgspec import Struct

from allworlds.engines.compiled.stretches import PlayedByStretches
from allworlds.engines.compiled.trees import PlayedByTrees
from allworlds.engines.isolation.generator_player import load as load_generators
from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.isolation.process import guardian
from allworlds.engines.job import Job
from allworlds.engines.kernel import engine as kernel
from allworlds.engines.kernel.batches import load_native
from allworlds.engines.kernel.chunks import load_trees
from allworlds.engines.kernel.compiling import is_compiled
from allworlds.engines.kernel.native import play_worlds
from allworlds.engines.kernel.runs import examine
from allworlds.engines.kernel.tree_player import play_tree
from allworlds.engines.python.earlier_plays import EarlierPlays
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.run_counter import PartwiseEngine
from allworlds.engines.python.scope import Scope
from allworlds.engines.python.tally import Tally
from allworlds.explorers import Subject


def load() -> None:
    """Load the kernel, and with it this module and all that players need."""
    load_native()
    load_trees()
    load_generators()


class UsersEngine(Struct, frozen=True):
    """The engine in which a user's explorer plays in stretches or trees, and the kernel judges.

    Attributes:
        scope, keep: as for the general engine.
    """

    scope: Scope
    keep: int

    def tally(self) -> Tally:
        """Return an empty tally."""
        return Tally(self.keep)

    @staticmethod
    def compiled(job: Job) -> None:
        """Compile or load the kernel in the guardian, before it forks."""
        if not all(map(is_compiled, (play_worlds, play_tree, examine))):
            job.notice(kernel.COMPILING)
        guardian().prepare(__name__, load.__name__)

    def for_built_in(
        self,
        subject: Subject,
        beat: MutableSequence[int] | None = None,
    ) -> PartwiseEngine:
        """Return the engine with a built-in explorer, of the interface ``WorkerEngine``."""
        return PythonEngine(self.scope, self.keep).for_built_in(subject, beat)

    def for_users(
        self, explorer: str, players: PlayerPair, earlier: EarlierPlays[Any]
    ) -> PartwiseEngine:
        """Return the engine with a user's explorer, of the interface ``WorkerEngine``."""
        players.in_stretches = True
        engine = PythonEngine(self.scope, self.keep)
        return PlayedByTrees(PlayedByStretches(engine, explorer, players, earlier))
