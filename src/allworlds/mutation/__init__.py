"""Mutants: wrong explorers, weakened judges and broken enumerators that must all be caught.

They are how a green run is believed: :func:`mutants` tries every one of them and says which
check kills it, at which smallest world.  A new mutant is a class in
:mod:`allworlds.mutation.explorers`, or a function in ``judges`` or ``enumerators``, and an
entry of the list at the end of that module.
"""

from allworlds.mutation.matrix import Kill, KillMatrix, mutants

__all__ = ["Kill", "KillMatrix", "mutants"]
