"""The reader as an explorer: percepts come, actions go."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, ClassVar, TypeAlias

from allworlds.document import Report, about
from allworlds.inputs import InputError, show
from allworlds.outcome import Exit
from allworlds.protocol import Action, Percept, Transcript
from allworlds.world import IllegalAction, World, world_named

Player: TypeAlias = Callable[[Percept, str], Action | None]
"""Whoever plays: told what is sensed, and what was wrong with the last action (empty: nothing),
it says what to do; None ends the game."""


class Play(Report):
    """Report of 'play'.

    A world and a walk in it.
    """

    exit_code: ClassVar[Exit] = Exit.ANSWERED

    path: Annotated[
        str | None, about("the page in which it is played; null where it was played here")
    ] = None
    world: World
    transcript: Annotated[Transcript, about("what was done and sensed; of a page the start alone")]


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
    return Play(world=world, transcript=Transcript(world.first, tuple(steps)))
