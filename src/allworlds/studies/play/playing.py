"""The reader as an explorer: percepts come, actions go."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from allworlds.inputs import InputError, show
from allworlds.outcome import SCHEMA, Exit
from allworlds.protocol import Action, Percept, Transcript
from allworlds.world import IllegalAction, World, world_named

if TYPE_CHECKING:
    from allworlds import documents

Player: TypeAlias = Callable[[Percept, str], Action | None]
"""Whoever plays: told what is sensed, and what was wrong with the last action (empty: nothing),
it says what to do; None ends the game."""


@dataclass(frozen=True, slots=True)
class Play:
    """A world and a walk in it.

    Attributes:
        world: where it was played, or is to be.
        transcript: what was done and sensed.
        path: the page in which it can be played; None where there is none.
    """

    world: World
    transcript: Transcript
    path: str | None = None

    @property
    def exit_code(self) -> Exit:
        """The exit code of the command: a question was answered."""
        return Exit.ANSWERED

    def to_json(self) -> documents.PlayDocument:
        """The document of ``play --json``."""
        return {
            "schema": SCHEMA,
            "path": self.path,
            "world": self.world.to_json(),
            "transcript": self.transcript.to_json(),
        }


def play(
    world: World | str, *, lighthouse: str = "directional", player: Player = lambda *_: None
) -> Play:
    """A walk in the world, action by action as the player wants it.

    Args:
        world: map, lighthouse and start; or what a WORLD may be on the command line.
        lighthouse: the kind of a world that is given as a text and names none.
        player: by default it ends the game at once.

    Raises:
        InputError: if there is no such world.
    """
    if isinstance(world, str):
        world = world_named(world, lighthouse)
    if not isinstance(world, World):
        raise InputError(f"world = {show(world)} is no World; World.from_json makes one")
    state, percept, steps, refused = world.initial, world.first, [], ""
    while (action := player(percept, refused)) is not None:
        try:
            state, percept = world.step(state, action)
        except IllegalAction as error:
            refused = str(error)
        else:
            refused = ""
            steps.append((action, percept))
    return Play(world, Transcript(world.first, tuple(steps)))
