"""The reader as an explorer: percepts come, actions go."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, TypeAlias

from allworlds.document import Report, about, computed
from allworlds.inputs import InputError, show
from allworlds.protocol import Action, Percept, Transcript
from allworlds.studies.play.costs import CostBeside, costs_beside, not_compared
from allworlds.world import GivenLighthouse, IllegalAction, World, world_named

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


def play(
    world: World | str,
    *,
    lighthouse: GivenLighthouse = "directional",
    seed: int | None = None,
    holes: str | None = None,
    player: Player = lambda *_: None,
) -> Play:
    """Let a player walk in the world, action by action.

    Args:
        world: map, lighthouse and start; or what a WORLD may be on the command line.
        lighthouse: the kind of a world that is given as a text and names none.
        seed: of a world of a family, by default 0: ``play("random:8", seed=3)``.
        holes: the share of its edges that are removed: ``play("lattice:3x3", holes="20%")``.
        player: by default it ends the game at once.

    Raises:
        InputError: if there is no such world.
    """
    if isinstance(world, str):
        world = world_named(world, lighthouse, seed, holes)
    else:
        for name, given in (("seed", seed), ("holes", holes)):
            if given is not None:
                raise InputError(f"{name} = {show(given)} has no effect on a world that is given")
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
