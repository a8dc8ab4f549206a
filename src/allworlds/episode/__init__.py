"""The episode: the one place where a world and an explorer meet."""

from allworlds.episode.episode import (
    Answered,
    Ending,
    Episode,
    Fault,
    Player,
    default_step_budget,
    own_copy,
    play,
    the_same,
)

__all__ = [
    "Answered",
    "Ending",
    "Episode",
    "Fault",
    "Player",
    "default_step_budget",
    "own_copy",
    "play",
    "the_same",
]
