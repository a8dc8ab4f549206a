"""Mutants: wrong explorers, weakened judges and broken enumerators that must all be caught.

They are how a green run is believed: :func:`~allworlds.evidence.mutants.matrix.mutants` tries every
one of them and says which check kills it, at which smallest world.  A new mutant is a class or a
function in one of the five lists, and an entry at the end of its module.

``explorers``, ``learners``, ``errands``, ``judges``, ``enumerators``
    the five lists: explorers with a direction, explorers with position only, explorers with other
    tasks and judges of these, judges, enumerators;
``unfair``
    a way of folding explorers that need not end;
``matrix``
    which check kills which mutant;
``mutants_telling``
    the same in words.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.evidence.mutants.matrix import mutants as mutants
else:
    open_door(__name__)
