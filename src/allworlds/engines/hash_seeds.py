"""The hash seeds of the plays, and the meaning of two plays of a run that differ.

The hash seed of a process determines the order in which Python goes through a set of texts.  If the
two plays of a run, under two hash seeds, have different logs, fresh players play the run again
under each of the two seeds:

    ==================================================  ======================================
    what the fresh players show                         what follows
    ==================================================  ======================================
    under each seed they make the same log as the       the seeds explain the difference: the run
    first player with this seed                         breaks a law only if one of the two logs
                                                        breaks a law
    some log is another one, or the two seeds are       the explorer is nondeterministic
    equal
    ==================================================  ======================================

If the log of an explorer depends on the hash seed, and breaks no law, a remark in the report says
so; it is no fault.
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
"""The hash seed of the second of the two processes that play all runs in small worlds.

The function :func:`across` returns the seeds of both processes.
"""

SIX_MORE = (OTHER_SEED, 3, 4, 5, 6, 7)
"""Further seeds under which some runs of larger worlds are played again."""

GOES_BY_HASHES = "the explorer goes by hashes: where PYTHONHASHSEED is another one, so is its walk"
"""The remark on an explorer whose plays of a run are equal under one seed, but not under two."""

Play = TypeVar("Play")


def seeds_of(subject: Subject, wanted: Seeds = (FIRST, SECOND)) -> Seeds:
    """The hash seeds of both players.

    A user's explorer gets the seeds ``wanted`` if other processes can load the explorer, and if the
    explorer is no shared library.  For any other explorer both seeds are the first wanted seed.
    """
    apart = subject.from_user and subject.importable and not subject.compiled
    return wanted if apart else (wanted[FIRST], wanted[FIRST])


def are_more_tried(subject: Subject, seeds: Seeds) -> bool:
    """Whether some runs are played again under the six seeds :data:`SIX_MORE`.

    They are if the explorer is a user's explorer in Python, and if ``seeds``, the hash seeds of the
    two players, are :data:`FIRST` and :data:`SECOND`.
    """
    return subject.from_user and seeds == (FIRST, SECOND) and not is_program(subject.name)


def across(seeds: Seeds) -> Seeds:
    """The hash seeds of the two processes that play all runs in small worlds in opposite orders.

    ``seeds`` are the hash seeds of the two players.  The first process gets the seed :data:`FIRST`.
    The other process gets :data:`OTHER_SEED`, a seed that no player has; but if both players have
    the seed 0, the user wants no other seed, and the process gets 0, too.
    """
    return FIRST, seeds[SECOND] and OTHER_SEED


def explain(
    seeds: Seeds,
    plays: Iterable[tuple[Play, Iterable[Play]]],
    differ: Callable[[Play, Play], bool],
) -> bool:
    """Whether two different hash seeds are the reason why the two plays of runs differ.

    They are the reason if the two seeds differ, and each play has the same log again when fresh
    players play under its seed.

    Args:
        seeds: the seeds of the two plays.
        plays: for each play a pair: the play; and the plays of the same run by fresh players under
            the same seed.
        differ: the function that tells whether two plays of a run differ.
    """
    repeated = not any(differ(play, fresh) for play, again in plays for fresh in again)
    return repeated and seeds[FIRST] != seeds[SECOND]


def by_seed(seeds: Seeds, first: Outcome, second: Outcome) -> Outcome | None:
    """The first of a run's two outcomes that breaks a law, with its hash seed added.

    Return None if neither outcome breaks a law.

    Args:
        seeds: the hash seeds of the two plays.
        first: the outcome under the first of these seeds.
        second: the outcome under the second of these seeds.
    """
    for seed, outcome in zip(seeds, (first, second), strict=True):
        if outcome.violation is not None:
            return replace(outcome, hash_seed=seed)
    return None
