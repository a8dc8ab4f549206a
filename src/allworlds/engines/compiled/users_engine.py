"""The compiled engine of users' explorers, for workers: it is sent to their referees.

No compiled code is loaded here, but in the guardian, which forks the referees.
"""

from __future__ import annotations

from collections.abc import MutableSequence

from msgspec import Struct

from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.isolation.process import guardian
from allworlds.engines.job import Job
from allworlds.engines.kernel.capabilities import COMPILING
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.run_counter import PartwiseEngine
from allworlds.engines.python.scope import Scope
from allworlds.engines.python.tally import Tally
from allworlds.explorers import Subject

KERNEL = "allworlds.engines.compiled.users_kernel"
"""The module that loads compiled code."""


class UsersEngine(Struct, frozen=True):
    """The engine in which a user's explorer plays in stretches, and the kernel judges.

    Attributes:
        general: the Python engine, by which it is checked, and which knows the scope.
    """

    general: PythonEngine

    @property
    def scope(self) -> Scope:
        """The worlds and the rules of the check."""
        return self.general.scope

    @property
    def keep(self) -> int:
        """The number of findings that are kept."""
        return self.general.keep

    def tally(self) -> Tally:
        """Return an empty tally."""
        return self.general.tally()

    def compiled(self, job: Job) -> None:
        """Compile or load the kernel in the guardian, before it forks."""
        if not guardian().prepare(KERNEL, "is_kept"):
            job.notice(COMPILING)
        guardian().prepare(KERNEL, "load")

    def for_built_in(
        self,
        subject: Subject,
        beat: MutableSequence[int] | None = None,
    ) -> PartwiseEngine:
        """Return the engine with a built-in explorer, of the interface ``WorkerEngine``."""
        return self.general.for_built_in(subject, beat)

    def for_users(self, explorer: str, players: PlayerPair) -> PartwiseEngine:
        """Return the engine with a user's explorer, of the interface ``WorkerEngine``."""
        from allworlds.engines.compiled.users_kernel import judged_by_kernel

        players.in_stretches = True
        return judged_by_kernel(self.general, explorer, players)
