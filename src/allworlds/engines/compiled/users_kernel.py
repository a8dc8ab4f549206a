"""The compiled code by which a process judges users' explorers, and all that is loaded with it."""

from __future__ import annotations

from allworlds.engines.compiled.stretches import PlayedByStretches
from allworlds.engines.isolation.generator_player import load as load_generators
from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.kernel.batches import load_native
from allworlds.engines.kernel.compiling import is_compiled
from allworlds.engines.kernel.native import play
from allworlds.engines.kernel.runs import examine
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.run_counter import PartwiseEngine


def is_kept() -> int:
    """Return 1 if the kernel has been compiled before, else 0."""
    return int(all(map(is_compiled, (play, examine))))


def load() -> None:
    """Load the kernel, and with it this module and all that players need."""
    load_native()
    load_generators()


def judged_by_kernel(engine: PythonEngine, explorer: str, players: PlayerPair) -> PartwiseEngine:
    """Return the engine in which these players play, and the kernel judges."""
    return PlayedByStretches(engine, explorer, players)
