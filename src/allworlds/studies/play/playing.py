"""The reader as an explorer: percepts come, actions go."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import KW_ONLY
from typing import Annotated, TypeAlias

from allworlds.document import Report, about, computed
from allworlds.inputs import SCOPE, Option, Request, answers, integer_of
from allworlds.protocol import Action, Percept, Transcript
from allworlds.studies.play.costs import CostBeside, costs_beside, not_compared
from allworlds.world import (
    HOLES,
    LIGHTHOUSE,
    WORLD,
    Directional,
    GivenLighthouse,
    IllegalAction,
    World,
    a_world,
)

Player: TypeAlias = Callable[[Percept, str], Action | None]
"""A player: given the percept, and the fault of the last action (empty if there is none),
it returns the next action; None ends the game."""


class Play(Report):
    """Report of 'play'.

    A world and a walk in it.
    """

    path: Annotated[str | None, about("the page for playing; null: played in the terminal")] = None
    world: World
    transcript: Annotated[Transcript, about("the actions and percepts; for a page only the start")]
    costs: Annotated[tuple[CostBeside, ...], about("of others in the same world")] = computed(
        lambda played: costs_beside(played.world)
    )

    @property
    def not_compared(self) -> str:
        """A sentence that says whose cost is not compared, and why; empty if each is."""
        return not_compared(self.world)


class PlayRequest(Request, kw_only=False):
    """Request of ``play``: a world, and who walks in it."""

    world: Annotated[World | str, WORLD]
    _: KW_ONLY
    lighthouse: Annotated[GivenLighthouse, LIGHTHOUSE] = Directional.kind
    seed: Annotated[
        int | None,
        Option(
            SCOPE,
            "S",
            "Seed for families that are drawn at random: with it, everybody gets the same world.",
            parse=integer_of,
        ),
    ] = None
    holes: Annotated[str | None, HOLES] = None
    player: Annotated[
        Player,
        "takes a percept and the fault of the last action, and returns the next action, or None to "
        "end the game; by default it ends the game at once",
    ] = lambda *_: None


@answers(PlayRequest)
def play(request: PlayRequest) -> Play:
    """Let a player walk in the world, action by action.

    Raises:
        InputError: if there is no such world.
    """
    world = a_world(request.world, request.lighthouse, request.seed, request.holes)
    player = request.player
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
