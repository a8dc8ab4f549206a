"""Hash seeds: those under which runs are played, and the meaning of plays that then differ.

    ==================================================  ======================================
    both plays are repeated, each time, by fresh        the seeds explain that they differ: the
    players under their own two seeds                   run is right if it is with each seed
    any is not, or the seed is the same one             the explorer is nondeterministic
    ==================================================  ======================================

Python allows an explorer to go by the order of a set of texts; that it goes so is a remark.
"""

from collections.abc import Callable, Iterable
from typing import TypeAlias, TypeVar

from allworlds.documents.document import replace
from allworlds.engines.batch import FIRST, SECOND
from allworlds.explorers.loading import Subject, is_program
from allworlds.judging.referee import Outcome

Seeds: TypeAlias = tuple[int, int]
"""The hash seeds of the two plays of a run."""

OTHER_SEED = 2
"""The hash seed of all runs in the other order, which no other play of a check has."""

SIX_MORE = (OTHER_SEED, 3, 4, 5, 6, 7)
"""Further seeds under which some runs of larger worlds are played again."""

GOES_BY_HASHES = "the explorer goes by hashes: where PYTHONHASHSEED is another one, so is its walk"
"""The remark on an explorer whose plays with one seed are always the same."""

Play = TypeVar("Play")


def seeds_of(subject: Subject, wanted: Seeds = (FIRST, SECOND)) -> Seeds:
    """The hash seeds of both players: one for both if no process has an explorer in Python."""
    apart = subject.from_user and subject.importable and not subject.compiled
    return wanted if apart else (wanted[FIRST], wanted[FIRST])


def are_more_tried(subject: Subject, seeds: Seeds) -> bool:
    """Whether some runs are played under further seeds; a program has seeds of its own."""
    return subject.from_user and seeds == (FIRST, SECOND) and not is_program(subject.name)


def across(seeds: Seeds) -> Seeds:
    """The seeds of all runs in both orders."""
    return FIRST, seeds[SECOND] and OTHER_SEED


def explain(
    seeds: Seeds,
    plays: Iterable[tuple[Play, Iterable[Play]]],
    differ: Callable[[Play, Play], bool],
) -> bool:
    """Whether seeds explain that plays differ: fresh players repeat each under its seed.

    Args:
        seeds: of the two plays.
        plays: each with those by fresh players under the same seed.
        differ: whether two of them do.
    """
    repeated = not any(differ(play, fresh) for play, again in plays for fresh in again)
    return repeated and seeds[FIRST] != seeds[SECOND]


def by_seed(seeds: Seeds, first: Outcome, second: Outcome) -> Outcome | None:
    """The outcome that refutes, with its seed; None if the run is right with each."""
    for seed, outcome in zip(seeds, (first, second), strict=True):
        if outcome.violation is not None:
            return replace(outcome, hash_seed=seed)
    return None
