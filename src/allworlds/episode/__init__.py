"""The episode: the one place where a world and an explorer meet."""

from allworlds.episode.endings import (
    Answered,
    Ending,
    Fault,
    LostRun,
    Said,
    SaidAmbiguous,
    Undecided,
    answered,
)
from allworlds.episode.episode import (
    ADAPTERS_LAWS,
    Episode,
    Log,
    Player,
    Stage,
    default_step_budget,
    own_copy,
    perform,
    play,
    retold,
    the_same,
)

__all__ = [
    "ADAPTERS_LAWS",
    "Answered",
    "Ending",
    "Episode",
    "Fault",
    "Log",
    "LostRun",
    "Player",
    "Said",
    "SaidAmbiguous",
    "Stage",
    "Undecided",
    "answered",
    "default_step_budget",
    "own_copy",
    "perform",
    "play",
    "retold",
    "the_same",
]
