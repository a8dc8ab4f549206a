"""The explanation of each law by the law's name.

A new law is explained by a function from a :class:`Story` to a :class:`Telling`, in the
module of its kin or in one of its own, and an entry of ``TELLERS``.
"""

from __future__ import annotations

from allworlds.explaining.laws.answers import tell_map, tell_pose
from allworlds.explaining.laws.bound import tell_bound
from allworlds.explaining.laws.checkpoints import tell_invariant_1, tell_invariant_2, tell_variant
from allworlds.explaining.laws.endings import ending
from allworlds.explaining.laws.folding import tell_folding
from allworlds.explaining.telling import Teller

TELLERS: dict[str, Teller] = {
    # A run that ended before it could be judged has one sentence of its own.
    "crash": ending("The explorer crashed."),
    "timeout": ending("The explorer was silent for too long."),
    "illegal-action": ending("The explorer did what no robot can do here."),
    "no-estimate": ending("The explorer ended without an answer that could be judged."),
    "budget": ending("The explorer went on for longer than it may."),
    "nondeterministic": ending("Exploring the same world again, the explorer did something else."),
    "map": tell_map,
    "pose": tell_pose,
    "invariant-1": tell_invariant_1,
    "invariant-2": tell_invariant_2,
    "variant": tell_variant,
    "folding": tell_folding,
    "bound": tell_bound,
}
"""What each law of the judge has to tell, in the judge's order."""


def teller_of(law: str) -> Teller:
    """What the law has to tell; of a law that has no entry, no more than its name."""
    return TELLERS.get(law) or ending(f"The law '{law}' is broken.")


__all__ = ["TELLERS", "teller_of"]
