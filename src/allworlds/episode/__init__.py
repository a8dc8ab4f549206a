"""The episode: the one place where a world and an explorer meet."""

from allworlds.episode.episode import (
    Answered,
    Ending,
    Episode,
    Fault,
    Log,
    LostRun,
    Player,
    Said,
    Stage,
    answered,
    default_step_budget,
    own_copy,
    perform,
    play,
    retold,
    the_same,
)

__all__ = [
    "Answered",
    "Ending",
    "Episode",
    "Fault",
    "Log",
    "LostRun",
    "Player",
    "Said",
    "Stage",
    "answered",
    "default_step_budget",
    "own_copy",
    "perform",
    "play",
    "retold",
    "the_same",
]
